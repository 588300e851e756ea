"""A rule as a page: the same text on the command line and in docs/reference/rules."""

from collections.abc import Mapping, Sequence
from typing import Any

from sigcat.rules.record import Rule


def rule_page(rule: Rule) -> str:
    """Everything that is known of a rule, in Markdown."""
    state = "" if rule.default else " Off by default."
    parts = [
        f"# {rule.id} {rule.name}",
        rule.title,
        f"Severity: {rule.severity}.{state} Source: {rule.source}.",
        rule.why,
        *filter(None, [field_table(rule)]),
        *_examples("Good", rule.good),
        *_examples("Bad", rule.bad),
    ]
    return "\n\n".join(parts) + "\n"


def field_table(rule: Rule) -> str:
    """The fields that a rule wants interfaces to have, as a Markdown table; nothing for other rules."""
    fields = rule.options.get("fields")
    if not isinstance(fields, dict):
        return ""
    rows = [row for name, field in fields.items() for row in _rows(name, field)]
    return "\n".join(["| field | required | datatype | unit | meaning |", "|---|---|---|---|---|", *rows])


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
            block = _blocks(value, "json" if name == "document" else "yaml")
            parts.append(block if name == "whole" else f"{name}:\n\n{block}")
    return "\n\n".join(parts)


def _language(file: str) -> str:
    ending = file.rpartition(".")[2]
    return ending if ending in ("json", "toml") else "yaml"
