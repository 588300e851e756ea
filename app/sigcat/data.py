"""Places of the data that sigcat ships: beside the package in a checkout, inside it once installed."""

from pathlib import Path

from sigcat.file_kind import ROOT_NAME

_INSIDE = Path(__file__).parent / "_data"
_HOME = _INSIDE if _INSIDE.is_dir() else Path(__file__).parents[2]

VSPEC = _HOME / "vspec"
OVERLAYS = _HOME / "overlays"
INTERFACE_RULES = _HOME / "interface_rules"
EXAMPLES = _HOME / "examples"
DOCUMENTATION = _HOME / "docs"

ROOT_FILE = VSPEC / ROOT_NAME
