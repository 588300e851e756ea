"""The databases in which a registry can be: the same tests run in each."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from sigcat.registry.storing.database import Place
from tests.needs import HAS_POSTGRESQL, postgresql
from tests.registry.server import Server, programs, running


@pytest.fixture(scope="session")
def server() -> Iterator[Server]:
    """A PostgreSQL server."""
    folder = programs()
    assert folder is not None
    assert HAS_POSTGRESQL
    with running(folder) as started:
        yield started


@pytest.fixture(params=["sqlite", pytest.param("postgresql", marks=postgresql)])
def place(request: pytest.FixtureRequest, tmp_path: Path) -> Place:
    """A database that does not have a registry yet."""
    if request.param == "sqlite":
        return tmp_path / "registry.db"
    server: Server = request.getfixturevalue("server")
    return server.new_database()
