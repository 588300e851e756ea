"""The configuration of the ECU as far as a set of components decides it: tasks, and the events that they serve.

The parameters are those of AUTOSAR_SWS_RTE and AUTOSAR_SWS_OS; their definitions are the vendor's.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat.adapter.arxml.tree import Package, Tag, conditional, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.behavior import EVENT, Within
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.paths import COMPOSITIONS, CONFIGURATIONS, DEFINITIONS, PROTOTYPE, SYSTEMS
from sigcat.adapter.autosar_classic.arxml.system import system_name
from sigcat.integration.autosar_classic.model import ClassicIntegration, Event, Prototype, Task, TaskEvent
from sigcat.integration.autosar_names import distinct, short_name

MODULE = "ECUC-MODULE-CONFIGURATION-VALUES"
_CONTAINER, _CONTAINER_DEF = "ECUC-CONTAINER-VALUE", "ECUC-PARAM-CONF-CONTAINER-DEF"
_COUNTER = "AdapterCounter"


class _Mapped(NamedTuple):
    """An event of a task or of an init batch, and what starts it."""

    place: TaskEvent
    event: Event
    alarm: str | None = None
    """Alarm of the operating system, for what is cyclic."""
    os_event: str | None = None
    """Event of the operating system, for a task that waits for several."""


def package(known: Library) -> Package:
    """The package of the configuration: modules RTE and operating system, and their collection."""
    model = known.model
    tasks = [(task, _mapped(task, known)) for task in model.ecu.tasks]
    modules = (reference(f"{MODULE}-REF", known.path(CONFIGURATIONS, name), MODULE) for name in ("Rte", "Os"))
    collection = tag(
        "ECUC-VALUE-COLLECTION",
        reference("ECU-EXTRACT-REF", known.path(SYSTEMS, system_name(model)), "SYSTEM"),
        listed("ECUC-VALUES", map(conditional, modules)),
        name=short_name(f"{model.ecu.name}_Configuration"),
    )
    rte = [_container(_BATCH, each.name, about=trace([("Reason", each.reason)])) for each in model.ecu.init_batches]
    rte += (each for prototype in model.composition.prototypes for each in _instance(prototype, tasks, known))
    rte += _os_interaction(tasks, known)
    return Package(CONFIGURATIONS, (_module("Rte", rte), _module("Os", _operating_system(tasks, known)), collection))


def _module(name: str, containers: Iterable[Tag]) -> Tag:
    return tag(
        MODULE,
        reference("DEFINITION-REF", f"{DEFINITIONS}/{name}", "ECUC-MODULE-DEF"),
        {"IMPLEMENTATION-CONFIG-VARIANT": "VARIANT-PRE-COMPILE"},
        listed("CONTAINERS", containers),
        name=name,
    )


# -- values of parameters ---------------------------------------------------------------------------------------------


def _container(
    definition: str, name: str, values: Iterable[Tag] = (), references: Iterable[Tag] = (), inner: Iterable[Tag] = (),
    about: Tag | None = None, kind: str = _CONTAINER_DEF,
) -> Tag:  # fmt: skip
    return tag(
        _CONTAINER,
        about,
        reference("DEFINITION-REF", f"{DEFINITIONS}/{definition}", kind),
        listed("PARAMETER-VALUES", values),
        listed("REFERENCE-VALUES", references),
        listed("SUB-CONTAINERS", inner),
        name=name,
    )


def _number(definition: str, value: float, kind: str = "INTEGER") -> Tag:
    target = reference("DEFINITION-REF", f"{DEFINITIONS}/{definition}", f"ECUC-{kind}-PARAM-DEF")
    return tag("ECUC-NUMERICAL-PARAM-VALUE", target, {"VALUE": value})


def _text(definition: str, value: str) -> Tag:
    target = reference("DEFINITION-REF", f"{DEFINITIONS}/{definition}", "ECUC-ENUMERATION-PARAM-DEF")
    return tag("ECUC-TEXTUAL-PARAM-VALUE", target, {"VALUE": value})


def _to(definition: str, kind: str, path: str, path_kind: str) -> Tag:
    target = reference("DEFINITION-REF", f"{DEFINITIONS}/{definition}", kind)
    return tag("ECUC-REFERENCE-VALUE", target, reference("VALUE-REF", path, path_kind))


def _within(definition: str, module: str, name: str, known: Library) -> Tag:
    """Reference to a container of the configuration."""
    return _to(definition, "ECUC-REFERENCE-DEF", known.path(CONFIGURATIONS, module, name), _CONTAINER)


def _foreign(definition: str, path: str, kind: str) -> Tag:
    """Reference to an element outside the configuration: an event, a component."""
    return _to(definition, "ECUC-FOREIGN-REFERENCE-DEF", path, kind)


# -- what activates tasks ---------------------------------------------------------------------------------------------

_Tasks = Sequence[tuple[Task, Sequence[_Mapped]]]
"""Tasks with their events."""


def _event_of(mapped: TaskEvent, known: Library) -> Event:
    types = {each.name: each.type for each in known.model.composition.prototypes}
    component = next(each for each in known.model.components if each.name == types[mapped.component])
    return next(each for each in component.events if each.name == mapped.event)


def _mapped(task: Task, known: Library) -> list[_Mapped]:
    """The events of a task. A task that only one alarm activates has no events of the operating system."""
    pairs = [(place, _event_of(place, known)) for place in task.events]
    sources = [_source(task, *pair) for pair in pairs]
    names = distinct({source: short_name(source) for source in sources})
    is_basic = len(names) == 1 and all(event.kind == "Timing" for _, event in pairs)
    return [
        _Mapped(
            place,
            event,
            short_name(f"Alarm_{names[source]}") if event.kind == "Timing" else None,
            None if is_basic else short_name(f"Event_{names[source]}"),
        )
        for source, (place, event) in zip(sources, pairs, strict=True)
    ]


def _source(task: Task, place: TaskEvent, event: Event) -> str:
    """Name of the activation of an event. Events of one period and offset have one alarm."""
    if event.kind != "Timing":
        return f"{place.component}_{event.name}"
    return f"{task.name}_{_microseconds(event.offset)}_{_microseconds(event.period)}"


def _microseconds(seconds: float | None) -> int:
    return round((seconds or 0) * 1_000_000)


# -- RTE --------------------------------------------------------------------------------------------------------------

_INSTANCE = "Rte/RteSwComponentInstance"
_MAPPING = f"{_INSTANCE}/RteEventToTaskMapping"
_AREA = f"{_INSTANCE}/RteExclusiveAreaImplementation"
_BATCH = "Rte/RteInitializationRunnableBatch"
_MECHANISM = "OS_RESOURCE"
"""Writes within an area may start runnables; an OS activates no task while interrupts are blocked."""


def _instance(prototype: Prototype, tasks: _Tasks, known: Library) -> Iterable[Tag]:
    """The instance of a component; none for one without code."""
    for component in (each for each in known.model.components if each.name == prototype.type):
        at = Within(component, known)
        inner = [
            _first(_Mapped(each, _event_of(each, known)), batch.name, at)
            for batch in known.model.ecu.init_batches
            for each in batch.events
            if each.component == prototype.name
        ]
        inner += (
            _mapping(each, task, at)
            for task, events in tasks
            for each in events
            if each.place.component == prototype.name
        )
        inner += (_area(each.name, at) for each in component.exclusive_areas)
        path = known.path(COMPOSITIONS, known.model.composition.name, prototype.name)
        target = _foreign(f"{_INSTANCE}/RteSoftwareComponentInstanceRef", path, PROTOTYPE)
        yield _container(_INSTANCE, prototype.name, (), [target], inner)


def _area(name: str, at: Within) -> Tag:
    mechanism = _text(f"{_AREA}/RteExclusiveAreaImplMechanism", _MECHANISM)
    target = _foreign(f"{_AREA}/RteExclusiveAreaRef", at.path(name), "EXCLUSIVE-AREA")
    return _container(_AREA, short_name(f"{name}_Implementation"), [mechanism], [target])


def _first(mapped: _Mapped, batch: str, at: Within) -> Tag:
    """The mapping of an event that `Rte_Init` runs, which has no task."""
    function = _within(f"{_MAPPING}/RteUsedInitFnc", "Rte", batch, at.known)
    return _event_mapping(mapped, [function], at)


def _mapping(mapped: _Mapped, task: Task, at: Within) -> Tag:
    used = {"RteMappedToTaskRef": task.name, "RteUsedOsAlarmRef": mapped.alarm, "RteUsedOsEventRef": mapped.os_event}
    targets = [_within(f"{_MAPPING}/{name}", "Os", target, at.known) for name, target in used.items() if target]
    is_cyclic = mapped.event.kind == "Timing"
    offset = _number(f"{_MAPPING}/RteActivationOffset", mapped.event.offset or 0, "FLOAT")
    return _event_mapping(mapped, targets, at, [offset] if is_cyclic else ())


def _event_mapping(mapped: _Mapped, targets: Iterable[Tag], at: Within, values: Iterable[Tag] = ()) -> Tag:
    event = mapped.event
    position = _number(f"{_MAPPING}/RtePositionInTask", mapped.place.position)
    references = [_foreign(f"{_MAPPING}/RteEventRef", at.path(event.name), EVENT[event.kind]), *targets]
    return _container(_MAPPING, short_name(f"{event.name}_Mapping"), [position, *values], references)


_ACTIVATION = "Rte/RteOsInteraction/RteUsedOsActivation"


def _os_interaction(tasks: _Tasks, known: Library) -> Iterable[Tag]:
    """Expected offset of each alarm, and the duration of a tick."""
    alarms = {each.alarm: each.event.offset or 0 for _, events in tasks for each in events if each.alarm is not None}
    duration = _number(f"{_ACTIVATION}/RteExpectedTickDuration", known.model.deployment.tick / 1_000_000, "FLOAT")
    used = [
        _container(
            _ACTIVATION,
            short_name(f"{alarm}_Activation"),
            [_number(f"{_ACTIVATION}/RteExpectedActivationOffset", offset, "FLOAT"), duration],
            [_within(f"{_ACTIVATION}/RteActivationOsAlarmRef", "Os", alarm, known)],
        )
        for alarm, offset in alarms.items()
    ]
    if used:
        yield _container("Rte/RteOsInteraction", "OsInteraction", inner=used)


# -- operating system -------------------------------------------------------------------------------------------------


def _operating_system(tasks: _Tasks, known: Library) -> Iterable[Tag]:
    yield _counter(known.model)
    for task, mapped in tasks:
        events = list(dict.fromkeys(each.os_event for each in mapped if each.os_event is not None))
        yield from (_container("Os/OsEvent", name) for name in events)
        yield _task(task, events, known)
    alarms = {each.alarm: (task.name, each.os_event) for task, mapped in tasks for each in mapped}
    yield from (_alarm(alarm, *target, known) for alarm, target in alarms.items() if alarm is not None)


def _counter(model: ClassicIntegration) -> Tag:
    """The counter whose ticks start what is cyclic."""
    return _container(
        "Os/OsCounter",
        _COUNTER,
        [
            _number("Os/OsCounter/OsCounterMaxAllowedValue", 2**32 - 1),
            _number("Os/OsCounter/OsCounterMinCycle", 1),
            _number("Os/OsCounter/OsCounterTicksPerBase", 1),
            _text("Os/OsCounter/OsCounterType", "SOFTWARE"),
            _number("Os/OsCounter/OsSecondsPerTick", model.deployment.tick / 1_000_000, "FLOAT"),
        ],
    )


def _task(task: Task, events: Iterable[str], known: Library) -> Tag:
    facts = [("Reason", task.reason), ("Period", task.period), ("Offset", task.offset), ("StackSize", task.stack_size)]
    return _container(
        "Os/OsTask",
        task.name,
        [
            _number("Os/OsTask/OsTaskActivation", 1),
            _number("Os/OsTask/OsTaskPriority", task.priority),
            _text("Os/OsTask/OsTaskSchedule", "FULL" if task.preemptable else "NON"),
        ],
        [_within("Os/OsTask/OsTaskEventRef", "Os", name, known) for name in events],
        about=trace(facts),
    )


def _alarm(name: str, task: str, event: str | None, known: Library) -> Tag:
    choice = "Os/OsAlarm/OsAlarmAction"
    kind = "OsAlarmActivateTask" if event is None else "OsAlarmSetEvent"
    references = [_within(f"{choice}/{kind}/{kind}{'Task' if event else ''}Ref", "Os", task, known)]
    if event is not None:
        references.append(_within(f"{choice}/{kind}/{kind}Ref", "Os", event, known))
    target = _container(f"{choice}/{kind}", kind, (), references)
    action = _container(choice, "Action", inner=[target], kind="ECUC-CHOICE-CONTAINER-DEF")
    counter = _within("Os/OsAlarm/OsAlarmCounterRef", "Os", _COUNTER, known)
    return _container("Os/OsAlarm", name, (), [counter], [action])
