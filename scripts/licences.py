"""Write docs/reference/licences.md anew: the licence of every package that is shipped: `python -m scripts.licences`."""

import sys

from scripts.shipped import ROOT, Package, shipped

FILE = ROOT / "docs" / "reference" / "licences.md"
_HEAD = """\
# Licences of what is shipped

sigcat is licensed under Apache-2.0. At run time it needs the packages below, as `requirements.txt` pins them; the
container has them all. They are used as they come, unchanged. `python -m scripts.licences` writes this page, and a test
compares it with `requirements.txt` and with the licences that may be shipped.

| package | version | licence | needed by |
|---|---|---|---|
"""


def licence_page() -> str:
    """The page as it has to be."""
    return _HEAD + "".join(map(_row, shipped()))


def _row(package: Package) -> str:
    return f"| {package.name} | {package.version} | {package.licence} | {', '.join(package.needed_by)} |\n"


def main() -> int:
    """Write the page."""
    FILE.write_text(licence_page(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
