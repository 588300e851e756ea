"""`sigcat version-bump [OLD] [NEW]`: the version that the changes since the last one need."""

import argparse
import sys

from sigcat.cli.compared_sides import SIDES, add_sides, changes_between, names_of_sides, read_compared

_EPILOG = f"""A breaking change needs a major version, a risky or compatible one a minor version, a change of texts a patch.
Before 1.0.0, a breaking change needs a minor version, all others a patch. Risky changes are listed: raise the version
further where one of them breaks your users.

{SIDES}"""


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "version-bump",
        help="propose the next version of a catalogue",
        description="Compare two trees and print the version that NEW needs after OLD (default: the last tag of git). "
        "Without a version in the name of OLD, print the part that changes: major, minor, patch or none.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add_sides(parser)
    parser.set_defaults(run=version_bump)


def version_bump(arguments: argparse.Namespace) -> int:
    """Print the version, or the part; the reason goes to standard error."""
    from sigcat.catalogue.comparing.changelog import next_version, version_part
    from sigcat.catalogue.comparing.diff_report import sentence, summary
    from sigcat.catalogue.comparing.sides import GIT

    if arguments.old is None and arguments.merge_base is None:
        from sigcat.catalogue.reading.git_revision import last_tag

        arguments.old = f"{GIT}{last_tag()}"
    old, new = names_of_sides(arguments)
    changes = changes_between(*read_compared(arguments, old, new))
    part = version_part(changes)
    print(f"{old} to {new}: {part}. {summary(changes)}", file=sys.stderr)
    for change in changes:
        if change.compatibility in ("breaking", "risky"):
            print(f"  {change.compatibility}: {sentence(change)}", file=sys.stderr)
    print(next_version(old.removeprefix(GIT).partition(":")[0], part) or part)
    return 0
