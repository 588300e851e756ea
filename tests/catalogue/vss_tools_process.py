"""Real vss-tools as the reference, which the tests run in a separate process.

Standard input: a JSON object of jobs by name, each with `exporter`, `folder` and `arguments` (without -o).
Standard output: a JSON object of the output of vss-tools, as text, by name; null if it refused.
vss-tools keeps units and types in globals and ends the process on bad input, so each job runs in a fork.
"""

import contextlib
import importlib
import json
import logging
import os
import sys
import tempfile
from pathlib import Path
from typing import Any

logging.disable(logging.CRITICAL)


def run(job: dict[str, Any], output: Path) -> None:
    cli = importlib.import_module(f"vss_tools.exporters.{job['exporter']}").cli
    child = os.fork()
    if child:
        os.waitpid(child, 0)
        return
    os.chdir(job["folder"])
    sink = os.open(os.devnull, os.O_WRONLY)
    os.dup2(sink, 1)
    os.dup2(sink, 2)
    with contextlib.suppress(BaseException):
        cli.main([*job["arguments"], "-o", str(output)], standalone_mode=False)
    os._exit(0)


def main() -> None:
    outputs = {}
    with tempfile.TemporaryDirectory() as temporary:
        for name, job in json.load(sys.stdin).items():
            output = Path(temporary) / "output"
            output.unlink(missing_ok=True)
            run(job, output)
            outputs[name] = output.read_text() if output.exists() else None
    print(json.dumps(outputs))


if __name__ == "__main__":
    main()
