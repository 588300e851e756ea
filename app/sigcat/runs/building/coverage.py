"""Coverage of the code of functions: measured by gcc or clang, reported by gcovr as Cobertura XML and as HTML."""

import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

from sigcat.adapter.host.connections import Member
from sigcat.adapter.toolchain import Toolchain
from sigcat.errors import UsageError

FLAGS = ("--coverage", "-O0")
XML, HTML = "coverage.xml", "index.html"


def check_coverage(tools: Toolchain) -> None:
    """Raise UsageError if coverage cannot be measured or reported."""
    if find_spec("gcovr") is None:
        raise UsageError("--coverage needs the extra `coverage`: run `pip install 'sigcat[coverage]'`")
    _reader(tools)


def report_coverage(members: Sequence[Member], folder: Path, target: Path, tools: Toolchain) -> None:
    """Write the reports about a run whose program is in a folder. Raises UsageError."""
    sources = [(member.folder / each).resolve() for member in members for each in _sources(member)]
    root = Path(os.path.commonpath([member.folder.resolve() for member in members]))
    filters = [word for source in sources for word in ("--filter", f"{_escaped(source)}$")]
    outputs = ("--cobertura", str(target / XML), "--html-details", str(target / HTML))
    command = [
        sys.executable, "-m", "gcovr", "--root", str(root), *filters, "--gcov-executable", _reader(tools), *outputs, str(folder),
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603 — no shell
    if done.returncode:
        raise UsageError(f"coverage cannot be reported: {(done.stderr or done.stdout).strip()}")


def _sources(member: Member) -> Sequence[str]:
    code = member.function.function.code
    return (code.sources if code else None) or ()


def _escaped(path: Path) -> str:
    """A path as a regular expression of gcovr, which takes `/` on all systems."""
    return "".join(each if each.isalnum() or each in "/_-" else f"\\{each}" for each in path.as_posix())


def _reader(tools: Toolchain) -> str:
    """The program that reads what the compiler measured. Raises UsageError."""
    name = Path(tools.c[0]).name
    version = subprocess.run([*tools.c, "--version"], capture_output=True, text=True, check=False).stdout  # noqa: S603
    known = ("llvm-cov",) if "clang" in version else (name.replace("gcc", "gcov"), "gcov")
    found = next((each for each in known if shutil.which(each)), None)
    if tools.is_zig or found is None:
        raise UsageError("--coverage needs gcc with gcov, or clang with llvm-cov")
    return f"{found} gcov" if found == "llvm-cov" else found
