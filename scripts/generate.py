"""Write everything in this repository that is generated: `make generate`, or `python -m scripts.generate NAME ...`.

tests/test_generated.py compares the files in the repository with the output of the generators.
"""

import argparse
import gzip
import importlib
import sys
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).parents[1]
PACKED = ".gz"
"""Files that end so are compared by what they hold: zlib packs it as its release does."""

GENERATORS: Mapping[str, str] = {
    "codes": "",
    "rule_docs": "docs/reference/rules/*.md",
    "command_line": "",
    "tables": "",
    "openapi": "",
    "python_api": "",
    "licences": "",
    "examples": "examples/*/expected/**/*",
    "drives": "examples/*/drive.csv",
    "can_log": "examples/*/can/drive.log.gz",
    "runs": "examples/*/run.csv",
    "cases": "tests/**/expected.*",
    "shown_outputs": "",
}
"""Modules of scripts/ in the order in which they run. Each has `files()`, which gives texts by their path in the repository.

Beside each: a glob of files that nothing else makes, so that those which are no longer made are removed.
"""


def made_by(name: str) -> Mapping[str, str]:
    """Return the files of a generator. It is imported here, since the generator before it may have written its modules."""
    made: Mapping[str, str] = importlib.import_module(f"scripts.{name}").files()
    assert made, f"scripts/{name}.py must make files."
    return made


def outdated(made: Mapping[str, str], owned: str = "") -> Mapping[str, str | None]:
    """The files that are not as they are made, with the text that they should have; None: no file."""
    found = (path for path in ROOT.glob(owned) if path.is_file()) if owned else ()
    stale = {path.relative_to(ROOT).as_posix() for path in found} - made.keys()
    return {path: made.get(path) for path in sorted({*made, *stale}) if made.get(path) != text_of(path)}


def text_of(path: str) -> str | None:
    """The text of a file of the repository, of a packed one unpacked; None where there is no such file."""
    file = ROOT / path
    if not file.is_file():
        return None
    data = file.read_bytes()
    return (gzip.decompress(data) if file.suffix == PACKED else data).decode("utf-8")


def write(path: str, text: str | None) -> None:
    """Give a file of the repository its text; None removes it."""
    file = ROOT / path
    if text is None:
        file.unlink()
    else:
        file.parent.mkdir(parents=True, exist_ok=True)
        data = text.encode("utf-8")
        file.write_bytes(gzip.compress(data, mtime=0) if file.suffix == PACKED else data)


def main() -> int:
    """Write what is outdated, and print its name."""
    parser = argparse.ArgumentParser(prog="python -m scripts.generate", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"what to generate: {', '.join(GENERATORS)}; else all")
    names = parser.parse_args().names or GENERATORS
    for name in names:
        if name not in GENERATORS:
            parser.error(f"there is no generator {name!r}; there are {', '.join(GENERATORS)}")
        for path, text in outdated(made_by(name), GENERATORS[name]).items():
            write(path, text)
            print(path if text is not None else f"{path} (removed)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
