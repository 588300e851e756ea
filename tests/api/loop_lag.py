"""A service whose event loop is watched: `python -m tests.api.loop_lag TREE` serves it, and `/lag` answers how long the loop stood still.

What is measured is not wall-clock time, which a busy machine lengthens: it is the processor time that the process used between two
turns of a task that the loop has to run every millisecond. That includes other threads, which block the loop where they do not
let go of the interpreter.
"""

import asyncio
import json
import sys
from contextlib import suppress
from pathlib import Path
from time import process_time

import uvicorn
from sqlalchemy import insert, update
from starlette.types import Receive, Scope, Send

from sigcat.api.server import prepare, uvicorn_config
from sigcat.api.settings import Settings
from sigcat.api.tokens import token_from_text
from sigcat.catalogue.hosting.library import Library
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.catalogue.model.vehicle import Setting, Vehicle
from sigcat.registry.storing.database import writing
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.sessions import SESSIONS
from sigcat.registry.storing.tokens import TOKENS, create_token
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES
from tests.registry.served import settings_of, signed_registry

ADDRESS = "/lag"
_TURN = 0.001
_VEHICLES = tuple(
    Vehicle(f"v{n}", "A vehicle", "wide", "sigcat.toml", n, without=(Setting(f"Vehicle.S{n}", True, n, 1),))
    for n in range(1, 6)
)


def _registry(folder: Path, settings: Settings) -> Registry:
    """A registry with a token that is the one of the service, and a session whose secret is the token."""
    registry = signed_registry(folder)
    (token,) = settings.tokens
    with writing(registry.database) as connection:
        create_token(connection, token.name, ["administer"], "", "")
        connection.execute(update(TOKENS).values(digest=token.digest))
        SESSIONS.create(connection)
        connection.execute(
            insert(SESSIONS).values(
                digest=token.digest, token=token.digest, name="", scopes="", owner="", begun="", ends="9999"
            )
        )
    return registry


class Watched:
    """An application, and the longest time that its event loop stood still since it was last asked."""

    def __init__(self, settings: Settings, tree: Path) -> None:
        self._app = create_site(
            Library([*shipped_sources(), Source("wide", "A wide tree", tree, vehicles=_VEHICLES), SOURCES[0]]),
            settings,
            registry=settings_of(_registry(tree.parent, settings)),
        )
        self._longest = 0.0
        self._watching: asyncio.Task[None] | None = None
        prepare(self._app, settings)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer as the application does."""
        if self._watching is None:
            self._watching = asyncio.create_task(self._watch())
        if scope["type"] == "http" and scope["path"] == ADDRESS:
            longest, self._longest = self._longest, 0.0
            body = json.dumps(longest).encode()
            await send({"type": "http.response.start", "status": 200, "headers": []})
            await send({"type": "http.response.body", "body": body})
        else:
            await self._app(scope, receive, send)

    async def _watch(self) -> None:
        while True:
            before = process_time()
            await asyncio.sleep(_TURN)
            self._longest = max(self._longest, process_time() - before)


class _Server(uvicorn.Server):
    async def startup(self, sockets: list[object] | None = None) -> None:  # type: ignore[override]
        await super().startup(sockets)  # type: ignore[arg-type]
        print("http://{}:{}".format(*self.servers[0].sockets[0].getsockname()), flush=True)


def main() -> None:
    """Serve until killed."""
    settings = Settings(port=0, log="none", tokens=(token_from_text(sys.argv[2]),))
    watched = Watched(settings, Path(sys.argv[1]))
    with suppress(KeyboardInterrupt):
        _Server(uvicorn_config(watched, settings)).run()  # type: ignore[arg-type]


if __name__ == "__main__":
    main()
