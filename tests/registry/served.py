"""A small registry with a signed log, and the service over it."""

from pathlib import Path

from sigcat.api.application import create_app
from sigcat.catalogue.hosting.library import Library, Source
from sigcat.project.project import RegistrySettings
from sigcat.registry.lines import record
from sigcat.registry.publish import publish
from sigcat.registry.reference import Reference
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.signing import new_key
from tests.api.conftest import SOURCES, Ask, asker
from tests.registry.parts import candidate, catalogue, declaration

LINE = "SUV-2025"
TREE = "Vehicle: {type: branch, description: A vehicle.}\n"
OVERLAY = "".join(
    f"Vehicle.{name}: {{type: sensor, datatype: float, description: A signal.}}\n" for name in ("S0", "S1", "S2", "S3")
)


def function_file(name: str, data: str, version: str = "1.0.0") -> bytes:
    """A function.yaml with its own schedule. `data` is a list such as `{path: Vehicle.S0, role: provided}`."""
    return (
        f"function: {name}\ndescription: An example.\nresponsible: Team {name}\nversion: {version}\n"
        "define: {scheduling: {Step: {cycleTime: 100, priority: 10, asil: QM, description: Runs.}}}\n"
        f"components: [{{name: {name}, runnables: [{{interface: Step, data: [{data}]}}]}}]\n"
    ).encode()


CONTENT = function_file("CoreAcc", "{path: Vehicle.S0, role: provided}, {path: Vehicle.S1, role: consumed}")


def signed_registry(folder: Path) -> Registry:
    """A registry with CoreAcc 1.0.0 in a line, Alpha 1.0.0 and 1.1.0, and a key."""
    registry = Registry(folder / "registry.db", folder / "registry.key")
    private, _ = new_key()
    (folder / "registry.key").write_bytes(private)
    over = catalogue()
    publish(registry, [candidate(CONTENT, over), candidate(declaration("Alpha", ("S1",)), over)])
    publish(registry, [candidate(declaration("Alpha", ("S1", "S2"), version="1.1.0"), over)])
    record(registry, "deployment", LINE, Reference("CoreAcc", "1.0.0"))
    return registry


def settings_of(registry: Registry) -> RegistrySettings:
    """The registry as a project file names it."""
    return RegistrySettings(registry.database, registry.key)


def asking(registry: Registry) -> Ask:
    """A function that asks a service with a registry."""
    return asker(create_app(Library(SOURCES[:1]), registry=settings_of(registry)))


def fleet(folder: Path) -> Source:
    """A catalogue of a tree, and of an overlay with the signals of the functions."""
    tree, overlay = folder / "tree.vspec", folder / "signals.vspec"
    tree.write_text(TREE, encoding="utf-8")
    overlay.write_text(OVERLAY, encoding="utf-8")
    return Source("fleet", "Fleet", tree, (overlay,))
