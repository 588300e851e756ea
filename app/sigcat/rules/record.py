"""A rule as a record: what `interface_rules/*.yaml` says, read and checked. The format: interface_rules/README.md."""

import re
from collections.abc import Collection, Iterable, Mapping
from pathlib import Path
from typing import Any, Literal, NamedTuple, get_args

from yaml.nodes import MappingNode, ScalarNode

from sigcat import codes
from sigcat.catalogue.model.datatypes import DATATYPES
from sigcat.catalogue.model.definition import SIGNALS, TYPES
from sigcat.catalogue.model.interfaces import CATEGORIES
from sigcat.catalogue.reading.yaml_document import (
    Builder,
    Unbuildable,
    collector_paused,
    duplicate_keys,
    position,
    read_document,
)
from sigcat.errors import InputRefused
from sigcat.findings import SEVERITIES, Finding, Severity
from sigcat.names import did_you_mean

MAKERS = frozenset(("composition", "configuration", "export", "function", "integration", "lint", "request"))
"""Values of `check` for rules whose findings are made elsewhere, not by a check of this room."""

_CODE = r"[A-Z]+[0-9]{3}"
_NAME = r"[a-z0-9]+(-[a-z0-9]+)*"
_REQUIRED = ("name", "title", "severity", "why", "check", "source")
_KEYS = (*_REQUIRED, "category", "default", "scope", "nodes", "options", "message", "fix", "good", "bad", "example")
_KINDS: Mapping[str, type] = {"message": str, "fix": str, "category": str, "default": bool, "options": dict}
_KIND_NAMES: Mapping[type, str] = {str: "a text", bool: "true or false", dict: "a mapping"}
_NODE_KEYS = ("types", "datatypes", "interfaces", "path")


Scope = Literal["node", "tree"]
"""What must be there to judge: the node by itself, or its whole tree, of which a part alone shows nothing."""


class Nodes(NamedTuple):
    """Which nodes a check sees; an empty field allows all."""

    types: frozenset[str] = frozenset()
    datatypes: frozenset[str] = frozenset()
    interfaces: frozenset[str] = frozenset()
    path: str = ""
    """A glob, in which `*` stands for any text."""


class Rule(NamedTuple):
    """One rule. `trusted` is false for a rule that sigcat does not ship: its patterns run under a time limit."""

    id: str
    name: str
    title: str
    category: str
    severity: Severity
    default: bool
    why: str
    check: str
    options: Mapping[str, Any]
    message: str
    fix: str
    good: tuple[Any, ...]
    bad: tuple[Any, ...]
    source: str
    file: str
    line: int
    trusted: bool
    scope: Scope
    nodes: Nodes


class RuleFile(NamedTuple):
    """The records of one file, and what was wrong with those that are left out."""

    rules: tuple[Rule, ...]
    findings: tuple[Finding, ...]


class _Bad(Exception):
    """A record cannot be used: the text says why, `key` at which field."""

    def __init__(self, message: str, key: str = "", fix: str = "") -> None:
        super().__init__(message)
        self.key = key
        self.fix = fix


def load_rules(folder: Path, *, trusted: bool = True) -> tuple[Rule, ...]:
    """Every rule of the files in `folder`, in the order of their codes. Raises InputRefused with all findings."""
    return load_rule_files(sorted(folder.glob("*.yaml")), trusted=trusted)


def load_rule_files(paths: Iterable[Path], *, trusted: bool) -> tuple[Rule, ...]:
    """The rules of these files, in the order of their codes. Raises InputRefused with all findings."""
    rules: dict[str, Rule] = {}
    findings: list[Finding] = []
    for path in paths:
        file = _read(path, trusted=trusted)
        findings.extend(file.findings)
        for rule in file.rules:
            if rule.id in rules:
                message = f"Rule {rule.id} is in {rules[rule.id].file} too."
                findings.append(codes.RULE_UNUSABLE.finding(message, rule.file, rule.line, 1, rule.id))
            rules[rule.id] = rule
    if findings:
        raise InputRefused("The rules cannot be used.", tuple(findings))
    return tuple(sorted(rules.values()))


def parse_rules(data: bytes, name: str, *, trusted: bool) -> RuleFile:
    """The rules in the bytes of one file; everything wrong is a finding L010."""
    document = read_document(data, name)
    findings = list(document.findings)
    if document.root is None:
        return RuleFile((), tuple(findings))
    if not isinstance(document.root, MappingNode):
        message = "A file of rules must be a mapping of codes to records."
        return RuleFile((), (codes.RULE_UNUSABLE.finding(message, name, 1, 1),))
    findings.extend(
        codes.RULE_UNUSABLE.finding(f"Rule {key.value} is defined twice.", name, *position(key), key.value)
        for key in duplicate_keys(document.root)
    )
    with collector_paused():
        rules = _records(document.root, name, findings, trusted=trusted)
    return RuleFile(tuple(rules), tuple(findings))


def _read(path: Path, *, trusted: bool) -> RuleFile:
    try:
        data = path.read_bytes()
    except OSError as error:
        message = f"The rules in {str(path)!r} cannot be read: {error.strerror}."
        return RuleFile((), (codes.RULE_UNUSABLE.finding(message, str(path)),))
    return parse_rules(data, str(path), trusted=trusted)


def _records(root: MappingNode, name: str, findings: list[Finding], *, trusted: bool) -> list[Rule]:
    builder = Builder()
    category = Path(name).stem
    rules = []
    for key, node in root.value:
        code = key.value if isinstance(key, ScalarNode) else ""
        line, column = position(key)
        try:
            rules.append(_rule(code, builder.value(node), category, name, line, trusted=trusted))
        except Unbuildable as error:
            findings.append(codes.RULE_UNUSABLE.finding(str(error), name, *position(error.node), code))
        except _Bad as error:
            at = _position_of(node, error.key) or (line, column)
            findings.append(codes.RULE_UNUSABLE.finding(str(error), name, *at, code, fix=error.fix))
    return rules


def _position_of(node: Any, key: str) -> tuple[int, int] | None:
    pairs = node.value if isinstance(node, MappingNode) else []
    return next((position(k) for k, _ in pairs if isinstance(k, ScalarNode) and k.value == key), None)


def _rule(code: str, values: Any, category: str, file: str, line: int, *, trusted: bool) -> Rule:
    if not re.fullmatch(_CODE, code):
        raise _Bad(
            f"The code of a rule must be capital letters and three digits, not {code!r}.",
            fix="Use one such as ACME001.",
        )
    if not isinstance(values, dict):
        raise _Bad(f"Rule {code} must be a mapping of fields.")
    _check_keys(code, values)
    if trusted and values.get("example") is not False and not (values.get("good") and values.get("bad")):
        raise _Bad(
            f"Rule {code} must have `good` and `bad` examples.", fix="Add them, or `example: false` if none is a text."
        )
    return Rule(
        code,
        values["name"],
        values["title"],
        values.get("category", category),
        values["severity"],
        values.get("default", True),
        values["why"].strip(),
        values["check"],
        values.get("options") or {},
        values.get("message", ""),
        values.get("fix", ""),
        _examples(values.get("good")),
        _examples(values.get("bad")),
        values["source"],
        file,
        line,
        trusted,
        values.get("scope", "node"),
        _nodes(values.get("nodes", {})),
    )


def _check_keys(code: str, values: dict[str, Any]) -> None:
    for key in values:
        if key not in _KEYS:
            raise _Bad(f"Unknown field {key!r} of rule {code}.", key, did_you_mean(str(key), _KEYS))
    for key in _REQUIRED:
        if not isinstance(values.get(key), str) or not values[key]:
            raise _Bad(f"Rule {code} must have a text as `{key}`.", key)
    if values["severity"] not in SEVERITIES:
        raise _Bad(f"`severity` must be one of {', '.join(SEVERITIES)}, not {values['severity']!r}.", "severity")
    if values.get("scope", "node") not in get_args(Scope):
        raise _Bad(f"`scope` must be one of {', '.join(get_args(Scope))}, not {values['scope']!r}.", "scope")
    if not re.fullmatch(_NAME, values["name"]):
        raise _Bad(
            f"`name` must be in kebab-case, not {values['name']!r}.", "name", "Use a name such as unit-without-key."
        )
    for key, kind in _KINDS.items():
        if key in values and not isinstance(values[key], kind):
            raise _Bad(f"`{key}` must be {_KIND_NAMES[kind]}, not {values[key]!r}.", key)


def _nodes(values: Any) -> Nodes:
    if not isinstance(values, dict):
        raise _Bad(f"`nodes` must be a mapping, not {values!r}.", "nodes")
    for key in values:
        if key not in _NODE_KEYS:
            raise _Bad(f"Unknown field {key!r} in `nodes`.", "nodes", did_you_mean(str(key), _NODE_KEYS))
    types = frozenset(_known_names(values, "types", (*TYPES, "signals")))
    if "signals" in types:
        types = types - {"signals"} | frozenset(SIGNALS)
    path = values.get("path", "")
    if not isinstance(path, str):
        raise _Bad(f"`path` must be a glob such as Vehicle.Body.*, not {path!r}.", "nodes")
    interfaces = frozenset(_known_names(values, "interfaces", CATEGORIES))
    datatypes = frozenset(_known_names(values, "datatypes", DATATYPES))
    return Nodes(types, datatypes, interfaces, path)


def _known_names(values: dict[str, Any], key: str, known: Collection[str]) -> list[str]:
    """Names that may decide which nodes a rule is about: one that no node has would end the rule without a word."""
    names = _names(values, key)
    for name in names:
        is_struct = key == "datatypes" and "." in name  # which structs there are, only a tree knows
        if name not in known and not is_struct:
            fix = did_you_mean(name, known) or f"Use one of {', '.join(sorted(known))}."
            raise _Bad(f"Unknown name {name!r} in `{key}` of `nodes`.", "nodes", fix)
    return names


def _names(values: dict[str, Any], key: str) -> list[str]:
    names = values.get(key, [])
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise _Bad(f"`{key}` must be a list of names, not {names!r}.", "nodes")
    return names


def _examples(given: Any) -> tuple[Any, ...]:
    if given is None:
        return ()
    return tuple(given) if isinstance(given, list) else (given,)
