"""Record what vehicle lines run, and the states of versions."""

from sqlalchemy import Connection

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.registry.compatibility.deploying import deployable
from sigcat.registry.published import all_versions, names_of, running, version_named
from sigcat.registry.reference import (
    CHANGEABLE,
    Kind,
    Reference,
    Rule,
    State,
    date_fault,
    name_problem,
    refused,
    unknown,
)
from sigcat.registry.storing.entry import Action, is_past
from sigcat.registry.storing.ledger import Ledger, Registry, ledger_of


def record(registry: Registry, action: Action, line: str, reference: Reference) -> str:
    """Record a deployment, a release or the end of support, and return the head of the log. Raises InputRefused."""
    problem = name_problem(line, "line")
    if problem is not None:
        raise refused(problem)
    with ledger_of(registry) as ledger:
        if action == "support ended":
            _check_running(ledger.connection, line, reference)
            owner = version_named(ledger.connection, "function", reference).owner
        else:
            _check_spelling(ledger.connection, line)
            owner = deployable(ledger.connection, reference).owner
        _check_owner(ledger, reference.name, owner)
        if not (action == "release" and _runs(ledger.connection, line, reference)):
            ledger.append(action, {"line": line, **reference._asdict()})
        return ledger.head_hash


def set_state(
    registry: Registry, kind: Kind, reference: Reference, state: State, until: str = "", successor: str = ""
) -> str:
    """Deprecate or retire a version, and return the head of the log. Raises InputRefused."""
    _check_date(until)
    with ledger_of(registry) as ledger:
        published = version_named(ledger.connection, kind, reference)
        _check_owner(ledger, reference.name, published.owner)
        if published.state in CHANGEABLE:
            raise _unfit(reference, f"{reference} must be published; it is {published.state}.", "Publish it first.")
        if published.state == "retired":
            raise _unfit(reference, f"{reference} is retired, and stays so.")
        if successor:
            replacing = version_named(ledger.connection, kind, Reference(reference.name, successor))
            if replacing.id == published.id:
                raise _unfit(reference, f"The successor of {reference} must be another version.")
            if replacing.state in ("deprecated", "retired"):
                message = f"The successor of {reference} must be supported; {successor} is {replacing.state}."
                raise _unfit(reference, message)
        _check_retired(ledger.connection, reference, state)
        ending = {"state": state, "until": until, "successor": successor}
        ledger.append("state", {"kind": kind, **reference._asdict(), **ending})
        return ledger.head_hash


def set_rule(registry: Registry, kind: Kind, name: str, rule: Rule) -> str:
    """Set the rule of a name, and return the head of the log. Raises InputRefused."""
    with ledger_of(registry) as ledger:
        known = names_of(ledger.connection, kind)
        if name not in known:
            raise unknown(kind, name, known)
        _check_owner(ledger, name, *(each.owner for each in all_versions(ledger.connection, kind, name)[-1:]))
        ledger.append("rule", {"kind": kind, "name": name, "rule": rule})
        return ledger.head_hash


def _check_owner(ledger: Ledger, name: str, *owners: str) -> None:
    findings = tuple(ledger.author.refusals(name, owners))
    if findings:
        raise refused(*findings)


def _check_running(connection: Connection, line: str, reference: Reference) -> None:
    if line not in names_of(connection, "line"):
        raise unknown("line", line, names_of(connection, "line"))
    if not _runs(connection, line, reference):
        message = f"{reference} does not run in line {line}."
        raise refused(codes.NOT_PUBLISHED.finding(message, path=reference.name))


def _runs(connection: Connection, line: str, reference: Reference) -> bool:
    return any(each.published.reference == reference for each in running(connection, line))


def _check_spelling(connection: Connection, line: str) -> None:
    known = next((name for name in names_of(connection, "line") if name.casefold() == line.casefold()), line)
    if known != line:
        message = f"The name must be {known!r}, as it is recorded, not {line!r}."
        raise refused(codes.PUBLISHED_NAME_UNFIT.finding(message, fix="Use the same case."))


def _check_retired(connection: Connection, reference: Reference, state: State) -> None:
    """Refuse to retire a version that vehicles run."""
    lines = [each.line for each in running(connection) if each.published.reference == reference]
    if state == "retired" and lines:
        message = f"{reference} runs in line {', '.join(lines)}."
        fix = f"Record the end of its support: `sigcat registry support-ended {lines[0]} {reference.name}@{reference.version}`."
        raise _unfit(reference, message, fix)


def _unfit(reference: Reference, message: str, fix: str = "") -> InputRefused:
    return refused(codes.VERSION_NOT_DEPLOYABLE.finding(message, path=reference.name, fix=fix))


def _check_date(text: str) -> None:
    if text and (fault := date_fault(text)):
        raise refused(codes.VERSION_NOT_DEPLOYABLE.finding(f"The date {fault}."))
    if is_past(text):
        message = f"The date must be today or later, not {text}: support ends on it."
        raise refused(codes.VERSION_NOT_DEPLOYABLE.finding(message))
