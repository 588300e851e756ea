"""`sigcat serve` as a process."""

import json
import os
import resource
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from tests.waiting import wait_until


class Service(NamedTuple):
    """A running service."""

    address: str
    process: "subprocess.Popen[str]"
    log: Path

    def logged(self, **fields: object) -> list[dict[str, object]]:
        """Lines of its log, each of them JSON, that have these fields; a line is written when its answer was sent."""

        def found() -> list[dict[str, object]]:
            lines = [json.loads(line) for line in self.log.read_text().splitlines(keepends=True) if line.endswith("\n")]
            return [line for line in lines if fields.items() <= line.items()]

        return wait_until(found, f"a request with {fields} is logged")

    @property
    def memory(self) -> int:
        """Bytes that the process holds in memory."""
        pages = int(Path(f"/proc/{self.process.pid}/statm").read_text().split()[1])
        return pages * resource.getpagesize()


@contextmanager
def served(tree: Path, before: Sequence[str] = (), **variables: str) -> Iterator[Service]:
    """A service over a tree; the words in `before` precede its command, and must replace themselves with it."""
    command = [*before, sys.executable, "-m", "sigcat.cli", "serve", "--port", "0", "-s", str(tree)]
    environment = {**os.environ, **variables}
    with (
        tempfile.NamedTemporaryFile("w") as log,
        subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log, text=True, env=environment) as process,
    ):
        assert process.stdout is not None
        try:
            yield Service(process.stdout.readline().split()[3], process, Path(log.name))
        finally:
            process.kill()
