"""Service needs of a component, from the declaration: memory, diagnosis, supervision, inhibition."""

from collections.abc import Iterable, Iterator, Sequence

from sigcat.function.document.text import Text
from sigcat.function.exchange import Part, errors_of, reactions_of
from sigcat.integration.autosar_classic import base_software, model
from sigcat.integration.autosar_classic.context import NamedCall
from sigcat.integration.autosar_classic.interfaces import in_seconds
from sigcat.integration.autosar_classic.parameters import parameters_of
from sigcat.integration.autosar_classic.partitioning import asil_of
from sigcat.integration.autosar_names import distinct, short_name

CLOCK_PORT, IGNITION_PORT, ECU_PORT = "Clock", "Ignition", "EcuMode"
NV_PORT, STORED, SUPERVISION_PORT = "StoredBlock", "Stored", "Supervision"


def monitors(part: Part) -> tuple[model.DiagnosticEvent, ...]:
    """An event of the DEM for each error. The core matures errors, so that the DEM does not debounce."""
    errors = errors_of(part)
    names = distinct({error.name: short_name(error.name) for error in errors})
    return tuple(
        model.DiagnosticEvent(
            name=names[error.name],
            error=error.name,
            port=short_name(f"Event_{names[error.name]}"),
            debouncing="MonitorInternal",
            description=error.description or None,
            severity=error.severity or None,
            occurrence_limit=error.occurrence_count_limit,
            ignition_limit=error.ignition_count_limit,
            asil_level=error.asil_level,
        )
        for error in errors
    )


def inhibitions(part: Part) -> tuple[model.Inhibition, ...]:
    """A function identifier for each safety condition: others ask whether they may run, this function decides itself."""
    names = distinct({each.name: short_name(f"Fid_{each.name}") for each in reactions_of(part)})
    return tuple(
        model.Inhibition(name=names[each.name], condition=each.name, events=each.errors, mask="LAST_FAILED")
        for each in reactions_of(part)
        if each.errors
    )


def nv_blocks(part: Part) -> tuple[model.NvBlock, ...]:
    """The block that keeps what is learned and counted; none if there is nothing to keep."""
    kept = tuple(each.interface.name for each in parameters_of(part) if each.is_stored)
    counted = tuple(error.name for error in errors_of(part))
    if not kept and not counted:
        return ()
    level = asil_of(part)
    return (
        model.NvBlock(
            name=short_name(f"{part.name}_{STORED}"),
            memory=STORED,
            port=NV_PORT,
            parameters=kept,
            errors=counted,
            reliability="ERROR-DETECTION" if level == "QM" else "ERROR-CORRECTION",
            restore_at_start=True,
            store_at_shutdown=True,
            asil_level=level,
        ),
    )


def memories(part: Part) -> tuple[model.PerInstanceMemory, ...]:
    """The RAM block of stored data."""
    if not nv_blocks(part):
        return ()
    core = f"{part.function_name}_Adapter"
    return (
        model.PerInstanceMemory(
            name=STORED,
            type=short_name(f"{part.name}_{STORED}Type"),
            type_definition=f"{core}_Stored",
            header=f"{part.function_name}_adapter.h",
            description=Text("What the core keeps from one run to the next: counts of errors and parameters."),
        ),
    )


def supervised_entities(part: Part, calls: Sequence[NamedCall]) -> tuple[model.SupervisedEntity, ...]:
    """One entity for the component, with a checkpoint before and after each supervised call."""
    supervised = [each for each in calls if each.call.watchdog is not None or each.call.checkpoint is not None]
    if not supervised:
        return ()
    points = tuple(_checkpoints(supervised))
    return (
        model.SupervisedEntity(
            name=short_name(f"{part.name}_Entity"),
            checkpoints=points,
            alive=tuple(_alive(supervised)),
            deadlines=tuple(_deadlines(supervised)),
            transitions=tuple(_transitions(supervised)),
        ),
    )


def _checkpoints(calls: Iterable[NamedCall]) -> Iterator[model.Checkpoint]:
    number = 0
    for each in calls:
        for moment in ("Begin", "End"):
            flow = each.call.checkpoint if moment == "Begin" else None
            yield model.Checkpoint(
                name=f"{each.name}_{moment}",
                number=number,
                port=short_name(f"{SUPERVISION_PORT}_{each.name}_{moment}"),
                call=each.call.name,
                moment=moment,
                initial=flow.initial if flow else None,
                final=flow.final if flow else None,
            )
            number += 1


def _alive(calls: Iterable[NamedCall]) -> Iterator[model.AliveSupervision]:
    for each in calls:
        alive, cycle = each.call.watchdog.alive if each.call.watchdog else None, each.call.cycle_time
        if alive is not None and cycle:
            expected = int(alive.reference)
            yield model.AliveSupervision(
                checkpoint=f"{each.name}_End",
                expected=expected,
                min_margin=max(0, expected - int(alive.min)),
                max_margin=max(0, int(alive.max) - expected),
                reference_cycle=in_seconds(expected * cycle),
                error=alive.error_name,
            )


def _deadlines(calls: Iterable[NamedCall]) -> Iterator[model.DeadlineSupervision]:
    for each in calls:
        deadline = each.call.watchdog.deadline if each.call.watchdog else None
        if deadline is not None:
            yield model.DeadlineSupervision(
                start=f"{each.name}_Begin",
                end=f"{each.name}_End",
                min=in_seconds(deadline.min),
                max=in_seconds(deadline.max),
                error=deadline.error_name,
            )


def _transitions(calls: Sequence[NamedCall]) -> Iterator[model.LogicalTransition]:
    names = {each.call.name: each.name for each in calls}
    for each in calls:
        for target in (each.call.checkpoint.next or ()) if each.call.checkpoint else ():
            if target in names:
                yield model.LogicalTransition(source=f"{each.name}_Begin", target=f"{names[target]}_Begin")


def service_ports(part: Part, calls: Sequence[NamedCall]) -> Iterator[model.Port]:
    """Ports to the base software, and to the sources of the time and the ignition cycle."""
    yield _call_port(CLOCK_PORT, base_software.CLOCK, "Time of the counter that starts timing events.")
    yield _call_port(IGNITION_PORT, base_software.IGNITION, "Number of the ignition cycle.")
    for event in monitors(part):
        yield _call_port(event.port, base_software.DIAGNOSTIC_MONITOR, f"Status of {event.error}.")
    if nv_blocks(part):
        yield _call_port(NV_PORT, base_software.NV_MEMORY, "State of the stored data.")
    for entity in supervised_entities(part, calls):
        for point in entity.checkpoints:
            yield _call_port(point.port, base_software.SUPERVISION, f"Checkpoint {point.name} of {entity.name}.")
    yield model.Port(
        name=ECU_PORT,
        direction="Required",
        kind="ModeSwitch",
        interface=base_software.ECU_MODE.name,
        elements=(model.Element(name=base_software.ECU_MODE.prototype),),
        service=base_software.ECU_MODE.service,
        description=Text("Mode of the ECU: it is shut down after Terminate."),
    )


def _call_port(name: str, interface: model.ClientServerInterface, description: str) -> model.Port:
    return model.Port(
        name=name,
        direction="Required",
        kind="ClientServer",
        interface=interface.name,
        elements=tuple(model.Element(name=operation.name) for operation in interface.operations),
        service=interface.service,
        description=Text(description),
    )
