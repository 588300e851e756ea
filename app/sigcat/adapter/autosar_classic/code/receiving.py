"""What comes from the RTE, handed over to the core."""

from sigcat.adapter.autosar_classic.code import transformer_errors
from sigcat.adapter.autosar_classic.code.names import at_core, core_object, function, static
from sigcat.adapter.autosar_classic.code.plan import DataEnd, MethodEnd, ModeEnd, SwcPlan
from sigcat.adapter.autosar_classic.code.values import Copy, by_address, core_declared
from sigcat.adapter.core.c.lines import Lines, block, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.integration.autosar_classic.model import Runnable


def functions(swc: SwcPlan) -> list[Lines]:
    """A function for each element that is taken, one for the mode, and one that asks what is due."""
    used = {key for each in swc.component.runnables for key in _keys(each, swc)}
    taken = [end for end in swc.received if (end.key, False) in used]
    return [
        *transformer_errors.functions(taken, swc),
        *(_take(end, swc) for end in taken),
        *(_take_copy(end, each, swc) for each in swc.component.runnables for end in swc.ends(each, "ImplicitRead")),
        *([_take_mode(swc.mode_in, swc)] if swc.mode_in and has_mode(swc) else []),
        *(_take_answer(each, swc) for each in swc.requests),
        *([_find_due(swc)] if swc.core.steps else []),
    ]


def _keys(runnable: Runnable, swc: SwcPlan) -> list[tuple[tuple[str, str], bool]]:
    explicit = (*swc.ends(runnable, "ExplicitRead"), *swc.ends(runnable, "QueuedReceive"))
    return [(end.key, False) for end in explicit]


def has_mode(swc: SwcPlan) -> bool:
    return any(access.kind == "Mode" for each in swc.component.runnables for access in each.accesses)


def takes(runnable: Runnable, swc: SwcPlan, *, before: str = "") -> Lines:
    """Calls that take what a runnable reads: all of it, or what is immediate in a call before this call."""
    explicit = (*swc.ends(runnable, "ExplicitRead"), *swc.ends(runnable, "QueuedReceive"))
    if before:
        return joined(lines(f"{_name(end, swc)}(t);") for end in explicit if before in end.immediate_in)
    mode = any(
        access.kind == "Mode" and swc.mode_in and access.port == swc.mode_in.port for access in runnable.accesses
    )
    return joined([
        lines(f"{static(swc, 'TakeMode')}(t);") if mode else (),
        *(lines(f"{_name(end, swc)}(t);") for end in explicit),
        *(lines(f"{_copy_name(end, runnable, swc)}(t);") for end in swc.ends(runnable, "ImplicitRead")),
        *(lines(f"{_answer_name(each, swc)}(t);") for each in _answered(runnable, swc)),
    ])  # fmt: skip


def _name(end: DataEnd, swc: SwcPlan) -> str:
    return static(swc, f"Take_{end.place}")


def _copy_name(end: DataEnd, runnable: Runnable, swc: SwcPlan) -> str:
    return static(swc, f"TakeIn_{runnable.name}_{end.place}")


def _given(end: DataEnd, source: str, swc: SwcPlan) -> Lines:
    """A value handed over to the core."""
    receive = f"{swc.core.type_name}_Receive_{end.place}"
    copy = Copy(swc.core, to_core=True)
    if end.type.is_number:
        return lines(f"{receive}({at_core(swc)}, {copy.number(source, end.type)}, t);")
    given = "&taken" if end.wire.is_struct and end.wire.length is None else "taken"
    return joined([
        lines(core_declared(end.wire, "taken") + "\n"),
        copy.of("taken", source, end.type, end.wire.c),
        lines(f"{receive}({at_core(swc)}, {given}, t);"),
    ])  # fmt: skip


def _take(end: DataEnd, swc: SwcPlan) -> Lines:
    """Explicit access: what is fresh, all that waits in a queue."""
    head = f"static void {_name(end, swc)}(uint64 t)"
    value = by_address(end.type, "value")
    declared = f"{end.type.name} value;"
    given = _given(end, "value", swc)
    if end.is_queue:
        return function(head, [lines(declared), transformer_errors.drained(end, value, given, swc)], end.comment)
    if end.has_transformer_errors:
        return function(head, [lines(declared), transformer_errors.read(end, value, given, swc)], end.comment)
    read = block(f"if (Rte_Read_{end.name}({value}) == RTE_E_OK)", [given])
    updated = [block(f"if (Rte_IsUpdated_{end.name}() != FALSE)", [read])] if end.has_update else [read]
    return function(head, [lines(f"{declared}\n"), *updated], end.comment)


def _take_copy(end: DataEnd, runnable: Runnable, swc: SwcPlan) -> Lines:
    """Implicit access: the copy that the RTE has made for the runnable."""
    api = f"{runnable.name}_{end.name}"
    head = f"static void {_copy_name(end, runnable, swc)}(uint64 t)"
    received = f"if (Rte_IStatus_{api}() == RTE_E_OK)"
    if end.type.is_number:
        return function(head, [block(received, [_given(end, f"Rte_IRead_{api}()", swc)])], end.comment)
    type_ = end.type.element.name if end.type.element else end.type.name
    source = "copy" if end.type.is_array else "(*copy)"
    copy = lines(f"const {type_} *const copy = Rte_IRead_{api}();")
    return function(head, [block(received, [copy, _given(end, source, swc)])], end.comment)


def _take_mode(mode: ModeEnd, swc: SwcPlan) -> Lines:
    wire = swc.core.mode_in.wire.c if swc.core.mode_in else "uint8_t"
    receive = f"{swc.core.type_name}_Receive_{mode.place}"
    body = [
        lines(f"const {mode.type} mode = Rte_Mode_{mode.name}();\n"),
        block(f"if (mode != RTE_TRANSITION_{mode.group})", [lines(f"{receive}({at_core(swc)}, ({wire})mode, t);")]),
    ]
    return function(
        f"static void {static(swc, 'TakeMode')}(uint64 t)",
        body,
        "During a transition, the mode before it is the one that is.",
    )


def _answered(runnable: Runnable, swc: SwcPlan) -> list[MethodEnd]:
    keys = {(access.port, access.element) for access in runnable.accesses if access.kind == "Result"}
    return [each for each in swc.methods if (each.port, each.operation) in keys]


def _answer_name(end: MethodEnd, swc: SwcPlan) -> str:
    return static(swc, f"TakeAnswer_{end.method.named.name}")


def _take_answer(end: MethodEnd, swc: SwcPlan) -> Lines:
    """The answer to the request that is pending, if it has come. The RTE drops those of requests before it."""
    p, name = swc.core.type_name, end.method.named.name
    taken = ", ".join(by_address(each.type, f"taken_{each.name}") for each in end.results)
    copy = Copy(swc.core, to_core=True)
    results = [copy.of(f"results.{each.place}", f"taken_{each.name}", each.type, each.wire.c) for each in end.results]
    number = f"{core_object(swc)}.method.{name}.number"
    given = ", &results" if results else ""
    zeroed = lines(f"{p}_{name}_Results results;\n\n(void)memset(&results, 0, sizeof(results));") if results else ()
    body = [
        *(lines(f"{each.type.name} taken_{each.name};") for each in end.results),
        lines(f"const Std_ReturnType status = Rte_Result_{end.name}({taken});\n"),
        block("if (status != RTE_E_NO_DATA)", [
            zeroed,
            block("if (status == RTE_E_OK)", results) if results else (),
            lines(f"{p}_Answer_{name}({at_core(swc)}, {number}, (status == RTE_E_OK){given}, t);"),
        ]),
    ]  # fmt: skip
    return function(f"static void {_answer_name(end, swc)}(uint64 t)", body, end.method.named.comment)


def _find_due(swc: SwcPlan) -> Lines:
    scope, core = Scope(swc.core), swc.core.type_name
    cases = [
        lines(f"case {scope.call(step.name)}:\n    {static(swc, 'Due')}.{step.name} = TRUE;\n    break;")
        for step in swc.core.steps
    ]  # fmt: skip
    ask = f"due = {core}_NextCall({at_core(swc)}, t);"
    body = [
        lines(f"{core}_Call {ask}\n"),
        block(f"while (due != {scope.constant('NO_CALL')})", [
            block("switch (due)", [*cases, lines(f"case {scope.constant('NO_CALL')}:\ndefault:\n    break;")]),
            lines(ask),
        ]),
    ]  # fmt: skip
    comment = "Each call that is due is said once: it is noted until its runnable runs."
    return function(f"static void {static(swc, 'FindDue')}(uint64 t)", body, comment)
