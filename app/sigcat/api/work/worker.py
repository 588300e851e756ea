"""A worker process: one piece of work after another, until the service closes the connection to it.

The module of the zygote of the service: `keep` and `prepare` run in that, `serve` in its children.
"""

import fcntl
import gc
import importlib
import io
import logging
import os
import pickle
import resource
import socket
import sys
import traceback
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import BaseModel

from sigcat.api.json_log import log_as_json
from sigcat.api.work.references import unpickled
from sigcat.catalogue.exporting.vss_tools.processes import keep_warm
from sigcat.errors import SigcatError
from sigcat.names import bounded_proposals
from sigcat.zygote import read_message, write_message

_kept: dict[int, Any] = {}
"""Catalogues and rules by number."""
EXPORTS = "exports"
"""The kind of workers that export."""
_GROWTH = 8 * 1024 * 1024
"""Bytes of memory that a worker may keep from work that is done; one with more is replaced."""
_STATUS = Path("/proc/self/status")
_FIRST_TO_END = "1000"
"""To the system: where memory runs out, end this process before any other."""


class Told(NamedTuple):
    """A message from the service to the zygote."""

    modules: tuple[str, ...] = ()
    """Modules to import."""
    values: Mapping[int, object] = {}
    """Values to keep."""
    forgotten: tuple[int, ...] = ()
    """Values that are no longer referred to."""
    rehearsals: tuple[bytes, ...] = ()
    """Work to do once: what that imports, compiles and caches, all later workers have."""


class Outcome(NamedTuple):
    """Result of a piece of work, or the exception that it raised."""

    result: Any = None
    error: Exception | None = None
    is_last: bool = False
    """Whether the worker ends after it."""
    modules: tuple[str, ...] = ()
    """Modules of sigcat that the work loaded, if the worker ends after it: the next one needs them from the start."""


def keep(data: bytes) -> None:
    """Process a message."""
    told: Told = pickle.loads(data)  # noqa: S301 - from the service that started this process
    for name in told.modules:
        importlib.import_module(name)
    _build_models_below(BaseModel)
    _kept.update(told.values)
    for number in told.forgotten:
        _kept.pop(number, None)
    for rehearsal in told.rehearsals:
        _rehearse(rehearsal)
    gc.collect()


def _rehearse(data: bytes) -> None:
    with suppress(Exception):  # it shows when a worker does the same
        function, arguments, options = unpickled(io.BytesIO(data), _kept)
        function(*arguments, **options)


def _build_models_below(model: type[BaseModel]) -> None:
    """Build models here that are otherwise built when they are first used: each worker would do so again."""
    for below in model.__subclasses__():
        if below.model_config.get("defer_build") and not below.__pydantic_complete__:
            below.model_rebuild()
        _build_models_below(below)


def prepare(kind: str) -> None:
    """Get ready for a worker of this kind."""
    if kind == EXPORTS:
        log_as_json(logging.WARNING)
        keep_warm()


def serve(connection: socket.socket) -> None:
    """Do the work that arrives over the connection, after the bytes of memory that each piece may take."""
    memory = int(read_message(connection) or 0)
    with suppress(OSError):
        Path("/proc/self/oom_score_adj").write_text(_FIRST_TO_END)
    warm, loaded = _memory(), frozenset(sys.modules)
    while (work := _next_work(connection)) is not None:
        with _ended_with(connection):
            outcome = _outcome(work, warm, memory)
            if outcome.is_last and outcome.error is None:
                outcome = outcome._replace(modules=_loaded_since(loaded))
            data = pickle.dumps(outcome, pickle.HIGHEST_PROTOCOL)
        write_message(connection, data)
        if outcome.is_last:
            return


def _next_work(connection: socket.socket) -> io.BytesIO | None:
    message = read_message(connection)
    return None if message is None else io.BytesIO(message)


def _loaded_since(before: frozenset[str]) -> tuple[str, ...]:
    """Modules of sigcat that were loaded after others, in the order of their imports."""
    return tuple(name for name in sys.modules if name not in before and name.startswith("sigcat."))


def _outcome(work: io.BytesIO, warm: "_Memory", memory: int) -> Outcome:
    try:
        with _bounded_memory(warm.data + memory), bounded_proposals():
            function, arguments, options = unpickled(work, _kept)
            result = function(*arguments, **options)
    except (MemoryError, SystemError) as error:  # the second where CPython had no memory left for the first
        return Outcome(error=MemoryError(*error.args), is_last=True)
    except (SigcatError, OSError) as error:
        return Outcome(error=error)
    except Exception as error:  # noqa: BLE001 - the service tells its log of it
        failure = RuntimeError(f"{type(error).__name__}: {error}")
        failure.add_note(traceback.format_exc())
        return Outcome(error=failure)
    return Outcome(result, is_last=_memory().resident - warm.resident > _GROWTH)


@contextmanager
def _ended_with(connection: socket.socket) -> Iterator[None]:
    """Meanwhile, the end of the connection ends this process at once, whatever it does: the system sends it SIGIO.

    That is how work ends that is given up, and all work when the service ends, even by force.
    """
    flags = fcntl.fcntl(connection, fcntl.F_GETFL)
    fcntl.fcntl(connection, fcntl.F_SETOWN, os.getpid())
    fcntl.fcntl(connection, fcntl.F_SETFL, flags | os.O_ASYNC)
    if _is_closed(connection):  # it was before
        raise ConnectionError
    yield
    fcntl.fcntl(connection, fcntl.F_SETFL, flags)


def _is_closed(connection: socket.socket) -> bool:
    try:
        return not connection.recv(1, socket.MSG_PEEK | socket.MSG_DONTWAIT)
    except BlockingIOError:
        return False


@contextmanager
def _bounded_memory(most: int) -> Iterator[None]:
    """Meanwhile, asking the system for more memory than this is a MemoryError."""
    before = resource.getrlimit(resource.RLIMIT_DATA)
    resource.setrlimit(resource.RLIMIT_DATA, (most, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_DATA, before)


class _Memory(NamedTuple):
    """Bytes of memory of this process."""

    data: int
    """Bytes that RLIMIT_DATA bounds."""
    resident: int


def _memory() -> _Memory:
    """The memory of this process; nothing where the system does not tell: there it does not bound it either."""
    if not _STATUS.is_file():
        return _Memory(0, 0)
    fields = dict(line.split(":") for line in _STATUS.read_text().splitlines())
    return _Memory(*(int(fields[name].split()[0]) * 1024 for name in ("VmData", "VmRSS")))
