"""A rule as a record: what `interface_rules/*.yaml` says, read and checked. The format: interface_rules/README.md."""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, ScalarNode

from sigcat import codes
from sigcat.catalogue.model.definition import SIGNALS
from sigcat.catalogue.reading.yaml_document import (
    Builder,
    Unbuildable,
    collector_paused,
    duplicate_keys,
    position,
    read_document,
)
from sigcat.errors import InputRefused
from sigcat.findings import Finding, Severity, first_at, in_order
from sigcat.open_files import read_bytes
from sigcat.rules.record_faults import REQUIRED, Scope, faults_of


class Nodes(NamedTuple):
    """Nodes that a check sees; an empty field allows all."""

    types: frozenset[str] = frozenset()
    datatypes: frozenset[str] = frozenset()
    interfaces: frozenset[str] = frozenset()
    path: str = ""
    """A glob, in which `*` matches any text."""
    is_of_overlay: bool = False
    """Whether only nodes count that an overlay adds."""


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
    unusable: tuple[Rule, ...] = ()
    """Records that are left out, with their checks and options, of which more may be wrong."""


def load_rules(folder: Path, *, trusted: bool = True) -> tuple[Rule, ...]:
    """Every rule of the files in `folder`, in the order of their codes. Raises InputRefused with all findings."""
    return load_rule_files(sorted(folder.glob("*.yaml")), trusted=trusted)


def load_rule_files(
    paths: Iterable[Path], *, trusted: bool, tried: Callable[[Iterable[Rule]], Iterable[Finding]] | None = None
) -> tuple[Rule, ...]:
    """The rules of these files, in the order of their codes. Raises InputRefused with all findings.

    `tried` finds errors in the options of checks; it is asked where the rules are refused anyway.
    """
    rules: dict[str, Rule] = {}
    findings: list[Finding] = []
    unusable: list[Rule] = []
    for path in paths:
        file = _read(path, trusted=trusted)
        findings.extend(file.findings)
        unusable.extend(file.unusable)
        for rule in file.rules:
            if rule.id in rules:
                message = f"Rule {rule.id} is in {rules[rule.id].file} too."
                findings.append(codes.RULE_UNUSABLE.finding(message, rule.file, rule.line, 1, rule.id))
            rules[rule.id] = rule
    if findings:
        more = tried((*rules.values(), *unusable)) if tried is not None else ()
        raise InputRefused("The rules cannot be used.", in_order([*findings, *more]))
    return tuple(sorted(rules.values()))


def parse_rules(data: bytes, name: str, *, trusted: bool) -> RuleFile:
    """The rules in the bytes of one file; everything wrong is a finding L010."""
    document = read_document(data, name)
    findings = list(document.findings)
    if document.root is None:
        return RuleFile((), tuple(findings))
    if not isinstance(document.root, MappingNode) or _is_list_of_rules(document.root):
        message = "A file of rules must be a mapping of codes to records."
        fix = "Write `ACME001:` at the beginning of a line, and the fields of the rule below it."
        return RuleFile((), (codes.RULE_UNUSABLE.finding(message, name, *position(document.root), fix=fix),))
    findings.extend(
        codes.RULE_UNUSABLE.finding(
            f"Rule {key.value} is defined twice, {first_at(name, position(first)[0])}.", name, *position(key), key.value
        )
        for key, first in duplicate_keys(document.root)
    )
    with collector_paused():
        file = _records(document.root, name, trusted=trusted)
    return file._replace(findings=(*findings, *file.findings))


def _is_list_of_rules(root: MappingNode) -> bool:
    """Whether a file has its rules below `rules`, as those of other linters do."""
    return [key.value for key, _ in root.value] == ["rules"]


def _read(path: Path, *, trusted: bool) -> RuleFile:
    try:
        data = read_bytes(path)
    except OSError as error:
        message = f"The rules in {str(path)!r} cannot be read: {error.strerror}."
        return RuleFile((), (codes.RULE_UNUSABLE.finding(message, str(path)),))
    return parse_rules(data, str(path), trusted=trusted)


def _records(root: MappingNode, name: str, *, trusted: bool) -> RuleFile:
    builder = Builder()
    rules, unusable, findings = [], [], []
    for key, node in root.value:
        code = key.value if isinstance(key, ScalarNode) else ""
        place = (Path(name).stem, name, position(key)[0])
        try:
            values = builder.value(node)
        except Unbuildable as error:
            findings.append(codes.RULE_UNUSABLE.finding(str(error), name, *position(error.node), code))
            continue
        faults = list(faults_of(code, values, trusted=trusted))
        for fault in faults:
            at = _position_of(node, fault.key) or position(key)
            findings.append(codes.RULE_UNUSABLE.finding(fault.message, name, *at, code, fix=fault.fix))
        if not faults:
            rules.append(_rule(code, values, *place, trusted=trusted))
        elif _has_check(values):
            unusable.append(_rule(code, _for_its_check(values), *place, trusted=trusted))
    return RuleFile(tuple(rules), tuple(findings), tuple(unusable))


def _has_check(values: Any) -> bool:
    return isinstance(values, dict) and isinstance(values.get("check"), str) and isinstance(values.get("options"), dict)


def _for_its_check(values: dict[str, Any]) -> dict[str, Any]:
    """A record of which only the options of the check are tried."""
    return {**dict.fromkeys(REQUIRED, ""), "check": values["check"], "options": values["options"]}


def _position_of(node: Any, key: str) -> tuple[int, int] | None:
    pair = _pair(node, key)
    return position(pair[0]) if pair is not None else None


def _pair(node: Any, key: str) -> tuple[Any, Any] | None:
    """A key of a mapping, and its value, as nodes."""
    pairs = node.value if isinstance(node, MappingNode) else []
    return next((pair for pair in pairs if isinstance(pair[0], ScalarNode) and pair[0].value == key), None)


def option_position(rule: Rule, option: str) -> tuple[int, int]:
    """Line and column of an option of a rule; of the rule without one, or if its file is no longer there."""
    at = rule.line, 1
    if not option:
        return at
    try:
        node: Any = read_document(read_bytes(Path(rule.file)), rule.file).root
    except (OSError, ValueError):
        return at
    for key in (rule.id, "options", option):
        pair = _pair(node, key)
        if pair is None:
            return at
        at, node = position(pair[0]), pair[1]
    return at


def _rule(code: str, values: Any, category: str, file: str, line: int, *, trusted: bool) -> Rule:
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


def _nodes(values: dict[str, Any]) -> Nodes:
    types = frozenset(values.get("types", ()))
    if "signals" in types:
        types = types - {"signals"} | frozenset(SIGNALS)
    datatypes, interfaces = (frozenset(values.get(key, ())) for key in ("datatypes", "interfaces"))
    return Nodes(types, datatypes, interfaces, values.get("path", ""), values.get("overlay", False))


def _examples(given: Any) -> tuple[Any, ...]:
    if given is None:
        return ()
    return tuple(given) if isinstance(given, list) else (given,)
