"""Grouping of interfaces into services: by the component that provides them, or by the branch they come from."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.methods import MethodInterface
from sigcat.function.function_json.role import PROVIDER
from sigcat.function.function_json.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.application import Part
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_names import branch_of, service_name
from sigcat.integration.autosar_parts import Item
from sigcat.integration.finding_collector import Subject

MODES = "ModeManagement"
SAFETY = "SafetyManagement"
"""Parts of the base software: which sends a function its mode, and which informs it of safety conditions."""


class Group(NamedTuple):
    """A service before its elements are named."""

    name: str
    origin: str
    provider: Part | None


class Placed(NamedTuple):
    """An interface, the service that it belongs to, and what makes it the same element for all who use it."""

    group: Group
    identity: str
    item: Item
    provides: bool


def placed(items: Sequence[Item], context: Context) -> list[Placed]:
    """Every interface with its service."""
    providers = _providers(items, context)
    return [*(_placed(item, providers, context) for item in items), *_dependencies(items)]


def _dependencies(items: Sequence[Item]) -> Iterator[Placed]:
    """Errors of other components that set an error or a safety reaction of a component: it consumes their status."""
    reported = {item.interface.name: item for item in reversed(items) if isinstance(item.interface, ErrorInterface)}
    seen: set[tuple[str, str]] = set()
    for item in items:
        for name in _causes(item.interface):
            other = reported.get(name)
            if other is not None and other.part.name != item.part.name and (item.part.name, name) not in seen:
                seen.add((item.part.name, name))
                consumed = Item(item.part, item.call, other.interface)
                yield Placed(_of_part(other.part), name, consumed, provides=False)


def _causes(interface: object) -> tuple[str, ...]:
    """Names of the errors that set an error or a safety reaction."""
    if isinstance(interface, SafetyReaction):
        return interface.errors
    return interface.dependencies if isinstance(interface, ErrorInterface) else ()


def identity_of(item: Item, context: Context) -> str:
    """VSS path of a data interface, or its name where it has none; the name of any other interface."""
    data = isinstance(item.interface, Signal | DataQueue)
    return (data and context.path_of(item)) or item.interface.name


def _providers(items: Iterable[Item], context: Context) -> dict[tuple[bool, str], list[Part]]:
    """Components that provide each signal (False) and each method (True), in the order of the set."""
    found: defaultdict[tuple[bool, str], list[Part]] = defaultdict(list)
    second: dict[tuple[bool, str], Item] = {}
    for item in items:
        if not isinstance(item.interface, Signal | DataQueue | MethodInterface) or item.interface.role != PROVIDER:
            continue
        key = (isinstance(item.interface, MethodInterface), identity_of(item, context))
        if all(part.name != item.part.name for part in found[key]):
            found[key].append(item.part)
            if len(found[key]) == 2:
                second[key] = item
    for key, item in second.items():
        subject, parts = Subject(key[1], item.interface), found[key]
        names = ", ".join(part.name for part in parts)
        message = f"{subject} must have one provider, not {names}. Consumers are connected to {parts[0].name}."
        context.findings.report(
            codes.SEVERAL_PROVIDERS, message, subject, "Let only one of them provide it.", key="Role"
        )
    return found


def _placed(item: Item, providers: dict[tuple[bool, str], list[Part]], context: Context) -> Placed:
    interface, identity = item.interface, identity_of(item, context)
    if isinstance(interface, SafetyReaction):
        return Placed(_of_origin(SAFETY), identity, item, provides=False)
    if isinstance(interface, ModeInterface) and interface.direction != "Out":
        return Placed(_of_origin(MODES), identity, item, provides=False)
    if isinstance(interface, ErrorInterface | ModeInterface) or interface.role == PROVIDER:
        return Placed(_of_part(item.part), identity, item, provides=True)
    parts = providers.get((isinstance(interface, MethodInterface), identity), [])
    if parts:
        return Placed(_of_part(parts[0]), identity, item, provides=False)
    return Placed(_outside(item, identity, context), identity, item, provides=False)


def _outside(item: Item, identity: str, context: Context) -> Group:
    """The service of elements that no function of the set provides."""
    is_path = not isinstance(item.interface, MethodInterface) and bool(context.path_of(item))
    if is_path:
        return _configured(identity, context) or _of_origin(branch_of(identity))
    message = f"{identity} ({item.where}) must have a VSS path or a provider in the set."
    fix = f"Set its path in the deployment file, as `paths: {{{item.part.function_name}.{item.interface.name}: Vehicle...}}`, or add the provider."
    fix = "Add its provider." if isinstance(item.interface, MethodInterface) else fix
    context.findings.report(codes.PROVIDER_UNKNOWN, message, Subject(identity, item.interface), fix)
    return _of_origin(f"{item.part.name}Required")


def _configured(path: str, context: Context) -> Group | None:
    """The service of the deployment with the longest path above the signal."""
    found = [
        (len(above), service.name, above)
        for service in context.settings.services
        for above in service.paths
        if path == above or path.startswith(f"{above}.")
    ]
    if not found:
        return None
    _, name, _ = max(found)
    return Group(name, name, None)


def _of_origin(origin: str) -> Group:
    return Group(service_name(origin), origin, None)


def _of_part(part: Part) -> Group:
    return Group(service_name(part.name), part.name, part)
