"""Checks of names as other languages see them: reserved words, lengths, and names that collide after conversion."""

from collections.abc import Callable, Iterator, Mapping
from functools import cache

from sigcat.catalogue.model.definition import Definition
from sigcat.findings import shown
from sigcat.names import camel_case, last_name, parent_path, screaming_snake_case, snake_case
from sigcat.rules.checks.kind import NodeTest, TreeTest
from sigcat.rules.patterns import compile_pattern
from sigcat.rules.problem import Problem
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree

CASES: Mapping[str, Callable[[str], str]] = {
    "snake": snake_case,
    "camel": camel_case,
    "screaming": screaming_snake_case,
    "unchanged": str,
}


def reserved_word(rule: Rule, _tree: Tree) -> NodeTest:
    """The node's name, as it is and converted to `case`, is none of `words`."""
    convert = _case(rule)
    words = frozenset(map(str, rule.options["words"]))
    target = rule.options["target"]
    known: dict[str, str] = {}

    def test(definition: Definition) -> Iterator[Problem]:
        own = last_name(definition.path)
        converted = known.get(own)
        if converted is None:
            known[own] = converted = own if own in words else convert(own)
        if converted in words:
            how = "is" if converted == own else f"becomes {converted!r},"
            message = f"Name {own!r} {how} a reserved word of {target}."
            fix = f"Use a longer name, such as {parent_path(definition.path).rpartition('.')[2] + own!r}."
            yield Problem(definition, message, fix=fix, facts={"name": own, "converted": converted})

    return test


def converted_name(rule: Rule, _tree: Tree) -> NodeTest:
    """The node's name, converted to `case`, matches `pattern` as a whole."""
    convert = _case(rule)
    pattern = compile_pattern(rule.options["pattern"], trusted=rule.trusted)
    target = rule.options["target"]
    known: dict[str, str] = {}

    def test(definition: Definition) -> Iterator[Problem]:
        own = last_name(definition.path)
        if own not in known:
            converted = convert(own)
            known[own] = "" if pattern.matches(converted) else converted
        if known[own]:
            how = f" becomes {known[own]!r}, which" if known[own] != own else ""
            message = f"Name {own!r}{how} is not a valid name in {target}: it must match {pattern.text}."
            proposal = camel_case(own)
            fix = f"Use a name such as {proposal!r}." if pattern.matches(convert(proposal)) else "Rename it."
            yield Problem(definition, message, fix=fix, facts={"name": own, "converted": known[own]})

    return test


def name_length(rule: Rule, _tree: Tree) -> NodeTest:
    """The name (`of: name`) or the path joined by underscores (`of: path`) has at most `most` characters."""
    most, target = rule.options["most"], rule.options["target"]
    of_path = rule.options.get("of") == "path"

    def test(definition: Definition) -> Iterator[Problem]:
        subject = definition.path if of_path else last_name(definition.path)
        if len(subject) > most:
            what = "The path" if of_path else f"Name {shown(subject)}"
            message = f"{what} must have at most {most} characters for {target}, not {len(subject)}."
            yield Problem(definition, message, fix=f"Use {len(subject) - most} fewer.")

    return test


def collision(rule: Rule, tree: Tree) -> TreeTest:
    """No two children of a branch (`of: name`), or paths of the tree (`of: path`), are equal after conversion.

    Instances are expanded; what collides in several of them is reported for the first.
    """
    of_path = rule.options.get("of") == "path"
    convert = _case(rule) if of_path else cache(_case(rule))
    target = rule.options["target"]

    def test() -> Iterator[Problem]:
        seen: dict[tuple[str, str], str] = {}
        reported: set[tuple[str, str]] = set()
        for path, definition in tree.expanded.items():
            above = "" if of_path else parent_path(path)
            converted = convert(path.replace(".", "_") if of_path else last_name(path))
            other = seen.setdefault((above, converted), path)
            if other == path or (of_path and _collide_above(path, other, convert)):
                continue
            pair = (definition.path, tree.expanded[other].path)
            if pair not in reported:
                reported.add(pair)
                message = f"{path!r} and {other!r} are both called {converted!r} in {target}."
                yield Problem(definition, message, fix="Rename one of the two.", facts={"converted": converted})

    return test


def _collide_above(path: str, other: str, convert: Callable[[str], str]) -> bool:
    """Whether two paths collide only because the branches above them do, which is reported for the branches."""
    above, other_above = parent_path(path), parent_path(other)
    is_same = last_name(path) == last_name(other) and above != other_above
    return is_same and convert(above.replace(".", "_")) == convert(other_above.replace(".", "_"))


def _case(rule: Rule) -> Callable[[str], str]:
    return CASES[rule.options.get("case", "unchanged")]
