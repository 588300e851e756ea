"""Run real vss-tools: jobs in, its output out."""

import json
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple


class Job(NamedTuple):
    """One run of `vspec export`, without its -o."""

    exporter: str
    folder: Path
    arguments: Sequence[str]


def outputs(jobs: Mapping[str, Job]) -> dict[str, str | None]:
    """Return the output of vss-tools for each job; None if it refused."""
    request = {
        name: {"exporter": job.exporter, "folder": str(job.folder.resolve()), "arguments": list(job.arguments)}
        for name, job in jobs.items()
    }
    process = Path(__file__).parent / "vss_tools_process.py"
    output = subprocess.run(
        [sys.executable, str(process)], input=json.dumps(request), capture_output=True, text=True, check=True
    ).stdout
    return dict(json.loads(output))
