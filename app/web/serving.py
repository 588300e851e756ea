"""Run the service."""

import uvicorn

from app.api.settings import DEFAULT_SETTINGS, Settings
from app.catalogue.hosting import Library
from app.web.site import create_site


class _Server(uvicorn.Server):
    """Says where it listens once it does: with port 0 nobody knows before."""

    async def startup(self, sockets: list[object] | None = None) -> None:  # type: ignore[override]
        await super().startup(sockets)  # type: ignore[arg-type]
        for server in self.servers:
            for socket in server.sockets:
                host, port = socket.getsockname()[:2]
                shown = f"[{host}]" if ":" in host else host
                print(f"sigcat is at http://{shown}:{port}  (Ctrl+C ends it)", flush=True)  # noqa: T201


def serve(library: Library, host: str, port: int, settings: Settings = DEFAULT_SETTINGS) -> None:
    """Serve until interrupted; requests under way are finished."""
    application = create_site(library, settings)
    config = uvicorn.Config(
        application, host=host, port=port, log_level="warning", server_header=False, timeout_graceful_shutdown=10
    )
    _Server(config).run()
