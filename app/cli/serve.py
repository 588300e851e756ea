"""`sigcat serve`."""

import argparse

from app.cli.tree_options import add_tree_options


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "serve",
        help="serve the catalogue: browser tree and REST API",
        description="Serve the shipped catalogues, or the tree named by -s, as a browser tree and a REST API.",
    )
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on (default: %(default)s)")
    parser.add_argument(
        "--port", type=int, default=8000, help="port to listen on; 0 picks a free one (default: %(default)s)"
    )
    add_tree_options(parser)
    parser.set_defaults(run=serve)


def serve(arguments: argparse.Namespace) -> int:
    """Serve until interrupted."""
    from app.web.serving import serve as serve_application
    from app.catalogue.hosting import Library, Source, shipped_sources
    from app.cli.tree_options import tree_files

    sources = shipped_sources()
    if arguments.vspec is not None or arguments.overlays:
        spec, units, overlays = tree_files(arguments)
        own = Source(
            "local", spec.stem, spec, overlays, units,
            tuple(arguments.quantities), tuple(arguments.types), tuple(arguments.include_dirs),
        )  # fmt: skip
        sources = (own, *sources)
    serve_application(Library(sources), arguments.host, arguments.port)
    return 0
