"""Findings of the linter in a function.yaml."""

import contextlib
import io
import json
from pathlib import Path

from sigcat.cli import main


def rules_found(file: Path) -> set[str]:
    """The rules that `sigcat lint` finds broken."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(io.StringIO()):
        main(["lint", str(file), "--format", "json"])
    return {finding["rule"] for finding in json.loads(output.getvalue())["findings"]}
