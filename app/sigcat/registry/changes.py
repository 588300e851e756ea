"""Classes of changes between what a version had and what a newer one has, by the table of `sigcat diff`."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from sigcat.catalogue.comparing.changes import Class
from sigcat.catalogue.comparing.compatibility import NO_VOCABULARIES, ROWS, Vocabularies, attribute_changes
from sigcat.catalogue.comparing.diff_report import plain
from sigcat.registry.use import RELIED_ON, Use

Nodes = Mapping[str, Mapping[str, Any]]
"""Attributes of nodes by path."""


class UseChange(NamedTuple):
    """A change of an element that is used. The attribute is empty if the whole element is gone or new."""

    element: str
    attribute: str
    old: Any
    new: Any
    rule: str
    compatibility: Class
    rules: tuple[tuple[str, Class], ...] = ()
    """Every rule of the change, with its class: for the role of a function another one may be the worst."""

    @property
    def sentence(self) -> str:
        """The change as the beginning of a sentence."""
        if not self.attribute:
            return f"{'Adding' if self.rule == 'added' else 'Removing'} {self.element}"
        return f"Changing `{self.attribute}` of {self.element} from {_shown(self.old)} to {_shown(self.new)}"


def _shown(value: Any) -> str:
    text = "none" if value is None else str(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def relied_changes(
    element: str,
    old: Mapping[str, Any],
    new: Mapping[str, Any] | None,
    vocabularies: Vocabularies = NO_VOCABULARIES,
) -> Iterator[UseChange]:
    """Changes of a node for software that relies on its old attributes; `new` is None if it is gone."""
    if new is None:
        kind = str(old.get("type"))
        yield UseChange(element, "", kind, None, "removed", ROWS["removed"].for_type(kind))
        return
    kept = plain({key: new[key] for key in RELIED_ON if new.get(key) is not None})
    for change in attribute_changes(old, kept, vocabularies):
        rules = tuple((rule, ROWS[rule].for_type(str(old.get("type")))) for rule in change.rules)
        yield UseChange(element, change.name, change.old, change.new, change.rule, change.compatibility, rules)


def node_changes(old: Nodes, new: Nodes, touched: Iterable[str]) -> Iterator[UseChange]:
    """Changes between the nodes of two versions. `new` has all nodes, and `touched` are those of the new version."""
    for path, values in old.items():
        yield from relied_changes(path, _part(values), new.get(path))
    for path in touched:
        if path not in old:
            yield UseChange(path, "", None, new[path].get("type"), "added", ROWS["added"].for_type("sensor"))


def _part(values: Mapping[str, Any]) -> Mapping[str, Any]:
    return {key: values[key] for key in RELIED_ON if values.get(key) is not None}


def function_changes(old: Iterable[Use], new: Iterable[Use]) -> Iterator[UseChange]:
    """Changes of a function for the functions around it.

    What it no longer provides is missing elsewhere, and a new input needs a provider.
    """
    before, after = _by_element(old), _by_element(new)
    for key, use in before.items():
        now = after.get(key)
        if now is not None:
            yield from relied_changes(use.element, use.values, now.values)
        elif use.provides:
            yield UseChange(use.element, "", use.verb, None, "removed", "breaking")
        else:
            yield UseChange(use.element, "", use.verb, None, "removed", "compatible")
    for key, use in after.items():
        if key not in before:
            yield UseChange(use.element, "", None, use.verb, "added", "risky" if use.is_needed else "compatible")


def _by_element(uses: Iterable[Use]) -> Mapping[tuple[str, bool], Use]:
    return {(use.element, use.provides): use for use in uses if use.verb != "runs"}
