"""Real vss-tools as the reference for exports, for as long as the tests run.

Each line of standard input is a JSON object with `format`, `arguments` and `folder`; each line of standard output is
the exit status of `vspec export` with them. Every export runs in a fork: vss-tools keeps units and types in globals.
"""

import importlib
import json
import os
import sys
from typing import Any


def exit_status(job: dict[str, Any]) -> int:
    cli = importlib.import_module(f"vss_tools.exporters.{job['format']}").cli
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    os.chdir(job["folder"])
    os.dup2(os.open("log", os.O_WRONLY | os.O_CREAT), 1)
    os.dup2(1, 2)
    status = 1
    try:
        cli.main(job["arguments"], standalone_mode=False)
        status = 0
    except SystemExit as error:
        status = int(bool(error.code))
    finally:
        sys.stdout.flush()
        os._exit(status)


for line in sys.stdin:
    sys.stdout.write(f"{exit_status(json.loads(line))}\n")
    sys.stdout.flush()
