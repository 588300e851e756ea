"""The runnables, by what they do with the core."""

from sigcat.adapter.autosar_classic.code.component.methods import offered
from sigcat.adapter.autosar_classic.code.component.receiving import takes
from sigcat.adapter.autosar_classic.code.component.rte_values import component_lines
from sigcat.adapter.autosar_classic.code.plan import SwcPlan
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.integration.autosar_classic.model import Runnable

_WITHOUT_STARTS = ("Init", "JudgeWindows", "Terminate")


def runnable(each: Runnable, swc: SwcPlan) -> Lines:
    """The definition of a runnable."""
    if each.role == "Method":
        return offered(each, swc)
    step = next((one for one in swc.core.steps if one.interface == each.call), None) if each.role == "Step" else None
    return component_lines(
        "runnable.c.j2",
        swc,
        runnable=each,
        takes=takes(each, swc),
        step=step,
        takes_before=takes(each, swc, before=step.name) if step else [],  # what is immediate
        requests=[one.method.named.name for one in swc.requests if step and one.method.call == step.name],
        starts_calls=each.role not in _WITHOUT_STARTS,
        triggered=_triggered(each, swc),
    )


def _triggered(each: Runnable, swc: SwcPlan) -> list[tuple[str, str]]:
    """Calls that a runnable can start, with the triggers that do."""
    calls = {one.name: one.call for one in swc.component.runnables if one.role == "Step"}
    steps = {step.interface: step.name for step in swc.core.steps}
    return [
        (steps[calls[access.element] or ""], f"Rte_IrTrigger_{each.name}_{access.name}")
        for access in each.accesses if access.kind == "InternalTrigger"
    ]  # fmt: skip
