"""Nodes: a lifecycle node for each component, with its calls, modes, diagnostics and safety conditions."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeVar

from sigcat import codes
from sigcat.function.function_json.model import (
    Contract,
    Datatype,
    Error,
    ModeInterface,
    Runnable,
    SafetyReaction,
    milliseconds,
)
from sigcat.integration.names import package_name, topic_name
from sigcat.integration.ros2.limits import Limits
from sigcat.integration.ros2.messages import STAMP, MessageBook, constants, unresolved
from sigcat.integration.ros2.model import (
    Communication,
    ConditionMonitor,
    Diagnostic,
    MessageField,
    ModeTopic,
    RosNode,
    Schedule,
    Transition,
)
from sigcat.integration.ros2.parameters import parameters_of
from sigcat.integration.ros2.quality import MODE
from sigcat.integration.ros2.settings import Ros2Settings
from sigcat.integration.ros2.signal_uses import CYCLIC, EVENT, INIT, SHUTDOWN, Place, run_kind, whole
from sigcat.integration.ros2.topics import PUBLISHER, SUBSCRIPTION
from sigcat.integration.ros2.types import c_definition, field_type

DIAGNOSTICS = "/diagnostics"
"""Where nodes report their statuses, as diagnostic_updater and the aggregator have it."""
_Named = TypeVar("_Named", Error, SafetyReaction)
_MILD = ("warn", "information", "amber", "none")
_PRIORITIES = range(1, 100)
"""Priorities of threads under SCHED_FIFO."""


def status_names(places: Sequence[Place]) -> dict[str, str]:
    """Names of the diagnostic statuses of every error of the set: `core_acc: CoreAcc_AliveError_ErrorSts`."""
    return {
        error.name: f"{place.node}: {error.name}"
        for place in reversed(places)
        for contract in contracts(place)
        for error in contract.errors or ()
    }


def contracts(place: Place) -> Iterable[Contract]:
    """Every contract of a component's calls."""
    return (contract for runnable in place.component.runnables for contract in runnable.contracts or ())


def node_of(
    place: Place, exchanged: Sequence[Communication], statuses: Mapping[str, str], settings: Ros2Settings,
    book: MessageBook, limits: Limits,
) -> RosNode:  # fmt: skip
    """The node of a component."""
    own = tuple(contracts(place))
    errors = _once(error for contract in own for error in contract.errors or ())
    reactions = _once(reaction for contract in own for reaction in contract.safety_reactions or ())
    running = [call for call in place.component.runnables if run_kind(call) in (CYCLIC, EVENT)]
    is_first = place.component == place.function.components[0]
    return RosNode(
        name=place.node,
        namespace=settings.namespace or "/",
        function=place.name,
        component=place.component.name,
        transitions=_transitions(place),
        schedules=tuple(_schedule(call, place, exchanged, limits) for call in running),
        parameters=parameters_of(own, place, book.table, limits),
        modes=tuple(_modes(place, settings, book, limits, is_first=is_first)),
        diagnostics=tuple(_diagnostic(error, place, statuses, limits) for error in errors.values()),
        diagnostics_topic=DIAGNOSTICS,
        conditions=tuple(_condition(each, statuses, book.table, limits) for each in reactions.values()),
    )


def _once(items: Iterable[_Named]) -> dict[str, _Named]:
    """Interfaces by name; several calls may share one."""
    return {item.name: item for item in items}


# -- life cycle and schedules -------------------------------------------------------------------------------------


def _transitions(place: Place) -> tuple[Transition, ...]:
    """Init when the node is configured; step while it is active; terminate when it is cleaned up, shut down or fails."""
    calls = place.component.runnables
    init = tuple(call.name for call in calls if run_kind(call) == INIT)
    steps = tuple(call.name for call in calls if run_kind(call) in (CYCLIC, EVENT))
    end = tuple(call.name for call in calls if run_kind(call) == SHUTDOWN)
    rows = (
        ("configure", "on_configure", "unconfigured", "inactive", init, (), ()),
        ("activate", "on_activate", "inactive", "active", (), steps, ()),
        ("deactivate", "on_deactivate", "active", "inactive", (), (), steps),
        ("cleanup", "on_cleanup", "inactive", "unconfigured", end, (), ()),
        ("shutdown", "on_shutdown", "inactive or active", "finalized", end, (), steps),
        ("error", "on_error", "errorprocessing", "unconfigured", end, (), steps),
    )
    return tuple(
        Transition(name=name, callback=callback, start=start, end=to, runnables=made, starts=starts, stops=stops)
        for name, callback, start, to, made, starts, stops in rows
    )


def _schedule(call: Runnable, place: Place, exchanged: Sequence[Communication], limits: Limits) -> Schedule:
    is_timed = run_kind(call) == CYCLIC
    topics = () if is_timed else _triggers(call, place, exchanged)
    if (is_timed and not call.cycle_time) or (not is_timed and not topics):
        lacking = "a cycle time" if is_timed else "a signal that it consumes"
        limits.report(
            codes.CALL_WITHOUT_TRIGGER,
            call.name,
            f"{call.name} has no trigger: {lacking} is missing.",
            "Add it, or the run type.",
        )
    own_group = call.scheduling.lower().replace("-", "").replace("_", "") == "preemptive"
    group = package_name(call.name if own_group else f"{place.node}_calls").text
    return Schedule(
        runnable=call.name,
        trigger="Timer" if is_timed else "Topics",
        period=call.cycle_time if is_timed else None,
        offset=whole(milliseconds(call.execution_offset)),
        debounce=whole(milliseconds(call.debounce_delay)),
        topics=topics,
        after=_after(call, place, limits),
        callback_group=group,
        callback_group_type="Reentrant" if call.parallel_processing else "MutuallyExclusive",
        thread_priority=_priority(call, limits),
        modes=_active_modes(call, place),
        **_supervision(call),
    )


def _triggers(call: Runnable, place: Place, exchanged: Sequence[Communication]) -> tuple[str, ...]:
    return tuple(
        topic.name
        for communication in exchanged
        if communication.runnable == call.name
        for topic in communication.topics
        if topic.role == SUBSCRIPTION and topic.node == place.node
    )


def _after(call: Runnable, place: Place, limits: Limits) -> str | None:
    """The call of this node that a call follows. The life cycle already puts init before every step."""
    before = call.previous_runnable
    own = {other.name: other for other in place.component.runnables}
    if not before or (before in own and run_kind(own[before]) == INIT):
        return None
    if before not in own:
        message = f"{call.name} runs after {before}, which is in no call of node {place.node}: nodes have no order."
        limits.report(
            codes.ORDER_BETWEEN_NODES, call.name, message, "Let a signal of the one trigger the other, or use offsets."
        )
        return None
    return before


def _priority(call: Runnable, limits: Limits) -> int | None:
    text = call.priority.strip()
    if text.isascii() and text.isdecimal() and len(text) < 4 and int(text) in _PRIORITIES:
        return int(text)
    if text:
        message = f"{call.name}: {_short(text)!r} is no priority of a thread, which goes from 1 to 99."
        limits.report(codes.PRIORITY_NOT_A_NUMBER, call.name, message, "Give a number; a higher one runs first.")
    return None


def _short(text: str) -> str:
    return text if len(text) <= 60 else text[:57] + "..."


def _active_modes(call: Runnable, place: Place) -> tuple[str, ...] | None:
    if place.function.modes is None:
        return None
    return tuple(mode.name for mode in place.function.modes if call.name in mode.runnables)


def _supervision(call: Runnable) -> dict[str, Any]:
    alive = call.watchdog.alive if call.watchdog else None
    deadline = call.watchdog.deadline if call.watchdog else None
    made: dict[str, Any] = {}
    if alive:
        made |= {"alive_min": alive.min, "alive_max": alive.max, "alive_reference": alive.reference}
        made["alive_error"] = alive.error_name
    if deadline:
        made |= {"deadline_min": deadline.min, "deadline_max": deadline.max, "deadline_error": deadline.error_name}
    if call.watchdog and call.watchdog.logical:
        made |= {"logical": call.watchdog.logical, "logical_error": call.watchdog.logical_error}
    return made


def report_calls(place: Place, limits: Limits) -> None:
    """Note what no call of a node can have."""
    for call in place.component.runnables:
        _unexpressed(call, limits)


def _unexpressed(call: Runnable, limits: Limits) -> None:
    if call.stack_size:
        message = f"{call.name}: ROS 2 sets no stack size; {_short(call.stack_size)} bytes are not carried."
        limits.report(codes.STACK_SIZE_NOT_CARRIED, call.name, message, "Set it for the process, with ulimit -s.")
    if call.watchdog and call.watchdog.logical:
        message = f"{call.name}: the logical supervision is in words, which no node can check."
        limits.report(codes.LOGICAL_SUPERVISION_IN_WORDS, call.name, message, "Supervise it by hand in the adapter.")


# -- modes --------------------------------------------------------------------------------------------------------


def _modes(
    place: Place, settings: Ros2Settings, book: MessageBook, limits: Limits, *, is_first: bool
) -> Iterable[ModeTopic]:
    """A topic for each mode interface of the function. Every node is told the mode; the first one tells it."""
    for interface in place.function.mode_interfaces or ():
        is_told = interface.direction.lower() == "in"
        if not is_told and not is_first:
            continue
        kind = field_type(interface.datatype, None, book.table)
        if kind is None or kind.element is None:
            unresolved(limits, interface.name, interface.datatype)
            continue
        way = f"mode_{interface.direction}"
        yield ModeTopic(
            interface=interface.name,
            topic=settings.namespace + topic_name(place.name, way),
            role=SUBSCRIPTION if is_told else PUBLISHER,
            message=f"{book.package}/msg/{_mode_message(interface, place, book, limits)}",
            field="mode",
            quality=MODE,
            vss_path=interface.vss_path,
        )


def _mode_message(interface: ModeInterface, place: Place, book: MessageBook, limits: Limits) -> str:
    if interface.name in book.modes:
        return book.modes[interface.name]
    kind = field_type(interface.datatype, None, book.table)
    assert kind is not None
    field = MessageField(
        name="mode",
        datatype=book.written(kind, interface.name) or "uint8",
        description=interface.description,
        vss_path=interface.vss_path,
    )
    values = constants(kind.symbols, kind, "", interface.name, limits)
    name = book.add(
        f"{place.name}_Mode_{interface.direction}", interface.name, interface.description, (STAMP, field), values
    )
    book.modes[interface.name] = name
    return name


# -- errors and safety conditions ---------------------------------------------------------------------------------


def _diagnostic(error: Error, place: Place, statuses: Mapping[str, str], limits: Limits) -> Diagnostic:
    if error.ignition_count_limit:
        message = (
            f"{error.name}: ROS 2 counts no ignition cycles; the limit of {error.ignition_count_limit} is not carried."
        )
        limits.report(
            codes.IGNITION_CYCLES_NOT_COUNTED, error.name, message, "Keep the count in a fault memory beside ROS 2."
        )
    if error.reset_condition:
        message = f"{error.name}: the reset condition is in words, which no node can check."
        limits.report(
            codes.RESET_CONDITION_IN_WORDS, error.name, message, "Report the error as passed when the condition holds."
        )
    return Diagnostic(
        name=f"{place.node}: {error.name}",
        error=error.name,
        message=error.description,
        level="WARN" if any(word in error.severity.lower() for word in _MILD) else "ERROR",
        severity=error.severity,
        maturation_time=error.maturation_time,
        occurrence_count_limit=error.occurrence_count_limit,
        reset_time=error.reset_time,
        reset_condition=error.reset_condition,
        dependencies=_statuses(error.name, error.dependencies, statuses, limits),
        vss_path=error.vss_path,
    )


def _condition(
    reaction: SafetyReaction, statuses: Mapping[str, str], table: Mapping[str, Datatype], limits: Limits
) -> ConditionMonitor:
    return ConditionMonitor(
        condition=reaction.name,
        description=reaction.description,
        topic=DIAGNOSTICS,
        statuses=_statuses(reaction.name, reaction.errors, statuses, limits),
        variable_type=c_definition(reaction.datatype, table),
        vss_path=reaction.vss_path,
    )


def _statuses(name: str, errors: Iterable[str], statuses: Mapping[str, str], limits: Limits) -> tuple[str, ...]:
    """Names of the statuses of errors; of an error from outside of the set, its own name."""
    made = []
    for error in errors:
        if error not in statuses:
            message = f"{name} depends on {_short(error)}, which no function of the set reports."
            limits.report(
                codes.ERROR_FROM_OUTSIDE, name, message, f"Whoever reports it names its status {_short(error)}."
            )
        made.append(statuses.get(error, error))
    return tuple(made)
