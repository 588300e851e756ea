"""`sigcat rule [CODE]`."""

import argparse

from sigcat.data import INTERFACE_RULES
from sigcat.errors import NotFound
from sigcat.names import nearest


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "rule",
        help="list the rules, or explain one",
        description="List all rules, or say what one checks and why, with good and bad examples.",
    )
    parser.add_argument("code", nargs="?", metavar="CODE", help="code or name of a rule, such as V101")
    parser.set_defaults(run=show_rule)


def show_rule(arguments: argparse.Namespace) -> int:
    """Print the rules. Raises NotFound with the nearest codes and names."""
    from sigcat.rules.compiled import compiled_rules
    from sigcat.rules.pages import rule_page

    rules = compiled_rules(INTERFACE_RULES)
    if arguments.code is None:
        for rule in rules:
            print(f"{rule.id:5} {rule.severity if rule.default else 'off':8} {rule.title}")
        return 0
    wanted = arguments.code
    found = next((rule for rule in rules if wanted.upper() == rule.id or wanted == rule.name), None)
    if found is None:
        near = nearest(wanted, [*(rule.id for rule in rules), *(rule.name for rule in rules)])
        hint = f" Did you mean {' or '.join(near)}?" if near else ""
        raise NotFound(f"there is no rule {wanted!r}.{hint}", near)
    print(rule_page(found), end="")
    return 0
