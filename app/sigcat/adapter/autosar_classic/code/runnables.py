"""The runnables, by what they do with the core."""

from sigcat.adapter.autosar_classic.code.methods import offered
from sigcat.adapter.autosar_classic.code.names import at_core, core_object, enter, function, in_calls, leave, static
from sigcat.adapter.autosar_classic.code.plan import ParameterEnd, Reported, SwcPlan
from sigcat.adapter.autosar_classic.code.publishing import requests, sends
from sigcat.adapter.autosar_classic.code.receiving import takes
from sigcat.adapter.autosar_classic.code.values import Copy
from sigcat.adapter.core.c.lines import Lines, block, joined, lines
from sigcat.function.document.text_filters import block_comment
from sigcat.integration.autosar_classic.model import Runnable


def runnable(each: Runnable, swc: SwcPlan) -> Lines:
    """The definition of a runnable."""
    if each.role == "Method":
        return offered(each, swc)
    bodies = {"Init": _init, "Step": _step, "JudgeWindows": _judge_windows, "Terminate": _terminate}
    body = bodies.get(each.role, _taking)(each, swc)
    return function(f"void {each.symbol}(void)", body, each.description or "")


def _t(swc: SwcPlan) -> str:
    return f"uint64 t = {static(swc, 'Now')}();"


def _publish(swc: SwcPlan) -> Lines:
    return lines(f"{static(swc, 'Publish')}();")


# -- life ---------------------------------------------------------------------------------------------------------


def _init(each: Runnable, swc: SwcPlan) -> list[Lines]:
    core, p = at_core(swc), swc.core.type_name
    return [
        lines(f"const {_t(swc)}\n{p}_Stored stored;"),
        lines("uint32 cycle = 0U;") if swc.ignition else (),
        lines("NvM_RequestResultType result = 1U;") if swc.memory and swc.restored else (),
        lines(""),
        lines("(void)memset(&stored, 0, sizeof(stored));"),
        _restored(swc),
        _cycle(swc),
        *(_calibrated(parameter, swc) for parameter in swc.parameters),
        enter(swc),
        lines("/* If Init of the function has failed, the core says so, and no call is due. */"),
        lines(f"(void){p}_Init({core}, &stored, {'cycle' if swc.ignition else 'stored.ignition_cycle + 1U'});"),
        takes(each, swc),
        lines(f"{p}_Start({core}, t);"),
        leave(swc),
        _publish(swc),
    ]


def _restored(swc: SwcPlan) -> Lines:
    """What was kept, if the memory manager could read it: 0 is NVM_REQ_OK."""
    if swc.memory is None:
        return ()
    kept = lines(f"stored = *Rte_Pim_{swc.memory.name}();")
    if not swc.restored:
        return kept
    return block(f"if (({swc.restored}(&result) == RTE_E_OK) && (result == 0U))", [kept])


def _cycle(swc: SwcPlan) -> Lines:
    """A cycle that nobody knows is another one than the last."""
    if not swc.ignition:
        return ()
    return block(f"if ({swc.ignition}(&cycle) != RTE_E_OK)", [lines("cycle = stored.ignition_cycle + 1U;")])


def _calibrated(each: ParameterEnd, swc: SwcPlan) -> Lines:
    place, wire = f"stored.{each.parameter.named.name}", each.parameter.value.wire
    copy = Copy(swc.core, to_core=True)
    there = lines(f"{place}.is_there = true;")
    if each.type.is_number:
        return joined([lines(f"{place}.value = {copy.number(f'{each.function}()', each.type)};"), there])
    type_ = each.type.element.name if each.type.element else each.type.name
    source = "calibrated" if each.type.is_array else "(*calibrated)"
    return block("", [
        lines(f"const {type_} *const calibrated = {each.function}();\n"),
        copy.of(f"{place}.value", source, each.type, wire.c),
        there,
    ])  # fmt: skip


def _terminate(each: Runnable, swc: SwcPlan) -> list[Lines]:
    core, p = at_core(swc), swc.core.type_name
    kept = lines(f"*Rte_Pim_{swc.memory.name}() = {core_object(swc)}.stored;") if swc.memory else ()
    why = "/* Nothing follows that could store it otherwise: the next start has what was stored before. */"
    mark = lines(f"{why}\n(void){swc.marked}(TRUE);") if swc.memory and swc.marked else ()
    return [
        lines(f"const {_t(swc)}\n"),
        enter(swc),
        takes(each, swc),
        lines(f"{p}_Terminate({core}, t);"),
        kept,
        leave(swc),
        _publish(swc),
        mark,
    ]


# -- calls --------------------------------------------------------------------------------------------------------


def _checkpoints(each: Runnable, moment: str, swc: SwcPlan) -> list[Lines]:
    reported: tuple[Reported, ...] = swc.reported.get((each.call or "", moment), ())
    return [
        lines(f"(void){one.function}(); {block_comment(f'{one.name}: the watchdog manager checks what it misses')}")
        for one in reported
    ]


def _step(each: Runnable, swc: SwcPlan) -> list[Lines]:
    """The call, if the core says that it is due: the event of the RTE alone does not."""
    step = next(one for one in swc.core.steps if one.interface == each.call)
    core, p, due = at_core(swc), swc.core.type_name, f"{static(swc, 'Due')}.{step.name}"
    immediate = takes(each, swc, before=step.name)
    later = [leave(swc), lines(f"t = {static(swc, 'Now')}();"), enter(swc), immediate] if immediate else []
    find = lines(f"{static(swc, 'FindDue')}(t);")
    return [
        lines(f"{_t(swc)}\nboolean is_due;"), _start_flags(each, swc), lines(""),
        enter(swc),
        takes(each, swc),
        find,
        lines(f"is_due = {due};\n{due} = FALSE;"),
        block("if (is_due != FALSE)", [
            lines(f"{p}_SetInput_{step.name}({core}, t);"), *later, lines(f"{p}_Begin_{step.name}({core}, t);"),
            leave(swc), _publish(swc),
            *_checkpoints(each, "Begin", swc),
            in_calls(swc, lines(f"{p}_Run_{step.name}({core});")),
            *_checkpoints(each, "End", swc),
            lines(f"t = {static(swc, 'Now')}();"),
            enter(swc), lines(f"{p}_GetOutput_{step.name}({core}, t);"), *sends(step.name, swc), leave(swc),
            _publish(swc), *requests(step.name, swc),
            enter(swc),
            find if _triggered(each, swc) else (),
        ]),
        lines(f"{p}_Supervise({core}, t);"),
        _note_starts(each, swc),
        leave(swc),
        _publish(swc),
        _start(each, swc),
    ]  # fmt: skip


def _taking(each: Runnable, swc: SwcPlan) -> list[Lines]:
    """What has come is taken at the time at which it came; calls that are due by it are started."""
    supervise = f"{swc.core.type_name}_Supervise({at_core(swc)}, t);" if each.role == "Supervise" else ""
    return [
        lines(f"const {_t(swc)}"), _start_flags(each, swc), lines(""),
        enter(swc),
        takes(each, swc),
        lines(f"{static(swc, 'FindDue')}(t);") if _triggered(each, swc) else (),
        lines(supervise) if supervise else (),
        _note_starts(each, swc),
        leave(swc),
        _publish(swc) if each.role != "Answer" else (),
        _start(each, swc),
    ]  # fmt: skip


def _judge_windows(each: Runnable, swc: SwcPlan) -> list[Lines]:
    """Only when the core names the time: at others it would judge errors that mature, where no other platform does."""
    p, core = swc.core.type_name, at_core(swc)
    return [
        lines(f"const {_t(swc)}\n"),
        enter(swc),
        takes(each, swc),
        block(f"if ({p}_NextTime({core}) <= t)", [lines(f"{p}_Supervise({core}, t);")]),
        leave(swc),
        _publish(swc),
    ]


# -- calls that are found due by another runnable than their own ---------------------------------------------------


def _triggered(each: Runnable, swc: SwcPlan) -> list[tuple[str, str]]:
    """Calls that a runnable can start, and the triggers that do."""
    calls = {one.name: one.call for one in swc.component.runnables if one.role == "Step"}
    steps = {step.interface: step.name for step in swc.core.steps}
    return [
        (steps[calls[access.element] or ""], f"Rte_IrTrigger_{each.name}_{access.name}")
        for access in each.accesses if access.kind == "InternalTrigger"
    ]  # fmt: skip


def _start_flags(each: Runnable, swc: SwcPlan) -> Lines:
    return joined(lines(f"boolean starts_{name};") for name, _ in _triggered(each, swc))


def _note_starts(each: Runnable, swc: SwcPlan) -> Lines:
    return joined(lines(f"starts_{name} = {static(swc, 'Due')}.{name};") for name, _ in _triggered(each, swc))


def _start(each: Runnable, swc: SwcPlan) -> Lines:
    return joined(
        block(f"if (starts_{name} != FALSE)", [lines(f"{trigger}();")]) for name, trigger in _triggered(each, swc)
    )
