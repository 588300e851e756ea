"""Hosted catalogues for a vehicle, with overlays switched off or instances folded: `interfaces~vehicle.coupe~folded`.

A variant is named like any other catalogue, in addresses of pages and of the API, so that a link to it shows the same.
It is composed from the layers in memory when it is first asked for.
"""

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import PurePath
from typing import NamedTuple
from weakref import WeakKeyDictionary

from sigcat.catalogue.composing.add_overlays import tolerating
from sigcat.catalogue.composing.compose import compose, unexpanded
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.hosting.vehicle_matrix import Matrix, matrix_of
from sigcat.catalogue.hosting.vehicles import composed_vehicles, vehicle_of
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.vehicle import VEHICLE, Vehicle
from sigcat.errors import NotFound
from sigcat.names import nearest, parent_path

MARK = "~"
_FOLDED, _WITHOUT, _VEHICLE, _STATE = "folded", "without.", "vehicle.", "state."


class Choice(NamedTuple):
    """Meaning of an id: a hosted catalogue or a vehicle of it, without some overlays, and whether instances are folded."""

    base: str
    without: frozenset[str] = frozenset()
    is_folded: bool = False
    vehicle: str = ""
    """Name of a vehicle: `ID` or `ID@STATE`."""

    @property
    def id(self) -> str:
        """The id that asks for this."""
        parts = [self.base, *self._vehicle_parts, *(f"{_WITHOUT}{name}" for name in sorted(self.without))]
        return MARK.join([*parts, _FOLDED] if self.is_folded else parts)

    @property
    def _vehicle_parts(self) -> Sequence[str]:
        """The parts of the id that name the vehicle: `@` names a version there."""
        vehicle, _, state = self.vehicle.partition("@")
        return [f"{_VEHICLE}{vehicle}", *([f"{_STATE}{state}"] if state else [])] if vehicle else []

    def for_vehicle(self, vehicle: str) -> "Choice":
        """For another vehicle; for none, the catalogue itself."""
        return self._replace(vehicle=vehicle, without=frozenset())

    def toggled(self, overlay: str) -> "Choice":
        """With an overlay switched on or off."""
        return self._replace(without=self.without ^ {overlay})

    def folded(self, is_folded: bool) -> "Choice":
        """With instances folded, or one by one."""
        return self._replace(is_folded=is_folded)


def choice_of(catalogue_id: str) -> Choice:
    """Return the meaning of an id. Parts without a meaning stay with the base, so that it is not found."""
    base, *parts = catalogue_id.split(MARK)
    unknown = [part for part in parts if part != _FOLDED and not part.startswith((_WITHOUT, _VEHICLE, _STATE))]
    without = frozenset(part.removeprefix(_WITHOUT) for part in parts if part.startswith(_WITHOUT))
    vehicle = next((part.removeprefix(_VEHICLE) for part in parts if part.startswith(_VEHICLE)), "")
    state = next((part.removeprefix(_STATE) for part in parts if part.startswith(_STATE)), "")
    name = f"{vehicle}@{state}" if state else vehicle
    return Choice(MARK.join([base, *unknown]), without, _FOLDED in parts, name)


def find_hosted(library: Library, catalogue_id: str) -> Hosted:
    """The hosted catalogue or the variant of one with this id. Raises NotFound with the nearest ids."""
    if MARK not in catalogue_id:
        return library.get(catalogue_id)
    choice = choice_of(catalogue_id)
    base = _for_vehicle(library.get(choice.base), choice)
    absent = choice.without - set(overlays_of(base.catalogue))
    if absent:
        message = f"Catalogue {choice.base!r} has no overlay {min(absent)!r}."
        raise NotFound(message, (choice._replace(without=choice.without - absent).id,))
    if choice == Choice(choice.base, vehicle=choice.vehicle):
        return base
    catalogue = variant_of(base.catalogue, choice)
    notes = [f"without {name}" for name in sorted(choice.without)] + (["folded"] if choice.is_folded else [])
    title = f"{base.source.title}, {', '.join(notes)}"
    return base._replace(source=base.source._replace(id=choice.id, title=title), catalogue=catalogue)


def _for_vehicle(base: Hosted, choice: Choice) -> Hosted:
    """The vehicle of a hosted catalogue that a choice names. Raises NotFound with the nearest ids."""
    if not choice.vehicle:
        return base
    vehicles = [each for each in base.source.vehicles if choice.vehicle in (each.id, each.name)]
    if not vehicles:
        near = nearest(choice.vehicle, [each.name for each in base.source.vehicles])
        message = f"Catalogue {base.source.id!r} has no vehicle {choice.vehicle[:80]!r}."
        raise NotFound(message, tuple(choice._replace(vehicle=name).id for name in near))
    vehicle = vehicles[-1]
    source = base.source.for_vehicle(vehicle)
    source = source._replace(
        id=Choice(choice.base, vehicle=choice.vehicle).id, title=f"{base.source.title}, {vehicle.shown}"
    )
    return base._replace(source=source, catalogue=_vehicle(base.catalogue, base.source, vehicle))


@lru_cache(maxsize=12)
def _vehicle(base: Catalogue, source: Source, vehicle: Vehicle) -> Catalogue:
    return vehicle_of(base, source, vehicle)


def vehicle_switches(hosted: Hosted) -> tuple[tuple[Vehicle, bool, str], ...]:
    """The vehicles that can be chosen: (vehicle, whether it is shown, id of its catalogue)."""
    choice, chosen = choice_of(hosted.source.id), hosted.source.vehicle
    return tuple((each, each == chosen, choice.for_vehicle(each.name).id) for each in hosted.source.vehicles)


def without_vehicle(hosted: Hosted) -> str:
    """Id of the catalogue itself where a vehicle of it is shown."""
    return choice_of(hosted.source.id).for_vehicle("").id


@lru_cache(maxsize=4)
def vehicle_matrix(base: Catalogue, source: Source) -> Matrix:
    """The nodes of a hosted catalogue, and which of its vehicles have them."""
    return matrix_of(list(composed_vehicles(base, source, source.vehicles)))


def overlays_of(catalogue: Catalogue) -> tuple[str, ...]:
    """Names of a catalogue's overlays, in the order in which they apply."""
    return tuple(PurePath(layer.name).stem for layer in catalogue.overlays)


def stand_in(library: Library, hosted: Hosted, path: str) -> str:
    """Return the variant's replacement for a node that only another variant has; empty if no variant has it.

    That is its definition, its first instance, or the branch above it.
    """
    choice = choice_of(hosted.source.id)
    whole = Choice(choice.base, vehicle=choice.vehicle)
    others = (library.get(choice.base), *(find_hosted(library, each.id) for each in (whole, whole.folded(True))))
    node = next((node for other in others if (node := other.catalogue.get(path))), None)
    if node is None:
        return ""
    nodes = hosted.catalogue.nodes
    if node.template in nodes:
        return node.template
    first = next((each.path for each in nodes.values() if each.template == node.template), "")
    above = parent_path(path)
    return first or (above if above in nodes else stand_in(library, hosted, above))


def folding(hosted: Hosted) -> str:
    """Id of the catalogue with instances folded if they are expanded, or the other way round."""
    choice = choice_of(hosted.source.id)
    return choice.folded(not choice.is_folded).id


def overlay_switches(library: Library, hosted: Hosted) -> tuple[tuple[str, bool, str], ...]:
    """The overlays that can be switched: (name, whether it is on, id of the catalogue with it switched)."""
    choice = choice_of(hosted.source.id)
    whole = find_hosted(library, Choice(choice.base, vehicle=choice.vehicle).id).catalogue
    names = [name for name in overlays_of(whole) if not name.startswith(VEHICLE)]
    return tuple((name, name not in choice.without, choice.toggled(name).id) for name in names)


@lru_cache(maxsize=12)
def instance_counts(catalogue: Catalogue) -> Mapping[str, int]:
    """Return the number of nodes of each branch with instances, by the path of its definition."""
    instances = (node for node in expanded_of(catalogue).nodes.values() if node.definition.is_instance)
    return Counter(node.template for node in instances if not any(c.definition.is_instance for c in node.children))


def expanded_of(catalogue: Catalogue) -> Catalogue:
    """A folded catalogue as it was before; any other one as it is."""
    return _expanded.get(catalogue, catalogue)


def instances_of(catalogue: Catalogue, path: str) -> Sequence[Node]:
    """The nodes for which one of a folded catalogue stands; none if it is a node itself."""
    expanded = expanded_of(catalogue)
    return () if path in expanded.nodes else _by_template(expanded).get(path, ())


@lru_cache(maxsize=12)
def _by_template(expanded: Catalogue) -> Mapping[str, Sequence[Node]]:
    found: defaultdict[str, list[Node]] = defaultdict(list)
    for node in expanded.nodes.values():
        found[node.template].append(node)
    return found


_expanded: WeakKeyDictionary[Catalogue, Catalogue] = WeakKeyDictionary()
"""Catalogue before it was folded."""

_origins: WeakKeyDictionary[Catalogue, tuple[Catalogue, Choice]] = WeakKeyDictionary()
"""Origin of a variant."""


def origin_of(variant: Catalogue) -> tuple[Catalogue, Choice] | None:
    """The arguments of which `variant_of` made a catalogue; None if it was read from files."""
    return _origins.get(variant)


@lru_cache(maxsize=12)
def variant_of(base: Catalogue, choice: Choice) -> Catalogue:
    """A catalogue without some overlays, or with instances folded."""
    if choice.is_folded:
        expanded = variant_of(base, choice.folded(False)) if choice.without else base
        variant = unexpanded(expanded)
        _expanded[variant] = expanded
    else:
        variant = _without(base, choice.without)
    _origins[variant] = (base, choice)
    return variant


def _without(base: Catalogue, names: frozenset[str]) -> Catalogue:
    """The catalogue composed again without some overlays. It still tolerates what it tolerated of an old release."""
    first, *overlays = base.tree_layers
    layers = [first, *(layer for layer in overlays if PurePath(layer.name).stem not in names)]
    catalogue = compose(
        layers, base.vocabulary, base.type_layers, name=base.name, expanded=base.is_expanded, earlier=base
    )
    return tolerating(catalogue, base.findings)
