"""A project: the catalogues and functions of a `sigcat.toml`."""

from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.python_api.catalogue import Catalogue, changes_between, sound
from sigcat.python_api.opening import PathLike, absolute, read_project_of, sources_of

if TYPE_CHECKING:
    from sigcat.catalogue.comparing.changes import Change
    from sigcat.catalogue.hosting.library import Library
    from sigcat.catalogue.hosting.source import Source
    from sigcat.catalogue.model import catalogue as model
    from sigcat.findings import Finding
    from sigcat.function.hosting import FunctionLibrary, HostedFunction
    from sigcat.function.node_uses import NodeUse
    from sigcat.project import project as read


class Project:
    """The catalogues and functions of a project. Files are read when they are needed, and again by `reload`."""

    def __init__(self, project: "read.Project", folder: Path) -> None:
        self._project = absolute(project)
        self._sources = absolute(sources_of(project))
        self._folder = folder.absolute()

    @property
    def catalogues(self) -> tuple[str, ...]:
        """Ids of the catalogues, the default one first."""
        return tuple(source.id for source in self._sources)

    @property
    def vehicles(self) -> tuple[str, ...]:
        """Names of the vehicles, for `catalogue` and `diff`: `vehicle:ID`, or `vehicle:ID@STATE`."""
        return tuple(vehicle.label for vehicle in self._project.vehicles)

    @property
    def root(self) -> Path:
        """Folder of the `sigcat.toml`, else the folder that was opened."""
        return self._project.file.parent if self._project.file else self._folder

    @property
    def functions(self) -> tuple[Path, ...]:
        """The function files of the project, for `Catalogue.resolve`."""
        return tuple(each.file.path for each in self._built(self._composed("")) if not each.file.is_shipped)

    def catalogue(self, name: str = "") -> Catalogue:
        """Return a catalogue by its id, or the default one; `vehicle:ID` is that of a vehicle.

        Raises NotFound with near ids, InputRefused with every finding if its files have errors.
        """
        from sigcat.catalogue.model.vehicle import VEHICLE

        if name.startswith(VEHICLE):
            return self._vehicle(name)
        hosted = self._library.get(name or self.catalogues[0])
        return sound(hosted.catalogue, hosted.source.title, self._project.lint, hosted.rejected)

    def users(self, path: str, catalogue: str = "") -> "tuple[NodeUse, ...]":
        """Return the uses of a node, or of any node below a branch, by the functions of the project.

        Files that `function_errors` reports are not among them. Raises NotFound with near paths.
        """
        from sigcat.catalogue.find_node import find_node
        from sigcat.function.node_uses import uses_of

        composed = self._composed(catalogue)
        found = find_node(path, composed)
        wanted = {node.path for top in found.instances or (found.node,) for node in composed.nodes[top.path].walk()}
        uses = (use for each in self._built(composed) if each.function for use in uses_of(each.id, each.function))
        return tuple(use for use in uses if use.path in wanted)

    def function_errors(self, catalogue: str = "") -> "tuple[Finding, ...]":
        """Return the errors of function files that cannot be used with a catalogue."""
        built = self._built(self._composed(catalogue))
        findings = (finding for each in built for finding in (*each.findings, *each.file.rejected))
        return tuple(finding for finding in findings if finding.severity == "error")

    def diff(self, old: str, new: str) -> "tuple[Change, ...]":
        """Return the changes between two sides: ids of catalogues, or names as for `sigcat diff`."""
        return changes_between(old, new, self._source_named)

    def reload(self) -> None:
        """Read files that changed again."""
        self._library.reload_changed()
        self._functions.reload_changed()

    def _vehicle(self, name: str) -> Catalogue:
        from sigcat.catalogue.hosting.source import load

        source = self._source_named(name)
        return sound(load(source), source.title, self._project.lint, ())

    @cached_property
    def _library(self) -> "Library":
        from sigcat.catalogue.hosting.library import Library

        return Library(self._sources)

    @cached_property
    def _functions(self) -> "FunctionLibrary":
        from sigcat.function.hosting import FunctionLibrary

        project = self._project
        return FunctionLibrary(project.functions, has_shipped=project.has_shipped_functions, catalogues=self._library)

    def _built(self, composed: "model.Catalogue") -> "tuple[HostedFunction, ...]":
        from sigcat.function.hosting import buildable, functions_over

        return functions_over(buildable(self._functions.files, composed), composed)

    def _composed(self, name: str) -> "model.Catalogue":
        return self.catalogue(name)._composed

    def _source_named(self, name: str) -> "Source":
        from sigcat.catalogue.hosting.sources import source_of_tree
        from sigcat.catalogue.model.vehicle import VEHICLE
        from sigcat.project.chosen_tree import vehicle_source

        if name.startswith(VEHICLE):
            return vehicle_source(self._project, name)
        declared = (source for source in self._sources if source.id == name)
        return next(declared, None) or source_of_tree(name)

    def __repr__(self) -> str:
        return f"<sigcat.Project {', '.join(self.catalogues)}>"


def open_project(folder: PathLike = ".") -> Project:
    """Open the project of a folder: the nearest `sigcat.toml` in it or above it, else what sigcat ships.

    Raises InputRefused with everything that is wrong with the file, UsageError if there is no such folder.
    """
    from sigcat.errors import existing_folder

    found = existing_folder(folder)
    return Project(read_project_of(found.absolute()), found)
