"""Service needs of a component: memory, diagnosis, inhibition, supervision."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Tag, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.behavior import Within
from sigcat.adapter.autosar_classic.arxml.paths import COMPONENTS
from sigcat.adapter.autosar_classic.arxml.ports import port_tag
from sigcat.integration.autosar_classic.model import (
    AliveSupervision,
    Checkpoint,
    DiagnosticEvent,
    Inhibition,
    NvBlock,
    SupervisedEntity,
)
from sigcat.integration.autosar_names import short_name

DEPENDENCY = "SWC-SERVICE-DEPENDENCY"


def dependency_name(need: str) -> str:
    """Name of the service dependency of a need."""
    return short_name(f"{need}_Dependency")


def dependencies(at: Within) -> Iterable[Tag]:
    """The service dependencies of a component."""
    component = at.component
    yield from (_block(each, at) for each in component.nv_blocks)
    yield from (_event(each, at) for each in component.diagnostic_events)
    yield from (_inhibition(each) for each in component.inhibitions)
    for entity in component.supervised_entities:
        yield _entity(entity, at)
        yield from (_checkpoint(each, entity, at) for each in entity.checkpoints)


def _dependency(name: str, needs: Tag, port: str | None, at: Within | None, data: Tag | None = None) -> Tag:
    """A dependency. The role of its port is the name of the interface, which the specifications give it."""
    ports = None
    if port is not None and at is not None:
        target = at.port(port)
        path = at.known.paths.of(COMPONENTS, at.component.name, target.name)
        ports = tag(
            "ASSIGNED-PORTS",
            tag(
                "ROLE-BASED-PORT-ASSIGNMENT",
                reference("PORT-PROTOTYPE-REF", path, port_tag(target.direction)),
                tag("ROLE", text=target.interface),
            ),
        )
    return tag(DEPENDENCY, data, ports, tag("SERVICE-NEEDS", needs), name=dependency_name(name))


def _block(block: NvBlock, at: Within) -> Tag:
    memory = tag(
        "ROLE-BASED-DATA-ASSIGNMENT",
        tag("ROLE", text="ramBlock"),
        reference("USED-PIM-REF", at.path(block.memory), "PER-INSTANCE-MEMORY"),
    )
    needs = tag(
        "NV-BLOCK-NEEDS",
        trace([("Parameters", block.parameters), ("Errors", block.errors), ("AsilLevel", block.asil_level)]),
        tag("CALC-RAM-BLOCK-CRC", text=_bool(block.reliability != "NO-PROTECTION")),
        tag("N-DATA-SETS", text=1),
        tag("RAM-BLOCK-STATUS-CONTROL", text="API"),
        tag("READONLY", text="false"),
        tag("RELIABILITY", text=block.reliability),
        tag("RESISTANT-TO-CHANGED-SW", text="false"),
        tag("RESTORE-AT-START", text=_bool(block.restore_at_start)),
        tag("STORE-AT-SHUTDOWN", text=_bool(block.store_at_shutdown)),
        name=block.name,
    )
    return _dependency(block.name, needs, block.port, at, tag("ASSIGNED-DATAS", memory))


def _bool(value: bool) -> str:
    return str(value).lower()


def _event(event: DiagnosticEvent, at: Within) -> Tag:
    facts = [
        ("Error", event.error), ("Severity", event.severity), ("OccurrenceCountLimit", event.occurrence_limit),
        ("IgnitionCountLimit", event.ignition_limit), ("AsilLevel", event.asil_level), ("Debouncing", event.debouncing),
    ]  # fmt: skip
    algorithm = tag("DIAG-EVENT-DEBOUNCE-MONITOR-INTERNAL", name=event.debouncing)
    needs = tag(
        "DIAGNOSTIC-EVENT-NEEDS",
        description(event.description),
        trace(facts),
        tag("DIAG-EVENT-DEBOUNCE-ALGORITHM", algorithm),
        tag("REPORT-BEHAVIOR", text="REPORT-AFTER-INIT"),
        name=event.name,
    )
    return _dependency(event.name, needs, event.port, at)


def _inhibition(inhibition: Inhibition) -> Tag:
    facts = [("Condition", inhibition.condition), ("Events", inhibition.events), ("Mask", inhibition.mask)]
    return _dependency(
        inhibition.name, tag("FUNCTION-INHIBITION-NEEDS", trace(facts), name=inhibition.name), None, None
    )


def _entity(entity: SupervisedEntity, at: Within) -> Tag:
    facts: list[tuple[str, object]] = [
        (f"Alive.{each.checkpoint}", each.model_dump(mode="json", by_alias=True, exclude={"checkpoint"}))
        for each in entity.alive
    ]
    facts += [(f"Deadline.{each.start}", each.model_dump(mode="json", by_alias=True)) for each in entity.deadlines]
    facts += [("Logical", f"{each.source} > {each.target}") for each in entity.transitions]
    points = (
        tag("SUPERVISED-ENTITY-CHECKPOINT-NEEDS-REF-CONDITIONAL", _point_reference(each, entity, at))
        for each in entity.checkpoints
    )
    needs = tag(
        "SUPERVISED-ENTITY-NEEDS",
        trace(facts),
        tag("ACTIVATE-AT-START", text="true"),
        listed("CHECKPOINTSS", points),
        tag("ENABLE-DEACTIVATION", text="false"),
        *(_cycles(entity.alive[0]) if entity.alive else ()),
        tag("TOLERATED-FAILED-CYCLES", text=0),
        name=entity.name,
    )
    return _dependency(entity.name, needs, None, None)


def _cycles(alive: AliveSupervision) -> Iterable[Tag | None]:
    """Alive supervision as times between indications, which is how the needs have it."""
    fewest, most = alive.expected - alive.min_margin, alive.expected + alive.max_margin
    for name, count in (("EXPECTED", alive.expected), ("MAX", fewest), ("MIN", most)):
        yield tag(f"{name}-ALIVE-CYCLE", text=round(alive.reference_cycle / count, 9)) if count > 0 else None


def _point_reference(point: Checkpoint, entity: SupervisedEntity, at: Within) -> Tag:
    name = _point_name(point, entity)
    path = at.path(dependency_name(name), name)
    return reference("SUPERVISED-ENTITY-CHECKPOINT-NEEDS-REF", path, "SUPERVISED-ENTITY-CHECKPOINT-NEEDS")


def _point_name(point: Checkpoint, entity: SupervisedEntity) -> str:
    return short_name(f"{entity.name}_{point.name}")


def _checkpoint(point: Checkpoint, entity: SupervisedEntity, at: Within) -> Tag:
    name = _point_name(point, entity)
    facts = [("Number", point.number), ("Call", point.call), ("Moment", point.moment)]
    more = [("Initial", point.initial), ("Final", point.final), ("Checkpoint", point.name)]
    needs = tag("SUPERVISED-ENTITY-CHECKPOINT-NEEDS", trace([*facts, *more]), name=name)
    return _dependency(name, needs, point.port, at)
