"""`sigcat completion SHELL`: the script by which a shell completes commands, options, signals, catalogues, rules and units."""

import argparse
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from sigcat.catalogue.model.vehicle import VEHICLE
from sigcat.cli.command_parser import CommandParser
from sigcat.cli.project_options import project_of
from sigcat.cli.tree_options import tree_options
from sigcat.errors import SigcatError

if TYPE_CHECKING:
    from sigcat.project.project import Project

_SHELLS = ("bash", "zsh", "fish")
_EPILOG = """To complete in every shell, add to its start-up file:

  bash   eval "$(sigcat completion bash)"       ~/.bashrc
  zsh    eval "$(sigcat completion zsh)"        ~/.zshrc, after compinit
  fish   sigcat completion fish | source        ~/.config/fish/config.fish
"""


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "completion",
        help="print the completion script of a shell",
        description="Print the script by which a shell completes commands, options, files, and of the project: paths of "
        "signals, ids of catalogues, rules and units.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("shell", choices=_SHELLS, metavar="SHELL", help="bash, zsh or fish")
    parser.set_defaults(run=completion)


def completion(arguments: argparse.Namespace) -> int:
    """Print the script."""
    from argcomplete.shell_integration import shellcode

    print(shellcode(["sigcat"], shell=arguments.shell))
    return 0


def wanted_command() -> str:
    """The command on the line that the shell completes, if it is whole."""
    words = os.environ.get("COMP_LINE", "").split(" ")
    return words[1] if len(words) > 2 else ""


def answer(parser: CommandParser) -> None:
    """Answer the shell, and end the process."""
    from argcomplete import autocomplete

    _add_completers(parser)
    autocomplete(parser, always_complete_options=False)


def _add_completers(parser: CommandParser) -> None:
    if getattr(parser, "fill", None) is not None:  # a parser that adds its options when it is used
        parser.parse_known_args([])
    for action in parser.actions:
        if isinstance(action, argparse._SubParsersAction):  # noqa: SLF001
            for below in action.choices.values():
                _add_completers(below)
        elif (parser.prog.split()[-1], action.dest) in _COMPLETERS:
            action.completer = _COMPLETERS[parser.prog.split()[-1], action.dest]  # type: ignore[attr-defined]
        elif action.dest in _OF_DEST:
            action.completer = _OF_DEST[action.dest]  # type: ignore[attr-defined]


Completer = Callable[..., Iterable[str]]


def _safe(find: Callable[[str, argparse.Namespace], Iterable[str]]) -> Completer:
    """A completer that has nothing to propose where the project or its tree cannot be read."""

    def complete(prefix: str, parsed_args: argparse.Namespace, **_others: Any) -> Sequence[str]:
        try:
            return [found for found in find(prefix, parsed_args) if found.startswith(prefix)]
        except (SigcatError, OSError):
            return []

    return complete


def _signals(prefix: str, arguments: argparse.Namespace) -> Sequence[str]:
    """The paths one level below what is written; a branch ends in a dot, as a folder in a slash.

    Where only one branch fits, what is below it: shells write a space after a word that is complete.
    """
    from sigcat.catalogue.hosting.source import load
    from sigcat.project.chosen_tree import chosen_tree

    nodes = load(chosen_tree(project_of(arguments), tree_options(arguments))).nodes.values()
    while True:
        fitting = [node for node in nodes if node.path.startswith(prefix) and node.path.count(".") == prefix.count(".")]
        if len(fitting) != 1 or not fitting[0].children:
            return [f"{node.path}." if node.children else node.path for node in fitting]
        prefix = f"{fitting[0].path}."


def _units(_prefix: str, arguments: argparse.Namespace) -> Iterator[str]:
    from sigcat.catalogue.hosting.source import load
    from sigcat.project.chosen_tree import chosen_tree

    source = chosen_tree(project_of(arguments), tree_options(arguments))
    yield "convert"
    yield from (unit.key for unit in load(source, expanded=False).vocabulary.distinct_units)


def _rules(_prefix: str, arguments: argparse.Namespace) -> Iterator[str]:
    from sigcat.rules.linting.selection import rules_for

    yield from (rule.id for rule in rules_for(project_of(arguments).lint))


def _trees(prefix: str, arguments: argparse.Namespace) -> Iterator[str]:
    from argcomplete.completers import FilesCompleter

    from sigcat.catalogue.hosting.sources import pulled_sources, shipped_sources

    project = project_of(arguments)
    sources = (*project.catalogues, *shipped_sources(), *pulled_sources())
    yield from dict.fromkeys(source.id for source in sources)
    yield from dict.fromkeys(f"{VEHICLE}{name}" for name in _names_of_vehicles(project))
    yield from FilesCompleter()(prefix)


def _names_of_vehicles(project: "Project") -> Iterator[str]:
    for vehicle in project.vehicles:
        yield vehicle.id
        yield vehicle.name


def _vehicles(_prefix: str, arguments: argparse.Namespace) -> Iterator[str]:
    yield "all"
    yield from dict.fromkeys(_names_of_vehicles(project_of(arguments)))


_COMPLETERS = {
    ("show", "path"): _safe(_signals),
    ("rule", "code"): _safe(_rules),
    ("units", "words"): _safe(_units),
}
"""By command and name of the argument."""
_OF_DEST = {
    **dict.fromkeys(("vspec", "old", "new"), _safe(_trees)),
    "define_under": _safe(_signals),
    "vehicles": _safe(_vehicles),
}
