"""A registry whose pages have a version that may not be deployed."""

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from sigcat.project.project import RegistrySettings
from sigcat.registry.lines import record, set_rule, set_state
from sigcat.registry.publish import publish
from sigcat.registry.reference import Reference
from sigcat.registry.storing.database import writing
from sigcat.registry.storing.entry import now
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.sqlite import close_all
from sigcat.registry.webhooks.addresses import Policy
from sigcat.registry.webhooks.deliveries import plan
from sigcat.registry.webhooks.subscriptions import subscribe
from tests.registry.parts import candidate, catalogue, declaration


def published(folder: Path) -> RegistrySettings:
    """Alpha 1.0.0 provides S0 to Beta and Gamma, and Alpha 2.0.0 does not."""
    database = folder / "registry.db"
    database.write_bytes(_content())
    return RegistrySettings(database)


@cache
def _content() -> bytes:
    """The file of the database, which is written once and copied: to publish takes much longer."""
    with TemporaryDirectory() as folder:
        registry = Registry(Path(folder, "registry.db"))
        _publish(registry)
        close_all()  # moves the write-ahead log into the file
        assert isinstance(registry.database, Path)
        return registry.database.read_bytes()


def _publish(registry: Registry) -> None:
    over = catalogue()
    first = (
        declaration("Alpha", ("S0",)),
        declaration("Beta", ("S1",), ("S0",)),
        declaration("Gamma", (), ("S0", "S1")),
    )
    publish(registry, [candidate(each, over) for each in first])
    for line, name in (("SUV-2025", "Alpha"), ("SUV-2025", "Beta"), ("VAN-2026", "Alpha")):
        record(registry, "deployment", line, Reference(name, "1.0.0"))
    publish(registry, [candidate(declaration("Alpha", ("S2",), version="2.0.0"), over)])
    set_rule(registry, "function", "Beta", "approval")
    publish(registry, [candidate(declaration("Beta", (), ("S0",), version="1.1.0"), over)])
    set_state(registry, "function", Reference("Gamma", "1.0.0"), "deprecated", "2040-01-31")
    subscribe(registry, "https://hooks.example.org/secret-path?token=1", (), Policy(("hooks.example.org",)))
    publish(registry, [candidate(declaration("Delta", ("S3",)), over)])
    with writing(registry.database) as connection:
        plan(connection, now())
        connection.exec_driver_sql("UPDATE deliveries SET state = 'failed', attempts = 12, answer = 'answered 503'")
