"""The sides of a comparison: whatever names a tree, read into a catalogue.

A side is a catalogue of the project, a folder, a root file, an exported JSON, `git:REVISION` or `git:REVISION:PATH`, or
the name of a release; each may be followed by overlays, `+OVERLAY+OVERLAY`. The first of these that exists counts.
A folder or a revision with a project file is the first catalogue of that project.
"""

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from sigcat.catalogue.comparing.exported_json import NOTHING_LOST, UNKNOWN, Lost, lost_in_exports, read_export
from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.git_revision import unpack_revision
from sigcat.catalogue.reading.joined_paths import split_paths
from sigcat.catalogue.reading.layers import Layer, read_layer
from sigcat.catalogue.reading.root_file import root_file, types_beside
from sigcat.data import OVERLAYS, VSPEC
from sigcat.errors import InputRefused, UsageError
from sigcat.file_kind import ending_of
from sigcat.findings import Finding, has_errors
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.real_path import each_once, real_path
from sigcat.temporary_files import temporary_folder

Release = Callable[[str], Source]
"""The source of a release by its name. Raises NotFound."""


class SideProject(NamedTuple):
    """The project that a side is in."""

    catalogues: Mapping[str, Source] = MappingProxyType({})
    """By id, the default one first, and the vehicles by `vehicle:ID`; complete."""
    complete: Callable[[Source], Source] = lambda source: source
    """Adds the units, quantities, types and include folders of the project to a tree that is not one of its catalogues."""

    @property
    def default(self) -> Source | None:
        """The first catalogue."""
        return next((source for source in self.catalogues.values() if source.vehicle is None), None)


NO_PROJECT = SideProject()
Projects = Callable[[Path, Path], SideProject]
"""The project of a folder: its file is in the first folder or above it, up to the second one. Raises InputRefused."""

GIT = "git:"


def _no_projects(_folder: Path, _top: Path) -> SideProject:
    return NO_PROJECT


class Options(NamedTuple):
    """Options for both sides."""

    overlays: tuple[Path, ...] = ()
    """Applied after the overlays of the side itself."""
    include_dirs: tuple[Path, ...] = ()
    units: tuple[Path, ...] = ()
    quantities: tuple[Path, ...] = ()
    types: tuple[Path, ...] = ()
    project: SideProject = NO_PROJECT
    """The project that the side is in: that of the current folder, or of the revision."""
    projects: Projects = _no_projects
    limits: Limits = DEFAULT_LIMITS
    lost: Lost = NOTHING_LOST
    """Facts that an exported JSON lacks, and the other side has."""


class Side(NamedTuple):
    """One side of a comparison."""

    title: str
    catalogue: Catalogue
    unknown: frozenset[str] = frozenset()
    """Attributes that a tree in this form cannot have."""
    folder: str = ""
    """Former current folder of a revision, whose files are removed. Empty: the current folder."""

    @property
    def is_export(self) -> bool:
        """Whether it is an exported JSON."""
        return self.unknown == UNKNOWN


NO_OPTIONS = Options()


def read_sides(old: str, new: str, release: Release, options: Options = NO_OPTIONS) -> tuple[Side, Side]:
    """Read both sides. Where one is an export, what that lacks counts as the other says. Raises as `read_side` does."""
    sides = read_side(old, release, options), read_side(new, release, options)
    before, after = sides
    if before.is_export == after.is_export:
        return sides
    lost = lost_in_exports(after.catalogue if before.is_export else before.catalogue)
    if not lost:
        return sides
    knowing = options._replace(lost=lost)
    if before.is_export:
        return read_side(old, release, knowing), after
    return before, read_side(new, release, knowing)


def read_side(name: str, release: Release, options: Options = NO_OPTIONS) -> Side:
    """Read a side.

    Raises UsageError if `name` names nothing, InputRefused if the tree has errors, and what `release` raises.
    """
    side = _git_side(name, options) if name.startswith(GIT) else _side_here(name, release, options)
    if has_errors(side.catalogue.findings):
        raise InputRefused(f"{name}: the tree has errors; nothing was compared", side.catalogue.findings)
    return side


def _side_here(name: str, release: Release, options: Options) -> Side:
    base, overlays = _parts(name)
    if not base:
        raise UsageError(f"{name!r}: there is no such file or folder")
    return (
        _named_side(name, base, overlays, options)
        or _file_side(name, Path(base), overlays, options)
        or _release_side(name, base, overlays, release, options)
    )


def _parts(name: str, folder: Path = Path()) -> tuple[str, tuple[Path, ...]]:
    """The tree and its overlays; each may have a plus in its path."""
    base, *overlays = split_paths(name, "+", folder)
    return base, tuple(folder / overlay for overlay in overlays)


def _named_side(title: str, base: str, overlays: tuple[Path, ...], options: Options) -> Side | None:
    """The side that a catalogue of the project is; None if it has none of this id."""
    source = options.project.catalogues.get(base)
    return _side_of(title, source, overlays, options) if source is not None else None


def _side_of(title: str, source: Source, overlays: tuple[Path, ...], options: Options) -> Side:
    added = source._replace(
        overlays=each_once((*source.overlays, *_existing((*overlays, *options.overlays)))),
        units=each_once((*source.units, *options.units)),
        quantities=each_once((*source.quantities, *options.quantities)),
        types=each_once((*source.types, *options.types)),
        include_dirs=each_once((*source.include_dirs, *options.include_dirs)),
    )
    return Side(title, load(added, options.limits))


def _file_side(
    title: str, path: Path, overlays: tuple[Path, ...], options: Options, top: Path | None = None
) -> Side | None:
    """The side that a file or folder is; None if it does not exist. `top` is the uppermost folder that may be looked into."""
    if not path.exists():
        return None
    if ending_of(path.name) == ".json" and path.is_file():
        return Side(title, read_export(path, _layers(overlays, options), options.limits, options.lost), UNKNOWN)
    if path.is_dir():
        return _side_of(title, _source_in(path, top or Path(real_path(path).anchor), options), overlays, options)
    return _side_of(title, options.project.complete(Source(path.stem, path.stem, path)), overlays, options)


def _source_in(folder: Path, top: Path, options: Options) -> Source:
    """The catalogue of the project in a folder, else the tree in it, else the catalogue of the project above it."""
    project = options.projects(folder, folder)
    if project.default is not None:
        return project.default
    try:
        spec = root_file(folder, options.limits)
    except UsageError as error:
        above = options.projects(folder, top)
        if above.default is not None:
            return above.default
        raise UsageError(f"{error} A `sigcat.toml` with a [[catalogue]] names the tree of overlays.") from None
    for source in options.projects(folder, top).catalogues.values():
        if real_path(spec) in map(real_path, source.overlays):
            return source
    types = types_beside(spec, options.limits) if not options.types else ()
    return options.project.complete(Source(spec.stem, spec.stem, spec, types=types))


def _release_side(title: str, base: str, overlays: tuple[Path, ...], release: Release, options: Options) -> Side:
    if "/" in base or base.endswith((".vspec", ".json")):
        raise UsageError(f"{base}: there is no such file or folder")
    return _side_of(title, options.project.complete(release(base)), overlays, options)


def _layers(overlays: tuple[Path, ...], options: Options) -> list[Layer]:
    paths = _existing((*overlays, *options.overlays))
    return [read_layer(path, options.include_dirs, is_overlay=True, limits=options.limits) for path in paths]


def _existing(overlays: tuple[Path, ...]) -> tuple[Path, ...]:
    for overlay in overlays:
        if not overlay.is_file():
            raise UsageError(f"{overlay}: there is no such overlay")
    return overlays


# -- git ----------------------------------------------------------------------------------------------------------


def _git_side(name: str, options: Options) -> Side:
    """`git:REVISION[:PATH]`: the path as git takes it, from the top of the repository; `./` is the current folder.

    Without a path: the project around the current folder, as it was then, or else the tree in the repository.
    """
    revision, _, path = name.removeprefix(GIT).partition(":")
    with temporary_folder("sigcat-diff-") as temporary:
        folder = real_path(Path(temporary))
        prefix = unpack_revision(revision, folder, options.limits)
        shown = f"{GIT}{revision}:"
        try:
            side = _unpacked_side(name, path, folder / prefix, folder, options)
        except (UsageError, InputRefused) as error:
            raise _renamed_error(error, f"{folder}/", shown) from None
        findings = tuple(_renamed(finding, f"{folder}/", shown) for finding in side.catalogue.findings)
        return side._replace(catalogue=side.catalogue.with_findings(findings), folder=str(folder / prefix))


def _unpacked_side(title: str, path: str, current: Path, top: Path, options: Options) -> Side:
    find = options.projects
    project = _inside(find(current, top), title, top)
    started = options.project.default
    options = options._replace(project=project, projects=lambda *folders: _inside(find(*folders), title, top))
    if not path and project.default is None and started is not None and _has_known_tree(started):
        return _side_of(f"{title} (no sigcat.toml: the tree without overlays)", _without_overlays(started), (), options)
    folder = current if path.startswith(".") else top
    base, overlays = _parts(path, folder)
    tree, *others = (Path(os.path.normpath(part)) for part in (folder / base, *overlays))
    for part in (tree, *others):
        _check_inside(part, title, top)
    source = project.catalogues.get(base) if base else project.default
    if source is not None:
        return _side_of(title, source, tuple(others), options)
    side = _file_side(title, tree, tuple(others), options, top)
    if side is None:
        raise UsageError(f"{title}: the revision has no {base!r} (only .vspec, .yaml and .json files are looked at)")
    return side


def _has_known_tree(source: Source) -> bool:
    return bool(source.release) or source.spec.is_relative_to(VSPEC)


def _without_overlays(source: Source) -> Source:
    """Return the catalogue before the project began."""
    return source._replace(overlays=tuple(path for path in source.overlays if path.is_relative_to(OVERLAYS)))


def _inside(project: SideProject, title: str, top: Path) -> SideProject:
    """The project of a revision, all of whose files belong to the revision, to a release, or to what sigcat ships."""
    for source in project.catalogues.values():
        known = (VSPEC, OVERLAYS, *((source.spec.parent,) if source.release else ()))
        for path in (source.spec, *source.overlays, *source.units, *source.quantities, *source.types):
            if not any(path.is_relative_to(folder) for folder in known):
                _check_inside(path, title, top)
    return project


def _check_inside(path: Path, title: str, top: Path) -> None:
    if not real_path(path).is_relative_to(top):
        raise UsageError(f"{title}: the path leaves the repository")


def _renamed(finding: Finding, folder: str, shown: str) -> Finding:
    return finding._replace(file=finding.file.replace(folder, shown), message=finding.message.replace(folder, shown))


def _renamed_error(error: UsageError | InputRefused, folder: str, shown: str) -> UsageError | InputRefused:
    message = str(error).replace(folder, shown).replace(folder.rstrip("/"), shown.rstrip(":"))
    if isinstance(error, InputRefused):
        return InputRefused(message, tuple(_renamed(finding, folder, shown) for finding in error.findings))
    return UsageError(message)
