"""Service needs of a component: memory, diagnosis, inhibition, supervision."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Tag, conditional, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.behavior import Within
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_names import short_name

DEPENDENCY = "SWC-SERVICE-DEPENDENCY"
_POINT = "SUPERVISED-ENTITY-CHECKPOINT-NEEDS"


def dependency_name(need: str) -> str:
    """Name of the service dependency of a need."""
    return short_name(f"{need}_Dependency")


def dependencies(at: Within) -> Iterable[Tag]:
    """The service dependencies of a component."""
    component = at.component
    yield from (_block(each, at) for each in component.nv_blocks)
    yield from (_event(each, at) for each in component.diagnostic_events)
    yield from (_inhibition(each, at) for each in component.inhibitions)
    for entity in component.supervised_entities:
        yield _entity(entity, at)
        yield from (_checkpoint(each, entity, at) for each in entity.checkpoints)


def _dependency(name: str, needs: Tag, port: str | None, at: Within, data: Tag | None = None) -> Tag:
    """A dependency. The role of its port is the name of the interface, which the specifications give it."""
    ports = None
    if port is not None:
        target = at.port(port)
        role = {"ROLE": target.interface}
        assignment = tag("ROLE-BASED-PORT-ASSIGNMENT", at.port_reference("PORT-PROTOTYPE-REF", target), role)
        ports = tag("ASSIGNED-PORTS", assignment)
    return tag(DEPENDENCY, data, ports, tag("SERVICE-NEEDS", needs), name=dependency_name(name))


def _block(block: model.NvBlock, at: Within) -> Tag:
    memory = reference("USED-PIM-REF", at.path(block.memory), "PER-INSTANCE-MEMORY")
    needs = tag(
        "NV-BLOCK-NEEDS",
        trace([("Parameters", block.parameters), ("Errors", block.errors), ("AsilLevel", block.asil_level)]),
        {"CALC-RAM-BLOCK-CRC": block.reliability != "NO-PROTECTION", "RELIABILITY": block.reliability},
        {"N-DATA-SETS": 1, "RAM-BLOCK-STATUS-CONTROL": "API", "READONLY": False, "RESISTANT-TO-CHANGED-SW": False},
        {"RESTORE-AT-START": block.restore_at_start, "STORE-AT-SHUTDOWN": block.store_at_shutdown},
        name=block.name,
    )
    data = tag("ASSIGNED-DATAS", tag("ROLE-BASED-DATA-ASSIGNMENT", {"ROLE": "ramBlock"}, memory))
    return _dependency(block.name, needs, block.port, at, data)


def _event(event: model.DiagnosticEvent, at: Within) -> Tag:
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
        {"REPORT-BEHAVIOR": "REPORT-AFTER-INIT"},
        name=event.name,
    )
    return _dependency(event.name, needs, event.port, at)


def _inhibition(inhibition: model.Inhibition, at: Within) -> Tag:
    facts = [("Condition", inhibition.condition), ("Events", inhibition.events), ("Mask", inhibition.mask)]
    needs = tag("FUNCTION-INHIBITION-NEEDS", trace(facts), name=inhibition.name)
    return _dependency(inhibition.name, needs, None, at)


def _entity(entity: model.SupervisedEntity, at: Within) -> Tag:
    names = (_point_name(each, entity) for each in entity.checkpoints)
    paths = (at.path(dependency_name(name), name) for name in names)
    points = (reference(f"{_POINT}-REF", path, _POINT) for path in paths)
    needs = tag(
        "SUPERVISED-ENTITY-NEEDS",
        trace(_facts(entity)),
        listed("CHECKPOINTSS", map(conditional, points)),
        {"ACTIVATE-AT-START": True, "ENABLE-DEACTIVATION": False, "TOLERATED-FAILED-CYCLES": 0},
        _cycles(entity.alive[0]) if entity.alive else None,
        name=entity.name,
    )
    return _dependency(entity.name, needs, None, at)


def _facts(entity: model.SupervisedEntity) -> Iterable[tuple[str, object]]:
    for each in entity.alive:
        yield f"Alive.{each.checkpoint}", each.model_dump(mode="json", exclude={"checkpoint"})
    yield from ((f"Deadline.{each.start}", each) for each in entity.deadlines)
    yield from (("Logical", f"{each.source} > {each.target}") for each in entity.transitions)


def _cycles(alive: model.AliveSupervision) -> dict[str, float]:
    """Alive supervision as times between indications, which is how the needs have it."""
    fewest, most = alive.expected - alive.min_margin, alive.expected + alive.max_margin
    counts = {"EXPECTED": alive.expected, "MAX": fewest, "MIN": most}
    cycle = alive.reference_cycle
    return {f"{name}-ALIVE-CYCLE": round(cycle / count, 9) for name, count in counts.items() if count > 0}


def _point_name(point: model.Checkpoint, entity: model.SupervisedEntity) -> str:
    return short_name(f"{entity.name}_{point.name}")


def _checkpoint(point: model.Checkpoint, entity: model.SupervisedEntity, at: Within) -> Tag:
    name = _point_name(point, entity)
    facts = [("Number", point.number), ("Call", point.call), ("Moment", point.moment)]
    more = [("Initial", point.initial), ("Final", point.final), ("Checkpoint", point.name)]
    needs = tag(_POINT, trace([*facts, *more]), name=name)
    return _dependency(name, needs, point.port, at)
