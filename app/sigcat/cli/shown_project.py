"""The lines of `sigcat config --show`: every value of the project, and where it comes from."""

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from sigcat.catalogue.composing.older_releases import unit_files_of
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.model.vehicle import Setting, Vehicle
from sigcat.catalogue.model.vocabulary import STANDARD_UNITS, files_beside
from sigcat.file_kind import QUANTITY_NAMES
from sigcat.project.chosen_tree import TreeOptions, chosen_tree
from sigcat.project.project import Project, ServerUrl
from sigcat.real_path import each_once, near_path
from sigcat.rules.linting.configuration import FIELDS
from sigcat.rules.linting.options import LintOptions

_OPTIONS = {"overlays": "-l", "units": "-u", "quantities": "-q", "types": "-t", "include_dirs": "-I"}
"""Lists of a tree, each with the option that adds to it."""
_OF_PROJECT = ("functions", "rules", "units", "quantities", "types", "include_dirs", "dbc")


class Shown(NamedTuple):
    """A value, and where it comes from."""

    name: str
    value: str
    origin: str


def shown_project(project: Project, given: TreeOptions) -> Iterator[Shown]:
    """Yield the values of the project, then those of its catalogues and of the one that commands use."""
    for name in _OF_PROJECT:
        yield from (Shown(name, str(path), _place(name, project)) for path in getattr(project, name))
    if project.deployment is not None:
        yield Shown("deployment", str(project.deployment), project.line("", 0, "deployment"))
    yield from _registry(project)
    yield Shown("watch", _yes(project.is_watching), project.line("", 0, "watch") if project.is_watching else "default")
    shipped = "default" if project.shipped is None else project.line("", 0, "shipped")
    yield Shown("shipped catalogues", _yes(project.has_shipped_catalogues), shipped)
    yield Shown("shipped functions", _yes(project.has_shipped_functions), shipped)
    yield from _lint(project)
    chosen = chosen_tree(project, given)
    yield from _catalogue("catalogue (default)" if given.tree is None else "catalogue (-s)", chosen, project, given)
    for source in project.catalogues:
        if source.id != chosen.id:
            yield from _catalogue("catalogue", source, project, TreeOptions())
    for vehicle in project.vehicles:
        yield from _vehicle(vehicle)


def _place(name: str, project: Project) -> str:
    """Return the place of a list of the project; units and quantities are found without one."""
    is_found = name in ("units", "quantities") and not project.has_key(name)
    return "beside the project file" if is_found else project.line("", 0, _key(name))


def _registry(project: Project) -> Iterator[Shown]:
    if project.registry_server:
        yield Shown("registry.server", project.registry_server, project.line("registry", 0, "server"))
    if project.registry is not None:
        for name, value in zip(project.registry._fields, project.registry, strict=True):
            for each in value if isinstance(value, tuple) and not isinstance(value, ServerUrl) else (value,):
                if each is not None:
                    yield Shown(f"registry.{_key(name)}", str(each), project.line("registry", 0, _key(name)))


def _vehicle(vehicle: Vehicle) -> Iterator[Shown]:
    """Yield what a vehicle is composed of, in one state."""
    place = f"{vehicle.file}:{vehicle.line}"
    yield Shown("vehicle", vehicle.name, place)
    yield Shown("  catalogue", vehicle.catalogue, place)
    yield from (Shown(f"  attributes.{name}", value, place) for name, value in vehicle.labels)
    yield from (_setting("attributes", each, vehicle) for each in vehicle.defaults)
    yield from (_setting("instances", each, vehicle) for each in vehicle.instances)
    yield from (Shown("  without", each.path, f"{vehicle.file}:{each.line}") for each in vehicle.without)
    yield from (Shown("  with", str(near_path(path)), place) for path in vehicle.overlays)


def _setting(key: str, setting: Setting, vehicle: Vehicle) -> Shown:
    return Shown(f"  {key}.{setting.path}", _text(setting.value), f"{vehicle.file}:{setting.line}")


def _lint(project: Project) -> Iterator[Shown]:
    """Yield the settings of `[lint]`, without what it has of the project."""
    for key, (name, _) in FIELDS.items():
        value = getattr(project.lint, name)
        if value not in (getattr(LintOptions(), name), getattr(project, key, ())):
            yield Shown(f"lint.{key}", _text(value), project.line("lint", 0, key))


def _text(value: Any) -> str:
    if isinstance(value, tuple):
        return ", ".join(map(str, value))
    return ", ".join(f"{key}: {inner}" for key, inner in value.items()) if isinstance(value, Mapping) else str(value)


def _catalogue(title: str, source: Source, project: Project, given: TreeOptions) -> Iterator[Shown]:
    name = source.vehicle.catalogue if source.vehicle else source.id
    number = next((n for n, each in enumerate(project.catalogues) if each.id == name), None)
    yield Shown(title, source.id, "shipped" if number is None else project.line("catalogue", number))
    written = "spec" if number is not None and not _is_shipped(source) and not source.release else "release"
    tree = "shipped" if number is None else project.line("catalogue", number, written)
    yield Shown("  tree", str(near_path(source.spec)), "-s" if given.tree and number is None else tree)
    units = unit_files_of(source.spec, source.overlays, source.units, has_standard=source.has_standard_units)
    quantities = each_once((*files_beside([source.spec, *source.overlays], QUANTITY_NAMES), *source.quantities))
    lists: dict[str, Iterable[Path]] = {
        "overlays": source.overlays, "units": units, "quantities": quantities, "types": source.types,
        "include_dirs": source.include_dirs,
    }  # fmt: skip
    for name, paths in lists.items():
        for path in paths:
            yield Shown(f"  {_key(name)}", str(near_path(path)), _origin(name, path, source, number, project, given))


def _origin(name: str, path: Path, source: Source, number: int | None, project: Project, given: TreeOptions) -> str:
    """Return where a path of a list comes from: an option, the project, its catalogue, or a folder that is looked into."""
    if path in getattr(given, name):
        return _OPTIONS[name]
    if path in getattr(project, name, ()):
        return _place(name, project)
    if path.parent == source.spec.parent and name != "overlays":
        return "beside the tree"
    if path == STANDARD_UNITS:
        return "VSS, as there is none beside the tree"
    if path in getattr(source, name):
        return "shipped" if number is None else project.line("catalogue", number, _key(name))
    return "beside the overlay"


def _is_shipped(source: Source) -> bool:
    return source.spec.parent == STANDARD_UNITS.parent


def _key(name: str) -> str:
    return name.replace("_", "-")


def _yes(value: bool) -> str:
    return "yes" if value else "no"
