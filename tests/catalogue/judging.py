"""Ask real vss-tools: jobs in, what it wrote out."""

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


def verdicts(jobs: Mapping[str, Job]) -> dict[str, str | None]:
    """What vss-tools wrote for each job; None where it refused."""
    request = {
        name: {"exporter": job.exporter, "folder": str(job.folder.resolve()), "arguments": list(job.arguments)}
        for name, job in jobs.items()
    }
    judge = Path(__file__).parent / "vss_tools_judge.py"
    output = subprocess.run(
        [sys.executable, str(judge)], input=json.dumps(request), capture_output=True, text=True, check=True
    ).stdout
    return dict(json.loads(output))
