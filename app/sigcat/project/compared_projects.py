"""The projects that sides of a comparison are in: a folder, or the folder of an unpacked revision."""

import os
from functools import partial
from pathlib import Path

from sigcat.catalogue.comparing.sides import NO_PROJECT, Projects, SideProject
from sigcat.catalogue.model.vehicle import VEHICLE
from sigcat.project.chosen_tree import source_of_vehicle, with_additions
from sigcat.project.find_project import nearest_project
from sigcat.project.project import Project
from sigcat.project.read_project import read_catalogues
from sigcat.real_path import real_path


def side_project(project: Project) -> SideProject:
    """The project as a comparison needs it."""
    sources = {source.id: source for source in project.catalogues}
    vehicles = [(vehicle, source_of_vehicle(project, vehicle)) for vehicle in project.vehicles]
    by_id = {f"{VEHICLE}{vehicle.id}": source for vehicle, source in vehicles}
    by_name = {vehicle.label: source for vehicle, source in vehicles}
    return SideProject({**sources, **by_id, **by_name}, partial(with_additions, project=project))


def compared_projects(named: Path | None) -> Projects:
    """Find the projects of sides. `named` is the project file that an option names: another side has it at the same place."""

    def find(folder: Path, top: Path) -> SideProject:
        file = nearest_project(folder, real_path(top)) if named is None else _beside(named, folder, real_path(top))
        return NO_PROJECT if file is None else side_project(read_catalogues(file))

    return find


def _beside(named: Path, folder: Path, top: Path) -> Path | None:
    file = real_path(folder / os.path.relpath(named))
    return file if file.is_file() and file.is_relative_to(top) else None
