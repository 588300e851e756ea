"""Where a path leads."""

import os
from pathlib import Path


def real_path(path: Path) -> Path:
    """With every link followed. One that leads to itself stays as it is: before Python 3.13 `Path.resolve` has no OSError for it."""
    return Path(os.path.realpath(path))
