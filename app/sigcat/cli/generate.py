"""`sigcat generate arxml INTEGRATION -o DIR`."""

import argparse
from pathlib import Path

from sigcat.cli.output import write_bytes
from sigcat.errors import UsageError


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command with a sub-command for each kind of file."""
    parser = commands.add_parser("generate", help="files for a platform, from Integration JSON")
    kinds = parser.add_subparsers(title="kinds", metavar="KIND", required=True)
    arxml = kinds.add_parser(
        "arxml",
        help="ARXML for AUTOSAR adaptive R23-11",
        description="Write ARXML for AUTOSAR adaptive R23-11: types, interfaces, components and deployment.",
    )
    arxml.add_argument("integration", type=Path, metavar="INTEGRATION", help="Integration JSON for AUTOSAR adaptive")
    arxml.add_argument("-o", "--output", type=Path, required=True, metavar="DIR", help="folder to write to")
    arxml.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Write the files; the folder is made if its parent exists. Raises InputRefused if the document cannot be used."""
    from sigcat.adapter.autosar_adaptive.arxml.generate import generate
    from sigcat.integration.autosar_adaptive.document import read_integration

    if not arguments.integration.is_file():
        raise UsageError(f"{arguments.integration}: there is no such file")
    files = generate(read_integration(arguments.integration.read_bytes(), str(arguments.integration)))
    _make(arguments.output)
    for file in files:
        write_bytes(file.data, arguments.output / file.name)
    return 0


def _make(folder: Path) -> None:
    if folder.exists() and not folder.is_dir():
        raise UsageError(f"{folder}: is not a folder")
    if not folder.parent.is_dir():
        raise UsageError(f"{folder.parent}: there is no such folder")
    folder.mkdir(exist_ok=True)
