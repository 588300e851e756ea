"""Real `vspec export` as the reference of every export."""

import json
import subprocess
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from sigcat.catalogue.exporting.exporter import Exporter
from sigcat.catalogue.exporting.vss_tools.exporter_calls import call_of


@cache
def _process() -> "subprocess.Popen[str]":
    script = Path(__file__).with_name("vspec_export.py")
    return subprocess.Popen([sys.executable, str(script)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def reference_export(exporter: Exporter, arguments: Sequence[str], folder: Path) -> dict[str, bytes]:
    """Files that `vspec export` writes into an empty folder, by path; arguments without the one for the output."""
    call = call_of(exporter.name)
    output = folder / f"Vehicle{exporter.suffix}"
    (output if call.output_exists else folder).mkdir(parents=True)
    job = {"format": exporter.name, "arguments": [*arguments, f"--{call.output}", str(output)], "folder": str(folder)}
    process = _process()
    assert process.stdin is not None
    assert process.stdout is not None
    print(json.dumps(job), file=process.stdin, flush=True)
    status = int(process.stdout.readline())
    log = folder / "log"
    assert status == 0, log.read_text()
    log.unlink()
    return files_in(output if exporter.is_folder else folder)


def files_in(folder: Path) -> dict[str, bytes]:
    """Content of all files below a folder, by path."""
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in folder.rglob("*") if file.is_file()}
