"""Checks of names: of nodes and of the instances of branches."""

import re
from collections.abc import Iterator

from sigcat.catalogue.model.definition import Definition, labels_of
from sigcat.names import camel_case, last_name, screaming_snake_case
from sigcat.rules.checks.kind import NodeTest
from sigcat.rules.patterns import Pattern, compile_pattern
from sigcat.rules.problem import Problem
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree

_RANGE = r"\[ *\d+ *, *\d+ *\]$"


def name(rule: Rule, _tree: Tree) -> NodeTest:
    """The last name of a path matches `pattern` as a whole, or begins with one of `prefixes` and a capital or digit."""
    pattern = _pattern(rule)
    exempt = frozenset(("", *map(str, rule.options.get("exempt", ()))))  # an empty name is a finding V024
    prefixes = " or ".join(f"`{prefix}`" for prefix in rule.options.get("prefixes", ()))
    known: dict[str, bool] = {}

    def test(definition: Definition) -> Iterator[Problem]:
        own = last_name(definition.path)
        if own not in known:
            known[own] = bool(pattern.matches(own)) or own in exempt
        if not known[own]:
            proposal = _proposal(own, rule)
            fix = f"Use a name such as {proposal!r}." if pattern.matches(proposal) else ""
            message = f"Name {own!r} must match {pattern.text}."
            yield Problem(definition, message, fix=fix, facts={"name": own, "proposal": proposal, "prefixes": prefixes})

    return test


def instance_name(rule: Rule, _tree: Tree) -> NodeTest:
    """Every label among the instances of a branch matches `pattern` as a whole; the bracket of a range aside."""
    pattern = compile_pattern(rule.options["pattern"], trusted=rule.trusted)

    def test(definition: Definition) -> Iterator[Problem]:
        for within, entry in labels_of(definition.values):
            label = re.sub(_RANGE, "", str(entry))
            if not pattern.matches(label):
                proposal = camel_case(_plain(label))
                message = f"Instance {label!r} must match {pattern.text}."
                fix = f"Use a name such as {proposal!r}." if pattern.matches(proposal) else ""
                facts = {"name": label, "proposal": proposal}
                fix = _separate(label, definition, pattern) or fix
                yield Problem(definition, message, "instances", fix, facts, within=within)

    return test


def _separate(label: str, definition: Definition, pattern: Pattern) -> str:
    """The fix of a label that is several: `1-3`, `Left Right`, `Pump[2]`; empty for others."""
    if count := re.fullmatch(r"(\w+)\[(?:1,)?(\d*),?\]", label):
        return f"Write {count[1]}[1,{count[2] or 2}] for each number from 1 to {count[2] or 2}."
    if numbers := re.fullmatch(r"\w*?\[?(\d+) *(?:-|\.\.|,) *(\d+)\]?", label):
        return f"Write {last_name(definition.path)}[{numbers[1]},{numbers[2]}] for each number from {numbers[1]} to {numbers[2]}."
    names = re.findall(r"[^\s,;]+", label)
    if len(names) > 1 and all(pattern.matches(name) for name in names):
        return (
            f"Write [{', '.join(names)}] for {len(names)} instances, or one name such as {camel_case(_plain(label))!r}."
        )
    return ""


def _pattern(rule: Rule) -> Pattern:
    prefixes = rule.options.get("prefixes")
    text = f"({'|'.join(map(str, prefixes))})[A-Z0-9].*" if prefixes else rule.options.get("pattern", ".*")
    return compile_pattern(text, trusted=rule.trusted)


def _proposal(own: str, rule: Rule) -> str:
    prefixes = rule.options.get("prefixes")
    name = camel_case(_plain(own))
    for ending in map(str, rule.options.get("endings", ())):
        name = name.removesuffix(ending)
    if prefixes:
        return name if _begins(name, prefixes) else _with_prefix(name, prefixes)
    return screaming_snake_case(name) if rule.options.get("case") == "screaming" else name


def _begins(name: str, prefixes: list[str]) -> bool:
    return any(name.startswith(prefix) and not name[len(prefix) :][:1].islower() for prefix in prefixes)


def _with_prefix(name: str, prefixes: list[str]) -> str:
    """The name with a prefix; one within it comes first: `DoorIsOpen` → `IsDoorOpen`."""
    within = re.fullmatch(f"(.*[a-z0-9])({'|'.join(map(re.escape, prefixes))})([A-Z0-9].*)", name)
    return f"{within[2]}{within[1]}{within[3]}" if within else f"{prefixes[0]}{name}"


_GERMAN = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue", "ß": "ss"})


def _plain(name: str) -> str:
    """The name without accents: `Öl` → `Oel`, `Café` → `Cafe`; a name without plain letters becomes empty."""
    if name.isascii():
        return name
    import unicodedata  # for few names: it takes time at start-up

    name = unicodedata.normalize("NFC", name).translate(_GERMAN)
    return unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
