"""Values from the RTE to the core.

docs/explanation/autosar-classic.md has the rule by which the core receives or rejects a message with a result of end-to-end
protection. SWS_Rte says when data are delivered, SWS_E2ETransformer what an error code means.
"""

from sigcat.adapter.autosar_classic.code.component.rte_values import component_lines
from sigcat.adapter.autosar_classic.code.names import static
from sigcat.adapter.autosar_classic.code.plan import DataEnd, MethodEnd, SwcPlan
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.integration.autosar_classic.model import Runnable


def functions(swc: SwcPlan) -> Lines:
    """A function for each element that is taken, one for the mode, and one that asks what is due."""
    used = {end.key for each in swc.component.runnables for end in _explicit(each, swc)}
    taken = [end for end in swc.received if end.key in used]
    return component_lines(
        "receiving.c.j2",
        swc,
        has_codes=any(each.has_transformer_errors for each in taken),
        taken=taken,
        mode=swc.mode_in if has_mode(swc) else None,
    )


def _explicit(runnable: Runnable, swc: SwcPlan) -> tuple[DataEnd, ...]:
    return (*swc.ends(runnable, "ExplicitRead"), *swc.ends(runnable, "QueuedReceive"))


def has_mode(swc: SwcPlan) -> bool:
    return any(access.kind == "Mode" for each in swc.component.runnables for access in each.accesses)


def takes(runnable: Runnable, swc: SwcPlan, *, before: str = "") -> list[str]:
    """Functions that take what a runnable reads: all of it, or what is immediate in a call before this call."""
    if before:
        names = [f"Take_{end.place}" for end in _explicit(runnable, swc) if before in end.immediate_in]
        return [static(swc, name) for name in names]
    has_own = any(
        access.kind == "Mode" and swc.mode_in and access.port == swc.mode_in.port for access in runnable.accesses
    )
    names = [
        *(["TakeMode"] if has_own else []),
        *(f"Take_{end.place}" for end in _explicit(runnable, swc)),
        *(f"TakeIn_{runnable.name}_{end.place}" for end in swc.ends(runnable, "ImplicitRead")),
        *(f"TakeAnswer_{each.method.named.name}" for each in _answered(runnable, swc)),
    ]
    return [static(swc, name) for name in names]


def _answered(runnable: Runnable, swc: SwcPlan) -> list[MethodEnd]:
    keys = {(access.port, access.element) for access in runnable.accesses if access.kind == "Result"}
    return [each for each in swc.methods if (each.port, each.operation) in keys]
