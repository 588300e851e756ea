"""The vehicles of a project, each with its catalogue."""

from collections.abc import Iterator, Sequence
from itertools import groupby

from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.vehicles import Composed, composed_vehicles
from sigcat.catalogue.model.vehicle import Vehicle
from sigcat.errors import NotFound
from sigcat.findings import Finding
from sigcat.names import nearest
from sigcat.project.chosen_tree import below_vehicle
from sigcat.project.project import Project

ALL = "all"


def chosen_vehicles(project: Project, names: str) -> tuple[Vehicle, ...]:
    """Return the vehicles that `all`, or ids with commas, name: an id all states, `ID@STATE` one. Raises NotFound."""
    if not project.vehicles:
        raise NotFound("The project has no vehicles. Add a [[vehicle]] to sigcat.toml.")
    if names == ALL:
        return project.vehicles
    found: dict[Vehicle, None] = {}
    for name in names.split(","):
        matching = [each for each in project.vehicles if name in (each.id, each.name)]
        if not matching:
            near = nearest(name, [word for each in project.vehicles for word in (each.id, each.name)])
            hint = f" Did you mean {near[0]}?" if near else ""
            raise NotFound(f"Unknown vehicle {name!r}.{hint}", near)
        found |= dict.fromkeys(matching)
    return tuple(found)


def each_composed(project: Project, vehicles: Sequence[Vehicle]) -> Iterator[Composed]:
    """Yield each vehicle with its catalogue. Vehicles of one catalogue, one after the other, share their nodes."""
    for _, group in groupby(vehicles, key=lambda vehicle: vehicle.catalogue):
        members = list(group)
        below = below_vehicle(project, members[0])
        yield from composed_vehicles(load(below), below, members)


def vehicle_findings(project: Project) -> Iterator[Finding]:
    """Yield the findings of vehicles in the project file."""
    for composed in each_composed(project, project.vehicles):
        yield from (each for each in composed.catalogue.findings if each.file == composed.vehicle.file)
