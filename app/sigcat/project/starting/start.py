"""The files of a new project: a catalogue with one signal, a rule, and a function with its code and a trace."""

import re
from collections.abc import Mapping
from pathlib import Path

from sigcat.catalogue.hosting.releases import is_version
from sigcat.catalogue.hosting.sources import SHIPPED, shipped_sources
from sigcat.project.project import FILE_NAME
from sigcat.project.starting.ci import FILES

FUNCTION = "functions/cabin_air"
_PLACES = {
    "sigcat.toml": FILE_NAME,
    "rules.yaml": "rules.yaml",
    "cabin.vspec": "overlays/cabin.vspec",
    **{name: f"{FUNCTION}/{name}" for name in ("function.yaml", "CabinAir.h", "CabinAir.c", "trace.csv")},
}
"""Paths in the project by name."""


def starting_files(folder: Path) -> Mapping[str, str]:
    """Return the texts of a new project by path. The catalogue is named after the folder."""
    texts = {place: (FILES / name).read_text(encoding="utf-8") for name, place in _PLACES.items()}
    title = re.sub(r"[^\w .-]", "", folder.name).strip() or "Catalogue"
    texts[FILE_NAME] = texts[FILE_NAME].replace("__ID__", catalogue_id(folder.name)).replace("__TITLE__", title)
    return texts


def catalogue_id(name: str) -> str:
    """Return a name as the id of a catalogue: `Our signals` → `our-signals`. Names of shipped trees and releases get a prefix."""
    plain = re.sub(r"[^a-z0-9._-]+", "-", name.lower()).strip("-._")[:60] or "catalogue"
    is_taken = plain in (SHIPPED, *(source.id for source in shipped_sources())) or is_version(plain)
    return f"own-{plain}" if is_taken else plain
