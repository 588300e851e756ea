"""The page of licences, docs/reference/licences.md: the licence of every package that is shipped."""

from collections.abc import Mapping

from scripts.shipped import Package, shipped

_HEAD = """\
# Licences of shipped packages

sigcat is licensed under Apache-2.0. At run time it needs the packages below, as `requirements.txt` pins them. The
container has all of them, unchanged. `make generate` writes this page, and a test
compares it with `requirements.txt` and with the allowed licences.

| package | version | licence | needed by |
|---|---|---|---|
"""


def files() -> Mapping[str, str]:
    """The page."""
    return {"docs/reference/licences.md": _HEAD + "".join(map(_row, shipped()))}


def _row(package: Package) -> str:
    return f"| {package.name} | {package.version} | {package.licence} | {', '.join(package.needed_by)} |\n"
