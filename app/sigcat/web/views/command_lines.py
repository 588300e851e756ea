"""The commands that do what a page does, for the tree of a hosted catalogue."""

import shlex
from collections.abc import Iterator

from sigcat.api.answers.serializers import shown_file
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.catalogue.hosting.variants import choice_of
from sigcat.catalogue.search import overlay_name
from sigcat.data import ROOT_FILE


def overlay_commands(hosted: Hosted, file: str = "overlay.vspec") -> tuple[str, str]:
    """Return the commands that show the effects of an overlay, and that check it."""
    tree = shlex.join(_tree_options(_chosen(hosted)))
    return f"sigcat try {file} {tree}", f"sigcat lint {file} {tree}"


def _chosen(hosted: Hosted) -> Source:
    """The source without the overlays that are switched off."""
    without = choice_of(hosted.source.id).without
    kept = tuple(path for path in hosted.source.overlays if overlay_name(str(path)) not in without)
    return hosted.source._replace(overlays=kept)


def _tree_options(source: Source) -> Iterator[str]:
    if source.vehicle is not None:
        yield from ("-s", source.vehicle.label)
        return
    for shipped in shipped_sources():
        if source._replace(id=shipped.id, title=shipped.title, vehicles=()) == shipped:
            yield from ("-s", shipped.id)
            return
    shipped_name = "vss" if source.spec == ROOT_FILE else ""
    yield from ("-s", source.release or shipped_name or shown_file(str(source.spec)))
    types = () if source.release else source.types
    lists = {"-l": source.overlays, "-u": source.units, "-q": source.quantities, "-t": types, "-I": source.include_dirs}
    for option, paths in lists.items():
        for path in paths:
            yield from (option, shown_file(str(path)))
