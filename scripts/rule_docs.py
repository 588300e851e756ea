"""The pages of rules, docs/reference/rules, made from interface_rules/: one for each rule, and an index."""

from collections.abc import Mapping, Sequence
from itertools import groupby

from sigcat.data import INTERFACE_RULES
from sigcat.rules.pages import rule_page
from sigcat.rules.record import Rule, load_rules

FOLDER = "docs/reference/rules"
_CATEGORIES: Mapping[str, str] = {
    "reading": "Reading files",
    "vss": "VSS",
    "units": "Units",
    "overlay": "Overlays",
    "data": "Data and parameter interfaces",
    "mapping": "Mappings to a network",
    "error": "Error interfaces",
    "safety_reaction": "Safety reaction interfaces",
    "mode": "Mode interfaces",
    "scheduling": "Scheduling interfaces",
    "function": "Function files",
    "code": "C code of functions",
    "read_code": "Import of C code",
    "portable_names": "Portable names",
    "integration": "Integration with a platform",
    "adapter": "Adapters",
    "simulation": "Simulation",
    "gateway": "Gateway",
    "migration": "Migrations",
    "export": "Exports",
    "registry": "Registry",
    "request": "Requests to the service",
    "configuration": "Configuration of the service",
    "lint": "The linter's own comments and files",
}
"""Categories in the order of the index, with their headings."""
_HEAD = """\
# Rules

Made from [interface_rules/](../../../interface_rules/) by `make generate`. `sigcat rule CODE` prints a page. Rules marked *off*
run where [they are selected](../configuration.md#lint)."""


def files() -> Mapping[str, str]:
    """The index and the pages."""
    rules = load_rules(INTERFACE_RULES)
    pages = {f"{FOLDER}/{rule.id}.md": f"{rule_page(rule)}\n[All rules](README.md)\n" for rule in rules}
    return {f"{FOLDER}/README.md": _index(rules), **pages}


def _index(rules: Sequence[Rule]) -> str:
    order = list(_CATEGORIES)
    parts = [_HEAD]
    ordered = sorted(rules, key=lambda rule: (order.index(rule.category), rule.id))
    for category, group in groupby(ordered, key=lambda rule: rule.category):
        rows = [f"| [{rule.id}]({rule.id}.md) | {_severity(rule)} | {_cell(rule.title)} |" for rule in group]
        table = "\n".join(["| code | severity | rule |", "|---|---|---|", *rows])
        parts.extend([f"## {_CATEGORIES[category]}", table])
    return "\n\n".join(parts) + "\n"


def _severity(rule: Rule) -> str:
    return rule.severity if rule.default else f"{rule.severity}, off"


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")
