"""The registry: what a change breaks, who uses a path, and publishing beside the bare driver."""

import random
import sqlite3
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from statistics import median
from time import perf_counter, process_time

from bench.rows import Bench, Row, time_of
from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.function.document.read_json import read_json
from sigcat.function.function_file import CheckedFunction
from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.compatibility.breaking import broken_by_catalogue, broken_by_functions
from sigcat.registry.compatibility.member import Member
from sigcat.registry.publish import publish
from sigcat.registry.storing.database import reading
from sigcat.registry.storing.ledger import Registry, ledger_of
from sigcat.registry.use import Use, to_json
from sigcat.registry.users import users_of

_SIGNALS, _LINES, _USES = 5_000, 20, 100
_VALUES = {"type": "sensor", "datatype": "float", "unit": "km/h", "min": 0, "max": 250}
_TABLES = ("contents", "names", "versions", "reliances", "uses", "log")


def check(bench: Bench) -> Row:
    """A catalogue with one other unit beside 1,000 functions with 100 signals each, in 20 lines."""
    database, changed = _registry(bench.folder, 1_000, _paths(_SIGNALS)), read_catalogue(_tree(bench.folder))
    taken = []
    for _ in range(2 * bench.runs):
        start = process_time()
        with reading(database) as connection:
            assert broken_by_catalogue(connection, changed, "tree")
        taken.append(process_time() - start)
    work = "check a changed unit against 1,000 functions of 100 signals, processor time"
    return Row(work, time_of(median(taken)), "", "", "under 100 ms", median(taken) < 0.1)


def check_functions(bench: Bench) -> Row:
    """A function file beside 1,000 functions with 100 signals each, in 20 lines: one of them reports the same error."""
    database = _registry(bench.folder, 1_000, _paths(_SIGNALS))
    uses = (Use("consumes", "Vehicle.Other", "Other", "New_Step"), Use("reports", "", "Function0_Error0", "New_Step"))
    checked = CheckedFunction(read_json(b"{}", "new.json"), None, ())
    taken = []
    for _ in range(2 * bench.runs):
        start = process_time()
        with reading(database) as connection:
            broken_by_functions(connection, [Member("New", "", "A team", uses, lambda: checked)])
        taken.append(process_time() - start)
    work = "check a function against 1,000 functions of 100 signals, processor time"
    return Row(work, time_of(median(taken)), "", "", "under 100 ms", median(taken) < 0.1)


def users(bench: Bench) -> Row:
    """Users of a signal among 1,000,000 uses, with the errors and modes that follow."""
    paths = _paths(10 * _SIGNALS)
    database, chance = _registry(bench.folder, 10_000, paths), random.Random(1)
    p99 = median(_p99(database, chance.sample(paths, 300)) for _ in range(bench.runs))
    return Row(
        "users of a signal among 1,000,000 uses, p99 of processor time", time_of(p99), "", "", "under 10 ms", p99 < 0.01
    )


def _p99(database: Path, paths: Iterable[str]) -> float:
    taken = []
    for path in paths:
        start = process_time()
        with reading(database) as connection:
            assert users_of(connection, path).users
        taken.append(process_time() - start)
    return sorted(taken)[int(len(taken) * 0.99)]


def publishing(bench: Bench) -> Row:
    """Versions of a function, each durable, beside the same rows from the bare driver."""
    rates = [_rates(bench.folder, run) for run in range(bench.runs)]
    ours, bare = (median(column) for column in zip(*rates, strict=True))
    ratio = median(mine / theirs for mine, theirs in rates)
    work = "versions published in a second, durable"
    return Row(
        work, f"{ours:.0f}/s", f"the same rows by the bare driver: {bare:.0f}/s", f"{ratio:.2f} ×", "at least 0.25 ×",
        ratio >= 0.25,
    )  # fmt: skip


ROWS: Mapping[str, Callable[[Bench], Row]] = {
    "registry-check": check, "registry-functions": check_functions, "registry-users": users, "registry-publish": publishing,
}  # fmt: skip


def _paths(count: int) -> tuple[str, ...]:
    return tuple(f"Vehicle.Branch{number % 100}.Signal{number}" for number in range(count))


def _registry(folder: Path, functions: int, paths: Sequence[str]) -> Path:
    """A registry with functions of random signals; every tenth signal sets an error."""
    database, chance = folder / f"{functions}.db", random.Random(1)
    with ledger_of(Registry(database)) as ledger:
        for number in range(functions):
            name = f"Function{number}"
            uses = to_json(_uses(name, chance.sample(paths, _USES)))
            digests = dict(zip(("content", "resolved", "uses"), ledger.put(name.encode(), b"{}", uses), strict=True))
            data = {"kind": "function", "name": name, "version": "1.0.0", "state": "published", "owner": "A team"}
            ledger.append("publish", data | digests)
            ledger.append("release", {"line": f"Line{number % _LINES}", "name": name, "version": "1.0.0"})
    return database


def _uses(name: str, paths: Iterable[str]) -> Iterator[Use]:
    for number, path in enumerate(paths):
        error = f"{name}_Error{number}"
        is_cause = number % 10 == 0
        signal = path.rpartition(".")[2]
        yield Use("consumes", path, signal, f"{name}_Step", "inputs", values=_VALUES, is_in_catalogue=True,
                  leads_to=(error,) if is_cause else ())  # fmt: skip
        if is_cause:
            yield Use("reports", "", error, f"{name}_Step", leads_to=(f"{name}_Mode",))
    yield Use("sends", "", f"{name}_Mode", f"{name}_Step")


def _tree(folder: Path) -> Path:
    """The catalogue of the signals, in which one has another unit."""
    paths = _paths(_SIGNALS)
    branches = {"Vehicle", *(path.rpartition(".")[0] for path in paths)}
    lines = [f"{path}: {{type: branch, description: A branch.}}\n" for path in sorted(branches)]
    lines += [
        f"{path}: {{type: sensor, datatype: float, unit: {'m/s' if path == paths[17] else 'km/h'}, min: 0, max: 250,"
        " description: A signal.}\n"
        for path in paths
    ]
    file = folder / "tree.yaml"
    file.write_text("".join(lines), encoding="utf-8")
    return file


def _rates(folder: Path, run: int) -> tuple[float, float]:
    database, count = folder / f"published{run}.db", 200
    candidates = [_candidate(number) for number in range(count)]
    publish(Registry(database), [_candidate(count)])
    start = perf_counter()
    for candidate in candidates:
        publish(Registry(database), [candidate])
    ours = count / (perf_counter() - start)
    return ours, _bare_rate(database, folder / f"bare{run}.db")


def _candidate(number: int) -> Candidate:
    uses, name = to_json(_uses("Function", _paths(3))), f"Function{number % 7}"
    content = f"content {number}".encode()
    return Candidate("function", name, f"1.{number}.0", "A team", content, content + b" resolved", uses)


def _bare_rate(source: Path, database: Path) -> float:
    """Insert the rows of a registry into an equal database, each version with its rows in one durable transaction."""
    origin, copy = sqlite3.connect(source), sqlite3.connect(database, isolation_level=None)
    copy.execute("PRAGMA journal_mode = WAL")
    copy.execute("PRAGMA synchronous = FULL")
    for (statement,) in origin.execute("SELECT sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY rowid").fetchall():
        copy.execute(statement)
    rows = {table: origin.execute(f"SELECT * FROM {table}").fetchall() for table in _TABLES}
    shared = ("names", "reliances")
    for table in shared:
        _insert(copy, table, rows[table])
    contents = {row[0]: row for row in rows["contents"]}
    uses = {key: list(group) for key, group in groupby(rows["uses"], itemgetter(0))}
    start = perf_counter()
    for version, link in zip(rows["versions"], rows["log"], strict=True):
        copy.execute("BEGIN IMMEDIATE")
        _insert(copy, "contents", [contents.pop(value) for value in version if value in contents])
        _insert(copy, "versions", [version])
        _insert(copy, "uses", uses[version[0]])
        _insert(copy, "log", [link])
        copy.execute("COMMIT")
    rate = len(rows["versions"]) / (perf_counter() - start)
    copy.close()
    origin.close()
    return rate


def _insert(connection: sqlite3.Connection, table: str, rows: list[tuple[object, ...]]) -> None:
    if rows:
        marks = ", ".join("?" * len(rows[0]))
        connection.executemany(f"INSERT INTO {table} VALUES ({marks})", rows)
