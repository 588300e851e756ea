"""Findings on settings for something that does not exist, mostly typing errors; and on settings of units."""

from collections.abc import Collection, Iterator, Sequence

from sigcat import codes
from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.deployment.identifiers import DATA_ID
from sigcat.integration.autosar_adaptive.deployment.transport import DEFAULT_TRANSPORT
from sigcat.integration.autosar_adaptive.protection import METHODS_ARE_NOT_PROTECTED
from sigcat.integration.autosar_adaptive.services.elements import Service
from sigcat.integration.autosar_si_units import WITHOUT_SI, si_unit
from sigcat.integration.unknown_paths import report_unknown_paths
from sigcat.names import did_you_mean


def report_unused(services: Sequence[Service], context: Context) -> None:
    """A finding for each key of the deployment that names nothing of the set."""
    settings = context.settings
    report_unknown_paths(codes.DEPLOYMENT_NAMES_NOTHING, context.application, context.findings)
    names = {each.name for each in services}
    _report_unknown(("components",), settings.components, {part.name for part in context.parts}, context)
    _report_unknown(("identifiers",), settings.identifiers, set(_identified(services)), context)
    _report_unknown(("versions",), settings.versions, names, context)
    _report_unknown(("transport",), settings.transport, names, context)
    _report_unknown_members(services, context)
    _report_unprotectable(services, context)
    paths = {side.path for side in context.exchange.sides if side.kind == "data"}
    for index, service in enumerate(settings.services):
        for number, above in enumerate(service.paths):
            if not any(path == above or path.startswith(f"{above}.") for path in paths):
                message = f"No signal of the set is at or below {above}, which the deployment file puts into service {service.name}."
                pointer = ("autosarAdaptive", "services", index, "paths", number)
                fix = did_you_mean(above, _branches(paths))
                context.findings.report_deployment(codes.DEPLOYMENT_NAMES_NOTHING, message, pointer, fix, above)


def report_units(units: Collection[str], context: Context) -> None:
    """A finding for each unit that nothing is known of, and for each that the deployment describes in vain."""
    described = context.settings.units
    _report_unknown(("units",), described, units, context)
    for unit in sorted(units):
        if unit not in described and unit not in WITHOUT_SI and si_unit(unit) is None:
            message = f"Unit {unit!r} is not one of VSS: in ARXML it has no dimension and no factor to SI units."
            fix = "Describe it under `units` of `autosarAdaptive` in the deployment file."
            context.findings.report(codes.UNIT_WITHOUT_SI, message, unit, fix)


def _report_unknown(section: Pointer, keys: Collection[str], known: Collection[str], context: Context) -> None:
    context.findings.report_unknown(codes.DEPLOYMENT_NAMES_NOTHING, ("autosarAdaptive", *section), keys, known)


def _identified(services: Sequence[Service]) -> Iterator[str]:
    for service in services:
        yield service.name
        yield f"{service.name}:instance"
        yield from (f"{service.name}.{name}" for name in (*service.ids, *service.event_groups))
        yield from (f"{service.name}.{name}{DATA_ID}" for name in service.protections)


def _report_unknown_members(services: Sequence[Service], context: Context) -> None:
    """A finding for each event group of the deployment with a member that the service does not send."""
    for service in services:
        chosen = context.settings.transport.get(service.name, DEFAULT_TRANSPORT)
        sent = {element.name for element in service.elements if not element.is_method}
        groups = chosen.event_groups if isinstance(chosen.event_groups, dict) else {}
        for group, names in groups.items():
            _report_unknown(("transport", service.name, "eventGroups", group), names, sent, context)


def _report_unprotectable(services: Sequence[Service], context: Context) -> None:
    """A finding for each key of `e2e` that names neither an event nor a field."""
    section: Pointer = ("e2e", "events")
    stated, protectable = context.settings.e2e.events, set(_protectable(services))
    others = {f"{each.name}.{element.name}" for each in services for element in each.elements} - protectable
    for key in sorted(stated.keys() & others):
        message = f"{key} cannot be protected end to end. {METHODS_ARE_NOT_PROTECTED}"
        fix = "Remove it. Send the arguments and results as signals, with their ASIL and a profile."
        context.findings.report_deployment(
            codes.DEPLOYMENT_NAMES_NOTHING, message, ("autosarAdaptive", *section, key), fix, key
        )
    _report_unknown(section, stated.keys() - others, protectable, context)


def _protectable(services: Sequence[Service]) -> Iterator[str]:
    for service in services:
        yield service.name
        yield from (f"{service.name}.{element.name}" for element in service.elements if not element.is_method)


def _branches(paths: Collection[str]) -> set[str]:
    found: set[str] = set()
    for path in paths:
        names = path.split(".")
        found.update(".".join(names[:length]) for length in range(1, len(names) + 1))
    return found
