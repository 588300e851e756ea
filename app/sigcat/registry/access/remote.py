"""The registry of a service, over HTTP."""

import json
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import wraps
from http import HTTPStatus
from http.client import HTTPException
from typing import Any, Concatenate, NamedTuple, ParamSpec, TypeVar
from urllib.parse import quote, urlencode

from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding
from sigcat.limits import REGISTRY_ANSWER_BYTES, REGISTRY_SECONDS
from sigcat.names import question
from sigcat.registry.access.access import Change, Listed
from sigcat.registry.compatibility.conflicts import Conflict, Side
from sigcat.registry.compatibility.deploying import Answer
from sigcat.registry.decisions.acknowledgements import Acknowledgement, Deprecation
from sigcat.registry.decisions.approvals import Approval, Decided, Pending
from sigcat.registry.publish import Outcome, Receipt, Status
from sigcat.registry.published import Published
from sigcat.registry.reference import GROUP_OF, KIND_OF, Kind, Reference, Rule, State
from sigcat.registry.storing.entry import Action
from sigcat.registry.use import Use
from sigcat.registry.users import User, Users

_ACTIONS: Mapping[Action, str] = {
    "deployment": "record-deployment", "release": "record-release", "support ended": "support-ended",
}  # fmt: skip
_LATER = (429, 502, 503, 504)
"""Statuses of a service that may answer later."""
_JSON = Mapping[str, Any]
_Asked = ParamSpec("_Asked")
_Answer = TypeVar("_Answer")


def _understood(
    ask: Callable[Concatenate["Server", _Asked], _Answer],
) -> Callable[Concatenate["Server", _Asked], _Answer]:
    """The function; an answer of another form raises UsageError."""

    @wraps(ask)
    def asking(server: "Server", /, *arguments: _Asked.args, **options: _Asked.kwargs) -> _Answer:
        try:
            return ask(server, *arguments, **options)
        except (AttributeError, IndexError, KeyError, TypeError):
            raise UsageError(f"{server.address} does not answer as this version of sigcat expects it") from None

    return asking


class Unanswered(UsageError):
    """A service that may answer later: it does not run, is busy, or is behind a proxy that does not reach it."""


class Server(NamedTuple):
    """Access to a registry that a service has."""

    address: str
    """Such as https://signals.example."""
    token: str = ""

    @_understood
    def all_versions(self, kind: Kind | None = None) -> tuple[Listed, ...]:
        """Versions by kind, name and precedence."""
        _refuse_empty(self)
        groups = sorted(GROUP_OF.values()) if kind is None else [GROUP_OF[kind]]
        named = (each for group in groups for each in sorted(_names(self, group), key=lambda each: str(each["name"])))
        found = [version for each in named for version in each["versions"]]
        return tuple(Listed(_ending(each, each["lifecycle"]), tuple(each["vehicle_lines"])) for each in found)

    @_understood
    def content(self, kind: Kind, reference: Reference, *, is_resolved: bool) -> bytes:
        """The published bytes of a version; resolved, its Function JSON or its nodes."""
        address = f"/{GROUP_OF[kind]}/{quote(reference.name, '')}/versions/{quote(reference.version, '')}"
        if not is_resolved:
            return _answer(self, "GET", address)
        digest = _asked(self, "GET", f"{address}$details")["resolved_digest"]
        return _answer(self, "GET", "/contents", {"digest": digest})

    @_understood
    def events(self, after: int, wait: int = 0) -> tuple[Sequence[_JSON], int]:
        """Events behind an entry of the log, or of the first one after so many seconds at most; and the entry they end with.

        Raises Unanswered.
        """
        found = _asked(self, "GET", "/events", {"after": str(after), "wait": str(wait)})
        return [dict(each) for each in found["registry_events"]], int(found["epoch"])

    @_understood
    def users_of(self, path: str, *, is_complete: bool = False, catalogue: str = "") -> Users:
        """The users of a path, or of nodes below it."""
        _refuse_empty(self)
        query = {"path": path, "all_versions": str(is_complete).lower(), **_over(catalogue)}
        found = _asked(self, "GET", "/users", query)
        return Users(tuple(map(_user, found["users"])), found["more"])

    @_understood
    def can_deploy(self, references: Sequence[Reference], line: str) -> Answer:
        """Return whether versions, which ship together, fit everything in the vehicles of a line."""
        first, *others = map(_written, references)
        found = _asked(self, "POST", "/can-i-deploy", {"function": first, "line": line, "others": others})
        finding = _finding(found["finding"]) if found["finding"] else None
        deployed, checked = (tuple(map(_reference, found[key])) for key in ("deployed", "checked"))
        conflicts = tuple(map(_conflict, found["conflicts"]))
        return Answer(found["decision"], found["vehicle_line"], deployed, checked, conflicts, finding)

    @_understood
    def check(self, files: Sequence[tuple[bytes, str]], catalogue: str = "") -> tuple[Finding, ...]:
        """Findings about published functions that files break."""
        found = _asked(self, "POST", "/check", _over(catalogue), _body(files))
        return tuple(map(_finding, found["findings"]))

    @_understood
    def publish(
        self,
        files: Sequence[tuple[bytes, str]],
        version: str = "",
        owner: str = "",
        *,
        is_draft: bool = False,
        catalogue: str = "",
    ) -> tuple[Receipt, Change]:
        """Publish files, and return what became of them."""
        query = {"version": version, "owner": owner, "draft": str(is_draft).lower(), **_over(catalogue)}
        found = _asked(self, "POST", "/publish", query, _body(files))
        change = _change(found)
        return Receipt(tuple(map(_outcome, found["versions_posted"])), change.head), change

    @_understood
    def record(self, action: Action, line: str, reference: Reference) -> Change:
        """Record a deployment, a release or the end of support."""
        query = {"function": _written(reference), "line": line}
        return _change(_asked(self, "POST", f"/{_ACTIONS[action]}", query))

    @_understood
    def set_state(self, kind: Kind, reference: Reference, state: State, until: str = "", successor: str = "") -> Change:
        """Deprecate or retire a version."""
        query = _about(kind, reference)
        if state == "retired":
            return _change(_asked(self, "POST", "/retire", query))
        return _change(_asked(self, "POST", "/deprecate", {**query, "removal": until, "alternative": successor}))

    @_understood
    def set_rule(self, kind: Kind, name: str, rule: Rule) -> Change:
        """Set the rule of a name."""
        query = {"published": name, "compatibility_rule": rule, "group": GROUP_OF[kind]}
        return _change(_asked(self, "POST", "/rule", query))

    @_understood
    def pending(self) -> tuple[Pending, ...]:
        """Versions that wait for approvals."""
        _refuse_empty(self)
        return tuple(map(_pending, _asked(self, "GET", "/pending")["versions_pending"]))

    @_understood
    def deprecations(self) -> tuple[Deprecation, ...]:
        """Deprecated versions, and the owners that use them."""
        _refuse_empty(self)
        return tuple(map(_deprecation, _asked(self, "GET", "/deprecations")["versions_deprecated"]))

    @_understood
    def acknowledge(self, kind: Kind, reference: Reference, owner: str) -> Change:
        """Record that an owner knows of a deprecation."""
        return _change(_asked(self, "POST", "/acknowledge", {**_about(kind, reference), "owner": owner}))

    @_understood
    def approve(self, kind: Kind, reference: Reference, owner: str, days: int, content: str) -> tuple[Decided, Change]:
        """Approve the content of a pending version, and return all decisions."""
        return _decide(self, "/approve", kind, reference, owner, {"content_digest": content, "valid_days": str(days)})

    @_understood
    def reject(self, kind: Kind, reference: Reference, owner: str, reason: str, content: str) -> tuple[Decided, Change]:
        """Reject the content of a pending version, and return all decisions."""
        return _decide(self, "/reject", kind, reference, owner, {"content_digest": content, "reason": reason})


def _names(server: Server, group: str) -> Iterator[_JSON]:
    query = {"inline": "versions"}
    while True:
        page = _asked(server, "GET", f"/{group}", query)
        yield from page["names"]
        if page["next_cursor"] is None:
            return
        query = {**query, "cursor": page["next_cursor"]}


def _refuse_empty(server: Server) -> None:
    """Raises UsageError if nothing is published: then no answer would mean anything."""
    if _asked(server, "GET", "")["head"] is None:
        raise UsageError(f"nothing is published in the registry of {server.address}: run `sigcat publish`")


def _decide(
    server: Server, path: str, kind: Kind, reference: Reference, owner: str, decision: _JSON
) -> tuple[Decided, Change]:
    found = _asked(server, "POST", path, {**_about(kind, reference), "owner": owner, **decision})
    change = _change(found)
    return Decided(tuple(map(_approval, found["approvals"])), change.head), change


# -- requests -----------------------------------------------------------------------------------------------------


class _NoRedirects(urllib.request.HTTPRedirectHandler):
    """The token must not reach another address."""

    def redirect_request(self, *_: Any, **__: Any) -> None:
        return None


_OPENER = urllib.request.build_opener(_NoRedirects)


def _asked(server: Server, method: str, path: str, query: _JSON | None = None, body: bytes = b"") -> Any:
    data = _answer(server, method, path, query, body)
    try:
        return json.loads(data)
    except ValueError:
        raise UsageError(f"{server.address} is not a service of sigcat: its answer is not JSON") from None


def _answer(server: Server, method: str, path: str, query: _JSON | None = None, body: bytes = b"") -> bytes:
    """The answer of a service. Raises InputRefused with its findings, and UsageError without any."""
    asked = urlencode({key: value for key, value in (query or {}).items() if value}, doseq=True)
    address = f"{server.address.rstrip('/')}/api/v1/registry{path}{asked and f'?{asked}'}"
    headers = {"Accept": "*/*", "Content-Type": "application/octet-stream"}
    if server.token:
        headers["Authorization"] = f"Bearer {server.token}"
    data = body if method == "POST" else None
    request = urllib.request.Request(address, data, headers, method=method)  # noqa: S310 - the scheme was checked
    try:
        with _OPENER.open(request, timeout=REGISTRY_SECONDS) as answer:
            found: bytes = answer.read(REGISTRY_ANSWER_BYTES + 1)
            is_cut = bool(answer.length) and len(found) <= REGISTRY_ANSWER_BYTES
    except urllib.error.HTTPError as error:
        refusal = _refusal(server, error)
        raise (Unanswered(_later(server, refusal)) if error.code in _LATER else refusal) from None
    except (OSError, HTTPException, ValueError) as error:
        reason = getattr(error, "reason", error)
        raise Unanswered(f"{server.address} does not answer: {reason}") from None
    if is_cut:
        raise Unanswered(f"{server.address} does not answer: its answer was cut off")
    if len(found) > REGISTRY_ANSWER_BYTES:
        raise UsageError(f"the answer of {server.address} has more than {REGISTRY_ANSWER_BYTES:,} bytes")
    return found


def _later(server: Server, refusal: InputRefused | UsageError) -> str:
    """The sentences of a service that answers later, with the causes that it names."""
    if isinstance(refusal, UsageError):
        return str(refusal)
    causes = " ".join(each.message for each in refusal.findings)
    return f"{server.address}: {refusal} {causes} Run the command again."


def _refusal(server: Server, error: urllib.error.HTTPError) -> InputRefused | UsageError:
    with error:
        data = error.read(REGISTRY_ANSWER_BYTES)
    try:
        problem = json.loads(data)
        detail, findings = str(problem["detail"]), tuple(map(_finding, problem["findings"]))
    except (ValueError, TypeError, KeyError):
        return UsageError(f"{server.address} answers with {error.code} {_phrase(error.code)}, and not as sigcat does")
    if findings:
        return InputRefused(detail, findings)
    if error.code == HTTPStatus.UNAUTHORIZED and not server.token:
        return UsageError(f"{server.address}: a token is needed: set SIGCAT_TOKEN. {detail}")
    return UsageError(f"{server.address}: {detail} {question(problem.get('nearest', ()))}".rstrip())


def _phrase(status: int) -> str:
    return HTTPStatus(status).phrase if status in list(HTTPStatus) else "an unknown status"


def _body(files: Sequence[tuple[bytes, str]]) -> bytes:
    return json.dumps({"files": [{"name": name, "text": _text(data, name)} for data, name in files]}).encode()


def _text(data: bytes, name: str) -> str:
    try:
        return data.decode()
    except UnicodeDecodeError:
        raise UsageError(f"{name} must be UTF-8") from None


def _over(catalogue: str) -> dict[str, str]:
    return {"catalogue": catalogue} if catalogue else {}


def _about(kind: Kind, reference: Reference) -> dict[str, str]:
    return {"reference": _written(reference), "group": GROUP_OF[kind]}


def _written(reference: Reference) -> str:
    return f"{reference.name}@{reference.version}"


# -- answers ------------------------------------------------------------------------------------------------------


def _change(data: _JSON) -> Change:
    head = data["head"]
    return Change(head["hash"], bool(head["signature"])) if head else Change("", is_signed=False)


def _finding(data: _JSON) -> Finding:
    values = {key: data[key] for key in Finding._fields if data.get(key) is not None}
    return Finding(**values)


def _outcome(data: _JSON) -> Outcome:
    owners = data.get("owner") or "", data.get("previous_owner") or ""  # an older service has neither
    approvals = tuple(map(_approval, data["approvals"]))
    return Outcome(KIND_OF[data["group"]], _reference(data), _status(data), approvals, *owners)


def _status(data: _JSON) -> Status:
    if data["is_pending"]:
        return "pending"
    return "unchanged" if not data["is_new"] else "draft" if data["is_draft"] else "published"


def _pending(data: _JSON) -> Pending:
    published = _published(data, KIND_OF[data["group"]], "pending")
    approvals = tuple(map(_approval, data["approvals"]))
    return Pending(published._replace(rule="approval", content=data["content_digest"]), approvals)


def _deprecation(data: _JSON) -> Deprecation:
    found = (
        Acknowledgement(each["owner"], each["using_functions"], each["acknowledged"] or "")
        for each in data["acknowledgements"]
    )
    return Deprecation(_ending(data, "deprecated"), tuple(found))


def _approval(data: _JSON) -> Approval:
    keys = ("owner", "broken_functions", "approval_decision", "decided", "valid_until", "reason")
    return Approval(*(data[key] or "" for key in keys))


def _reference(data: _JSON) -> Reference:
    return Reference(data["name"], data["versionid"])


def _ending(data: _JSON, state: State) -> Published:
    """A version with the end of its support."""
    published = _published(data, KIND_OF[data["group"]], state)
    return published._replace(until=data["removal"] or "", successor=data["alternative"] or "")


def _published(data: _JSON, kind: Kind, state: State) -> Published:
    """A version as far as answers have it: what commands print."""
    name, version, owner = data["name"], data["versionid"], data["owner"] or ""
    return Published(0, kind, name, "backward", version, state, owner, "", "", "", "", "", "")


def _user(data: _JSON) -> User:
    values = {key: value for key, value in data["use"].items() if key in Use._fields and value is not None}
    values |= {key: "" for key in ("path", "call", "variable", "via") if data["use"][key] is None}
    use = Use(**{**values, "leads_to": tuple(values["leads_to"])})
    return User(
        _published(data, "function", data["lifecycle"]), use, tuple(data["through"]), tuple(data["vehicle_lines"])
    )


def _conflict(data: _JSON) -> Conflict:
    sides = tuple(
        Side(each["name"], each["versionid"], each["owner"] or "", tuple(each["calls"])) for each in data["sides"]
    )
    return Conflict(
        data["rule"], data["severity"], data["message"], data["path"] or "", data["attribute"] or "", sides,
        data["fix"] or "", lines=tuple(data["vehicle_lines"]),
    )  # fmt: skip
