"""The SOME/IP ids of a set: those of the deployment, then those of an id catalogue, then those of the rule."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from sigcat import codes
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.deployment.identifiers import INSTANCE, Span, assign, ruled_part
from sigcat.integration.autosar_adaptive.deployment.settings import AutosarAdaptiveSettings


class Names(NamedTuple):
    """Names that have ids of one kind, and the text around each in the keys of a deployment."""

    listed: Sequence[str]
    span: Span
    scope: str = ""
    """`Service.` of the elements of a service."""
    suffix: str = ""
    """`:instance` of instances."""
    has_dots: bool = False
    """Whether names are those of elements with their services."""
    given: Mapping[str, Span] = MappingProxyType({})
    """Spans of ids that are given, by name, where they are not those of the rule."""

    def key(self, name: str) -> str:
        """The key of a name in the deployment, or in an id catalogue."""
        return f"{self.scope}{name}{self.suffix}"

    def name(self, key: str) -> str | None:
        """The name of a key; None if it is one of other names than these."""
        if not key.startswith(self.scope) or not key.endswith(self.suffix):
            return None
        name = key[len(self.scope) : len(key) - len(self.suffix)]
        return None if ("." in name) != self.has_dots or ":" in name else name

    def span_of(self, name: str) -> Span:
        """Ids that a name may be given."""
        return self.given.get(name, self.span)


def numbers(names: Names, context: Context) -> dict[str, int]:
    """An id for each name; errors in the given ones are reported."""
    if names.suffix == INSTANCE and len(names.listed) > 1:  # instances of two services may have one id
        alone = (names._replace(listed=(name,)) for name in names.listed)
        return {name: number for each in alone for name, number in numbers(each, context).items()}
    reserved = {} if names.suffix == INSTANCE else _reserved(names, context)
    fixed = _fixed(names, reserved, context)
    if _are_too_many(names, reserved, context):
        return dict.fromkeys(names.listed, names.span.first)
    assigned = assign(names.listed, names.span, fixed, f"{names.scope}{names.suffix}", reserved)
    for name, other, number in assigned.collisions:
        message = f"{names.scope}{name} and {names.scope}{other} have the same digest: id 0x{number:04X} changes if one of them is removed."
        fix = f"To keep it, fix it in the deployment file: identifiers: {{{names.key(name)}: {number}}}."
        context.findings.report(codes.ID_DEPENDS_ON_OTHERS, message, f"{names.scope}{name}", fix)
    return assigned.ids


def is_given(names: Names, name: str, context: Context) -> bool:
    """Whether the deployment or an id catalogue has the id of a name."""
    return any(each == name for each, _, _ in _stated_ids(names, context.settings))


def _reserved(names: Names, context: Context) -> dict[int, str]:
    """Ids of the catalogue whose names the set does not have, so that nothing else gets them."""
    listed = set(names.listed)
    found = ((number, names.name(key)) for key, number in context.settings.identifier_catalogue.items())
    span = names.span
    return {
        ruled_part(number): name
        for number, name in found
        if name is not None and name not in listed and span.first <= ruled_part(number) <= span.last
    }


def _fixed(names: Names, reserved: Mapping[int, str], context: Context) -> dict[str, int]:
    """Ids that are given. One that cannot be is reported."""
    fixed: dict[str, int] = {}
    for name, number, where in _stated_ids(names, context.settings):
        if reason := _refusal(number, name, names, reserved, fixed):
            message = f"Id 0x{number:04X} of {names.key(name)} in the {where} {reason}."
            context.findings.report(codes.ID_REFUSED, message, f"{names.scope}{name}", "Use another one.")
        else:
            fixed[name] = number
    return fixed


def _stated_ids(names: Names, settings: AutosarAdaptiveSettings) -> Iterator[tuple[str, int, str]]:
    """Names with their ids, and where those stand: the deployment goes before the catalogue."""
    stated, catalogue = settings.identifiers, settings.identifier_catalogue
    keys = [(name, names.key(name)) for name in names.listed]
    yield from ((name, stated[key], "deployment file") for name, key in keys if key in stated)
    yield from ((name, catalogue[key], "id catalogue") for name, key in keys if key in catalogue and key not in stated)


def _refusal(number: int, name: str, names: Names, reserved: Mapping[int, str], fixed: Mapping[str, int]) -> str:
    """Why a name cannot have an id; empty if it can."""
    span = names.span_of(name)
    if not span.first <= number <= span.last:
        return f"must be from 0x{span.first:04X} to 0x{span.last:04X}"
    if number in fixed.values():
        return "must not be used twice"
    if number in reserved:
        return f"must not be used twice: the id catalogue has it for {names.key(reserved[number])}"
    return ""


def _are_too_many(names: Names, reserved: Iterable[int], context: Context) -> bool:
    free = names.span.last - names.span.first + 1 - len(set(reserved))
    if len(names.listed) <= free:
        return False
    message = f"At most {free} names can have an id of this kind in SOME/IP, not {len(names.listed)}."
    context.findings.report(codes.ID_REFUSED, message, names.scope.rstrip("."), "Spread them over several services.")
    return True
