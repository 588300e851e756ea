"""Calls of a function: complete, in an order that can be kept, and implemented to the ASIL of their outputs."""

from sigcat import codes
from sigcat.asil import Level, is_above, level_of, rank
from sigcat.function.checks.circles import circles
from sigcat.function.checks.schedule.order import contradiction, previous_calls
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.interfaces.role import CONSUMER, PROVIDER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.triggers import EVENT_TRIGGERED, absent_in, consumed_by, events_of
from sigcat.function.function_json.walk import Located, data, errors, runnables
from sigcat.names import did_you_mean


def check_calls(function: FunctionJson) -> Problems:
    """Every problem of calls, but for their supervision."""
    yield from _complete(function)
    yield from _cycles(function)
    yield from _events(function)
    yield from _order(function)
    yield from _asil(function)


def _complete(function: FunctionJson) -> Problems:
    for i, component in enumerate(function.components):
        subject = Subject("component", component.name)
        if not any(runnable.name.endswith("Step") for runnable in component.runnables):
            message = f"Component {component.name!r} must have a Step call."
            yield Problem(codes.CALLS_INCOMPLETE, ("ComponentList", i), message, "", subject, cause=subject)


def _cycles(function: FunctionJson) -> Problems:
    """Cyclic calls without a cycle time, or that are held back when they are due."""
    for pointer, _, runnable in runnables(function):
        delay, cycle = milliseconds(runnable.debounce_delay), runnable.cycle_time
        if runnable.run_type != "Cyclic":
            continue
        if not cycle:
            message = f"{runnable.name} is cyclic, but has no cycle time."
            subject = Subject("scheduling", runnable.name, ("cycleTime",))
            yield Problem(codes.CYCLIC_CALL_WITHOUT_CYCLE, (*pointer, "Cycletime"), message, subject=subject)
        elif delay is not None and delay > cycle:
            message = f"The debounce time of {runnable.name} must not exceed its cycle, {cycle} ms; got {delay:g} ms."
            fix = "Make it shorter: it would hold back calls that are due."
            subject = Subject("scheduling", runnable.name, ("debounceTime", "cycleTime"))
            yield Problem(codes.DEBOUNCE_BEYOND_CYCLE, (*pointer, "DebounceDelay"), message, fix, subject)


def _events(function: FunctionJson) -> Problems:
    for pointer, _, call in runnables(function):
        read = (*consumed_by(call), *absent_in(call))
        known = [name for item in read for name in (item.vss_path, item.name) if name]
        at, subject = (*pointer, "EventList"), Subject("scheduling", call.name, ("runType",))
        for event in events_of(call):
            if event not in known:
                message = f"The event {event!r} of {call.name} must be a signal that the call consumes."
                fix = did_you_mean(event, known) or "List the signal under the data of the call, as consumed."
                yield Problem(codes.EVENT_UNKNOWN, at, message, fix, Subject("scheduling", call.name))
        if call.events and call.run_type != EVENT_TRIGGERED:
            message = f"{call.name} must be {EVENT_TRIGGERED} to run on events, not {call.run_type}."
            fix = "Change its run type, or remove the events."
            yield Problem(codes.EVENTS_OF_TIMED_CALL, at, message, fix, subject)


def _order(function: FunctionJson) -> Problems:
    by_name = {located.runnable.name: located for located in runnables(function)}
    before = {name: previous_calls(located.runnable) for name, located in by_name.items()}
    circle_of = circles(before, "scheduling", "previousRunnable")
    for name, located in by_name.items():
        at, subject = (*located.pointer, "PrevRunnable"), Subject("scheduling", name, ("previousRunnable",))
        for previous in before[name]:
            if previous not in by_name:
                yield from _unknown_previous(previous, located, by_name, function)
            elif name in circle_of and circle_of.get(previous) is circle_of[name]:
                message = f"{name} depends on itself: it runs after {previous}, and that after it."
                circle = circle_of[name]
                yield Problem(codes.PREVIOUS_CALLS_IN_A_CIRCLE, at, message, subject=subject, circle=circle)
            elif found := contradiction(located.runnable, by_name[previous].runnable):
                yield Problem(codes.ORDER_CONTRADICTS_PRIORITY, at, found.message, found.fix, subject)


def _unknown_previous(previous: str, located: Located, by_name: dict[str, Located], function: FunctionJson) -> Problems:
    """Calls of other functions are not known here."""
    if previous.startswith(f"{function.info.function_name}_"):
        name = located.runnable.name
        message = f"{name} must run after a call of the function, not after {previous!r}, which does not exist."
        at, fix = (*located.pointer, "PrevRunnable"), did_you_mean(previous, by_name)
        subject, cause = Subject("scheduling", name, ("previousRunnable",)), Subject("scheduling", previous)
        yield Problem(codes.PREVIOUS_CALL_UNKNOWN, at, message, fix, subject, cause)


def _asil(function: FunctionJson) -> Problems:
    """One problem for a call, however much it provides and reports."""
    demands: dict[Pointer, list[tuple[Level | None, str]]] = {}
    for _, located, item in data(function):
        if item.role == PROVIDER:
            demands.setdefault(located.pointer, []).append((level_of(item.asil_level), f"provides {item.name!r}"))
    for _, located, error in errors(function):
        demands.setdefault(located.pointer, []).append((level_of(error.asil_level), f"reports {error.name}"))
    for pointer, _, runnable in runnables(function):
        own = level_of(runnable.asil_level)
        above = [(level, what) for level, what in demands.get(pointer, ()) if level and is_above(level, own)]
        if above:
            level, what = max(above, key=lambda demand: rank(demand[0]))
            more = f", and {len(above) - 1} more need an ASIL above {own}" if len(above) > 1 else ""
            message = f"{runnable.name} must be implemented to {level}, not {own}: it {what}{more}."
            subject = Subject("scheduling", runnable.name, ("ASILlevel",))
            yield Problem(codes.ASIL_OF_CALL_TOO_LOW, (*pointer, "AsilLevel"), message, subject=subject)


def check_inputs(function: FunctionJson) -> Problems:
    """Inputs without an ASIL, at calls that are implemented to an ASIL."""
    for pointer, (_, _, runnable), item in data(function):
        if item.role == CONSUMER and item.asil_level is None and is_above(level_of(runnable.asil_level), "QM"):
            message = f"{item.name!r} must state its ASIL: {runnable.name}, which reads it, has {runnable.asil_level}."
            fix = "Give `asil`, QM where the value is not relied on."
            subject = Subject("data", item.vss_path or item.name, ("ASILlevel",))
            yield Problem(codes.ASIL_OF_ELEMENT_MISSING, pointer, message, fix, subject)
