"""Small catalogues and functions, published in separate registries."""

from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from pathlib import Path

from sqlalchemy import Connection

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.function.function_file import CheckedFunction
from sigcat.function.function_json.model import to_json
from sigcat.function.sets.check_set import read_set
from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.published import Published, version_named
from sigcat.registry.reference import Reference
from sigcat.registry.storing.ledger import Ledger
from sigcat.registry.use import to_json as uses_json
from sigcat.registry.use import uses_of
from tests.catalogue.trees import ROOT, catalogue_of

NAMES = ("Alpha", "Beta", "Gamma", "Delta")
SIGNALS = ("S0", "S1", "S2", "S3")


def catalogue(datatypes: Mapping[str, str] = {}, *, without: Iterable[str] = (), text: str = "A signal.") -> Catalogue:
    """A catalogue whose signals an overlay defines, so that a function has to provide them."""
    calls = "".join(
        f"Vehicle.{name}: {{type: branch, description: A function.}}\n"
        f"Vehicle.{name}.Scheduling: {{type: branch, description: Calls.}}\n"
        f"Vehicle.{name}.Scheduling.Step: {{type: branch, description: Runs., runType: Cyclic, cycleTime: 10, priority: 1,"
        " scheduling: Preemptive, ASILlevel: QM}\n"
        for name in (f"Function.{each}" for each in NAMES)
    )
    signals = "".join(
        f"Vehicle.{name}: {{type: sensor, datatype: {datatypes.get(name, 'float')}, description: {text}}}\n"
        for name in SIGNALS
        if name not in without
    )
    functions = "Vehicle.Function: {type: branch, description: Functions.}\n"
    return catalogue_of(ROOT, f"{functions}{calls}{signals}")


def declaration(name: str, provided: Iterable[str] = (), consumed: Iterable[str] = (), version: str = "1.0.0") -> bytes:
    """A function.yaml."""
    data = [f"{{path: Vehicle.{each}, role: {role}}}" for role, signals in (("provided", provided), ("consumed", consumed)) for each in signals]  # fmt: skip
    return (
        f"function: {name}\ndescription: An example.\nresponsible: Team {name}\nversion: {version}\n"
        f"components: [{{name: {name}, runnables: [{{interface: {name}_Step, data: [{', '.join(data)}]}}]}}]\n"
    ).encode()


@lru_cache(maxsize=10_000)
def checked(content: bytes, over: Catalogue, file: str = "function.yaml") -> CheckedFunction:
    """The function of a declaration, which may have errors."""
    ((member,), _) = read_set([(content, file)], over)
    return member


@lru_cache(maxsize=10_000)
def candidate(content: bytes, over: Catalogue, file: str = "function.yaml") -> Candidate:
    """A candidate of a declaration without errors."""
    ((member,), extended) = read_set([(content, file)], over)
    function = member.sound_function
    assert function is not None, member.findings
    info = function.info
    uses = uses_json(uses_of(function, over, extended))
    owner = info.function_responsible.raw
    return Candidate("function", info.function_name, info.version or "", owner, content, to_json(function), uses, file)


def add(connection: Connection, *candidates: Candidate) -> None:
    """Write candidates into the log, without asking whether their versions rise."""
    ledger = Ledger(connection, None)
    for each in candidates:
        data = {
            "kind": each.kind,
            "name": each.name,
            "version": each.version,
            "state": "published",
            "owner": each.owner,
        }
        digests = {
            **dict(
                zip(("content", "resolved", "uses"), ledger.put(each.content, each.resolved, each.uses), strict=True)
            ),
        }
        ledger.append("publish", data | digests)


def deploy(connection: Connection, line: str, references: Sequence[Reference]) -> None:
    """Record versions beside each other."""
    for each in references:
        Ledger(connection, None).append("release", {"line": line, "name": each.name, "version": each.version})


def published(connection: Connection, reference: Reference) -> Published:
    """A published function."""
    return version_named(connection, "function", reference)


def plain_candidate(name: str, version: str, content: bytes = b"text", folder: Path = Path()) -> Candidate:
    """An overlay without nodes: publishing it takes no more than the registry does."""
    return Candidate("overlay", name, version, "A team", content, b"{}", b"", str(folder / name))
