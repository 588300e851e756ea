"""Tasks, and what runs before them: a proposal from the cycles and priorities of calls, which an integrator may change."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from sigcat.function.document.text import Text
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.runnables import JUDGE_WINDOWS, Behaviour
from sigcat.integration.autosar_names import distinct, short_name

_ROLES = ("Init", "Receive", "Answer", "Method", "Step", "Supervise", "JudgeWindows", "Terminate")


class _Mapped(NamedTuple):
    component: model.Component
    event: model.Event
    runnable: model.Runnable
    rank: tuple[int, int, int]
    """Order within a task: what the runnable does, then the higher priority, then the order of the file."""
    preemptable: bool
    period: float | None
    """Period of the runnable, whatever starts it: all its events are in one task, since it never runs twice at a time."""


def init_batches_of(components: Sequence[model.Component], behaviours: Mapping[str, Behaviour]) -> tuple[model.InitBatch, ...]:  # fmt: skip
    """One batch with Init of all components: no task runs before it has ended."""
    mapped = [each for each in _all_mapped(components, behaviours) if each.runnable.role == "Init"]
    if not mapped:
        return ()
    reason = "Init of every component before anything else; timing events start afterwards."
    name = distinct({"batch": "InitComponents"}, (each.name for each in components))["batch"]
    return (model.InitBatch(name=name, events=_in_order(mapped), reason=Text(reason)),)


def tasks_of(components: Sequence[model.Component], behaviours: Mapping[str, Behaviour]) -> tuple[model.Task, ...]:
    """One task for each period, one for what other events start, one for windows, one for terminate; the shorter the period,
    the higher the priority."""
    mapped = _all_mapped(components, behaviours)
    windows = [each for each in mapped if each.runnable.role == JUDGE_WINDOWS]
    cyclic = [each for each in mapped if each.runnable.role != JUDGE_WINDOWS]
    ends = [each for each in mapped if each.runnable.role == "Terminate"]
    events = [each for each in mapped if each.period is None and each.runnable.role not in ("Init", "Terminate")]
    periods = sorted({each.period for each in cyclic if each.period is not None})
    served = "What is received, called or switched is served before what is cyclic."
    groups: list[tuple[str, list[_Mapped], float | None, str]] = [("Events", events, None, served)]
    groups += [
        (f"Cycle_{_text(period)}ms", [each for each in cyclic if each.period == period], period,
         f"Everything with a period of {_text(period)} ms: the shorter, the higher the priority.")
        for period in periods
    ]  # fmt: skip
    ticks = next((each.period for each in windows), None)
    groups += [("Windows", windows, ticks, "Steps come before: what is released with the end of a window closes it.")]
    groups += [("Life", ends, None, "Terminate after everything else.")]
    filled = [group for group in groups if group[1]]
    return tuple(_task(*group, priority=len(filled) - index) for index, group in enumerate(filled))


def _text(period: float) -> str:
    number = round(period * 1000, 6)
    return str(int(number)) if number == int(number) else str(number).replace(".", "_")


def _task(name: str, mapped: Iterable[_Mapped], period: float | None, reason: str, *, priority: int) -> model.Task:
    listed = list(mapped)
    stacks = [each.runnable.stack_size for each in listed if each.runnable.stack_size]
    return model.Task(
        name=short_name(f"Task_{name}"),
        priority=priority,
        preemptable=all(each.preemptable for each in listed),
        period=period,
        offset=0 if period is not None else None,
        stack_size=max(stacks, default=None),
        events=_in_order(listed),
        reason=Text(reason),
    )


def _in_order(mapped: Iterable[_Mapped]) -> tuple[model.TaskEvent, ...]:
    ordered = sorted(mapped, key=lambda each: each.rank)
    return tuple(
        model.TaskEvent(component=each.component.name, event=each.event.name, position=number)
        for number, each in enumerate(ordered, 1)
    )


def _all_mapped(components: Iterable[model.Component], behaviours: Mapping[str, Behaviour]) -> list[_Mapped]:
    return [each for component in components for each in _mapped(component, behaviours[component.name])]


def _mapped(component: model.Component, behaviour: Behaviour) -> Iterable[_Mapped]:
    runnables = {each.name: each for each in component.runnables}
    order = [each.name for each in component.runnables]
    calls = {each.call.name: each.call for each in behaviour.calls}
    periods: dict[str, float] = {}
    for event in component.events:
        if event.period is not None:
            periods[event.runnable] = min(event.period, periods.get(event.runnable, event.period))
    for event in component.events:
        runnable = runnables[event.runnable]
        call = calls.get(runnable.call or "")
        priority = call.priority_number if call else None
        plain = "".join(letter for letter in (call.scheduling if call else "").lower() if letter.isalpha())
        rank = (_ROLES.index(runnable.role), -(priority or 0), order.index(runnable.name))
        yield _Mapped(component, event, runnable, rank, plain != "nonpreemptive", periods.get(runnable.name))
