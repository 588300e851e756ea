"""Values from the RTE to the core.

docs/explanation/autosar-classic.md has the rule by which the core receives or rejects a message with a result of end-to-end
protection. SWS_Rte says when data are delivered, SWS_E2ETransformer what an error code means.
"""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.component.rte_values import Copy, CopyRow, by_address
from sigcat.adapter.autosar_classic.code.names import core_object, static
from sigcat.adapter.autosar_classic.code.plan import DataEnd, MethodEnd, SwcPlan
from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.integration.autosar_classic.model import Runnable


class _Taken(NamedTuple):
    """An element that is handed over to the core: statements that fill a variable for it, if it needs one, and the argument.

    `address` is what the RTE fills; of a copy that a runnable has, the type behind the pointer to it.
    """

    end: DataEnd
    address: str
    copied: Sequence[CopyRow]
    argument: str
    runnable: str = ""


class _Answer(NamedTuple):
    """An answer to a request: what the RTE fills, and statements that copy it."""

    end: MethodEnd
    addresses: Sequence[str]
    copied: Sequence[CopyRow]


def functions(swc: SwcPlan) -> Lines:
    """A function for each element that is taken, one for the mode, and one that asks what is due."""
    scope = Scope(swc.core)
    used = {end.key for each in swc.component.runnables for end in _explicit(each, swc)}
    taken = [_taken(end, swc) for end in swc.received if end.key in used]
    return c_lines(
        "code/component/receiving.c.j2",
        swc=swc,
        core=core_object(swc),
        has_codes=any(each.end.has_transformer_errors for each in taken),
        taken=taken,
        copies=[_copy(end, each, swc) for each in swc.component.runnables for end in swc.ends(each, "ImplicitRead")],
        mode=swc.mode_in if has_mode(swc) else None,
        answers=[_answer(each, swc) for each in swc.requests],
        calls={step.name: scope.call(step.name) for step in swc.core.steps},
        no_call=scope.constant("NO_CALL"),
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


def _taken(end: DataEnd, swc: SwcPlan) -> _Taken:
    return _Taken(end, by_address(end.type, "value"), *_handed_over(end, "value", swc))


def _copy(end: DataEnd, runnable: Runnable, swc: SwcPlan) -> _Taken:
    """Implicit access: the copy that the RTE has made for the runnable."""
    if end.type.is_number:
        return _Taken(end, "", *_handed_over(end, f"Rte_IRead_{runnable.name}_{end.name}()", swc), runnable.name)
    type_ = end.type.element.name if end.type.element else end.type.name
    return _Taken(end, type_, *_handed_over(end, "copy" if end.type.is_array else "(*copy)", swc), runnable.name)


def _handed_over(end: DataEnd, source: str, swc: SwcPlan) -> tuple[list[CopyRow], str]:
    """Statements that fill a variable for a value, and the argument for the core."""
    copy = Copy(swc.core, to_core=True)
    if end.type.is_number:
        return [], copy.number(source, end.type)
    copied = [*copy.of("taken", source, end.type, end.wire.c)]
    return copied, "&taken" if end.wire.is_one_struct else "taken"


def _answered(runnable: Runnable, swc: SwcPlan) -> list[MethodEnd]:
    keys = {(access.port, access.element) for access in runnable.accesses if access.kind == "Result"}
    return [each for each in swc.methods if (each.port, each.operation) in keys]


def _answer(end: MethodEnd, swc: SwcPlan) -> _Answer:
    copy = Copy(swc.core, to_core=True)
    copied = [
        row for each in end.results
        for row in copy.of(f"results.{each.place}", f"taken_{each.name}", each.type, each.wire.c)
    ]  # fmt: skip
    addresses = [by_address(each.type, f"taken_{each.name}") for each in end.results]
    return _Answer(end, addresses, copied)
