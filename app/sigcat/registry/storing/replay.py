"""Apply entries of the log to the tables: at once when they are written, and again to verify or import a registry."""

from collections.abc import Callable, Mapping
from typing import Any

from sqlalchemy import Connection, and_, delete, insert, select, update

from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.entry import Action, Entry
from sigcat.registry.storing.tables import APPROVALS, DEPLOYMENTS, NAMES, USES, VERSIONS
from sigcat.registry.use import from_json
from sigcat.registry.version import version_of

_Data = Mapping[str, Any]


def apply(connection: Connection, entry: Entry) -> None:
    """Change the tables as an entry says."""
    _ACTIONS[entry.action](connection, entry.data, entry.at)


def _publish(connection: Connection, data: _Data, at: str) -> None:
    name_id = _name_id(connection, data["kind"], data["name"])
    version = version_of(data["version"])
    values = {
        "version": data["version"], "state": data["state"], "owner": data["owner"], "content": data["content"],
        "resolved": data["resolved"], "uses": data["uses"], "at": at, "until": "", "successor": "",
    }  # fmt: skip
    release = version.release if version else data["version"]
    at_release = (VERSIONS.c.name_id == name_id) & (VERSIONS.c.release == release)
    version_id = connection.execute(select(VERSIONS.c.id).where(at_release)).scalar()
    if version_id is None:
        row = connection.execute(insert(VERSIONS).values(name_id=name_id, release=release, **values))
        version_id = row.inserted_primary_key[0]  # type: ignore[index]
    else:
        connection.execute(update(VERSIONS).where(VERSIONS.c.id == version_id).values(**values))
        connection.execute(delete(USES).where(USES.c.version_id == version_id))
    _index_uses(connection, version_id, data)
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


def _index_uses(connection: Connection, version_id: int, data: _Data) -> None:
    if data["kind"] != "function":
        return
    rows = [
        {"version_id": version_id, "number": number, "path": use.path, "element": use.element, "relied": use.relied}
        for number, use in enumerate(from_json(content_of(connection, data["uses"])))
    ]
    if rows:
        connection.execute(insert(USES), rows)


def _rule(connection: Connection, data: _Data, _at: str) -> None:
    name_id = _name_id(connection, data["kind"], data["name"])
    connection.execute(update(NAMES).where(NAMES.c.id == name_id).values(rule=data["rule"]))


def _state(connection: Connection, data: _Data, _at: str) -> None:
    version_id = _version_id(connection, data["kind"], data["name"], data["version"])
    values = {"state": data["state"], "until": data["until"], "successor": data["successor"]}
    connection.execute(update(VERSIONS).where(VERSIONS.c.id == version_id).values(**values))


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
    connection.execute(insert(DEPLOYMENTS).values(line_id=line_id, version_id=version_id, since=at, until=""))


def _support_ended(connection: Connection, data: _Data, at: str) -> None:
    _end(connection, data, at, data["version"])


def _end(connection: Connection, data: _Data, at: str, version: str = "") -> None:
    line_id = _name_id(connection, "line", data["line"])
    versions = select(VERSIONS.c.id).join(NAMES).where(NAMES.c.kind == "function", NAMES.c.name == data["name"])
    if version:
        versions = versions.where(VERSIONS.c.version == version)
    running = (DEPLOYMENTS.c.line_id == line_id) & (DEPLOYMENTS.c.until == "") & DEPLOYMENTS.c.version_id.in_(versions)
    connection.execute(update(DEPLOYMENTS).where(running).values(until=at))


def _name_id(connection: Connection, kind: str, name: str) -> int:
    """The id of a name, which is added if it is new."""
    found = select(NAMES.c.id).where(NAMES.c.kind == kind, NAMES.c.name == name)
    name_id: int | None = connection.execute(found).scalar()
    if name_id is None:
        values = {"kind": kind, "name": name, "folded": name.casefold(), "rule": "backward"}
        name_id = connection.execute(insert(NAMES).values(**values)).inserted_primary_key[0]  # type: ignore[index]
    assert name_id is not None
    return name_id


def _version_id(connection: Connection, kind: str, name: str, version: str) -> int:
    found = select(VERSIONS.c.id).join(NAMES)
    found = found.where(NAMES.c.kind == kind, NAMES.c.name == name, VERSIONS.c.version == version)
    return int(connection.execute(found).scalar_one())


_ACTIONS: Mapping[Action, Callable[[Connection, _Data, str], None]] = {
    "publish": _publish, "rule": _rule, "state": _state, "deployment": _deployment, "release": _release,
    "support ended": _support_ended, "approve": _approve, "reject": _reject,
}  # fmt: skip
