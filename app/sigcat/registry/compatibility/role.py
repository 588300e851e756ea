"""Changes of a node for a function that relies on it, by its role: it provides the value, or it consumes it."""

from collections.abc import Iterable, Iterator, Mapping

from sigcat import codes
from sigcat.catalogue.comparing.changes import CLASSES, Class
from sigcat.registry.changes import UseChange
from sigcat.registry.use import Use

RULES = {"breaking": codes.BREAKS_A_PUBLISHED_FUNCTION, "risky": codes.MAY_BREAK_A_PUBLISHED_FUNCTION}
"""Rules of the findings about a change, by its class."""

_OF_PROVIDERS: Mapping[str, Class] = {
    **dict.fromkeys(("range-narrowed", "values-limited", "values-removed"), "breaking"),
    **dict.fromkeys(("range-widened", "values-unlimited", "values-added"), "compatible"),
}
"""Classes for a function that provides a value, by rule: it may send what is no longer allowed, whatever the node is."""

_OF_CONSUMERS: Mapping[str, Class] = {"type-not-settable": "compatible"}
"""Classes for a function that consumes a value: it does not set the node."""


def for_role(use: Use, changes: Iterable[UseChange]) -> Iterator[UseChange]:
    """Yield the changes that break a use, or may. An optional use needs no node."""
    for change in changes:
        if use.is_optional and change.rule == "removed":
            continue
        classes = _OF_PROVIDERS if use.provides else _OF_CONSUMERS
        rules = change.rules or ((change.rule, change.compatibility),)
        classified = [(classes.get(rule, compatibility), rule) for rule, compatibility in rules]
        compatibility, rule = min(classified, key=lambda each: CLASSES.index(each[0]))
        if compatibility in RULES:
            yield change._replace(rule=rule, compatibility=compatibility)


def verb_of(change: UseChange) -> str:
    """The verb for a change that affects a function, in a sentence."""
    return "breaks" if change.compatibility == "breaking" else "may break"
