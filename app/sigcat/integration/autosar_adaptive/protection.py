"""Events and fields that are protected end to end, each with its data id."""

from collections.abc import Iterator, Mapping, Sequence

from sigcat import codes
from sigcat.asil import is_above
from sigcat.function.exchange import Side
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.deployment import identifiers
from sigcat.integration.autosar_adaptive.e2e import E2eProtection, EventE2eSettings, Profile
from sigcat.integration.autosar_adaptive.model import IntegrationModel, TypeEntry
from sigcat.integration.autosar_adaptive.services.elements import Element, Service
from sigcat.integration.autosar_adaptive.someip.numbering import Names, is_given, numbers

METHODS_ARE_NOT_PROTECTED = "sigcat protects events and fields end to end, and this is a method."
TEXT = "string"
WITH_INSTANCE = 4
"""The profile in whose data ids vsomeip puts the instance."""
WITHOUT_LENGTH = 5
"""The profile whose header has no length."""


def protected(services: Sequence[Service], context: Context) -> tuple[Service, ...]:
    """The services, with how each of their events and fields is protected."""
    profiles = dict(_profiles(services, context))
    spans = {key: identifiers.data_ids(profile) for key, profile in profiles.items()}
    names = Names(sorted(profiles), identifiers.RULED_DATA_IDS, suffix=identifiers.DATA_ID, has_dots=True, given=spans)
    instances = {_key(service, element): service.instance for service in services for element in service.elements}
    ids = {
        key: number if is_given(names, key, context) else _with_instance(number, profiles[key], instances[key])
        for key, number in (numbers(names, context) if profiles else {}).items()
    }
    made = {
        key: E2eProtection(profile=profile, data_id=ids[key], max_delta_counter=_step(key, context))
        for key, profile in profiles.items()
    }
    return tuple(
        service._replace(protections={e.name: made[key] for e in service.elements if (key := _key(service, e)) in made})
        for service in services
    )


def _with_instance(number: int, profile: Profile, instance: int) -> int:
    """A data id by rule. With profile 4, its highest byte is the instance, as vsomeip has it."""
    return (
        instance << 24 | number if profile == WITH_INSTANCE and instance <= identifiers.RULED_INSTANCES.last else number
    )


def report_unset_errors(services: Sequence[Service], context: Context) -> None:
    """Report errors of end-to-end protection that nothing sets."""
    for key, side in unprotected_sides(services):
        if rejection := side.rejection_error:
            message = f"{key} must be protected end to end to set {rejection.error} of {side.function}."
            fix = f"State a profile for it under `e2e` in the deployment file: events: {{{key}: {{profile: 4}}}}."
            context.findings.report(codes.E2E_ERROR_NEVER_SET, message, side, fix, key=rejection.key)


def unprotected_sides(services: Sequence[Service]) -> Iterator[tuple[str, Side]]:
    """Sides of elements that are not protected end to end, each with the key of its element."""
    for service in services:
        for element in service.elements:
            yield from (
                (_key(service, element), each) for each in element.sides if element.name not in service.protections
            )


def report_open_lengths(model: IntegrationModel, context: Context) -> None:
    """Report events of open length whose profile sends no length."""
    types = {entry.name: entry for entry in model.datatypes or ()}
    found = {f"{each.name}.{event.name}": event for each in model.interfaces for event in each.events}
    for key, event in found.items():
        if event.protection and event.protection.profile == WITHOUT_LENGTH and _is_open(event.datatype, types):
            message = f"{key} must have a fixed length to be protected by profile {WITHOUT_LENGTH}, which sends none."
            context.findings.report(codes.E2E_LENGTH_OPEN, message, key, "Use profile 4, 6 or 7 for it.")


def _is_open(word: str, types: Mapping[str, TypeEntry]) -> bool:
    """Whether values of a datatype, or of anything in it, vary in length."""
    waiting, seen = [word], {word}
    while waiting:
        entry = types.get(name := waiting.pop())
        if name == TEXT or (entry and entry.is_open):
            return True
        inner = [entry.element, entry.c_definition, *(field.type for field in entry.fields or ())] if entry else []
        waiting += [each for each in inner if each and each not in seen]
        seen.update(waiting)
    return False


def _profiles(services: Sequence[Service], context: Context) -> Iterator[tuple[str, Profile]]:
    for service in services:
        for element in service.elements:
            key = _key(service, element)
            profile = _profile(element, key, context) if not element.is_method else None
            if profile is not None:
                yield key, profile


def _profile(element: Element, key: str, context: Context) -> Profile | None:
    for stated in _stated(key, context):
        if stated.profile is not None:
            return None if stated.profile == "none" else stated.profile
    levels = (each.asil for each in element.sides if states_asil(each))
    return context.settings.e2e.profile if any(is_above(level, "QM") for level in levels) else None


def states_asil(side: Side) -> bool:
    """Whether a side says which ASIL is sent: what consumes an error of another function does not."""
    return side.provides or side.kind != "error"


def _step(key: str, context: Context) -> int:
    stated = (each.max_delta_counter for each in _stated(key, context))
    return next((step for step in stated if step is not None), context.settings.e2e.max_delta_counter)


def _stated(key: str, context: Context) -> Iterator[EventE2eSettings]:
    """Yield the deployment's settings for an event: its own, then those of its service."""
    events = context.settings.e2e.events
    yield from (events[each] for each in (key, key.partition(".")[0]) if each in events)


def _key(service: Service, element: Element) -> str:
    return f"{service.name}.{element.name}"
