"""The book of rules, docs/reference/rules.md, made from interface_rules/."""

from collections.abc import Mapping

from sigcat.data import INTERFACE_RULES
from sigcat.rules.pages import rule_book
from sigcat.rules.record import load_rules


def files() -> Mapping[str, str]:
    """The book."""
    return {"docs/reference/rules.md": rule_book(load_rules(INTERFACE_RULES))}
