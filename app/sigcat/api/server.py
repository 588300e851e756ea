"""Run an application until it is stopped; requests under way are finished."""

import errno
import gc
import logging
import os
import socket
import sys
from multiprocessing import parent_process

import uvicorn
from fastapi import FastAPI

from sigcat.api.connections.http import HttpConnection
from sigcat.api.json_log import log_as_json
from sigcat.api.middleware.metrics import SHARED_FOLDER
from sigcat.api.request_lines import RequestLines
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import tell_errors
from sigcat.errors import UsageError

_log = logging.getLogger("sigcat")


class _Server(uvicorn.Server):
    """Says where it listens once it does: with port 0 it is not known before. Requests that wait for events end with it."""

    def __init__(self, application: FastAPI, settings: Settings) -> None:
        super().__init__(uvicorn_config(application, settings))
        self._application = application

    async def startup(self, sockets: list[object] | None = None) -> None:  # type: ignore[override]
        await super().startup(sockets)  # type: ignore[arg-type]
        for server in self.servers:
            for listening in server.sockets:
                host, port = listening.getsockname()[:2]
                shown = f"[{host}]" if ":" in host else host
                print(f"sigcat is at http://{shown}:{port}  (Ctrl+C ends it)", flush=True)  # noqa: T201

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        self._application.state.event_watch.close()
        await super().shutdown(sockets)


def run(application: FastAPI, settings: Settings) -> None:
    """Serve until a signal comes. Logs go to standard error.

    Raises UsageError if it cannot listen, and ends the process with 2 if the server finds this out later.
    """
    refuse_address_in_use(settings.host, settings.port)
    prepare(application, settings)
    try:
        _Server(application, settings).run()
    except SystemExit as ended:
        raise SystemExit(_COULD_NOT_RUN if ended.code else 0) from None


_COULD_NOT_RUN = 2


def refuse_address_in_use(host: str, port: int) -> None:
    """Raise UsageError if a host and a port cannot be listened on: the server would report it without advice."""
    try:
        addresses = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)
        for family, kind, protocol, _, address in addresses:
            with socket.socket(family, kind, protocol) as probe:
                probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
                if family == socket.AF_INET6:
                    probe.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
                probe.bind(address)
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            message = f"port {port} of {host} is in use. Choose another with --port, such as --port {port + 1}"
            raise UsageError(f"{message}; --port 0 picks a free one.") from None
        raise UsageError(
            f"cannot listen on port {port} of {host}: {error.strerror}. Choose others with --host and --port."
        ) from None


def prepare(application: FastAPI, settings: Settings) -> None:
    """Prepare a serving process: its log, the errors of its catalogues, fewer runs of the garbage collector."""
    log_as_json(logging.INFO if settings.log == "json" else logging.WARNING)
    if settings.log == "json":
        application.state.request_notes.log = RequestLines(sys.stderr).add
    tell_errors(application.state.library)
    if settings.reading == "token" and not any("read" in token.scopes for token in settings.tokens):
        _log.warning("reading needs a token, and none of `tokens` has the scope read: no client can read")
    if settings.metrics and parent_process() is not None and SHARED_FOLDER not in os.environ:
        _log.warning("/metrics has the figures of one worker; for a total let %s name an empty folder", SHARED_FOLDER)
    gc.set_threshold(50_000, 20)  # answers make much that is gone at once: cycles are looked for less often
    sys.setswitchinterval(0.001)  # seconds that a request waits while the thread for heavy work computes
    gc.freeze()  # the catalogues stay: a collection that walks them all would hold up every request for 50 ms


def uvicorn_config(application: FastAPI, settings: Settings) -> uvicorn.Config:
    """Return the configuration of uvicorn for these settings."""
    return uvicorn.Config(
        application,
        host=settings.host,
        port=settings.port,
        root_path=settings.root_path,
        proxy_headers=bool(settings.trusted_proxies),
        forwarded_allow_ips=list(settings.trusted_proxies),
        timeout_graceful_shutdown=settings.stop_seconds,
        http=HttpConnection,
        ws="none",
        log_config=None,
        access_log=False,
        server_header=False,
    )
