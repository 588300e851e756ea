"""The book of rules, docs/reference/rules.md, made from interface_rules/."""

from collections.abc import Mapping

from sigcat.data import INTERFACE_RULES
from sigcat.rules.pages import service_rules
from sigcat.rules.record import load_rules


def files() -> Mapping[str, str]:
    """The book."""
    return {"docs/reference/rules.md": service_rules(load_rules(INTERFACE_RULES))}
