"""The runnables, by what they do with the core."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.component.methods import offered
from sigcat.adapter.autosar_classic.code.component.publishing import outputs
from sigcat.adapter.autosar_classic.code.component.receiving import takes
from sigcat.adapter.autosar_classic.code.component.rte_values import Copy, CopyRow
from sigcat.adapter.autosar_classic.code.names import core_object
from sigcat.adapter.autosar_classic.code.plan import ParameterEnd, Reported, SwcPlan
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.integration.autosar_classic.model import Runnable

_WITHOUT_STARTS = ("Init", "JudgeWindows", "Terminate")


class _Calibrated(NamedTuple):
    """A parameter: the number itself, or the type behind a pointer to it and statements that copy it."""

    end: ParameterEnd
    number: str
    type: str
    copied: Sequence[CopyRow]


class _Triggered(NamedTuple):
    """A call that a runnable can start, and the trigger that does."""

    call: str
    trigger: str


class _Step(NamedTuple):
    """The call of a runnable: functions that take what is immediate, checkpoints around it, and requests after it."""

    name: str
    takes: Sequence[str]
    begins: Sequence[Reported]
    ends: Sequence[Reported]
    has_outputs: bool
    requests: Sequence[str]


def runnable(each: Runnable, swc: SwcPlan) -> Lines:
    """The definition of a runnable."""
    if each.role == "Method":
        return offered(each, swc)
    return c_lines(
        "code/component/runnable.c.j2",
        swc=swc,
        core=core_object(swc),
        runnable=each,
        takes=takes(each, swc),
        parameters=[_calibrated(end, swc) for end in swc.parameters] if each.role == "Init" else [],
        step=_step(each, swc) if each.role == "Step" else None,
        starts_calls=each.role not in _WITHOUT_STARTS,
        triggered=_triggered(each, swc),
    )


def _calibrated(end: ParameterEnd, swc: SwcPlan) -> _Calibrated:
    copy = Copy(swc.core, to_core=True)
    if end.type.is_number:
        return _Calibrated(end, copy.number(f"{end.function}()", end.type), "", [])
    type_ = end.type.element.name if end.type.element else end.type.name
    source = "calibrated" if end.type.is_array else "(*calibrated)"
    target = f"stored.{end.parameter.named.name}.value"
    return _Calibrated(end, "", type_, [*copy.of(target, source, end.type, end.parameter.value.wire.c)])


def _step(each: Runnable, swc: SwcPlan) -> _Step:
    step = next(one for one in swc.core.steps if one.interface == each.call)
    begins, ends = (swc.reported.get((step.interface, moment), ()) for moment in ("Begin", "End"))
    requests = [one.method.named.name for one in swc.requests if one.method.call == step.name]
    immediate = takes(each, swc, before=step.name)
    return _Step(step.name, immediate, begins, ends, bool(outputs(step.name, swc)), requests)


def _triggered(each: Runnable, swc: SwcPlan) -> list[_Triggered]:
    calls = {one.name: one.call for one in swc.component.runnables if one.role == "Step"}
    steps = {step.interface: step.name for step in swc.core.steps}
    return [
        _Triggered(steps[calls[access.element] or ""], f"Rte_IrTrigger_{each.name}_{access.name}")
        for access in each.accesses if access.kind == "InternalTrigger"
    ]  # fmt: skip
