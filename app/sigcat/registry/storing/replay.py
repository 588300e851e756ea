"""Apply entries of the log to the tables: at once when they are written, and again to verify, import or upgrade a registry."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from sqlalchemy import Column, Connection, Table, and_, bindparam, delete, func, insert, select, update

from sigcat.registry.reference import DEPLOYABLE
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.entry import Action, Entry
from sigcat.registry.storing.tables import ACKNOWLEDGEMENTS, APPROVALS, DEPLOYMENTS, NAMES, RELIANCES, USES, VERSIONS
from sigcat.registry.use import Use, from_json, row_text
from sigcat.registry.version import version_of

_Data = Mapping[str, Any]
DERIVED: Sequence[Table] = (NAMES, VERSIONS, RELIANCES, USES, DEPLOYMENTS, APPROVALS, ACKNOWLEDGEMENTS)
"""Tables that follow from the log, each after those to which it refers."""
PORTION = 500
"""Values of one statement: databases limit them."""


def apply(connection: Connection, entry: Entry) -> None:
    """Change the tables as an entry says."""
    _ACTIONS[entry.action](connection, entry.data, entry.at)


_INSERT_VERSION, _INSERT_USES = insert(VERSIONS), insert(USES)
_IS_RELEASE = and_(VERSIONS.c.name_id == bindparam("of"), VERSIONS.c.release == bindparam("is_release"))
_OF_RELEASE = select(
    select(VERSIONS.c.id).where(_IS_RELEASE).scalar_subquery(), select(func.max(VERSIONS.c.id)).scalar_subquery()
)
"""Ids of the release and of the last version; none if there is none."""
_NEWEST = (
    select(VERSIONS.c.id)
    .where(VERSIONS.c.name_id == NAMES.c.id, VERSIONS.c.state.in_(sorted(DEPLOYABLE)))
    .order_by(VERSIONS.c.precedence.desc())
    .limit(1)
    .scalar_subquery()
)
_SET_NEWEST = update(NAMES).where(NAMES.c.id == bindparam("of")).values(newest=_NEWEST)


def _publish(connection: Connection, data: _Data, at: str) -> None:
    name_id = _name_id(connection, data["kind"], data["name"])
    version = version_of(data["version"])
    values = {
        "version": data["version"], "precedence": version.sort_text if version else "", "state": data["state"],
        "owner": data["owner"], "content": data["content"], "resolved": data["resolved"], "uses": data["uses"],
        "at": at, "until": "", "successor": "",
    }  # fmt: skip
    release = version.release if version else data["version"]
    found, last = connection.execute(_OF_RELEASE, {"of": name_id, "is_release": release}).one()
    is_known = found is not None
    version_id = found if is_known else (last or 0) + 1
    if not is_known:
        row = {"id": version_id, "name_id": name_id, "release": release, **values}
        connection.execute(_INSERT_VERSION, row)
    else:
        connection.execute(update(VERSIONS).where(VERSIONS.c.id == version_id).values(**values))
        connection.execute(delete(USES).where(USES.c.version_id == version_id))
    connection.execute(_SET_NEWEST, {"of": name_id})
    if data["kind"] == "function":
        _index_uses(connection, version_id, from_json(content_of(connection, data["uses"])))
    if is_known or data.get("broken"):
        _ask_owners(connection, version_id, data)


def _ask_owners(connection: Connection, version_id: int, data: _Data) -> None:
    """Replace the requests for approval of a version. Decisions about earlier content are kept."""
    of_version = APPROVALS.c.version_id == version_id
    connection.execute(delete(APPROVALS).where(of_version, APPROVALS.c.decision == ""))
    connection.execute(update(APPROVALS).where(of_version).values(functions=""))
    for owner, functions in data.get("broken", {}).items():
        key = {"version_id": version_id, "content": data["content"], "uses": data["uses"], "owner": owner}
        values = {"functions": ", ".join(functions)}
        same = and_(*(APPROVALS.c[name] == value for name, value in key.items()))
        if connection.execute(update(APPROVALS).where(same).values(**values)).rowcount == 0:
            undecided = {"decision": "", "at": "", "until": "", "reason": ""}
            connection.execute(insert(APPROVALS).values(**key, **values, **undecided))


def _index_uses(connection: Connection, version_id: int, uses: Sequence[Use]) -> None:
    relied = [use.relied for use in uses]
    wanted = {(use.path, text): None for use, text in zip(uses, relied, strict=True) if text}
    reliances = _reliances(connection, wanted)
    rows = [
        {
            "version_id": version_id, "number": number, "path": use.path, "element": use.element,
            "reliance_id": reliances.get((use.path, text)), "text": row_text(use, text),
        }
        for number, (use, text) in enumerate(zip(uses, relied, strict=True))
    ]  # fmt: skip
    if rows:
        connection.execute(_INSERT_USES, rows)


_OF_PATHS = select(RELIANCES).where(RELIANCES.c.path.in_(bindparam("paths", expanding=True)))
_Reliance = tuple[str, str]
"""Path of a node, and the attributes that a function relies on."""


def _reliances(connection: Connection, wanted: Mapping[_Reliance, None]) -> Mapping[_Reliance, int]:
    """Ids of reliances; new ones are added."""
    found: dict[_Reliance, int] = {}
    for paths in portions(list(dict.fromkeys(path for path, _ in wanted))):
        for number, path, relied in connection.execute(_OF_PATHS, {"paths": paths}):
            found[path, relied] = number
    new = [each for each in wanted if each not in found]
    if new:
        first = _next(connection, RELIANCES.c.id)
        rows = [{"id": number, "path": path, "relied": relied} for number, (path, relied) in enumerate(new, first)]
        connection.execute(insert(RELIANCES), rows)
        found.update((each, number) for number, each in enumerate(new, first))
    return found


def portions(values: Sequence[Any]) -> Iterator[Sequence[Any]]:
    """Parts of values that are not too many for one statement."""
    return (values[start : start + PORTION] for start in range(0, len(values), PORTION))


def _rule(connection: Connection, data: _Data, _at: str) -> None:
    name_id = _name_id(connection, data["kind"], data["name"])
    connection.execute(update(NAMES).where(NAMES.c.id == name_id).values(rule=data["rule"]))


def _state(connection: Connection, data: _Data, _at: str) -> None:
    """Set the state. Another deprecation, such as one with an earlier date, has to be acknowledged again."""
    version_id = _version_id(connection, data["kind"], data["name"], data["version"])
    values = {"state": data["state"], "until": data["until"], "successor": data["successor"]}
    connection.execute(update(VERSIONS).where(VERSIONS.c.id == version_id).values(**values))
    connection.execute(delete(ACKNOWLEDGEMENTS).where(ACKNOWLEDGEMENTS.c.version_id == version_id))
    connection.execute(_SET_NEWEST, {"of": _name_id(connection, data["kind"], data["name"])})


def _acknowledge(connection: Connection, data: _Data, at: str) -> None:
    version_id = _version_id(connection, data["kind"], data["name"], data["version"])
    connection.execute(insert(ACKNOWLEDGEMENTS), {"version_id": version_id, "owner": data["owner"], "at": at})


def _approve(connection: Connection, data: _Data, at: str) -> None:
    _decide(connection, data, decision="approved", at=at, until=data["until"], reason="")


def _reject(connection: Connection, data: _Data, at: str) -> None:
    _decide(connection, data, decision="rejected", at=at, until="", reason=data["reason"])


def _decide(connection: Connection, data: _Data, **values: str) -> None:
    version_id = _version_id(connection, data["kind"], data["name"], data["version"])
    same = [APPROVALS.c[name] == data[name] for name in ("content", "uses", "owner")]
    connection.execute(update(APPROVALS).where(APPROVALS.c.version_id == version_id, *same).values(**values))


def _deployment(connection: Connection, data: _Data, at: str) -> None:
    """End the support of all other versions of the function in the line, and record this one."""
    _end(connection, data, at)
    _release(connection, data, at)


def _release(connection: Connection, data: _Data, at: str) -> None:
    line_id = _name_id(connection, "line", data["line"])
    version_id = _version_id(connection, "function", data["name"], data["version"])
    row = {"id": _next(connection, DEPLOYMENTS.c.id), "line_id": line_id, "version_id": version_id, "since": at}
    connection.execute(insert(DEPLOYMENTS), {**row, "until": ""})


def _support_ended(connection: Connection, data: _Data, at: str) -> None:
    _end(connection, data, at, data["version"])


def _end(connection: Connection, data: _Data, at: str, version: str = "") -> None:
    line_id = _name_id(connection, "line", data["line"])
    versions = select(VERSIONS.c.id).join(NAMES).where(NAMES.c.kind == "function", NAMES.c.name == data["name"])
    if version:
        versions = versions.where(VERSIONS.c.version == version)
    running = (DEPLOYMENTS.c.line_id == line_id) & (DEPLOYMENTS.c.until == "") & DEPLOYMENTS.c.version_id.in_(versions)
    connection.execute(update(DEPLOYMENTS).where(running).values(until=at))


_NAMED = select(NAMES.c.id).where(
    NAMES.c.kind == bindparam("kind"), NAMES.c.folded == bindparam("folded"), NAMES.c.name == bindparam("name")
)


def _name_id(connection: Connection, kind: str, name: str) -> int:
    """The id of a name, which is added if it is new."""
    key = {"kind": kind, "folded": name.casefold(), "name": name}
    name_id: int | None = connection.execute(_NAMED, key).scalar()
    if name_id is None:
        name_id = _next(connection, NAMES.c.id)
        connection.execute(insert(NAMES), {"id": name_id, **key, "rule": "backward"})
    return name_id


def _next(connection: Connection, column: "Column[int]") -> int:
    """The next free number, which is the same when the log is applied again."""
    return int(connection.execute(_LAST[column]).scalar() or 0) + 1


_LAST = {table.c.id: select(func.max(table.c.id)) for table in (NAMES, RELIANCES, DEPLOYMENTS)}


def _version_id(connection: Connection, kind: str, name: str, version: str) -> int:
    found = select(VERSIONS.c.id).join(NAMES)
    found = found.where(NAMES.c.kind == kind, NAMES.c.name == name, VERSIONS.c.version == version)
    return int(connection.execute(found).scalar_one())


_ACTIONS: Mapping[Action, Callable[[Connection, _Data, str], None]] = {
    "publish": _publish, "rule": _rule, "state": _state, "deployment": _deployment, "release": _release,
    "support ended": _support_ended, "approve": _approve, "reject": _reject, "acknowledge": _acknowledge,
}  # fmt: skip
