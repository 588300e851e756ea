"""Sources of catalogues: the trees that sigcat ships, pulled releases, and any other tree with its overlays."""

from collections.abc import Iterable
from pathlib import Path

from sigcat.catalogue.hosting.source import Source
from sigcat.data import OVERLAYS, ROOT_FILE
from sigcat.errors import UsageError, existing_file
from sigcat.file_kind import TREE_ENDINGS, ending_of

SHIPPED = "shipped"
"""Name of the tree that sigcat ships, where a release is needed."""


def shipped_sources() -> tuple[Source, ...]:
    """The trees that sigcat ships: the standard tree alone, and with the interface overlays."""
    overlays = tuple(
        OVERLAYS / f"{name}.vspec" for name in ("ecocontrol", "error", "safety_reaction", "mode", "scheduling")
    )
    return (
        Source("interfaces", "VSS 6.0 with function interfaces", ROOT_FILE, overlays),
        Source("vss", "VSS 6.0", ROOT_FILE),
    )


def release_source(name: str) -> Source:
    """The source of a pulled release, or of a shipped tree. Raises NotFound, which says how to pull it."""
    for source in shipped_sources():
        if name == source.id or (name == SHIPPED and not source.overlays):
            return source
    from sigcat.catalogue.hosting.releases import find_release

    release = find_release(name)
    title = f"VSS {release.name.removeprefix('v')}"
    return Source(release.name, title, release.spec, types=release.types, release=release.name)


def pulled_sources() -> tuple[Source, ...]:
    """The sources of all releases that were pulled, newest first."""
    from sigcat.catalogue.hosting.releases import pulled_releases

    return tuple(release_source(release.name) for release in reversed(pulled_releases()))


def source_from_option(text: str) -> Source:
    """The source that `ID=TREE[,OVERLAY,…]` names. TREE is a .vspec file, a folder, or a pulled release."""
    from sigcat.catalogue.reading.joined_paths import split_paths

    catalogue_id, equals, rest = text.partition("=")
    tree, *overlays = split_paths(rest, ",")
    if not (catalogue_id and equals and tree):
        raise UsageError(f"{text!r} does not name a catalogue; write ID=TREE or ID=TREE,OVERLAY,…")
    source = source_of_tree(tree)
    for overlay in overlays:
        existing_file(overlay)
    title = catalogue_id if not source.release else source.title
    return source._replace(id=catalogue_id, title=title, overlays=(*source.overlays, *map(Path, overlays)))


def source_of_tree(tree: str) -> Source:
    """The source of a .vspec file, a folder with a tree and its struct types, the tree that sigcat ships, or a release.

    Raises UsageError, or NotFound with near names.
    """
    path = Path(tree)
    if path.is_file():
        return Source(path.stem, path.stem, path)
    if path.is_dir():
        from sigcat.catalogue.reading.root_file import root_file, types_beside

        root = root_file(path)
        return Source(path.name, path.name, root, types=types_beside(root))
    if ending_of(path.name) in TREE_ENDINGS or len(path.parts) > 1:
        raise UsageError(f"{tree}: there is no such file")
    return release_source(tree)


def sources_in_order(chosen: Iterable[Source], shipped: Iterable[Source]) -> tuple[Source, ...]:
    """The chosen sources, and after them the shipped ones whose ids are still free. The last of equal ids counts."""
    by_id = {source.id: source for source in chosen}
    return (*by_id.values(), *(source for source in shipped if source.id not in by_id))
