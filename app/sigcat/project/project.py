"""A project: what one `sigcat.toml` says, as a frozen value."""

import re
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.model.vehicle import Vehicle
from sigcat.catalogue.reading.toml_lines import Lines
from sigcat.rules.linting.options import LintOptions

FILE_NAME = "sigcat.toml"
POSTGRESQL = "postgresql://"
"""The begin of the URL of a PostgreSQL database."""


class ServerUrl(NamedTuple):
    """The URL of a database on a server. It is shown without its password."""

    text: str

    def __str__(self) -> str:
        return re.sub(r"(?<=[?&]password=)[^&]*", "***", re.sub(r"(?<=://)([^:@/]*):.*@", r"\1:***@", self.text))


class RegistrySettings(NamedTuple):
    """Place of the registry of published versions."""

    database: Path | ServerUrl
    """SQLite database, which the first publish creates, or the URL of a PostgreSQL database."""
    key: Path | None = None
    """Private key that signs the log."""
    webhook_hosts: tuple[str, ...] = ()
    """Hosts to which webhooks may be sent."""
    webhook_networks: tuple[str, ...] = ()
    """Private networks that these hosts may be in."""

    @property
    def files(self) -> tuple[Path, ...]:
        """Files of the registry."""
        return tuple(each for each in self if isinstance(each, Path))


class Project(NamedTuple):
    """The values of the file; without a file, the defaults. Paths are relative to the current folder, or absolute."""

    file: Path | None = None
    catalogues: tuple[Source, ...] = ()
    """In order, the default one first. Each has the units, quantities, types and include folders of the project."""
    vehicles: tuple[Vehicle, ...] = ()
    """One for each state of each vehicle, in the order of the file."""
    functions: tuple[Path, ...] = ()
    """Folders of functions."""
    rules: tuple[Path, ...] = ()
    units: tuple[Path, ...] = ()
    quantities: tuple[Path, ...] = ()
    types: tuple[Path, ...] = ()
    include_dirs: tuple[Path, ...] = ()
    dbc: tuple[Path, ...] = ()
    deployment: Path | None = None
    is_watching: bool = False
    shipped: bool | None = None
    """Whether to host what sigcat ships; None: the catalogues, and the functions unless the project has catalogues."""
    lint: LintOptions = LintOptions()
    registry: RegistrySettings | None = None
    registry_server: str = ""
    """Address of a service with the registry; empty: `registry`, if there is one."""
    tables: Mapping[str, Any] = MappingProxyType({})
    """The values that others made of their tables."""
    lines: Lines = Lines("")
    """Lines of the keys in the file."""

    @property
    def has_shipped_catalogues(self) -> bool:
        """Whether the catalogues that sigcat ships, and pulled releases, are hosted too."""
        return self.shipped is not False

    @property
    def has_shipped_functions(self) -> bool:
        """Whether the examples are hosted too. Beside the catalogue of a company they would be errors."""
        return not self.catalogues if self.shipped is None else self.shipped

    def line(self, table: str, number: int = 0, key: str = "") -> str:
        """The place of a key of a table: FILE:LINE."""
        return f"{self.file}:{self.lines.line(self._table(table), number, key)}"

    def has_key(self, key: str) -> bool:
        """Whether the file has a key before its tables."""
        return self.lines.has(self._table(""), key)

    def _table(self, name: str) -> str:
        """The name of a table in the file."""
        prefix = "tool.sigcat" if self.file is not None and self.file.name == "pyproject.toml" else ""
        return ".".join(filter(None, (prefix, name)))

    @property
    def files(self) -> tuple[Path, ...]:
        """The project file and the files that it names: no command writes over them."""
        named = (self.file, self.deployment, *(self.registry.files if self.registry else ()))
        overlays = (path for vehicle in self.vehicles for path in vehicle.overlays)
        lists = (*self.rules, *self.units, *self.quantities, *self.dbc, *overlays)
        return (*(path for path in named if path is not None), *lists)
