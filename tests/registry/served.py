"""A small registry with a signed log, and the service over it."""

from pathlib import Path

from sigcat.api.application import create_app
from sigcat.catalogue.hosting.library import Library
from sigcat.project.project import RegistrySettings
from sigcat.registry.lines import record
from sigcat.registry.publish import publish
from sigcat.registry.reference import Reference
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.signing import new_key
from tests.api.conftest import Ask, asker
from tests.registry.parts import candidate, catalogue, declaration

LINE = "SUV-2025"
CONTENT = b"""\
function: CoreAcc
description: An example.
responsible: Team CoreAcc
version: 1.0.0
define: {scheduling: {Step: {cycleTime: 100, priority: 10, asil: QM, description: Runs.}}}
components:
  - name: CoreAcc
    runnables:
      - {interface: Step, data: [{path: Vehicle.S0, role: provided}, {path: Vehicle.S1, role: consumed}]}
"""


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
    """A function that asks a service with a registry and no catalogue."""
    return asker(create_app(Library(()), registry=settings_of(registry)))
