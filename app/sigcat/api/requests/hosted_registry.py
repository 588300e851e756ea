"""The registry that the service hosts, if its project has one. SQLAlchemy is loaded with the first question."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from fastapi import Depends, Request

from sigcat import codes
from sigcat.errors import NotFound
from sigcat.limits import REGISTRY_REQUEST_SECONDS
from sigcat.project.project import RegistrySettings, ServerUrl
from sigcat.registry.reference import unusable

if TYPE_CHECKING:
    from sigcat.registry.author import Author
    from sigcat.registry.storing.database import Snapshot
    from sigcat.registry.storing.ledger import Registry

_NONE = (
    "The service has no registry. Add a table [registry] with `database` to its sigcat.toml, and install the extra "
    "`registry`."
)


class HostedRegistry:
    """A registry that must not disappear while the service runs: an empty one in its place would be a wrong answer."""

    def __init__(self, settings: RegistrySettings) -> None:
        self.settings = settings
        self._was_there = False

    @contextmanager
    def reading(self) -> "Iterator[Snapshot]":
        """One state of the registry. Raises RegistryUnusable."""
        from sigcat.registry.storing.database import reading

        self.refuse_gone()
        with reading(self.settings.database) as connection:
            yield connection

    def written_by(self, author: "Author") -> "Registry":
        """The registry to write to. Raises RegistryUnusable."""
        from sigcat.registry.storing.ledger import Registry

        self.refuse_gone()
        return Registry(self.settings.database, self.settings.key, author, REGISTRY_REQUEST_SECONDS)

    def present(self) -> Path | ServerUrl:
        """The database, for work in another process. Raises RegistryUnusable."""
        self.refuse_gone()
        return self.settings.database

    def refuse_gone(self) -> None:
        """Raises RegistryUnusable if the database was there before, and is not now."""
        database = self.settings.database
        is_there = not isinstance(database, Path) or database.exists()
        if self._was_there and not is_there:
            fix = "Restore the file from a backup or an export."
            raise unusable(codes.REGISTRY_UNUSABLE.finding("The database is gone.", str(database), fix=fix))
        self._was_there = is_there


async def _registry(request: Request) -> HostedRegistry:
    found: HostedRegistry | None = request.app.state.registry
    if found is None:
        raise NotFound(_NONE)
    return found


TheRegistry = Annotated[HostedRegistry, Depends(_registry)]
