"""Tables within pages: each is between `<!-- NAME ARGUMENTS -->` and `<!-- /NAME -->`, and is generated again.

`keys SCHEMA KEY ...`: the keys of a JSON Schema of sigcat, or of the schema below these keys. `fields CODE`: the fields that a rule requires interfaces to
have. `limits [CLASS]`: the limits in `limits.py`.
`rules PREFIX`: the rules whose codes begin so. `settings`: the settings of the service. `classes`: those of changes.
"""

import ast
import json
import re
from collections.abc import Callable, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any

from sigcat import limits
from sigcat.api.read_settings import shown
from sigcat.api.settings import Settings
from sigcat.catalogue.comparing.diff_report import binding_names, binding_table, class_table
from sigcat.data import INTERFACE_RULES
from sigcat.platforms.schemas import schema
from sigcat.rules.checks import CHECKS, network
from sigcat.rules.pages import field_table
from sigcat.rules.record import load_rules
from sigcat.rules.templates import OF_EVERY_CHECK, placeholders

ROOT = Path(__file__).parents[1]
_KINDS = {
    "string": "text",
    "object": "mapping",
    "any": "any",
    "number": "number",
    "integer": "integer",
    "boolean": "boolean",
}
_PLACE = re.compile(
    r"^<!-- (?P<name>keys|fields|checks|limits|rules|settings|classes|bindings|binding-names)(?P<arguments>( [\w-]+)*) -->\n.*?^<!-- /(?P=name) -->$",
    re.MULTILINE | re.DOTALL,
)


def files() -> Mapping[str, str]:
    """The pages that have tables."""
    pages = {str(page.relative_to(ROOT)): page.read_text(encoding="utf-8") for page in sorted(ROOT.glob("docs/*/*.md"))}
    return {name: _PLACE.sub(_filled, text) for name, text in pages.items() if _PLACE.search(text)}


def _filled(place: re.Match[str]) -> str:
    name, arguments = place["name"], place["arguments"]
    return f"<!-- {name}{arguments} -->\n{_TABLES[name](*arguments.split()).strip()}\n<!-- /{name} -->"


def _keys(name: str, *path: str) -> str:
    document = schema(name)
    described: Mapping[str, Any] = document
    for key in path:
        described = _mapping(described["properties"][key], document)
    required = described.get("required", ())
    lines = ["| key | value | meaning |", "|---|---|---|"]
    for key, value in described["properties"].items():
        spelled = f"`{key}` (required)" if key in required else f"`{key}`"
        lines.append(f"| {spelled} | {_kind(value)} | {_meaning(value, document).replace('<', '&lt;')} |")
    return "\n".join(lines)


def _mapping(described: Mapping[str, Any], document: Mapping[str, Any]) -> Mapping[str, Any]:
    """The mapping with named keys that a value is, or that is an item of it."""
    while "properties" not in described:
        if "anyOf" in described:
            described = next(each for each in described["anyOf"] if each.get("type") in (None, "array", "object"))
        elif "$ref" in described:
            described = document["$defs"][described["$ref"].rpartition("/")[2]]
        else:
            described = described["items"] if described["type"] == "array" else _values(described)
    return described


def _values(described: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the schema of the values of a mapping with free keys."""
    patterns: Mapping[str, Mapping[str, Any]] = described.get("patternProperties", {})
    return next(iter(patterns.values()), described.get("additionalProperties", {}))


def _kind(described: Mapping[str, Any]) -> str:
    """The kind of a value in a few words."""
    if "anyOf" in described:
        return " or ".join(_kind(each) for each in described["anyOf"] if each.get("type") != "null")
    if "enum" in described:
        return ", ".join(f"`{value}`" for value in described["enum"])
    if described.get("type") == "array":
        return f"list: {_kind(described['items'])}"
    return _KINDS[described.get("type", "object" if "$ref" in described else "any")]


def _meaning(described: Mapping[str, Any], document: Mapping[str, Any]) -> str:
    referred = document["$defs"].get(described.get("$ref", "").rpartition("/")[2], {})
    text = str(described.get("description") or referred.get("description", ""))
    default = described.get("default")
    has_default = isinstance(default, str | int | float) and default != ""
    return f"{text} Default: `{json.dumps(default)}`." if has_default else text


def _fields(code: str) -> str:
    rule = next(rule for rule in load_rules(INTERFACE_RULES) if rule.id == code)
    return field_table(rule)


def _rules(prefix: str) -> str:
    rules = (rule for rule in load_rules(INTERFACE_RULES) if rule.id.startswith(prefix))
    rows = (f"| [{rule.id}](../reference/rules/{rule.id}.md) | {rule.severity} | {rule.title} |" for rule in rules)
    return "\n".join(["| rule | severity | requirement |", "|---|---|---|", *rows])


def _checks() -> str:
    """The checks that rules can use, with their options and placeholders; options that a rule has to give are bold."""
    lines = ["| check | options | placeholders | requirement |", "|---|---|---|---|"]
    for name, check in sorted(CHECKS.items()):
        kinds = {each: kind.name for each, kind in check.options.items()}
        options = [f"{f'**`{each}`**' if each in check.required else f'`{each}`'} {kinds[each]}" for each in kinds]
        documented = getattr(network, check.prepare.__name__, check.prepare)  # checks of mappings load their code late
        meaning = (documented.__doc__ or "").partition("\n\n")[0].replace("\n", " ").replace("|", "\\|")
        filled = ", ".join(f"`{{{each}}}`" for each in placeholders(name) if each not in OF_EVERY_CHECK)
        lines.append(f"| `{name}` | {', '.join(options) or '–'} | {filled or '–'} | {' '.join(meaning.split())} |")
    return "\n".join(lines)


def _settings() -> str:
    rows = (f"| `{name}` | `{value}` | {description} |" for name, value, description in shown(Settings()))
    return "\n".join(["| setting | default | meaning |", "|---|---|---|", *rows])


def _limits(owner: str = "") -> str:
    """Return the constants of `limits.py`, or the fields of one of its classes, with the text below each."""
    body = ast.parse(Path(limits.__file__).read_text(encoding="utf-8")).body
    if owner:
        body = next(each.body for each in body if isinstance(each, ast.ClassDef) and each.name == owner)
    values = getattr(limits, owner)._field_defaults if owner else vars(limits)
    lines = ["| limit | of |", "|---|---|"]
    for statement, meaning in pairwise(body):
        if isinstance(statement, ast.Assign | ast.AnnAssign) and isinstance(meaning, ast.Expr):
            name = ast.unparse(statement.target if isinstance(statement, ast.AnnAssign) else statement.targets[0])
            lines.append(f"| {_shown_limit(values[name])} | {ast.literal_eval(meaning.value)} |")
    return "\n".join(lines)


def _shown_limit(value: float) -> str:
    unit = next((size for size in _SIZES if value >= 64 * 1024 and value % size == 0), None)
    return f"{value // unit:,} {_SIZES[unit]}" if unit else f"{value:,.10g}"


_SIZES = {1024**3: "GiB", 1024**2: "MiB", 1024: "KiB"}


_TABLES: Mapping[str, Callable[..., str]] = {
    "keys": _keys, "fields": _fields, "checks": _checks, "limits": _limits, "rules": _rules, "settings": _settings, "classes": class_table, "bindings": binding_table, "binding-names": binding_names,
}  # fmt: skip
