"""A rule as a page: the same text on the command line, in the browser and in docs/reference/rules.md."""

from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

from sigcat.rules.record import Rule

_CATEGORIES: Mapping[str, str] = {
    "reading": "Reading files",
    "vss": "VSS",
    "units": "Units",
    "overlay": "Overlays",
    "data": "Data and parameter interfaces",
    "error": "Error interfaces",
    "safety_reaction": "Safety reaction interfaces",
    "mode": "Mode interfaces",
    "scheduling": "Scheduling interfaces",
    "function": "Function files",
    "portable_names": "Portable names",
    "integration": "Integration with a platform",
    "export": "Exports",
    "request": "Requests to the service",
    "configuration": "Configuration of the service",
    "lint": "The linter's own comments and files",
}


def category_title(category: str) -> str:
    """The heading of a category; that of a company's own category is made from its name."""
    return _CATEGORIES.get(category, category.replace("_", " ").capitalize())


def rule_page(rule: Rule, level: int = 1) -> str:
    """Everything that is known of a rule, in Markdown."""
    state = "" if rule.default else " Off by default."
    parts = [
        f"{'#' * level} {rule.id} {rule.name}",
        rule.title,
        f"Severity: {rule.severity}.{state} Source: {rule.source}.",
        rule.why,
        *_fields(rule),
        *_examples("Good", rule.good),
        *_examples("Bad", rule.bad),
    ]
    return "\n\n".join(parts) + "\n"


def service_rules(rules: Sequence[Rule]) -> str:
    """All rules in one Markdown document, by category, with a table at the start."""
    order = list(_CATEGORIES)
    places = {category: number for number, category in enumerate(order)}
    ordered = sorted(rules, key=lambda rule: (places.get(rule.category, len(places)), rule.category, rule.id))
    parts = [
        "# Rules of `sigcat lint`",
        "Made from `interface_rules/` by `make generate`; a test checks that it is up to date.",
    ]
    for category, group in groupby(ordered, key=lambda rule: rule.category):
        members = list(group)
        rows = "\n".join(f"| [{r.id}](#{r.id.lower()}-{r.name}) | {_severity(r)} | {_cell(r.title)} |" for r in members)
        parts.append(f"## {category_title(category)}")
        parts.append(f"| code | severity | rule |\n|---|---|---|\n{rows}")
        parts.extend(rule_page(rule, 3).rstrip() for rule in members)
    return "\n\n".join(parts) + "\n"


def _severity(rule: Rule) -> str:
    return rule.severity if rule.default else f"{rule.severity}, off"


def _fields(rule: Rule) -> list[str]:
    fields = rule.options.get("fields")
    if not isinstance(fields, dict):
        return []
    rows = [row for name, field in fields.items() for row in _rows(name, field)]
    return ["| field | required | datatype | unit | meaning |\n|---|---|---|---|---|\n" + "\n".join(rows)]


def _rows(name: str, field: Mapping[str, Any]) -> list[str]:
    datatype = field.get("datatype", "value")
    if "values" in field:
        datatype = f"{datatype}: {', '.join(map(str, field['values']))}"
    required = "yes" if field.get("required") else "no"
    cells = (f"`{name}`", required, datatype, field.get("unit", ""), field.get("description", ""))
    rows = [f"| {' | '.join(_cell(str(cell)) for cell in cells)} |"]
    for inner, inner_field in field.get("fields", {}).items():
        rows.extend(_rows(f"{name}.{inner}", inner_field))
    return rows


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")


def _examples(label: str, examples: Sequence[Any]) -> list[str]:
    return [f"{label}:\n\n{_blocks(example)}" for example in examples]


def _blocks(example: Any, language: str = "yaml") -> str:
    if isinstance(example, str):
        return f"```{language}\n{example.rstrip()}\n```"
    parts: list[str] = []
    for name, value in example.items():
        if isinstance(value, Mapping):
            parts.extend(f"`{file}`:\n\n{_blocks(text, _language(file))}" for file, text in value.items())
        elif isinstance(value, list):
            parts.extend(f"{name} {number}:\n\n{_blocks(text)}" for number, text in enumerate(value, 1))
        else:
            parts.append(_blocks(value) if name == "whole" else f"{name}:\n\n{_blocks(value)}")
    return "\n\n".join(parts)


def _language(file: str) -> str:
    ending = file.rpartition(".")[2]
    return ending if ending in ("json", "toml") else "yaml"
