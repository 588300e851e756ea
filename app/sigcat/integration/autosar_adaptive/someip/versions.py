"""Versions of services: stated in the deployment, or raised from those of a previous Integration JSON.

A service has a new major version where software that was built for the previous one no longer works: peers with another
major version do not find each other (PRS_SOMEIPServiceDiscovery). A new minor version only adds.
"""

from collections.abc import Iterable, Mapping
from typing import Literal, NamedTuple

from sigcat import codes
from sigcat.findings import Finding
from sigcat.integration.autosar_adaptive.deployment.transport import DEFAULT_TRANSPORT
from sigcat.integration.autosar_adaptive.model import (
    Event,
    IntegrationModel,
    Method,
    ServiceField,
    ServiceInterface,
    TypeEntry,
)

Element = Event | ServiceField | Method
Shape = tuple[object, ...]
"""Everything of an element that both sides of a service must agree on."""


class Version(NamedTuple):
    """Version of a service."""

    major: int
    minor: int

    def __str__(self) -> str:
        return f"{self.major}.{self.minor}"


FIRST = Version(1, 0)
"""Version of a service that has no other."""


class Change(NamedTuple):
    """A difference of a service that changes its version."""

    kind: Literal["breaking", "compatible"]
    text: str


def version_of(interface: ServiceInterface) -> Version:
    """The version of a service."""
    return Version(
        FIRST.major if interface.major_version is None else interface.major_version,
        FIRST.minor if interface.minor_version is None else interface.minor_version,
    )


def parsed(text: str) -> Version:
    """A version as the deployment file has it: `2.1`."""
    major, _, minor = text.partition(".")
    return Version(int(major), int(minor))


class Raised(NamedTuple):
    """A document with the versions that follow from a previous one, and a finding for each that differs."""

    model: IntegrationModel
    findings: tuple[Finding, ...]


def raised(model: IntegrationModel, previous: IntegrationModel, stated: Mapping[str, str]) -> Raised:
    """Raise the version of each service that changed since a previous document, unless the deployment states it."""
    before, now = previous.interfaces_by_name(), model.interfaces_by_name()
    versions: dict[str, Version] = {}
    findings = []
    for name in sorted(before.keys() & now.keys() - stated.keys()):
        old, changes = version_of(before[name][0]), _changes(before[name], previous, now[name], model)
        versions[name] = _next(old, changes)
        if changes:
            breaking = next((each for each in changes if each.kind == "breaking"), changes[0])
            message = f"{name} has version {versions[name]}, not {old}: {breaking.text} ({breaking.kind})."
            findings.append(codes.SERVICE_VERSION_RAISED.finding(message, path=name))
    return Raised(with_versions(model, versions), tuple(findings))


def with_versions(model: IntegrationModel, versions: Mapping[str, Version]) -> IntegrationModel:
    """The document with versions of services by name; others keep theirs."""

    def changed(interface: ServiceInterface) -> ServiceInterface:
        version = versions.get(interface.name, version_of(interface))
        return interface.model_copy(update={"major_version": version.major, "minor_version": version.minor})

    return model.with_interfaces(changed)


def _next(old: Version, changes: Iterable[Change]) -> Version:
    kinds = {each.kind for each in changes}
    if "breaking" in kinds:
        return Version(old.major + 1, 0)
    return Version(old.major, old.minor + 1) if kinds else old


def _changes(
    before: list[ServiceInterface], previous: IntegrationModel, now: list[ServiceInterface], model: IntegrationModel
) -> list[Change]:
    if _head(before[0], previous) != _head(now[0], model):
        return [Change("breaking", "its id, its transport, or how SOME/IP lays out its data changed")]
    old, new = _elements(before, previous), _elements(now, model)
    changed = sorted(name for name in old.keys() & new.keys() if old[name] != new[name])
    return [
        *(Change("breaking", f"{name} was removed") for name in sorted(old.keys() - new.keys())),
        *(Change("breaking", f"{name} changed") for name in changed),
        *(Change("compatible", f"{name} was added") for name in sorted(new.keys() - old.keys())),
    ]


def _head(interface: ServiceInterface, model: IntegrationModel) -> Shape:
    layout = interface.transformation or (model.deployment.transformation if model.deployment else None)
    protocol = (interface.transport or DEFAULT_TRANSPORT).protocol
    return interface.service_id, interface.namespace, layout, protocol


def _elements(interfaces: list[ServiceInterface], model: IntegrationModel) -> dict[str, Shape]:
    """Shapes of elements, by name. If several components list an element, the provider's counts."""
    types = {entry.name: entry for entry in model.datatypes or ()}
    found: dict[str, Shape] = {}
    for interface in sorted(interfaces, key=lambda each: each.role != "Provider"):
        groups = {group.name: group.id for group in interface.event_groups or ()}
        for services in interface.services:
            listed: tuple[Element, ...] = (*services.events, *services.fields, *services.methods)
            for each in listed:
                found.setdefault(each.name, _shape(each, types, groups))
    return found


def _shape(each: Element, types: Mapping[str, TypeEntry], groups: Mapping[str, int]) -> Shape:
    match each:
        case Event():
            meaning = (each.unit, each.scaling, each.offset, each.protection)
            return each.event_id, groups.get(each.event_group or ""), _type(each.datatype, types), meaning
        case ServiceField():
            ids = (each.notifier_id, each.getter_id, groups.get(each.event_group or ""))
            return ids, _type(each.word, types), each.protection
        case Method():
            sides = (each.inputs or (), each.outputs or ())
            arguments = [[(one.name, _type(one.datatype, types), one.unit) for one in side] for side in sides]
            return each.method_id, arguments


def _type(word: str, types: Mapping[str, TypeEntry], above: frozenset[str] = frozenset()) -> Shape | str:
    """Parts of a datatype; the word itself for a primitive."""
    entry = types.get(word)
    if entry is None or word in above:
        return word
    inner = above | {word}
    members = [(field.name, _type(field.type, types, inner), field.unit) for field in entry.fields or ()]
    values = [(each.symbol, each.value) for each in entry.symbols or ()]
    words = [_type(each, types, inner) for each in (entry.type, entry.storage, entry.c_definition) if each]
    return entry.kind, entry.dimension, members, values, words
