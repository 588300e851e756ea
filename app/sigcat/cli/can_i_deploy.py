"""`sigcat can-i-deploy FUNC@V --to LINE`."""

import argparse
from typing import TYPE_CHECKING

from sigcat.cli.project_options import add_project_options
from sigcat.cli.registry_options import access_of, add_server, print_more
from sigcat.errors import InputRefused, UsageError
from sigcat.limits import REGISTRY_ROWS
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.registry.compatibility.deploying import Answer


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "can-i-deploy",
        help="say whether a version fits all vehicles of a line",
        description=(
            "Check a published version with every version of other functions that vehicles of the line run. Nothing is "
            "recorded."
        ),
        epilog="Exit status: 0 yes; 1 no, or unknown because nothing is recorded for the line.",
    )
    parser.add_argument("function", metavar="FUNC@V", help="published version of a function")
    parser.add_argument("--to", action="append", required=True, metavar="LINE", help="vehicle line")
    parser.add_argument(
        "--with", dest="others", action="append", default=[], metavar="OTHER@V",
        help="version that ships together with it; may be repeated",
    )  # fmt: skip
    parser.add_argument("--format", choices=("text", "json"), default="text", help="default: %(default)s")
    add_server(parser)
    add_project_options(parser)
    parser.set_defaults(run=can_i_deploy)


def can_i_deploy(arguments: argparse.Namespace) -> int:
    """Print the answer with its reasons; 0 only if it is yes."""
    access, line = access_of(arguments), _line_of(arguments)
    from sigcat.registry.reference import NO_ANSWER, reference_of

    try:
        references = [reference_of(text) for text in (arguments.function, *arguments.others)]
    except InputRefused as error:  # a question changes nothing
        raise InputRefused(NO_ANSWER, error.findings) from None
    answer = access.can_deploy(references, line)
    if arguments.format == "json":
        import json

        print(json.dumps(_data(answer), indent=2, ensure_ascii=False))
    else:
        _print(answer)
    return int(answer.decision != "yes")


def _line_of(arguments: argparse.Namespace) -> str:
    """The vehicle line. Raises UsageError for several: the answer is about one."""
    if len(arguments.to) > 1:
        raise UsageError("--to must be given once: ask for each vehicle line separately")
    return str(arguments.to[0])


def _print(answer: "Answer") -> None:
    deployed = ", ".join(map(str, answer.deployed))
    print_more(len(answer.conflicts))
    for conflict in answer.conflicts[:REGISTRY_ROWS]:
        print(conflict.finding.line_of_text)
    if answer.finding is not None:
        print(answer.finding.line_of_text)
    checked = (
        f"checked with {', '.join(map(str, answer.checked))}" if answer.checked else "no other function runs there"
    )
    reason = "" if answer.decision == "unknown" else f" ({checked})"
    print(printable(f"{answer.decision}: {deployed} in line {answer.line}{reason}"))


def _data(answer: "Answer") -> dict[str, object]:
    return {
        "decision": answer.decision,
        "line": answer.line,
        "deployed": [each._asdict() for each in answer.deployed],
        "checked": [each._asdict() for each in answer.checked],
        "conflicts": [
            {
                "rule": each.rule, "severity": each.severity, "message": each.message, "path": each.path,
                "attribute": each.attribute, "sides": [side._asdict() for side in each.sides],
            }
            for each in answer.conflicts[:REGISTRY_ROWS]
        ],
        "finding": answer.finding._asdict() if answer.finding else None,
    }  # fmt: skip
