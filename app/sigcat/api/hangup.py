"""SIGHUP reads the files of all catalogues and functions again, as `POST …/reload` does for one of them."""

import asyncio
import logging
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from threading import current_thread, main_thread
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # a service ignores SIGHUP before it imports what takes time
    from sigcat.catalogue.hosting.library import Library
    from sigcat.function.hosting import FunctionLibrary

_log = logging.getLogger("sigcat.hosting")


def ignore_hangup() -> None:
    """Ignore SIGHUP while the service starts or stops."""
    if _may_be_handled():
        signal.signal(signal.SIGHUP, signal.SIG_IGN)


@contextmanager
def reloading_at_hangup(library: "Library", functions: "FunctionLibrary") -> Iterator[None]:
    """Reload at each SIGHUP meanwhile, in a thread: requests are answered from the earlier state until it is done."""
    if not _may_be_handled():
        yield
        return
    loop, tasks = asyncio.get_running_loop(), set[asyncio.Task[None]]()

    def begin() -> None:
        task = loop.create_task(asyncio.to_thread(_reload, library, functions))
        tasks.add(task)
        task.add_done_callback(tasks.discard)

    loop.add_signal_handler(signal.SIGHUP, begin)
    yield
    loop.remove_signal_handler(signal.SIGHUP)
    ignore_hangup()


def _may_be_handled() -> bool:
    return hasattr(signal, "SIGHUP") and current_thread() is main_thread()


def _reload(library: "Library", functions: "FunctionLibrary") -> None:
    _log.info("SIGHUP: the files of all catalogues and functions are read again")
    try:
        for hosted in library:
            library.reload(hosted.source.id)
        functions.reload()
    except Exception:  # noqa: BLE001 - what is hosted stays as it is
        _log.exception("the files could not be read again")
    else:
        _log.info("functions: read again, %d files, %d runs", len(functions.files), len(functions.runs))
