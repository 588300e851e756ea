"""Faults in the fields of a rule's record: all of them, each with its field."""

import re
from collections.abc import Collection, Iterator, Mapping
from typing import Any, Literal, NamedTuple, get_args

from sigcat.catalogue.model.datatypes import DATATYPES
from sigcat.catalogue.model.definition import TYPES
from sigcat.catalogue.model.interfaces import CATEGORIES
from sigcat.findings import SEVERITIES, shown
from sigcat.names import did_you_mean, nearest
from sigcat.rules.templates import template_faults

Scope = Literal["node", "tree"]
"""Scope that a check needs: the node by itself, or its whole tree, as a part alone shows nothing."""

MAKERS = frozenset((
    "adapter", "composition", "configuration", "export", "function", "gateway", "import", "integration", "lint", "request",
    "migration", "registry", "simulation",
))  # fmt: skip
"""Values of `check` for rules whose findings are made elsewhere, not by a check of this room."""
REQUIRED = ("name", "title", "severity", "why", "check", "source")

_CODE = r"[A-Z]+[0-9]{3}"
_NAME = r"[a-z0-9]+(-[a-z0-9]+)*"
KEYS = (*REQUIRED, "category", "default", "scope", "nodes", "options", "message", "fix", "good", "bad", "example")
_KINDS: Mapping[str, type] = {"message": str, "fix": str, "category": str, "default": bool, "options": dict}
_KIND_NAMES: Mapping[type, str] = {str: "a text", bool: "true or false", dict: "a mapping"}
_NODE_NAMES: Mapping[str, Collection[str]] = {
    "types": (*TYPES, "signals"), "datatypes": DATATYPES, "interfaces": CATEGORIES
}  # fmt: skip
_EXAMPLE_TEXTS = ("whole", "base", "overlay", "quantities", "units", "dbc")
_EXAMPLE_KEYS = (*_EXAMPLE_TEXTS, "overlays", "files")
_FILE_NAME = r"\w[\w.-]*"


class Fault(NamedTuple):
    """Why a record cannot be used, and at which field."""

    message: str
    key: str = ""
    fix: str = ""


def faults_of(code: str, values: Any, *, trusted: bool) -> Iterator[Fault]:
    """Everything that is wrong with a record."""
    if not re.fullmatch(_CODE, code):
        message = f"The code of a rule must be capital letters and three digits, not {code!r}."
        is_spelled_small = re.fullmatch(_CODE, code.upper()) is not None
        yield Fault(message, fix=f"Write {code.upper()}." if is_spelled_small else "Use one such as ACME001.")
    if not isinstance(values, dict):
        yield Fault(f"Rule {code} must be a mapping of fields.")
        return
    yield from _of_keys(code, values)
    yield from _of_words(values)
    yield from _of_nodes(values.get("nodes", {}))
    yield from _of_templates(values)
    if not (_is_text(values.get("check")) and values["check"] in MAKERS):  # these have examples of other kinds
        yield from _of_examples(values)
    if trusted and values.get("example") is not False and not (values.get("good") and values.get("bad")):
        fix = "Add them, or `example: false` if none is a text."
        yield Fault(f"Rule {code} must have `good` and `bad` examples.", fix=fix)


def _of_keys(code: str, values: dict[str, Any]) -> Iterator[Fault]:
    for key in values:
        if key not in KEYS:
            yield Fault(f"Unknown field {key!r} of rule {code}.", key, did_you_mean(str(key), KEYS))
    for key in REQUIRED:
        is_misspelled = key not in values and any(nearest(str(name), [key]) for name in values if name not in KEYS)
        if not _is_text(values.get(key)) and not is_misspelled:
            yield Fault(f"Rule {code} must have a text as `{key}`.", key)
    for key, kind in _KINDS.items():
        if key in values and not isinstance(values[key], kind):
            yield Fault(f"`{key}` must be {_KIND_NAMES[kind]}, not {shown(values[key])}.", key)


def _of_words(values: dict[str, Any]) -> Iterator[Fault]:
    severity, scope, name = values.get("severity"), values.get("scope", "node"), values.get("name")
    if _is_text(severity) and severity not in SEVERITIES:
        yield Fault(f"`severity` must be one of {', '.join(SEVERITIES)}, not {shown(severity)}.", "severity")
    if scope not in get_args(Scope):
        yield Fault(f"`scope` must be one of {', '.join(get_args(Scope))}, not {shown(scope)}.", "scope")
    if isinstance(name, str) and name and not re.fullmatch(_NAME, name):
        yield Fault(f"`name` must be in kebab-case, not {name!r}.", "name", "Use a name such as unit-without-key.")


def _of_templates(values: dict[str, Any]) -> Iterator[Fault]:
    check = values.get("check")
    for key in ("message", "fix"):
        text = values.get(key)
        if isinstance(text, str) and isinstance(check, str):
            for fault, fix in template_faults(text, check):
                yield Fault(f"`{key}` {fault}.", key, fix)


def _of_nodes(values: Any) -> Iterator[Fault]:
    if not isinstance(values, dict):
        yield Fault(f"`nodes` must be a mapping, not {shown(values)}.", "nodes")
        return
    known = (*_NODE_NAMES, "path", "overlay")
    for key in values:
        if key not in known:
            yield Fault(f"Unknown field {key!r} in `nodes`.", "nodes", did_you_mean(str(key), known))
    if not isinstance(values.get("path", ""), str):
        yield Fault(f"`path` must be a glob such as Vehicle.Body.*, not {shown(values['path'])}.", "nodes")
    if not isinstance(values.get("overlay", False), bool):
        yield Fault(f"`overlay` must be true or false, not {shown(values['overlay'])}.", "nodes")
    for key, names in _NODE_NAMES.items():
        yield from _of_names(key, values.get(key, []), names)


def _of_names(key: str, names: Any, known: Collection[str]) -> Iterator[Fault]:
    """Names that decide which nodes a rule is about: one that no node has would silently end the rule."""
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        yield Fault(f"`{key}` must be a list of names, not {shown(names)}.", "nodes")
        return
    for name in names:
        is_struct = key == "datatypes" and "." in name  # which structs there are, only a tree knows
        if name not in known and not is_struct:
            fix = did_you_mean(name, known) or f"Use one of {', '.join(sorted(known))}."
            yield Fault(f"Unknown name {name!r} in `{key}` of `nodes`.", "nodes", fix)


def _of_examples(values: dict[str, Any]) -> Iterator[Fault]:
    for key in ("good", "bad"):
        given = values.get(key)
        for example in given if isinstance(given, list) else [given]:
            if isinstance(example, dict):
                yield from _of_example(example, key)
            elif not isinstance(example, str) and given is not None:
                yield Fault(f"`{key}` must be a text or a list of texts, not {shown(example)}.", key)


def _of_example(example: dict[Any, Any], key: str) -> Iterator[Fault]:
    """Faults in an example that is a mapping."""
    for part, value in example.items():
        if part not in _EXAMPLE_KEYS:
            fix = did_you_mean(str(part), _EXAMPLE_KEYS) or f"Use one of {', '.join(_EXAMPLE_KEYS)}."
            yield Fault(f"Unknown field {shown(part)} in `{key}`.", key, fix)
        elif part in _EXAMPLE_TEXTS and not isinstance(value, str):
            fix = f"Write `{part}: |`, and the text in the lines below it."
            yield Fault(f"`{part}` in `{key}` must be a text, not {shown(value)}.", key, fix)
        elif part == "overlays" and not (isinstance(value, list) and all(isinstance(each, str) for each in value)):
            yield Fault(f"`overlays` in `{key}` must be a list of texts, not {shown(value)}.", key)
        elif part == "files" and not _are_files(value):
            yield Fault(f"`files` in `{key}` must be texts by file name, without folders, not {shown(value)}.", key)


def _are_files(value: Any) -> bool:
    return (
        isinstance(value, dict)
        and value != {}
        and all(
            isinstance(name, str) and re.fullmatch(_FILE_NAME, name) and isinstance(text, str)
            for name, text in value.items()
        )
    )


def _is_text(value: Any) -> bool:
    return isinstance(value, str) and value != ""
