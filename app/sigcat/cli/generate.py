"""`sigcat generate KIND INTEGRATION -o DIR`."""

import argparse
from pathlib import Path

from sigcat.cli import generate_core
from sigcat.cli.generated_folder import add_folder, paths_in, write_generated
from sigcat.cli.output import write_bytes
from sigcat.cli.output_options import add_output, refuse_overwriting
from sigcat.errors import existing_file
from sigcat.platforms.platform import Generator, Options, Platform
from sigcat.platforms.table import PLATFORMS


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command with a sub-command for each kind of file."""
    parser = commands.add_parser("generate", help="files for a platform, from Integration JSON")
    kinds = parser.add_subparsers(title="kinds", metavar="KIND")
    for platform in PLATFORMS.values():
        for generator in platform.generators:
            _add_kind(kinds, platform, generator)
    generate_core.add_kind(kinds)


def _add_kind(
    kinds: "argparse._SubParsersAction[argparse.ArgumentParser]", platform: Platform, generator: Generator
) -> None:
    one = kinds.add_parser(
        generator.name,
        help=f"{generator.title} for {generator.target}",
        description=f"Write {generator.title} for {generator.target}: {generator.contents}.",
    )
    one.add_argument("integration", type=Path, metavar="INTEGRATION", help=f"Integration JSON for {platform.title}")
    add_folder(one)
    add_output(one, "--report", metavar="FILE", help="where each field went: .json, or else a Markdown table")
    if generator.releases:
        one.add_argument(
            f"--{generator.release_word}",
            dest="release",
            choices=generator.releases,
            metavar=generator.release_word.upper(),
            help=f"{', '.join(generator.releases)} (default: {generator.default_release or 'that of the Integration JSON'})",
        )
    if generator.has_bench:
        help_text = f"add what builds and runs it without {platform.title}: for desks and tests, not for vehicles"
        one.add_argument("--bench", action="store_true", help=help_text)
    one.set_defaults(run=run, generator=generator)


def run(arguments: argparse.Namespace) -> int:
    """Write the files; the folder is made if its parent exists. Raises InputRefused if the document cannot be used."""
    from sigcat.integration.report import written_as
    from sigcat.limits import DEFAULT_LIMITS

    source = existing_file(arguments.integration)
    options = Options(getattr(arguments, "release", None), getattr(arguments, "bench", False))
    files = arguments.generator.generate(source.read_bytes(), str(source), DEFAULT_LIMITS, options)
    refuse_overwriting(arguments, written=paths_in(arguments.output, files))
    write_generated(files, arguments.output, arguments.generator.name, is_whole=True, force=arguments.force)
    if arguments.report is not None:
        report = arguments.generator.report(source.read_bytes(), str(source), DEFAULT_LIMITS)
        write_bytes(written_as(report, arguments.report.suffix), arguments.report)
    return 0
