"""Servers to measure, each a process on the first core: `sigcat serve` as it is shipped, and the floor as its reference.

The floor is Starlette with a route that returns bytes made beforehand, on the same event loop and with the same parser.
"""

import os
import re
import resource
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from bench.measuring import ROOT

FLOOR = """
import uvicorn
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route
BODY = b"x" * 2000
async def floor(request: Request) -> Response:
    return Response(BODY, media_type="application/json")
class Server(uvicorn.Server):
    async def startup(self, sockets=None):
        await super().startup(sockets)
        print("http://%s:%d" % self.servers[0].sockets[0].getsockname(), flush=True)
application = Starlette(routes=[Route("/floor", floor)])
Server(uvicorn.Config(application, port=0, log_config=None, access_log=False, server_header=False)).run()
"""
SERVICE = """
import sys
from sigcat.cli import main
sys.exit(main(["serve", "--port", "0", *sys.argv[1:]]))
"""


_CORES = sorted(os.sched_getaffinity(0))
"""Those of this process before it has moved to the last one."""


class Server(NamedTuple):
    """A server in a separate process."""

    place: str
    """Host and port."""
    process: int

    @property
    def memory(self) -> int:
        """Bytes that it holds."""
        pages = int(Path(f"/proc/{self.process}/statm").read_text().split()[1])
        return pages * resource.getpagesize()

    @property
    def seconds(self) -> float:
        """Seconds of the processor that it has used, all its threads together."""
        threads = Path(f"/proc/{self.process}/task").glob("*/schedstat")
        return sum(int(thread.read_text().split()[0]) for thread in threads) / 1e9


@contextmanager
def server(code: str, *arguments: str, is_on_one_core: bool = True) -> Iterator[Server]:
    """A server on the first core, or on all; this process moves to the last one. Its log goes to a file, as in production."""
    pin = f"import os; os.sched_setaffinity(0, [{_CORES[0]}])\n" if len(_CORES) > 1 and is_on_one_core else ""
    os.sched_setaffinity(0, _CORES[-1:] if pin else _CORES)
    with (
        tempfile.TemporaryFile() as log,
        _started([sys.executable, "-c", pin + code, *arguments], log.fileno()) as process,
    ):
        assert process.stdout is not None
        match = re.search(r"http://([\w.:]+)", process.stdout.readline())
        assert match, "the server did not start"
        yield Server(match[1], process.pid)
    os.sched_setaffinity(0, _CORES)


@contextmanager
def _started(command: Sequence[str], log: int) -> Iterator["subprocess.Popen[str]"]:
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=log, text=True) as process:
        try:
            yield process
        finally:
            process.terminate()
