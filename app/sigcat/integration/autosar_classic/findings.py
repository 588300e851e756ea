"""Findings on what the platform cannot express, or an integrator should know, at the part of the function concerned."""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

from sigcat import codes
from sigcat.asil import is_above
from sigcat.function.exchange import Side
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.triggers import absent_in
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import STEP, Context, named_calls
from sigcat.integration.autosar_classic.elements import Element
from sigcat.integration.autosar_classic.interfaces import type_of
from sigcat.integration.autosar_classic.service_needs import STORED
from sigcat.integration.autosar_names import LONGEST_SHORT_NAME
from sigcat.integration.finding_collector import Subject


def report_meanings(elements: Iterable[Element], context: Context) -> None:
    """Sides of an element that take it as another datatype, or in another unit."""
    for element in elements:
        for side in element.sides if element.kind == "data" else ():
            found, wanted = _meaning(side, context), _meaning(element.leading, context)
            if found != wanted:
                message = (
                    f"{element.identity}: {side.where} takes it as {found[0]} in {found[1] or 'no unit'}, "
                    f"{element.leading.where} as {wanted[0]} in {wanted[1] or 'no unit'}."
                )
                fix = "Build both from the same catalogue."
                context.findings.report(codes.MEANINGS_DIFFER_CLASSIC, message, side, fix)


def _meaning(side: Side, context: Context) -> tuple[str, str]:
    return type_of(side, context), side.data.vss_unit or side.data.units or ""


def report_asil(elements: Iterable[Element], composition: model.Composition, context: Context) -> None:
    """Report elements with an ASIL that cross the border: nothing in this document protects them end to end."""
    crossing = {port.interface for port in composition.ports}
    for element in elements:
        for side in element.sides if element.kind == "data" and element.name in crossing else ():
            if is_above(side.asil, "QM"):
                message = f"{element.identity} ({side.where}) is of ASIL {side.asil}, and its way over a bus has to be protected end to end."
                fix = "Configure an end-to-end transformer for its system signal."
                context.findings.report(codes.ASIL_OVER_A_BUS, message, side, fix, key="AsilLevel")


def report_long_names(context: Context) -> None:
    """Functions whose core would have names that are not valid identifiers of AUTOSAR."""
    longest = LONGEST_SHORT_NAME - len(f"_Adapter_{STORED}")
    for function in dict.fromkeys(part.function_name for part in context.parts):
        if len(function) > longest:
            part = next(each for each in context.parts if each.function_name == function)
            message = f"The name of a function must have {longest} characters at most, not {len(function)}: its core has longer ones, and identifiers of AUTOSAR have {LONGEST_SHORT_NAME}."
            subject = Subject(f"{function[:40]}…", part.function.info)
            context.findings.report(codes.NOT_WRITABLE_AS_CLASSIC, message, subject, "Shorten it.", key="FunctionName")


def report_calls(context: Context) -> None:
    """Steps that nothing starts, and times that no counter has."""
    for part in context.parts:
        for each in named_calls(part):
            if each.role == STEP:
                _report_call(each.call, context)


def _report_call(call: Runnable, context: Context) -> None:
    consumed = absent_in(call) or any(contract.signals or contract.queues for contract in call.contracts or ())
    if not call.cycle_time and not (call.run_type == "EventTriggered" and consumed):
        message = f"{call.name} must have a cycle time, or events that start it: no event starts its runnable."
        context.findings.report(codes.RUNNABLE_WITHOUT_EVENT, message, call, "Give `cycleTime` in its scheduling.")
    for key, time in (("Cycletime", call.cycle_time), ("ExecOffset", milliseconds(call.execution_offset))):
        microseconds = Fraction(str(time or 0)) * 1000
        if microseconds % context.settings.tick:
            message = f"{key} of {call.name} must be a multiple of the counter's tick, {context.settings.tick} µs, not {time} ms."
            fix = (
                "Correct it in the function, or set `tick` under `autosarClassic` in the deployment file."
                if microseconds.denominator == 1
                else "AUTOSAR Classic counts whole microseconds: correct it in the function."
            )
            context.findings.report(codes.TIME_NOT_IN_TICKS, message, call, fix, key=key)


def report_order(tasks: Sequence[model.Task], priorities: Mapping[tuple[str, str], int], context: Context) -> None:
    """Calls whose declared priority is higher than that of a call with a shorter period: tasks go by the period."""
    lowest: tuple[float, str] | None = None
    for task in tasks:
        if task.period is None:
            continue
        for event in task.events:
            priority = priorities.get((event.component, event.event))
            if priority is None:
                continue
            if lowest is not None and priority > lowest[0]:
                name = f"{event.component}.{event.event}"
                message = f"{name} has a higher priority ({priority}) than {lowest[1]} ({lowest[0]}), whose period is shorter: tasks are ordered by period."
                context.findings.report(codes.PRIORITY_AGAINST_PERIOD, message, name)
        own = [(p, f"{e.component}.{e.event}") for e in task.events if (p := priorities.get((e.component, e.event))) is not None]  # fmt: skip
        lowest = min([*own, *([lowest] if lowest else [])], default=None)
