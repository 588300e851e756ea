"""Nodes: a lifecycle node for each component, with its calls, modes, diagnostics and safety conditions."""

from collections.abc import Iterable, Sequence
from typing import Any

from sigcat import codes
from sigcat.function.checks.schedule.order import previous_calls
from sigcat.function.exchange import Part
from sigcat.function.function_json.duration import milliseconds, whole
from sigcat.function.function_json.interfaces.status_interfaces import ModeInterface
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.triggers import absent_in, triggers
from sigcat.integration.finding_collector import FindingCollector, subject_of
from sigcat.integration.ros2 import model
from sigcat.integration.ros2.context import Context
from sigcat.integration.ros2.messages.common_types import STAMP
from sigcat.integration.ros2.messages.field_types import FieldType, field_type
from sigcat.integration.ros2.messages.made_messages import constants, unresolved
from sigcat.integration.ros2.names import shortened, topic_name
from sigcat.integration.ros2.parameters import parameters_of
from sigcat.integration.ros2.quality_of_service import MODE
from sigcat.integration.ros2.settings import SchedulingPolicy
from sigcat.integration.ros2.signal_uses import CYCLIC, EVENT, INIT, SHUTDOWN, run_kind
from sigcat.integration.ros2.statuses import (
    DIAGNOSTICS,
    Statuses,
    conditions,
    diagnostics,
    error_topics,
    reaction_topics,
)
from sigcat.integration.ros2.topics import PUBLISHER, SUBSCRIPTION
from sigcat.names import camel_case

_PRIORITIES = range(1, 100)
"""Priorities of threads under SCHED_FIFO."""


def node_of(
    part: Part, exchanged: Sequence[model.Communication], statuses: Statuses, context: Context
) -> model.RosNode:
    """The node of a component."""
    running = [call for call in part.component.runnables if run_kind(call) in (CYCLIC, EVENT)]
    schedules = tuple(_schedule(call, part, exchanged, context.findings) for call in running)
    return model.RosNode(
        name=part.name,
        namespace=context.settings.namespace or "/",
        function=part.function_name,
        component=part.component.name,
        executable=f"{part.name}_node",
        plugin=f"{context.package}::{camel_case(part.name)}Node",
        transitions=_transitions(part),
        schedules=schedules,
        parameters=parameters_of(part, context),
        modes=tuple(_modes(part, context)),
        error_topics=tuple(error_topics(part, statuses, context)),
        reaction_topics=tuple(reaction_topics(part, statuses, context)),
        diagnostics=tuple(diagnostics(part, statuses, context.findings)),
        diagnostics_topic=DIAGNOSTICS,
        conditions=tuple(conditions(part, statuses, context)),
        scheduling_policy=_policy(part.name, running, schedules, context),
    )


# -- life cycle and schedules -------------------------------------------------------------------------------------


def _transitions(part: Part) -> tuple[model.Transition, ...]:
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
        model.Transition(name=name, callback=callback, start=start, end=to, runnables=made, starts=starts, stops=stops)
        for name, callback, start, to, made, starts, stops in rows
    )


def _schedule(
    call: Runnable, part: Part, exchanged: Sequence[model.Communication], findings: FindingCollector
) -> model.Schedule:
    is_timed = run_kind(call) == CYCLIC
    topics = () if is_timed else _triggers(call, part, exchanged)
    if (is_timed and not call.cycle_time) or not (is_timed or topics or absent_in(call)):
        lacking = "a cycle time" if is_timed else "a signal that it consumes"
        message, fix = f"{call.name} must have {lacking} to run on.", "Add it, or correct the run type."
        findings.report(codes.CALL_WITHOUT_TRIGGER, message, call, fix, key="Runtype")
    return model.Schedule(
        runnable=call.name,
        trigger="Timer" if is_timed else "Topics",
        period=call.cycle_time if is_timed else None,
        offset=whole(milliseconds(call.execution_offset)),
        debounce=whole(milliseconds(call.debounce_delay)),
        topics=topics,
        after=_after(call, part, findings),
        thread_priority=_priority(call, findings),
        modes=_active_modes(call, part),
        **_supervision(call),
    )


def _triggers(call: Runnable, part: Part, exchanged: Sequence[model.Communication]) -> tuple[str, ...]:
    """Topics that bring a signal on which the call runs."""
    names = {item.name for item in triggers(call)}
    return tuple(
        topic.name
        for topic in (topic for each in exchanged if each.runnable == call.name for topic in each.topics)
        if (topic.role, topic.node) == (SUBSCRIPTION, part.name)
        and names.intersection(mapping.signal for mapping in topic.mappings)
    )


def _after(call: Runnable, part: Part, findings: FindingCollector) -> str | None:
    """The calls of this node that a call follows. The life cycle already puts init before every step."""
    own = {other.name: other for other in part.component.runnables}
    before = previous_calls(call)
    for name in before:
        if name not in own:
            message = f"{call.name} is ordered after {name}, which runs in another node; ROS 2 cannot order calls across nodes."
            fix = "Trigger it by a signal, or use offsets."
            findings.report(codes.ORDER_BETWEEN_NODES, message, call, fix, key="PrevRunnable")
    return ", ".join(name for name in before if name in own and run_kind(own[name]) != INIT) or None


def _priority(call: Runnable, findings: FindingCollector) -> int | None:
    number = call.priority_number
    if number is not None and number in _PRIORITIES:
        return number
    if call.priority.strip():
        message = f"The priority of {call.name} must be from 1 to 99, not {shortened(call.priority.strip())!r}."
        fix = "Use a number; higher ones run first."
        findings.report(codes.PRIORITY_NOT_A_NUMBER, message, call, fix, key="Priority")
    return None


def _policy(
    node: str, running: Sequence[Runnable], schedules: Sequence[model.Schedule], context: Context
) -> SchedulingPolicy | None:
    """Return the policy of the deployment, if a call has a priority."""
    policy = context.settings.scheduling_policy
    if policy == "other" or not running:
        return None
    if any(schedule.thread_priority is not None for schedule in schedules):
        return policy
    message = f"{node} must have a priority to run under {policy}; none of its calls has one: it runs without."
    fix = "Give the call a `priority` from 1 to 99."
    context.findings.report(codes.POLICY_WITHOUT_PRIORITY, message, running[0], fix)
    return None


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
        if call.stack_size:
            message = f"{call.name}: ROS 2 has no setting for the stack size of {shortened(call.stack_size)} bytes; it is left out."
            fix = "Set it for the process, for instance with `ulimit -s`."
            findings.report(codes.STACK_SIZE_NOT_CARRIED, message, call, fix, key="StackSize")
        if call.watchdog and call.watchdog.logical and call.checkpoint is None:
            message = f"{call.name}: the logical supervision is free text and cannot be checked."
            fix = "Give the calls a `checkpoint` each, with the calls that may follow."
            findings.report(codes.LOGICAL_SUPERVISION_IN_WORDS, message, call, fix, key="Watchdog")


# -- modes --------------------------------------------------------------------------------------------------------


def mode_topic(function: str, interface: ModeInterface) -> str:
    """The topic of a mode interface: `core_acc/mode_in`."""
    return topic_name(function, f"mode_{interface.direction}")


def _modes(part: Part, context: Context) -> Iterable[model.StatusTopic]:
    """A topic for each mode interface of the function. Every node receives the mode; the first one sends it."""
    for interface in part.function.mode_interfaces or ():
        is_received = interface.direction.lower() == "in"
        if not is_received and not part.is_first:
            continue
        kind = field_type(interface.datatype, None, context.book.table)
        if kind is None or kind.element is None:
            unresolved(context.findings, subject_of(interface), interface.datatype)
            continue
        yield model.StatusTopic(
            interface=interface.name,
            topic=mode_topic(part.function_name, interface),
            role=SUBSCRIPTION if is_received else PUBLISHER,
            message=f"{context.book.package}/msg/{_mode_message(interface, kind, part, context)}",
            field="mode",
            provider=context.application.mode_manager if is_received else None,
            quality=MODE,
            vss_path=interface.vss_path,
        )


def _mode_message(interface: ModeInterface, kind: FieldType, part: Part, context: Context) -> str:
    book, subject, meaning = context.book, subject_of(interface), interface.description
    if interface.name not in book.modes:
        written = book.written(kind, subject) or "uint8"
        field = model.MessageField(name="mode", datatype=written, description=meaning, vss_path=interface.vss_path)
        values = constants(kind, "", subject, context.findings)
        name = book.reserved(f"{part.function_name}_Mode_{interface.direction}", subject)
        book.modes[interface.name] = book.add(name, meaning, (STAMP, field), values)
    return book.modes[interface.name]
