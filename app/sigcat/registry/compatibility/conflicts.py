"""Conflicts of functions that are deployed with those in a vehicle line, by the checks of a set of functions."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice, product
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.comparing.compatibility import ROWS
from sigcat.findings import Finding, Severity
from sigcat.function.sets.check_set import check_set
from sigcat.integration.grouping import grouped
from sigcat.registry.changes import UseChange, relied_changes
from sigcat.registry.compatibility.member import NOWHERE, Member
from sigcat.registry.compatibility.role import RULES, for_role, verb_of

_ATTRIBUTES: Mapping[str, str] = {
    codes.PROVIDED_AS_ANOTHER_DATATYPE.id: "datatype", codes.PROVIDED_IN_ANOTHER_UNIT.id: "unit",
    codes.PROVIDED_BEYOND_THE_RANGE.id: "range", codes.TIMEOUT_SHORTER_THAN_PROVIDER.id: "timeout",
    codes.PROVIDED_AT_LOWER_ASIL.id: "asil", codes.PROVIDED_TWICE.id: "provider", codes.PROVIDER_LOST.id: "provider",
}  # fmt: skip


class Side(NamedTuple):
    """A function of a conflict."""

    function: str
    version: str
    """Empty for a file."""
    owner: str
    calls: tuple[str, ...]

    @property
    def sentence(self) -> str:
        """The side in a sentence."""
        version = f" {self.version}" if self.version else ""
        calls = f", call {', '.join(self.calls)}" if self.calls else ""
        return f"{self.function}{version}{calls}, owner {self.owner}"


class Conflict(NamedTuple):
    """Two functions that do not fit, or one that loses its provider."""

    rule: str
    severity: Severity
    message: str
    path: str
    attribute: str
    """Attribute of the signal in which both differ."""
    sides: tuple[Side, ...]
    """The function at fault first."""
    fix: str
    place: tuple[str, int, int] = NOWHERE
    """File, line and column in a file that is deployed."""
    lines: tuple[str, ...] = ()
    """Vehicle lines."""

    @property
    def finding(self) -> Finding:
        """The conflict for a report."""
        sides = "; ".join(side.sentence for side in self.sides)
        where = f"; in line {', '.join(self.lines)}" if self.lines else ""
        message = f"{self.message} ({sides}{where})"
        return Finding(self.rule, self.severity, message, *self.place, path=self.path, fix=self.fix)


def conflicts(deployed: Sequence[Member], field: Sequence[Member], replaced: Sequence[Member]) -> tuple[Conflict, ...]:
    """Conflicts that a deployment brings. `field` are all versions of other functions in the vehicles of a line.

    `replaced` are the versions of the deployed functions that run there now.
    """
    others = [each for each in field if each.name not in {member.name for member in deployed}]
    alone = _mismatches(deployed, ())
    found = [*alone, *(each for other in others for each in _with_other(deployed, other, alone))]
    found += [each for other in others for member in deployed for each in _other_values(member, other)]
    found += _in_circles(deployed, others, found)
    found += _lost(deployed, others, replaced)
    return tuple(dict.fromkeys(found))


def _with_other(deployed: Sequence[Member], other: Member, known: Sequence[Conflict]) -> Iterator[Conflict]:
    if any(not member.elements.isdisjoint(other.elements) for member in deployed):
        seen = {(each.rule, each.message) for each in known}
        found = (each for each in _mismatches(deployed, (other,)) if (each.rule, each.message) not in seen)
        yield from (each for each in found if not _is_of_values(each, (*deployed, other)))


# -- allowed values -----------------------------------------------------------------------------------------------


_VALUES = frozenset(("allowed", "enum"))


def _is_of_values(conflict: Conflict, members: Iterable[Member]) -> bool:
    """Whether two functions have one datatype with other values. Which of them is newer decides whether it matters."""
    uses = (use for member in members for use in member.uses if conflict.path in (use.element, use.path))
    datatypes = {use.values.get("datatype") for use in uses if use.values}
    return conflict.rule == codes.PROVIDED_AS_ANOTHER_DATATYPE.id and len(datatypes) == 1


def _other_values(member: Member, other: Member) -> Iterator[Conflict]:
    """Conflicts about values that are allowed where one function is deployed, and not where the other one was built.

    They are those that a check of the changed catalogue reports.
    """
    by_role = {(use.element, use.provides): use for use in member.uses if use.values}
    for use in {(use.element, use.provides): use for use in other.uses if use.values}.values():
        now = by_role.get((use.element, not use.provides))
        changes = () if now is None else relied_changes(use.element, use.values, now.values)
        for change in for_role(use, (each for each in changes if each.attribute in _VALUES)):
            yield _other_value(change, member, other)


def _other_value(change: UseChange, member: Member, other: Member) -> Conflict:
    rule, element = RULES[change.compatibility], change.element
    message = f"{change.sentence} {verb_of(change)} {other.label}."
    sides = (_side(other, element), _side(member, element))
    why, place = ROWS[change.rule].why, member.place(element)
    return Conflict(rule.id, rule.severity, message, element, change.attribute, sides, why, place)


_OF_CIRCLES = frozenset((codes.CALLS_OF_FUNCTIONS_IN_A_CIRCLE.id, codes.ERRORS_OF_FUNCTIONS_IN_A_CIRCLE.id))
_MOST_VEHICLES = 1_000
"""Combinations of versions in which circles are searched."""


def _in_circles(deployed: Sequence[Member], others: Sequence[Member], known: Sequence[Conflict]) -> Iterator[Conflict]:
    """Yield circles of calls or errors through several functions. A vehicle has one version of each function."""
    seen = {(each.rule, each.message) for each in known}
    versions = grouped(_on_ways_back(deployed, others), lambda member: member.name)
    if len(versions) < 2:
        return
    for vehicle in islice(product(*versions.values()), _MOST_VEHICLES):
        before = {(each.rule, each.message) for each in check_set([each.checked for each in vehicle], is_whole=False)}
        for each in _mismatches(deployed, vehicle):
            if each.rule in _OF_CIRCLES and (each.rule, each.message) not in before | seen:
                seen.add((each.rule, each.message))
                yield each


def _on_ways_back(deployed: Sequence[Member], others: Sequence[Member]) -> Sequence[Member]:
    """Functions to which the deployed ones lead by the order of calls or by errors, and which lead back to them.

    Only functions on the way are read.
    """
    reached, waiting = list[Member](), list(deployed)
    while waiting:
        member = waiting.pop()
        following = [each for each in others if each not in reached and member.depends_on(each)]
        reached += following
        waiting += following
    back, waiting = list[Member](), list(deployed)
    while waiting:
        member = waiting.pop()
        before = [each for each in reached if each not in back and each.depends_on(member)]
        back += before
        waiting += before
    return back


def _mismatches(deployed: Sequence[Member], others: Sequence[Member]) -> tuple[Conflict, ...]:
    members = (*deployed, *others)
    findings = check_set([member.checked for member in members], is_whole=False)
    return tuple(_conflict(finding, deployed, members) for finding in findings)


def _conflict(finding: Finding, deployed: Sequence[Member], members: Sequence[Member]) -> Conflict:
    first = next((each for each in members if each.checked.document.name == finding.file), members[0])
    second = next((each for each in members if each is not first and each.calls(finding.path)), None)
    shown = first if first in deployed else second
    place = shown.place(finding.path) if shown is not None else NOWHERE
    sides = tuple(_side(each, finding.path) for each in (first, second) if each is not None)
    attribute = _ATTRIBUTES.get(finding.rule, "")
    return Conflict(finding.rule, finding.severity, finding.message, finding.path, attribute, sides, finding.fix, place)


def _side(member: Member, path: str) -> Side:
    return Side(member.name, member.version, member.owner, member.calls(path))


# -- providers ----------------------------------------------------------------------------------------------------


def _lost(deployed: Sequence[Member], others: Sequence[Member], replaced: Sequence[Member]) -> Iterator[Conflict]:
    """Consumers that have no provider in some vehicle, and had one before, or need it for the first time.

    A vehicle has one version of each function.
    """
    providers = _providers((*deployed, *others))
    for consumer in (*deployed, *others):
        now = [each for each in replaced if consumer in deployed and each.name == consumer.name]
        needed = consumer.needed
        for path in (*needed, *consumer.optional):
            before = [each for each in replaced if each.provides(path)]
            is_new = consumer in deployed and (not now or any(path not in each.needed for each in now))
            if (before or (is_new and path in needed)) and not _is_provided(path, consumer, providers):
                yield _lost_provider(path, consumer, before, deployed)


def _providers(members: Iterable[Member]) -> Mapping[str, frozenset[str]]:
    """Names of the functions that provide an element in all of their versions, by element."""
    always: dict[str, frozenset[str]] = {}
    for member in members:
        always[member.name] = always.get(member.name, member.provided) & member.provided
    found: dict[str, set[str]] = {}
    for name, elements in always.items():
        for element in elements:
            found.setdefault(element, set()).add(name)
    return {element: frozenset(names) for element, names in found.items()}


def _is_provided(path: str, consumer: Member, providers: Mapping[str, frozenset[str]]) -> bool:
    """Whether every vehicle has a provider: the consumer itself, or another function."""
    return consumer.provides(path) or bool(providers.get(path, frozenset()) - {consumer.name})


def _lost_provider(path: str, consumer: Member, before: Sequence[Member], deployed: Sequence[Member]) -> Conflict:
    is_optional = path in consumer.optional
    rule = codes.PROVIDER_LOST.graded("warning") if is_optional else codes.PROVIDER_LOST  # it runs with its start value
    message = f"No function provides {path!r} to {consumer.label} in every vehicle."
    if before:
        message = f"Removing {path} breaks {consumer.label}: no other function provides it in every vehicle."
    if is_optional:
        message = f"Removing {path} leaves {consumer.label} with the start value: no other function provides it."
    sides = (_side(consumer, path), *(_side(each, path) for each in before))
    named = consumer if consumer in deployed else next(
        (member for member in deployed if member.name in {each.name for each in before}), deployed[0]
    )  # fmt: skip
    fix = "Deploy a provider with it, or keep the signal."
    attribute = _ATTRIBUTES[rule.id]
    return Conflict(rule.id, rule.severity, message, path, attribute, sides, fix, named.place(path))
