"""`sigcat serve`."""

import argparse
from contextlib import nullcontext

from app.cli.catalogue_options import add_catalogue_options, chosen_configuration
from app.cli.tree_options import add_tree_options, tree_files


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "serve",
        help="serve the catalogue: browser tree and REST API",
        description="Serve the shipped catalogues, those of a configuration, and the tree named by -s, as a browser tree and REST API.",
    )
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on (default: %(default)s)")
    parser.add_argument(
        "--port", type=int, default=8000, help="port to listen on; 0 picks a free one (default: %(default)s)"
    )
    add_catalogue_options(parser)
    add_tree_options(parser)
    parser.set_defaults(run=serve)


def serve(arguments: argparse.Namespace) -> int:
    """Serve until interrupted."""
    from app.catalogue.hosting import Library, Source, Watch
    from app.web.serving import serve as serve_application

    configuration = chosen_configuration(arguments)
    sources = configuration.sources
    if arguments.vspec is not None or arguments.overlays:
        spec, units, overlays = tree_files(arguments)
        own = Source(
            "local", spec.stem, spec, overlays, units,
            tuple(arguments.quantities), tuple(arguments.types), tuple(arguments.include_dirs),
        )  # fmt: skip
        sources = (own, *sources)
    library = Library(sources)
    with Watch(library) if configuration.is_watching else nullcontext():
        serve_application(library, arguments.host, arguments.port)
    return 0
