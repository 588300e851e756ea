"""Nodes: a lifecycle node for each component, with its calls, modes, diagnostics and safety conditions."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple, TypeVar

from sigcat import codes
from sigcat.function.checks.order import previous_calls
from sigcat.function.function_json.datatype import Datatype
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.runnable import Contract, Runnable
from sigcat.function.function_json.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.triggers import triggers
from sigcat.integration.application import Part
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.ros2.messages import STAMP, MessageBook, constants, unresolved
from sigcat.integration.ros2.model import (
    Communication,
    ConditionMonitor,
    Diagnostic,
    MessageField,
    ModeTopic,
    RosNode,
    RosTopic,
    Schedule,
    Transition,
)
from sigcat.integration.ros2.names import package_name, topic_name
from sigcat.integration.ros2.parameters import parameters_of
from sigcat.integration.ros2.quality import MODE
from sigcat.integration.ros2.settings import Ros2Settings
from sigcat.integration.ros2.signal_uses import CYCLIC, EVENT, INIT, SHUTDOWN, run_kind, whole
from sigcat.integration.ros2.topics import PUBLISHER, SUBSCRIPTION
from sigcat.integration.ros2.types import c_definition, field_type

DIAGNOSTICS = "/diagnostics"
"""Where nodes report their statuses, as diagnostic_updater and the aggregator have it."""
_Named = TypeVar("_Named", ErrorInterface, SafetyReaction)
_MILD = ("warn", "information", "amber", "none")
_PRIORITIES = range(1, 100)
"""Priorities of threads under SCHED_FIFO."""


def status_names(parts: Sequence[Part]) -> dict[str, str]:
    """Names of the diagnostic statuses of every error of the set: `core_acc: CoreAcc_AliveError_ErrorSts`."""
    return {
        error.name: f"{part.name}: {error.name}"
        for part in reversed(parts)
        for contract in contracts(part)
        for error in contract.errors or ()
    }


def contracts(part: Part) -> Iterable[Contract]:
    """Every contract of a component's calls."""
    return (contract for runnable in part.component.runnables for contract in runnable.contracts or ())


class Managers(NamedTuple):
    """Who of the platform provides what no function does."""

    safety: str | None = None
    mode: str | None = None


def node_of(
    part: Part, managers: Managers, exchanged: Sequence[Communication], statuses: Mapping[str, str], settings: Ros2Settings,
    book: MessageBook, findings: FindingCollector,
) -> RosNode:  # fmt: skip
    """The node of a component."""
    own = tuple(contracts(part))
    errors = _once(error for contract in own for error in contract.errors or ())
    reactions = _once(reaction for contract in own for reaction in contract.safety_reactions or ())
    running = [call for call in part.component.runnables if run_kind(call) in (CYCLIC, EVENT)]
    is_first = part.is_first
    return RosNode(
        name=part.name,
        namespace=settings.namespace or "/",
        function=part.function_name,
        component=part.component.name,
        transitions=_transitions(part),
        schedules=tuple(_schedule(call, part, exchanged, findings) for call in running),
        parameters=parameters_of(own, part, book.table, findings),
        modes=tuple(_modes(part, managers, book, findings, is_first=is_first)),
        diagnostics=tuple(_diagnostic(error, part, statuses, findings) for error in errors.values()),
        diagnostics_topic=DIAGNOSTICS,
        conditions=tuple(_condition(each, managers, statuses, book.table, findings) for each in reactions.values()),
    )


def _once(items: Iterable[_Named]) -> dict[str, _Named]:
    """Interfaces by name; several calls may share one."""
    return {item.name: item for item in items}


# -- life cycle and schedules -------------------------------------------------------------------------------------


def _transitions(part: Part) -> tuple[Transition, ...]:
    """Init when the node is configured; step while it is active; terminate when it is cleaned up, shut down or fails."""
    calls = part.component.runnables
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


def _schedule(call: Runnable, part: Part, exchanged: Sequence[Communication], findings: FindingCollector) -> Schedule:
    is_timed = run_kind(call) == CYCLIC
    topics = () if is_timed else _triggers(call, part, exchanged)
    if (is_timed and not call.cycle_time) or (not is_timed and not topics):
        lacking = "a cycle time" if is_timed else "a signal that it consumes"
        findings.report(
            codes.CALL_WITHOUT_TRIGGER,
            f"{call.name} must have {lacking} to run on.",
            Subject(call.name, call),
            "Add it, or correct the run type.",
            key="Runtype",
        )
    own_group = call.scheduling.lower().replace("-", "").replace("_", "") == "preemptive"
    group = package_name(call.name if own_group else f"{part.name}_calls").text
    return Schedule(
        runnable=call.name,
        trigger="Timer" if is_timed else "Topics",
        period=call.cycle_time if is_timed else None,
        offset=whole(milliseconds(call.execution_offset)),
        debounce=whole(milliseconds(call.debounce_delay)),
        topics=topics,
        after=_after(call, part, findings),
        callback_group=group,
        callback_group_type="Reentrant" if call.parallel_processing else "MutuallyExclusive",
        thread_priority=_priority(call, findings),
        modes=_active_modes(call, part),
        **_supervision(call),
    )


def _triggers(call: Runnable, part: Part, exchanged: Sequence[Communication]) -> tuple[str, ...]:
    """Topics that bring a signal on which the call runs."""
    names = {item.name for item in triggers(call)}
    return tuple(
        topic.name
        for communication in exchanged
        if communication.runnable == call.name
        for topic in communication.topics
        if topic.role == SUBSCRIPTION and topic.node == part.name and names.intersection(_signals(topic))
    )


def _signals(topic: RosTopic) -> Iterable[str]:
    return (mapping.signal for data_map in topic.data_maps for mapping in data_map.mappings or ())


def _after(call: Runnable, part: Part, findings: FindingCollector) -> str | None:
    """The calls of this node that a call follows. The life cycle already puts init before every step."""
    own = {other.name: other for other in part.component.runnables}
    before = previous_calls(call)
    for name in before:
        if name not in own:
            message = f"{call.name} must run after a call of its own node, not after {name}: nodes have no order."
            fix = "Let a signal of one trigger the other, or use offsets."
            findings.report(codes.ORDER_BETWEEN_NODES, message, Subject(call.name, call), fix, key="PrevRunnable")
    return ", ".join(name for name in before if name in own and run_kind(own[name]) != INIT) or None


def _priority(call: Runnable, findings: FindingCollector) -> int | None:
    text = call.priority.strip()
    if text.isascii() and text.isdecimal() and len(text) < 4 and int(text) in _PRIORITIES:
        return int(text)
    if text:
        message = f"The priority of {call.name} must be from 1 to 99, not {_short(text)!r}."
        fix = "Use a number; higher ones run first."
        findings.report(codes.PRIORITY_NOT_A_NUMBER, message, Subject(call.name, call), fix, key="Priority")
    return None


def _short(text: str) -> str:
    return text if len(text) <= 60 else text[:57] + "..."


def _active_modes(call: Runnable, part: Part) -> tuple[str, ...] | None:
    if part.function.modes is None:
        return None
    return tuple(mode.name for mode in part.function.modes if call.name in mode.runnables)


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


def report_calls(part: Part, findings: FindingCollector) -> None:
    """Note what no call of a node can have."""
    for call in part.component.runnables:
        _unexpressed(call, findings)


def _unexpressed(call: Runnable, findings: FindingCollector) -> None:
    if call.stack_size:
        message = (
            f"{call.name}: ROS 2 has no setting for the stack size of {_short(call.stack_size)} bytes; it is left out."
        )
        fix = "Set it for the process, for instance with `ulimit -s`."
        findings.report(codes.STACK_SIZE_NOT_CARRIED, message, Subject(call.name, call), fix, key="StackSize")
    if call.watchdog and call.watchdog.logical and call.checkpoint is None:
        message = f"{call.name}: the logical supervision is free text, which no node can check."
        fix = "Give the calls a `checkpoint` each, with the calls that may follow."
        findings.report(codes.LOGICAL_SUPERVISION_IN_WORDS, message, Subject(call.name, call), fix, key="Watchdog")


# -- modes --------------------------------------------------------------------------------------------------------


def _modes(
    part: Part,
    managers: Managers,
    book: MessageBook,
    findings: FindingCollector,
    *,
    is_first: bool,
) -> Iterable[ModeTopic]:
    """A topic for each mode interface of the function. Every node receives the mode; the first one sends it."""
    for interface in part.function.mode_interfaces or ():
        is_received = interface.direction.lower() == "in"
        if not is_received and not is_first:
            continue
        kind = field_type(interface.datatype, None, book.table)
        if kind is None or kind.element is None:
            unresolved(findings, Subject(interface.name, interface), interface.datatype)
            continue
        way = f"mode_{interface.direction}"
        yield ModeTopic(
            interface=interface.name,
            topic=topic_name(part.function_name, way),
            role=SUBSCRIPTION if is_received else PUBLISHER,
            message=f"{book.package}/msg/{_mode_message(interface, part, book, findings)}",
            field="mode",
            provider=managers.mode if is_received else None,
            quality=MODE,
            vss_path=interface.vss_path,
        )


def _mode_message(interface: ModeInterface, part: Part, book: MessageBook, findings: FindingCollector) -> str:
    if interface.name in book.modes:
        return book.modes[interface.name]
    kind = field_type(interface.datatype, None, book.table)
    assert kind is not None
    subject = Subject(interface.name, interface)
    field = MessageField(
        name="mode",
        datatype=book.written(kind, subject) or "uint8",
        description=interface.description,
        vss_path=interface.vss_path,
    )
    values = constants(kind, "", subject, findings)
    name = book.add(
        f"{part.function_name}_Mode_{interface.direction}",
        subject,
        interface.description,
        (STAMP, field),
        values,
    )
    book.modes[interface.name] = name
    return name


# -- errors and safety conditions ---------------------------------------------------------------------------------


def _diagnostic(
    error: ErrorInterface, part: Part, statuses: Mapping[str, str], findings: FindingCollector
) -> Diagnostic:
    subject = Subject(error.name, error)
    if error.ignition_count_limit:
        message = (
            f"{error.name}: ROS 2 counts no ignition cycles; the limit of {error.ignition_count_limit} is left out."
        )
        fix = "Count them in a fault memory outside ROS 2."
        findings.report(codes.IGNITION_CYCLES_NOT_COUNTED, message, subject, fix, key="IgnitionCountLimit")
    if error.reset_condition and error.reset is None:
        message = f"{error.name}: the reset condition is free text, which no node can check."
        fix = "Say it with `reset`, unless it is that the error is no longer present."
        findings.report(codes.RESET_CONDITION_IN_WORDS, message, subject, fix, key="ResetCondition")
    return Diagnostic(
        name=f"{part.name}: {error.name}",
        error=error.name,
        message=error.description,
        level="WARN" if any(word in error.severity.lower() for word in _MILD) else "ERROR",
        severity=error.severity,
        maturation_time=error.maturation_time,
        occurrence_count_limit=error.occurrence_count_limit,
        reset_time=error.reset_time,
        reset_condition=error.reset_condition,
        dependencies=_statuses(subject, "Dependancy", error.dependencies, statuses, findings),
        vss_path=error.vss_path,
    )


def _condition(
    reaction: SafetyReaction,
    managers: Managers,
    statuses: Mapping[str, str],
    table: Mapping[str, Datatype],
    findings: FindingCollector,
) -> ConditionMonitor:
    return ConditionMonitor(
        condition=reaction.name,
        description=reaction.description,
        topic=DIAGNOSTICS,
        statuses=_statuses(Subject(reaction.name, reaction), "ErrorList", reaction.errors, statuses, findings),
        provider=managers.safety,
        variable_type=c_definition(reaction.datatype, table),
        vss_path=reaction.vss_path,
    )


def _statuses(
    subject: Subject, key: str, errors: Iterable[str], statuses: Mapping[str, str], findings: FindingCollector
) -> tuple[str, ...]:
    """Names of the statuses of errors; of an error from outside of the set, its own name."""
    made = []
    for error in errors:
        if error not in statuses:
            message = f"{subject} depends on {_short(error)}, which no function in the set reports."
            fix = f"The node that reports it must call its status {_short(error)!r}."
            findings.report(codes.ERROR_FROM_OUTSIDE, message, subject, fix, key=key)
        made.append(statuses.get(error, error))
    return tuple(made)
