"""The configuration of the ECU as far as a set of components decides it: tasks, and the events that they serve.

The parameters are those of AUTOSAR_SWS_RTE and AUTOSAR_SWS_OS; their definitions are the vendor's.
"""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.adapter.arxml.tree import Package, Tag, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.behavior import EVENT, Within
from sigcat.adapter.autosar_classic.arxml.composition import prototype_path
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.paths import CONFIGURATIONS, DEFINITIONS, PROTOTYPE, SYSTEMS
from sigcat.adapter.autosar_classic.arxml.releases import Release
from sigcat.adapter.autosar_classic.arxml.system import system_name
from sigcat.integration.autosar_classic.model import ClassicIntegration, Component, Event, Task, TaskEvent
from sigcat.integration.autosar_names import distinct, short_name

MODULE = "ECUC-MODULE-CONFIGURATION-VALUES"
_CONTAINER, _CONTAINER_DEF = "ECUC-CONTAINER-VALUE", "ECUC-PARAM-CONF-CONTAINER-DEF"
_COUNTER = "AdapterCounter"


class _Activation(NamedTuple):
    """The source that activates a task, or sets one of its events."""

    alarm: str | None
    """Alarm of the operating system, for what is cyclic."""
    event: str | None
    """Event of the operating system, for a task that waits for several."""


def package(model: ClassicIntegration, known: Library, release: Release) -> Package:
    """The package of the configuration: modules RTE and operating system, and their collection."""
    activations = _activations(model)
    members = (
        tag(f"{MODULE}-REF-CONDITIONAL", reference(f"{MODULE}-REF", known.paths.of(CONFIGURATIONS, name), MODULE))
        for name in ("Rte", "Os")
    )
    collection = tag(
        "ECUC-VALUE-COLLECTION",
        reference("ECU-EXTRACT-REF", known.paths.of(SYSTEMS, system_name(model)), "SYSTEM"),
        listed("ECUC-VALUES", members),
        name=short_name(f"{model.ecu.name}_Configuration"),
    )
    rte = [_instance(each.name, each.type, model, activations, known, release) for each in model.composition.prototypes]
    content = (
        _module(
            "Rte",
            [
                *(
                    _container(_BATCH, each.name, about=trace([("Reason", each.reason)]))
                    for each in model.ecu.init_batches
                ),
                *(each for each in rte if each is not None),
                *_os_interaction(model, activations, known),
            ],
        ),
        _module("Os", _operating_system(model, activations, known)),
        collection,
    )
    return Package(CONFIGURATIONS, content)


def _module(name: str, containers: Iterable[Tag]) -> Tag:
    return tag(
        MODULE,
        reference("DEFINITION-REF", f"{DEFINITIONS}/{name}", "ECUC-MODULE-DEF"),
        tag("IMPLEMENTATION-CONFIG-VARIANT", text="VARIANT-PRE-COMPILE"),
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
    return tag("ECUC-NUMERICAL-PARAM-VALUE", target, tag("VALUE", text=value))


def _text(definition: str, value: str) -> Tag:
    target = reference("DEFINITION-REF", f"{DEFINITIONS}/{definition}", "ECUC-ENUMERATION-PARAM-DEF")
    return tag("ECUC-TEXTUAL-PARAM-VALUE", target, tag("VALUE", text=value))


def _to(definition: str, path: str, kind: str, definition_kind: str = "ECUC-REFERENCE-DEF") -> Tag:
    target = reference("DEFINITION-REF", f"{DEFINITIONS}/{definition}", definition_kind)
    return tag("ECUC-REFERENCE-VALUE", target, reference("VALUE-REF", path, kind))


def _foreign(definition: str, path: str, kind: str) -> Tag:
    """Reference to an element outside the configuration: an event, a component."""
    return _to(definition, path, kind, "ECUC-FOREIGN-REFERENCE-DEF")


# -- what activates tasks ---------------------------------------------------------------------------------------------


def _event_of(mapped: TaskEvent, model: ClassicIntegration) -> tuple[Component, Event]:
    types = {each.name: each.type for each in model.composition.prototypes}
    component = next(each for each in model.components if each.name == types[mapped.component])
    return component, next(each for each in component.events if each.name == mapped.event)


def _activations(model: ClassicIntegration) -> dict[tuple[str, str], _Activation]:
    """The activation of each event, by component and name. A task that only one alarm activates has no events."""
    found: dict[tuple[str, str], _Activation] = {}
    for task in model.ecu.tasks:
        sources = {(each.component, each.event): _source(task, each, model) for each in task.events}
        names = distinct({source: short_name(source) for source, _ in sources.values()})
        is_basic = len(names) == 1 and all(cyclic for _, cyclic in sources.values())
        for key, (source, cyclic) in sources.items():
            alarm = short_name(f"Alarm_{names[source]}") if cyclic else None
            found[key] = _Activation(alarm, None if is_basic else short_name(f"Event_{names[source]}"))
    return found


def _source(task: Task, mapped: TaskEvent, model: ClassicIntegration) -> tuple[str, bool]:
    """Name of the activation, and whether it is cyclic. Events of one period and offset have one alarm."""
    _, event = _event_of(mapped, model)
    if event.kind != "Timing":
        return f"{mapped.component}_{event.name}", False
    return f"{task.name}_{_microseconds(event.offset)}_{_microseconds(event.period)}", True


def _microseconds(seconds: float | None) -> int:
    return round((seconds or 0) * 1_000_000)


# -- RTE --------------------------------------------------------------------------------------------------------------

_INSTANCE = "Rte/RteSwComponentInstance"
_MAPPING = f"{_INSTANCE}/RteEventToTaskMapping"
_AREA = f"{_INSTANCE}/RteExclusiveAreaImplementation"
_BATCH = "Rte/RteInitializationRunnableBatch"
_MECHANISM = "OS_RESOURCE"
"""Writes within an area may start runnables; an OS activates no task while interrupts are blocked."""


def _instance(
    prototype: str,
    type_name: str,
    model: ClassicIntegration,
    activations: dict[tuple[str, str], _Activation],
    known: Library,
    release: Release,
) -> Tag | None:
    component = next((each for each in model.components if each.name == type_name), None)
    if component is None:
        return None
    at = Within(component, known, release)
    first = [
        _first(each, batch.name, model, at)
        for batch in model.ecu.init_batches
        for each in batch.events
        if each.component == prototype
    ]
    mappings = [
        _mapping(each, task, model, activations[each.component, each.event], at)
        for task in model.ecu.tasks
        for each in task.events
        if each.component == prototype
    ]
    areas = [
        _container(
            _AREA,
            short_name(f"{each.name}_Implementation"),
            [_text(f"{_AREA}/RteExclusiveAreaImplMechanism", _MECHANISM)],
            [_foreign(f"{_AREA}/RteExclusiveAreaRef", at.path(each.name), "EXCLUSIVE-AREA")],
        )
        for each in component.exclusive_areas
    ]
    target = _foreign(
        f"{_INSTANCE}/RteSoftwareComponentInstanceRef", prototype_path(prototype, model.composition, known), PROTOTYPE
    )
    return _container(_INSTANCE, prototype, (), [target], [*first, *mappings, *areas])


def _first(mapped: TaskEvent, batch: str, model: ClassicIntegration, at: Within) -> Tag:
    """The mapping of an event that `Rte_Init` runs, which has no task."""
    _, event = _event_of(mapped, model)
    references = [
        _foreign(f"{_MAPPING}/RteEventRef", at.path(event.name), EVENT[event.kind]),
        _to(f"{_MAPPING}/RteUsedInitFnc", at.known.paths.of(CONFIGURATIONS, "Rte", batch), _CONTAINER),
    ]
    values = [_number(f"{_MAPPING}/RtePositionInTask", mapped.position)]
    return _container(_MAPPING, short_name(f"{event.name}_Mapping"), values, references)


def _mapping(mapped: TaskEvent, task: Task, model: ClassicIntegration, activation: _Activation, at: Within) -> Tag:
    _, event = _event_of(mapped, model)
    references = [
        _foreign(f"{_MAPPING}/RteEventRef", at.path(event.name), EVENT[event.kind]),
        _to(f"{_MAPPING}/RteMappedToTaskRef", at.known.paths.of(CONFIGURATIONS, "Os", task.name), _CONTAINER),
    ]
    for name, target in (("RteUsedOsAlarmRef", activation.alarm), ("RteUsedOsEventRef", activation.event)):
        if target is not None:
            references.append(_to(f"{_MAPPING}/{name}", at.known.paths.of(CONFIGURATIONS, "Os", target), _CONTAINER))
    values = [_number(f"{_MAPPING}/RtePositionInTask", mapped.position)]
    if event.kind == "Timing":
        values.append(_number(f"{_MAPPING}/RteActivationOffset", event.offset or 0, "FLOAT"))
    return _container(_MAPPING, short_name(f"{event.name}_Mapping"), values, references)


_ACTIVATION = "Rte/RteOsInteraction/RteUsedOsActivation"


def _os_interaction(
    model: ClassicIntegration, activations: dict[tuple[str, str], _Activation], known: Library
) -> Iterable[Tag]:
    """Expected offset of each alarm, and the duration of a tick."""
    alarms = {
        activations[each.component, each.event].alarm: _event_of(each, model)[1].offset or 0
        for task in model.ecu.tasks
        for each in task.events
    }
    used = [
        _container(
            _ACTIVATION,
            short_name(f"{alarm}_Activation"),
            [
                _number(f"{_ACTIVATION}/RteExpectedActivationOffset", offset, "FLOAT"),
                _number(f"{_ACTIVATION}/RteExpectedTickDuration", model.deployment.tick / 1_000_000, "FLOAT"),
            ],
            [_to(f"{_ACTIVATION}/RteActivationOsAlarmRef", known.paths.of(CONFIGURATIONS, "Os", alarm), _CONTAINER)],
        )
        for alarm, offset in alarms.items()
        if alarm is not None
    ]
    if used:
        yield _container("Rte/RteOsInteraction", "OsInteraction", inner=used)


# -- operating system -------------------------------------------------------------------------------------------------


def _operating_system(
    model: ClassicIntegration, activations: dict[tuple[str, str], _Activation], known: Library
) -> Iterable[Tag]:
    root = known.paths.of(CONFIGURATIONS, "Os")
    yield _counter(model)
    alarms: dict[str, tuple[str, str | None]] = {}
    for task in model.ecu.tasks:
        used = [activations[each.component, each.event] for each in task.events]
        events = list(dict.fromkeys(each.event for each in used if each.event is not None))
        alarms |= {each.alarm: (task.name, each.event) for each in used if each.alarm is not None}
        yield from (_container("Os/OsEvent", name) for name in events)
        yield _task(task, [f"{root}/{name}" for name in events])
    for alarm, (task_name, event) in alarms.items():
        yield _alarm(alarm, task_name, event, root)


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


def _task(task: Task, events: Iterable[str]) -> Tag:
    facts = [("Reason", task.reason), ("Period", task.period), ("Offset", task.offset), ("StackSize", task.stack_size)]
    return _container(
        "Os/OsTask",
        task.name,
        [
            _number("Os/OsTask/OsTaskActivation", 1),
            _number("Os/OsTask/OsTaskPriority", task.priority),
            _text("Os/OsTask/OsTaskSchedule", "FULL" if task.preemptable else "NON"),
        ],
        [_to("Os/OsTask/OsTaskEventRef", path, _CONTAINER) for path in events],
        about=trace(facts),
    )


def _alarm(name: str, task: str, event: str | None, root: str) -> Tag:
    choice = "Os/OsAlarm/OsAlarmAction"
    kind = "OsAlarmActivateTask" if event is None else "OsAlarmSetEvent"
    references = [_to(f"{choice}/{kind}/{kind}{'Task' if event else ''}Ref", f"{root}/{task}", _CONTAINER)]
    if event is not None:
        references.append(_to(f"{choice}/{kind}/{kind}Ref", f"{root}/{event}", _CONTAINER))
    action = _container(
        choice,
        "Action",
        inner=[_container(f"{choice}/{kind}", kind, (), references)],
        kind="ECUC-CHOICE-CONTAINER-DEF",
    )
    counter = _to("Os/OsAlarm/OsAlarmCounterRef", f"{root}/{_COUNTER}", _CONTAINER)
    return _container("Os/OsAlarm", name, (), [counter], [action])
