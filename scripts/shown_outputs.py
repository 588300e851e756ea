"""Outputs in the `console` blocks of pages: the commands run, and their output replaces the old one.

The blocks of a page run in order, in one empty folder. A block with `title="NAME"` beside its language is a file of that
folder from there on. `$ ` begins a command, `> ` continues it; every other line is output.
"""

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).parents[1]
_BLOCK = re.compile(
    r'^```(?P<language>\w+)(?: title="(?P<title>[^"]+)")?\n(?P<text>.*?)^```$', re.MULTILINE | re.DOTALL
)
_COMMAND = re.compile(r"^\$ .*\n(?:> .*\n)*", re.MULTILINE)
_PRELUDE = f'sigcat() {{ {sys.executable} -m sigcat.cli "$@"; }}\n'


def files() -> Mapping[str, str]:
    """The pages that show commands with their output."""
    pages = (ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md")))
    texts = {str(page.relative_to(ROOT)): page.read_text(encoding="utf-8") for page in pages if page.is_file()}
    return {name: with_outputs(text) for name, text in texts.items() if "\n```console\n" in text}


def with_outputs(page: str) -> str:
    """A page with what its commands print today."""
    with tempfile.TemporaryDirectory(prefix="sigcat-page-") as folder:

        def replaced(block: re.Match[str]) -> str:
            if block["title"]:
                _write(Path(folder, block["title"]), block["text"])
            if block["language"] != "console":
                return block[0]
            shown = (f"{shown}{_output(shown, Path(folder))}" for shown in _COMMAND.findall(block["text"]))
            return f"```console\n{''.join(shown)}```"

        return _BLOCK.sub(replaced, page)


def _write(file: Path, text: str) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def _output(shown: str, folder: Path) -> str:
    """Return the output of a command. It must run; findings are not a failure."""
    command = re.sub(r"^[$>] ", "", shown, flags=re.MULTILINE)
    done = subprocess.run(
        ["bash", "-c", _PRELUDE + command],
        cwd=folder,
        env=_environment(folder),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    if done.returncode not in (0, 1) or "internal error" in done.stdout:
        raise RuntimeError(f"{command}{done.stdout}")
    return done.stdout if done.stdout.endswith("\n") or not done.stdout else f"{done.stdout}\n"


def _environment(folder: Path) -> Mapping[str, str]:
    """A terminal of 100 columns, and nothing that was pulled or configured before."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("SIGCAT_", "XDG_"))}
    mine = {"PYTHONPATH": str(ROOT / "app"), "PYTHONUNBUFFERED": "1", "COLUMNS": "100", "LC_ALL": "C.UTF-8"}
    return {**kept, **mine, "XDG_DATA_HOME": str(folder / ".data")}
