"""`sigcat rule [CODE]`."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.output import could_not_run
from sigcat.cli.project_options import add_project_options, project_of
from sigcat.data import INTERFACE_RULES
from sigcat.errors import InputRefused, NotFound
from sigcat.names import nearest
from sigcat.terminal_text import printable, printable_lines

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sigcat.rules.record import Rule


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "rule",
        help="list the rules, or explain one",
        description=(
            "List all rules, or say what one checks and why, with good and bad examples. Rules of the project are "
            "among them."
        ),
    )
    parser.add_argument("code", nargs="?", metavar="CODE", help="code or name of a rule, such as V101")
    add_project_options(parser)
    parser.set_defaults(run=show_rule)


def show_rule(arguments: argparse.Namespace) -> int:
    """Print the rules. Raises NotFound with the nearest codes and names."""
    rules = _rules(arguments)
    if arguments.code is None:
        for rule in rules:
            print(printable(_line(rule)))
    else:
        print(printable_lines(_page(_find(arguments.code, rules))), end="")
    return 0


def _rules(arguments: argparse.Namespace) -> "Sequence[Rule]":
    """The shipped rules and those of the project. Raises UsageError where the latter cannot be used."""
    from sigcat.rules.linting.selection import rules_for

    try:
        return rules_for(project_of(arguments).lint)
    except InputRefused as error:
        raise could_not_run(error) from None


def _find(wanted: str, rules: "Sequence[Rule]") -> "Rule":
    for rule in rules:
        if wanted.upper() == rule.id or wanted == rule.name:
            return rule
    near = nearest(wanted, [*(rule.id for rule in rules), *(rule.name for rule in rules)])
    hint = f" Did you mean {' or '.join(near)}?" if near else " `sigcat rule` lists all of them."
    raise NotFound(f"unknown rule {wanted!r}.{hint}", near)


def _line(rule: "Rule") -> str:
    own = f" ({rule.file})" if _is_own(rule) else ""
    return f"{rule.id:5} {rule.severity if rule.default else 'off':8} {rule.title}{own}"


def _page(rule: "Rule") -> str:
    from sigcat.rules.pages import rule_page

    own = f"\nDefined in {rule.file}, line {rule.line}.\n" if _is_own(rule) else ""
    return rule_page(rule) + own


def _is_own(rule: "Rule") -> bool:
    """Whether the rule is one of the company that uses sigcat."""
    return Path(rule.file).parent != INTERFACE_RULES
