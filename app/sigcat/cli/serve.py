"""`sigcat serve`."""

import argparse
import atexit
from contextlib import ExitStack, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.catalogue_options import add_catalogue_options, hosted_sources, read_again, served_project
from sigcat.cli.ended_by_signals import was_interrupted
from sigcat.cli.registry_options import hosted_registry
from sigcat.cli.tree_options import add_tree_options, tree_options
from sigcat.errors import UsageError, without_signals
from sigcat.findings import has_errors

if TYPE_CHECKING:
    from fastapi import FastAPI

    from sigcat.catalogue.hosting.library import Library
    from sigcat.catalogue.hosting.source import Source
    from sigcat.function.hosting import FunctionLibrary
    from sigcat.project.changed_file import ProjectFile
    from sigcat.project.project import Project

_HIGHEST_PORT = 65535


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "serve",
        help="serve the catalogue: browser tree and REST API",
        description="Serve the shipped catalogues and functions, those of a configuration, and the tree named by -s, as a "
        "browser tree and REST API. `sigcat config` lists what else can be set.",
    )
    parser.add_argument("--host", help="address to listen on (default: 127.0.0.1)")
    parser.add_argument("--port", type=_port, help="port to listen on; 0 picks a free one (default: 8000)")
    add_catalogue_options(parser)
    add_tree_options(parser)
    parser.set_defaults(run=serve)


def _port(text: str) -> int:
    if not (text.isascii() and text.isdecimal() and len(text) < 6 and int(text) <= _HIGHEST_PORT):
        raise argparse.ArgumentTypeError(f"must be a port from 0 to {_HIGHEST_PORT}, not {text[:80]!r}")
    return int(text)


def serve(arguments: argparse.Namespace) -> int:
    """Serve until interrupted."""
    from sigcat.api.hangup import ignore_hangup
    from sigcat.zygote import IS_POSSIBLE

    if not IS_POSSIBLE:
        raise UsageError("`sigcat serve` needs Linux or macOS. Use the container, or the Linux subsystem of Windows.")
    ignore_hangup()
    from sigcat.api.server import run
    from sigcat.catalogue.hosting.library import Library, Watch
    from sigcat.function.hosting import FunctionLibrary
    from sigcat.temporary_files import temporary_folder
    from sigcat.web.openid import check_openid
    from sigcat.web.site import create_site

    with temporary_folder("sigcat-serve-"):
        pass  # better told now than with the first export
    project, settings = served_project(arguments)
    library = Library(_sources(arguments, project))
    _refuse_without_signals(library, project)
    check_openid(settings)
    functions = FunctionLibrary(project.functions, has_shipped=project.has_shipped_functions, catalogues=library)
    if was_interrupted():
        raise KeyboardInterrupt
    file = _project_file(arguments, project, library, functions)
    with Watch(file, library, functions) if project.is_watching else nullcontext():
        run(create_site(library, settings, functions, hosted_registry(project), project.lint), settings)
    return 0


def _refuse_without_signals(library: "Library", project: "Project") -> None:
    """Raise UsageError for a catalogue of the project that has nothing to show; one with errors is hosted, and says so."""
    for hosted in filter(None, (library.find(source.id) for source in project.catalogues)):
        catalogue = hosted.catalogue
        if not catalogue.has_signals and not has_errors(catalogue.findings):
            raise UsageError(f"catalogue {hosted.source.id!r}: {without_signals(hosted.source.spec)}")


def _project_file(
    arguments: argparse.Namespace, project: "Project", library: "Library", functions: "FunctionLibrary"
) -> "ProjectFile":
    """Return the project file, whose changes are hosted."""
    from sigcat.project.changed_file import ProjectFile

    def take(file: Path) -> None:
        changed = read_again(arguments, file)
        library.host(_sources(arguments, changed))
        functions.host(changed.functions, has_shipped=changed.has_shipped_functions)

    return ProjectFile(project.file, take, library.refuse)


def _sources(arguments: argparse.Namespace, project: "Project") -> "tuple[Source, ...]":
    """Return the sources with the tree that the options name in front: of the project by its id, any other as `local`."""
    from sigcat.catalogue.hosting.sources import sources_in_order
    from sigcat.project.chosen_tree import TreeOptions, chosen_tree

    sources = hosted_sources(arguments, project)
    given = tree_options(arguments)
    if given == TreeOptions():
        return sources
    source = chosen_tree(project, given)
    if source not in project.catalogues:
        source = source._replace(id="local", title=source.spec.stem)
    return sources_in_order((source,), sources)


def application() -> "FastAPI":
    """The service as another server loads it: `uvicorn --factory sigcat.cli.serve:application --workers 4`."""
    from sigcat.api.hangup import ignore_hangup
    from sigcat.api.server import prepare
    from sigcat.catalogue.hosting.library import Library, Watch
    from sigcat.function.hosting import FunctionLibrary
    from sigcat.web.openid import check_openid
    from sigcat.web.site import create_site

    ignore_hangup()
    parser = argparse.ArgumentParser()
    add_catalogue_options(parser)
    add_tree_options(parser)
    arguments = parser.parse_args([])
    project, settings = served_project(arguments)
    library = Library(_sources(arguments, project))
    _refuse_without_signals(library, project)
    check_openid(settings)
    functions = FunctionLibrary(project.functions, has_shipped=project.has_shipped_functions, catalogues=library)
    service = create_site(library, settings, functions, hosted_registry(project), project.lint)
    prepare(service, settings)
    if project.is_watching:
        watching = ExitStack()
        file = _project_file(arguments, project, library, functions)
        watching.enter_context(Watch(file, library, functions))
        atexit.register(watching.close)
    return service
