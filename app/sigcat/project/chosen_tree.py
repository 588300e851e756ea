"""The tree of a command: that of the options, else that of the project, else the one near its overlays, else the shipped one."""

from pathlib import Path
from typing import NamedTuple

from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.hosting.sources import shipped_sources, source_of_tree
from sigcat.catalogue.model.vehicle import VEHICLE, Vehicle
from sigcat.data import ROOT_FILE, VSPEC
from sigcat.errors import NotFound
from sigcat.file_kind import root_name
from sigcat.names import nearest
from sigcat.project.project import Project
from sigcat.real_path import each_once, real_path
from sigcat.rules.linting.context import tree_near
from sigcat.rules.linting.includes import first_bytes
from sigcat.rules.linting.severity import ConfiguredSeverities


class TreeOptions(NamedTuple):
    """The tree that options name, and what they add to it."""

    tree: str | None = None
    """Id of a catalogue of the project, a file, a folder or a release."""
    overlays: tuple[Path, ...] = ()
    include_dirs: tuple[Path, ...] = ()
    units: tuple[Path, ...] = ()
    quantities: tuple[Path, ...] = ()
    types: tuple[Path, ...] = ()


def chosen_tree(project: Project, options: TreeOptions) -> Source:
    """The tree, with what the options add. Raises UsageError, or NotFound with near names."""
    source = named_tree(project, options) or _tree_near_overlay(project, options)
    source = source or with_additions(shipped_sources()[0], project)
    return source._replace(
        overlays=each_once((*source.overlays, *options.overlays)),
        include_dirs=each_once((*source.include_dirs, *options.include_dirs)),
        units=each_once((*source.units, *options.units)),
        quantities=each_once((*source.quantities, *options.quantities)),
        types=each_once((*source.types, *options.types)),
    )


def named_tree(project: Project, options: TreeOptions) -> Source | None:
    """The tree that the options name, or the default one of the project; None if there is none.

    Struct types beside a tree that is not of the project count only where the options name none, as for vss-tools.
    """
    if options.tree is None:
        return project.catalogues[0] if project.catalogues else None
    if options.tree.startswith(VEHICLE):
        return vehicle_source(project, options.tree)
    for source in project.catalogues:
        if source.id == options.tree:
            return source
    try:
        source = source_of_tree(options.tree)
    except NotFound as error:
        near = nearest(options.tree, [each.id for each in project.catalogues])
        raise NotFound(f"{error} Did you mean {near[0]}?", near) if near else error from None
    return with_additions(source._replace(types=()) if options.types else source, project)


def vehicle_source(project: Project, name: str) -> Source:
    """Return the catalogue of `vehicle:ID` or `vehicle:ID@STATE`; without a state, of the last one. Raises NotFound."""
    wanted = name.removeprefix(VEHICLE)
    found = [each for each in project.vehicles if wanted in (each.id, each.name)]
    if not found:
        names = [each.label for each in project.vehicles]
        near = nearest(name, names) or tuple(names[:1])
        hint = f"Did you mean {near[0]}?" if near else "The project has no [[vehicle]]."
        raise NotFound(f"Unknown vehicle {wanted!r}. {hint}", near)
    return source_of_vehicle(project, found[-1])


def source_of_vehicle(project: Project, vehicle: Vehicle) -> Source:
    """Return the catalogue of a vehicle."""
    return below_vehicle(project, vehicle).for_vehicle(vehicle)


def below_vehicle(project: Project, vehicle: Vehicle) -> Source:
    """Return the catalogue of which a vehicle is composed."""
    sources = project.catalogues or tuple(with_additions(source, project) for source in shipped_sources())
    return next(source for source in sources if source.id == vehicle.catalogue)


def _tree_near_overlay(project: Project, options: TreeOptions) -> Source | None:
    """Return the tree near the first overlay, over which a lint checks it; None where that is the shipped tree."""
    near = tree_near(root_name(first_bytes(options.overlays[0])), options.overlays[0]) if options.overlays else None
    if near is None or _is_shipped(near):
        return None
    here = real_path(Path.cwd())
    shown = near.relative_to(here) if near.is_relative_to(here) else near
    return named_tree(project, options._replace(tree=str(shown)))


def _is_shipped(tree: Path) -> bool:
    """Return whether a tree is the shipped one, or a copy of it, as in a checkout of sigcat."""
    return tree == ROOT_FILE or _is_copy(tree.parent)


def _is_copy(folder: Path) -> bool:
    from filecmp import cmp

    copies = ((file, folder / file.relative_to(VSPEC)) for file in VSPEC.rglob("*.vspec"))
    return all(copy.is_file() and cmp(file, copy, shallow=False) for file, copy in copies)


def with_additions(source: Source, project: Project) -> Source:
    """A source with the units, quantities, types and include folders of the project."""
    return source._replace(
        units=each_once((*project.units, *source.units)),
        quantities=each_once((*project.quantities, *source.quantities)),
        types=each_once((*project.types, *source.types)),
        include_dirs=each_once((*source.include_dirs, *project.include_dirs)),
        severities=ConfiguredSeverities.of(project.lint),
        vehicles=tuple(vehicle for vehicle in project.vehicles if vehicle.catalogue == source.id),
    )
