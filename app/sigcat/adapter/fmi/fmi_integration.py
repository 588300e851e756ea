"""From functions to the Integration JSON of FMI. The variables of an FMU follow from the cores of its functions."""

import hashlib
import json
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.adapter.core.cores import plans
from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.fmi.bus.planned_bus import bus_of
from sigcat.adapter.fmi.clocks import clocks_of
from sigcat.adapter.fmi.variables import Layout, Variable, layout_of
from sigcat.adapter.host.connections import Connections, Member, connect
from sigcat.function.document.text import Text
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import methods, parts
from sigcat.integration.application import Application, application, info_of, joined, meta_of
from sigcat.integration.deployment import NO_DEPLOYMENT, Deployment
from sigcat.integration.derived import Derived
from sigcat.integration.finding_collector import FindingCollector
from sigcat.integration.fmi.bus import FmuBus
from sigcat.integration.fmi.model import (
    Causality,
    EnumerationItem,
    FmiIntegration,
    Fmu,
    FmuClock,
    FmuConnection,
    FmuVariable,
)
from sigcat.integration.fmi.settings import NO_SETTINGS, FmiSettings
from sigcat.integration.report import Entry, FieldTarget, entries

_DEFAULT_STEP_MS = 10
LONGEST_NAME = 100


class Unit(NamedTuple):
    """An FMU: its name, its functions, connected, and the layout of its values."""

    name: str
    connections: Connections
    layout: Layout


def derive(
    functions: Sequence[ResolvedFunction], deployment: Deployment = NO_DEPLOYMENT, settings: FmiSettings = NO_SETTINGS
) -> Derived[FmiIntegration]:
    """The integration of a function or a set. Raises InputRefused if a function has no core, or the set does not fit."""
    app = application(functions, deployment)
    findings = FindingCollector(app.functions, deployment)
    _report_methods(app, settings, findings)
    units = units_of(app.functions, app.name if settings.fmus == "set" else None, has_arrays=settings.version == "3.0")
    buses = _buses(units, settings, findings)
    model = FmiIntegration(
        meta=meta_of(app, "Integration JSON for FMI"),
        info=info_of(app, app.version),
        version="2.0" if settings.version == "2.0" else None,
        interface="scheduledExecution" if settings.interface == "scheduledExecution" else None,
        license=Text(settings.license),
        copyright=Text(settings.copyright) if settings.copyright else None,
        fmus=tuple(_fmu(unit, settings, buses[unit.name]) for unit in units),
        connections=tuple(_connections(units, buses)),
        functions=app.wholes,
    )
    return Derived(model, findings.findings, tuple(_targets(app, units)))


def units_of(
    functions: Sequence[ResolvedFunction], set_name: str | None, *, has_arrays: bool = True
) -> tuple[Unit, ...]:
    """One FMU for each function, or one of a name for all of them."""
    layout = partial(layout_of, has_arrays=has_arrays)
    planned = plans(functions)
    members = [Member(each, one.plan, Path()) for each, one in zip(functions, planned, strict=True)]
    if set_name is not None:
        connections = connect(members)
        return (Unit(identifier(set_name)[:LONGEST_NAME], connections, layout(connections)),)
    alone = [connect([member]) for member in members]
    return tuple(Unit(each.members[0].name[:LONGEST_NAME], each, layout(each)) for each in alone)


def _buses(units: Sequence[Unit], settings: FmiSettings, findings: FindingCollector) -> Mapping[str, FmuBus | None]:
    """The bus of each FMU; None if nothing of it is mapped."""
    if settings.bus is None:
        return dict.fromkeys((unit.name for unit in units), None)
    at = ("fmi", "bus")
    if settings.network is None:
        fix = "Run `sigcat integrate fmi` where the CAN database is, or remove `bus`."
        findings.report_deployment(codes.BUS_UNFIT, "The CAN database of the bus is not read here.", at, fix, "")
        return dict.fromkeys((unit.name for unit in units), None)
    found = {unit.name: bus_of(unit.connections, unit.layout, settings.bus, settings.network) for unit in units}
    findings.take(settings.network.findings)
    for each in found.values():
        findings.take(each.findings)
    if not any(each.bus or each.findings for each in found.values()):
        fix = "Pass the overlay with `network_serialization`, `dbc2vss` or `vss2dbc` with -l."
        findings.report_deployment(
            codes.BUS_UNFIT, "No signal of the functions is mapped to the CAN database.", at, fix, ""
        )
    return {name: each.bus for name, each in found.items()}


def _fmu(unit: Unit, settings: FmiSettings, bus: FmuBus | None) -> Fmu:
    members = unit.connections.members
    cycles = [call.cycle for member in members for call in member.plan.steps if call.cycle]
    variables = tuple(_variable(index, each) for index, each in enumerate(unit.layout.variables))
    clocks = clocks_of(unit.connections, unit.layout) if settings.interface == "scheduledExecution" else None
    return Fmu(
        name=unit.name,
        description=joined((each.plan.description for each in members), " "),
        functions=tuple(each.function.name for each in members),
        token=token_of(unit.name, (*variables, *(clocks or ()), *((bus,) if bus else ()))),
        step_size=settings.step_size or (_milliseconds(min(cycles)) if cycles else _DEFAULT_STEP_MS),
        variables=variables,
        clocks=clocks,
        bus=bus,
    )


def _milliseconds(nanoseconds: int) -> int | float:
    whole, rest = divmod(nanoseconds, 10**6)
    return nanoseconds / 10**6 if rest else whole


def token_of(name: str, variables: Sequence[FmuVariable | FmuClock | FmuBus]) -> str:
    """The instantiation token: it changes with everything that an importer reads of the variables."""
    read = [name, *(each.model_dump(mode="json", by_alias=True) for each in variables)]
    return f"sigcat_{hashlib.sha256(json.dumps(read, sort_keys=True).encode()).hexdigest()[:32]}"


def _variable(index: int, each: Variable) -> FmuVariable:
    items = tuple(EnumerationItem(name=name, value=number) for name, number in each.number.symbols)
    return FmuVariable(
        name=each.name, reference=index, causality=each.causality, type=each.type, length=each.length, unit=each.unit or None,
        min=each.least, max=each.greatest, start=each.start, items=items or None, description=Text(each.description),
    )  # fmt: skip


def _connections(units: Sequence[Unit], buses: Mapping[str, FmuBus | None]) -> Iterator[FmuConnection]:
    """Outputs of one FMU, and the inputs of others that get them in a set."""
    whole = connect([member for unit in units for member in unit.connections.members])
    exits, entries = _numbered(each.member for each in whole.exits), _numbered(each.member for each in whole.entries)
    connected: set[tuple[str, str]] = set()
    for number, targets in enumerate(whole.routes if len(units) > 1 else ()):
        source, sent = exits[number]
        outputs = _shown(units[source], "output", sent, buses)
        for target in targets:
            end, entry = entries[target]
            received = units[end].layout.inputs[entry].variable
            for start, stop in zip(outputs, _shown(units[end], "input", received, buses), strict=False):
                is_alike = (start.type, start.length) == (stop.type, stop.length)
                if end != source and is_alike and (units[end].name, stop.name) not in connected:
                    connected.add((units[end].name, stop.name))
                    yield FmuConnection(
                        start_fmu=units[source].name,
                        start_variable=start.name,
                        end_fmu=units[end].name,
                        end_variable=stop.name,
                    )


def _numbered(members: Iterable[int]) -> list[tuple[int, int]]:
    """Return for each part of a set its function, and its number among the parts of this function."""
    seen: Counter[int] = Counter()
    numbered = []
    for member in members:
        numbered.append((member, seen[member]))
        seen[member] += 1
    return numbered


def _shown(unit: Unit, causality: Causality, owner: int, buses: Mapping[str, FmuBus | None]) -> list[Variable]:
    """Return the variables of an input or output, unless the bus replaces them."""
    bus = buses[unit.name]
    return [
        each
        for number, each in enumerate(unit.layout.variables)
        if (each.causality, each.owner) == (causality, owner) and not (bus and number in bus.hidden)
    ]


def _report_methods(app: Application, settings: FmiSettings, findings: FindingCollector) -> None:
    """FMI has no calls from one FMU to another: a method works within the FMU of a set alone."""
    for function in app.functions:
        for _, _, method in methods(function.function):
            is_inside = settings.fmus == "set" and len(app.functions) > 1
            if not is_inside:
                message = f"{method.name} cannot be called through FMI: an FMU exchanges values alone."
                fix = "Use `fmi: {fmus: set}` in the deployment file if both functions are in the set."
                findings.report(codes.METHOD_WITHOUT_FMI, message, method, fix)


def _targets(app: Application, units: Sequence[Unit]) -> Iterator[Entry]:
    """Each field goes to the function in the document, from which the FMU is generated."""
    names = {member.function.name: unit.name for unit in units for member in unit.connections.members}
    for function in app.functions:
        for pointer, part in parts(function.function):
            kind = str(next((step for step in reversed(pointer) if isinstance(step, str)), "document"))
            fields = {str(field.alias or name) for name, field in type(part).model_fields.items()}
            goes = FieldTarget(f"FMU {names[function.name]}, SourceFunctionList")
            scalars = dict.fromkeys(fields, goes)
            name = getattr(part, "name", None)
            yield from entries(function.name, name if isinstance(name, str) else function.name, kind, part, scalars)
