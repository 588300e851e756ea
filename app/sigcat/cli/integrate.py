"""`sigcat integrate PLATFORM FUNCTION...`."""

import argparse
import os
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.function_options import add_functions, deployment_of, functions_of, tree_for_functions
from sigcat.cli.output import print_findings, write_bytes
from sigcat.cli.output_options import add_output
from sigcat.cli.project_options import project_of
from sigcat.cli.tree_options import add_tree_options
from sigcat.errors import existing_file
from sigcat.platforms.table import PLATFORMS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sigcat.catalogue.model.catalogue import Catalogue
    from sigcat.function.function_json.resolved_function import ResolvedFunction
    from sigcat.integration.deployment import Deployment
    from sigcat.platforms.platform import Platform


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command with a sub-command for each platform."""
    parser = commands.add_parser("integrate", help="Integration JSON of functions, for a platform")
    platforms = parser.add_subparsers(title="platforms", metavar="PLATFORM")
    for platform in PLATFORMS.values():
        one = platforms.add_parser(
            platform.name,
            help=f"for {platform.title}",
            description=f"Derive the Integration JSON for {platform.title} of one function, or of a set of functions.",
        )
        add_functions(one)
        one.add_argument(
            "--deployment",
            type=Path,
            metavar="FILE",
            help="what differs from the defaults (default: that of the project)",
        )
        add_output(one, "-o", "--output", metavar="OUT", help="write here instead of to standard output")
        add_output(one, "--report", metavar="FILE", help="where each field went: .json, or else a Markdown table")
        if platform.with_identifiers is not None:
            one.add_argument(
                "--identifiers",
                type=Path,
                action="append",
                default=[],
                metavar="FILE",
                help="ids that are given away, as CSV or ARXML; may be repeated",
            )
        if platform.with_previous is not None:
            one.add_argument(
                "--previous",
                type=Path,
                metavar="FILE",
                help="the Integration JSON before: services that changed get a new version",
            )
        add_tree_options(one)
        one.set_defaults(run=run, platform=platform)


def run(arguments: argparse.Namespace) -> int:
    """Write the Integration JSON; findings go to standard error. Raises InputRefused if there are errors."""
    from sigcat.integration.report import written_as
    from sigcat.platforms.integrate import integrate

    files = [(path.read_bytes(), str(path)) for path in functions_of(arguments)]
    catalogue = tree_for_functions(arguments, files)
    functions = _functions(files, catalogue)
    integrated = integrate(arguments.platform, functions, _deployment(arguments, catalogue), _previous(arguments))
    print_findings(integrated.findings)
    write_bytes(integrated.document, arguments.output)
    if arguments.report is not None:
        write_bytes(written_as(integrated.report, arguments.report.suffix), arguments.report)
    return 0


def _functions(files: "Sequence[tuple[bytes, str]]", catalogue: "Catalogue") -> "tuple[ResolvedFunction, ...]":
    from sigcat.integration.reading import read_functions

    functions, findings = read_functions(files, catalogue)
    print_findings(findings)
    return functions


def _deployment(arguments: argparse.Namespace, catalogue: "Catalogue") -> "Deployment":
    """Return the deployment, with the ids of the named files, and what the platform needs of the catalogue."""
    from sigcat.limits import DEFAULT_LIMITS
    from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT, deployment_of_file

    platform: Platform = arguments.platform
    path = deployment_of(arguments)
    deployment = DEFAULT_DEPLOYMENT if path is None else deployment_of_file(path, os.environ)
    files = [(existing_file(each).read_bytes(), str(each)) for each in getattr(arguments, "identifiers", ())]
    if files and platform.with_identifiers is not None:
        deployment = platform.with_identifiers(deployment, files, DEFAULT_LIMITS)
    if platform.with_catalogue is None:
        return deployment
    return platform.with_catalogue(deployment, catalogue, project_of(arguments).dbc)


def _previous(arguments: argparse.Namespace) -> tuple[bytes, str] | None:
    path: Path | None = getattr(arguments, "previous", None)
    return None if path is None else (existing_file(path).read_bytes(), str(path))
