"""Checks of names: of nodes and of the instances of branches."""

from collections.abc import Iterator
from typing import Any

from app.catalogue.definition import Definition, instances_of
from app.names import camel_case, last_name, screaming_snake_case
from app.rules.checks.kind import NodeTest
from app.rules.flaw import Flaw
from app.rules.patterns import Pattern, compile_pattern
from app.rules.record import Rule
from app.rules.tree import Tree


def name(rule: Rule, _tree: Tree) -> NodeTest:
    """The last name of a path matches `pattern` as a whole, or begins with one of `prefixes` and a capital or digit."""
    pattern = _pattern(rule)
    exempt = frozenset(map(str, rule.options.get("exempt", ())))
    known: dict[str, bool] = {}

    def test(definition: Definition) -> Iterator[Flaw]:
        own = last_name(definition.path)
        if own not in known:
            known[own] = bool(pattern.matches(own)) or own in exempt
        if not known[own]:
            proposal = _proposal(own, rule)
            fix = f"Use a name such as {proposal!r}." if pattern.matches(proposal) else ""
            message = f"Name {own!r} does not follow the naming convention {pattern.text}."
            yield Flaw(definition, message, fix=fix, facts={"name": own, "proposal": proposal})

    return test


def instance_name(rule: Rule, _tree: Tree) -> NodeTest:
    """Every label among the instances of a branch matches `pattern` as a whole; the bracket of a range aside."""
    pattern = compile_pattern(rule.options["pattern"], trusted=rule.trusted)

    def test(definition: Definition) -> Iterator[Flaw]:
        for label in _labels(instances_of(definition.values)):
            if not pattern.matches(label):
                proposal = camel_case(label)
                message = f"Instance {label!r} does not follow the naming convention {pattern.text}."
                fix = f"Use a name such as {proposal!r}." if pattern.matches(proposal) else ""
                facts = {"name": label, "proposal": proposal}
                yield Flaw(definition, message, "instances", fix, facts)

    return test


def _pattern(rule: Rule) -> Pattern:
    prefixes = rule.options.get("prefixes")
    text = f"({'|'.join(map(str, prefixes))})[A-Z0-9][A-Za-z0-9]*" if prefixes else rule.options.get("pattern", ".*")
    return compile_pattern(text, trusted=rule.trusted)


def _proposal(own: str, rule: Rule) -> str:
    prefixes = rule.options.get("prefixes")
    if prefixes:
        return f"{prefixes[0]}{camel_case(own)}"
    return screaming_snake_case(own) if rule.options.get("case") == "screaming" else camel_case(own)


def _labels(instances: list[Any]) -> Iterator[str]:
    for entry in instances:
        for item in entry if isinstance(entry, list) else [entry]:
            text = str(item)
            yield text.partition("[")[0] if text.endswith("]") else text
