"""`sigcat releases`."""

import argparse
import json
import sys


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "releases",
        help="list the releases that were pulled",
        description="List the releases of VSS that were pulled: version, date, nodes, digest of the archive.",
    )
    parser.add_argument("--format", choices=("text", "json"), default="text", help="(default: %(default)s)")
    parser.set_defaults(run=list_releases)


def list_releases(arguments: argparse.Namespace) -> int:
    """Print the pulled releases, oldest version first."""
    from sigcat.catalogue.hosting.releases import pulled_releases, releases_folder

    releases = pulled_releases()
    if arguments.format == "json":
        listed = [{**release._asdict(), "folder": str(release.folder)} for release in releases]
        print(json.dumps(listed, indent=2))
        return 0
    if not releases:
        print(f"No releases in {releases_folder()}. `sigcat pull v5.0` fetches one.", file=sys.stderr)
        return 0
    width = max(len(release.name) for release in releases)
    for release in releases:
        print(f"{release.name:{width}}  {release.pulled[:10]}  {release.nodes:6,} nodes  sha256:{release.digest}")
    return 0
