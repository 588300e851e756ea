"""Projects of CMake are configured, if that was not done with the same settings, and built."""

import os
from collections.abc import Mapping
from pathlib import Path

from sigcat.players.commands import ran

_SAID = "sigcat-settings.txt"


def build(
    source: Path,
    folder: Path,
    settings: Mapping[str, object],
    *options: str,
    target: str = "all",
    environment: Mapping[str, str] | None = None,
) -> None:
    """Raises BuildFails with what CMake or a compiler says. What was built and did not change is not built again."""
    cache = [f"-D{name}={value}" for name, value in settings.items()]
    said = "\n".join(
        [str(source), *options, *cache, *((environment or {}).get("CMAKE_PREFIX_PATH", "").split(os.pathsep))]
    )
    known = folder / _SAID
    if not known.exists() or known.read_text("utf-8") != said:
        known.unlink(missing_ok=True)  # if configuring fails, the folder has neither these settings nor those before
        (folder / "CMakeCache.txt").unlink(missing_ok=True)  # it names the folder that was: this one may be a copy
        ran(["cmake", *options, "-S", source, "-B", folder, *cache], environment)
        known.write_text(said, "utf-8")
    ran(["cmake", "--build", folder, "--target", target, "-j", os.cpu_count() or 1], environment)
