"""The configuration of the ECU as far as a set of components decides it: tasks, and the events that they serve.

The parameters are those of AUTOSAR_SWS_RTE and AUTOSAR_SWS_OS; their definitions are the vendor's.
"""

from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from sigcat.adapter.arxml.tree import Package, Tag, conditional, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.behavior import EVENT, Within
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.paths import COMPOSITIONS, CONFIGURATIONS, DEFINITIONS, PROTOTYPE, SYSTEMS
from sigcat.adapter.autosar_classic.arxml.system import system_name
from sigcat.integration.autosar_classic.model import ClassicIntegration, Event, Prototype, Task, TaskEvent
from sigcat.integration.autosar_names import distinct, short_name

MODULE = "ECUC-MODULE-CONFIGURATION-VALUES"
_CONTAINER = "ECUC-CONTAINER-VALUE"
_ACTION = "Os/OsAlarm/OsAlarmAction"
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
        _definition(name, "ECUC-MODULE-DEF"),
        {"IMPLEMENTATION-CONFIG-VARIANT": "VARIANT-PRE-COMPILE"},
        listed("CONTAINERS", containers),
        name=name,
    )


# -- values of parameters ---------------------------------------------------------------------------------------------


_FLOATS = ("RteActivationOffset", "RteExpectedActivationOffset", "RteExpectedTickDuration", "OsSecondsPerTick")
"""Parameters that may have a fraction."""


class _Target(NamedTuple):
    """A reference to an element, by the name of its definition."""

    name: str
    path: str
    kind: str = _CONTAINER


def _container(
    definition: str,
    name: str,
    parameters: Mapping[str, str | float] = MappingProxyType({}),
    targets: Iterable[_Target] = (),
    inner: Iterable[Tag] = (),
    about: Tag | None = None,
) -> Tag:
    """A container with its parameters, by the names of their definitions."""
    kind = "CHOICE-CONTAINER" if definition == _ACTION else "PARAM-CONF-CONTAINER"
    return tag(
        _CONTAINER,
        about,
        _definition(definition, f"ECUC-{kind}-DEF"),
        listed("PARAMETER-VALUES", (_parameter(definition, key, value) for key, value in parameters.items())),
        listed("REFERENCE-VALUES", (_reference(definition, each) for each in targets)),
        listed("SUB-CONTAINERS", inner),
        name=name,
    )


def _definition(path: str, kind: str) -> Tag:
    return reference("DEFINITION-REF", f"{DEFINITIONS}/{path}", kind)


def _parameter(container: str, name: str, value: str | float) -> Tag:
    kind = "ENUMERATION" if isinstance(value, str) else "FLOAT" if name in _FLOATS else "INTEGER"
    word = "TEXTUAL" if isinstance(value, str) else "NUMERICAL"
    definition = _definition(f"{container}/{name}", f"ECUC-{kind}-PARAM-DEF")
    return tag(f"ECUC-{word}-PARAM-VALUE", definition, {"VALUE": value})


def _reference(container: str, target: _Target) -> Tag:
    """Reference to a container of the configuration, or to an element outside: an event, a component."""
    kind = "ECUC-REFERENCE-DEF" if target.kind == _CONTAINER else "ECUC-FOREIGN-REFERENCE-DEF"
    value = reference("VALUE-REF", target.path, target.kind)
    return tag("ECUC-REFERENCE-VALUE", _definition(f"{container}/{target.name}", kind), value)


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
            _event_mapping(_Mapped(each, _event_of(each, known)), {"RteUsedInitFnc": batch.name}, "Rte", at)
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
        target = _Target("RteSoftwareComponentInstanceRef", path, PROTOTYPE)
        yield _container(_INSTANCE, prototype.name, targets=[target], inner=inner)


def _area(name: str, at: Within) -> Tag:
    target = _Target("RteExclusiveAreaRef", at.path(name), "EXCLUSIVE-AREA")
    mechanism = {"RteExclusiveAreaImplMechanism": _MECHANISM}
    return _container(_AREA, short_name(f"{name}_Implementation"), mechanism, [target])


def _mapping(mapped: _Mapped, task: Task, at: Within) -> Tag:
    used = {"RteMappedToTaskRef": task.name, "RteUsedOsAlarmRef": mapped.alarm, "RteUsedOsEventRef": mapped.os_event}
    return _event_mapping(mapped, used, "Os", at)


def _event_mapping(mapped: _Mapped, used: Mapping[str, str | None], module: str, at: Within) -> Tag:
    """The mapping of an event, with the containers of a module that it uses. `Rte_Init` runs some without a task."""
    event = mapped.event
    targets = [_Target("RteEventRef", at.path(event.name), EVENT[event.kind])]
    targets += (_Target(key, at.known.path(CONFIGURATIONS, module, name)) for key, name in used.items() if name)
    position: dict[str, str | float] = {"RtePositionInTask": mapped.place.position}
    offset = {"RteActivationOffset": event.offset or 0} if event.kind == "Timing" and module == "Os" else {}
    return _container(_MAPPING, short_name(f"{event.name}_Mapping"), {**position, **offset}, targets)


def _os_interaction(tasks: _Tasks, known: Library) -> Iterable[Tag]:
    """Expected offset of each alarm, and the duration of a tick."""
    alarms = {each.alarm: each.event.offset or 0 for _, events in tasks for each in events if each.alarm is not None}
    duration = known.model.deployment.tick / 1_000_000
    used = [
        _container(
            "Rte/RteOsInteraction/RteUsedOsActivation",
            short_name(f"{alarm}_Activation"),
            {"RteExpectedActivationOffset": offset, "RteExpectedTickDuration": duration},
            [_Target("RteActivationOsAlarmRef", known.path(CONFIGURATIONS, "Os", alarm))],
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
    parameters: dict[str, str | float] = {
        "OsCounterMaxAllowedValue": 2**32 - 1,
        "OsCounterMinCycle": 1,
        "OsCounterTicksPerBase": 1,
        "OsCounterType": "SOFTWARE",
        "OsSecondsPerTick": model.deployment.tick / 1_000_000,
    }
    return _container("Os/OsCounter", _COUNTER, parameters)


def _task(task: Task, events: Iterable[str], known: Library) -> Tag:
    facts = [("Reason", task.reason), ("Period", task.period), ("Offset", task.offset), ("StackSize", task.stack_size)]
    numbers: dict[str, str | float] = {"OsTaskActivation": 1, "OsTaskPriority": task.priority}
    parameters = {**numbers, "OsTaskSchedule": "FULL" if task.preemptable else "NON"}
    targets = (_Target("OsTaskEventRef", known.path(CONFIGURATIONS, "Os", name)) for name in events)
    return _container("Os/OsTask", task.name, parameters, targets, about=trace(facts))


def _alarm(name: str, task: str, event: str | None, known: Library) -> Tag:
    kind = "OsAlarmActivateTask" if event is None else "OsAlarmSetEvent"
    used = {f"{kind}TaskRef": task, f"{kind}Ref": event} if event else {f"{kind}Ref": task}
    targets = (_Target(key, known.path(CONFIGURATIONS, "Os", each)) for key, each in used.items())
    action = _container(_ACTION, "Action", inner=[_container(f"{_ACTION}/{kind}", kind, targets=targets)])
    counter = _Target("OsAlarmCounterRef", known.path(CONFIGURATIONS, "Os", _COUNTER))
    return _container("Os/OsAlarm", name, targets=[counter], inner=[action])
