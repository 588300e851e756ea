"""The module app/sigcat/codes.py, made from interface_rules/: a constant for each rule that code finds broken."""

from collections.abc import Mapping
from itertools import groupby

from sigcat.data import INTERFACE_RULES
from sigcat.rules.record import Rule, load_rules
from sigcat.rules.record_faults import MAKERS

_HEADER = '''\
"""The rules that code finds broken, by name: `codes.NOT_YAML.finding(message, file, line, …)`.

Written by `make generate` from the records in interface_rules/, which say why each rule is there and how severe it is.
"""

from sigcat.findings import RuleCode
'''


def files() -> Mapping[str, str]:
    """The module."""
    return {"app/sigcat/codes.py": codes_module(load_rules(INTERFACE_RULES))}


def codes_module(rules: tuple[Rule, ...]) -> str:
    """The module as text, in the order of categories and codes. Raises ValueError if two rules have one name."""
    found = sorted((rule for rule in rules if rule.check in MAKERS), key=lambda rule: (rule.category, rule.id))
    names = [rule.name for rule in found]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise ValueError(f"Two rules have the name {', '.join(twice)}: names must be unique.")
    paragraphs = [
        "\n".join([f"# {category}", *(_constant(rule) for rule in members)])
        for category, members in groupby(found, key=lambda rule: rule.category)
    ]
    return "\n\n".join([_HEADER.rstrip(), *paragraphs]) + "\n"


def _constant(rule: Rule) -> str:
    return f'{rule.name.replace("-", "_").upper()} = RuleCode("{rule.id}", "{rule.severity}")'
