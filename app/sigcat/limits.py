"""How much input is taken before it is refused: the limits that a caller may set. Others stand where they are met."""

from typing import NamedTuple


class Limits(NamedTuple):
    """Bounds on input. The defaults are far above any real tree and far below what would hurt the process."""

    file_bytes: int = 32 * 1024 * 1024
    nesting: int = 64
    """Levels of YAML collections inside each other (VSS needs four)."""
    values: int = 2_000_000
    """Values in one file, with every alias counted as often as it is used."""
    files: int = 10_000
    """Files that one tree may include, a file counted as often as it is included."""
    nodes: int = 1_000_000
    """Nodes of a tree after the expansion of instances."""
    path_names: int = 64
    """Names in one path."""
    compared: int = 1_000_000_000
    """Characters of paths that the wildcard paths of one layer, such as `Vehicle.*.Speed`, are compared with."""
    pattern_seconds: float = 10.0
    """Seconds for the patterns of one tree, all together; those left after that are not checked, and a finding says so."""


DEFAULT_LIMITS = Limits()
