"""Operations that components call: services of the base software, methods of others, answers that a trace has."""

from sigcat.adapter.autosar_classic.code.api import Call
from sigcat.adapter.autosar_classic.code.methods import head
from sigcat.adapter.autosar_classic.code.names import function
from sigcat.adapter.autosar_classic.code.plan import MethodEnd, SwcPlan
from sigcat.adapter.autosar_classic.test_rte.names import own
from sigcat.adapter.autosar_classic.test_rte.plan import TestRte, server
from sigcat.adapter.core.c.lines import Line, Lines, block, joined, lines
from sigcat.adapter.text_filters import c_string

_SERVICES = {
    "GetTime": "TestRte_GetTime", "GetCycle": "TestRte_GetCycle", "SetEventStatus": "Dem_SetEventStatus",
    "CheckpointReached": "WdgM_CheckpointReached", "GetErrorStatus": "NvM_GetErrorStatus",
    "SetRamBlockStatus": "NvM_SetRamBlockStatus",
}  # fmt: skip


def answer_type(end: MethodEnd, swc: SwcPlan) -> str:
    return own("Answer", end.name, swc)


def answers(swc: SwcPlan) -> list[Lines]:
    """What is answered from now on, and whether an answer waits to be taken."""
    return [
        lines(f"static struct {{ {answer_type(each, swc)} value; boolean is_there; boolean is_ready; Std_ReturnType status; }} "
              f"{_place(each, swc)};") for each in swc.requests
    ]  # fmt: skip


def answer_types(swc: SwcPlan) -> list[Lines]:
    """Results of a method as one value; of a method without results whether it is done."""
    found = []
    for end in swc.requests:
        members = [Line(f"    {each.type.name} {each.place};") for each in end.results] or [Line("    boolean is_ok;")]
        found.append((Line("typedef struct {"), *members, Line(f"}} {answer_type(end, swc)};")))
    return found


def _place(end: MethodEnd, swc: SwcPlan) -> str:
    return f"answer_{swc.name}_{end.name}"


def deliver_answer(end: MethodEnd, swc: SwcPlan) -> str:
    return own("DeliverAnswer", end.name, swc)


def deliveries(swc: SwcPlan) -> list[Lines]:
    """What a trace says is answered from then on."""
    return [
        function(f"void {deliver_answer(each, swc)}(const void *value)", [lines(
            f"(void)memcpy(&{_place(each, swc)}.value, value, sizeof({_place(each, swc)}.value));\n"
            f"{_place(each, swc)}.is_there = TRUE;\n"
            f"{_place(each, swc)}.status = {_status(each, swc)};"
        )])
        for each in swc.requests
    ]  # fmt: skip


def _status(end: MethodEnd, swc: SwcPlan) -> str:
    return "RTE_E_OK" if end.results else f"({_place(end, swc)}.value.is_ok != FALSE) ? RTE_E_OK : RTE_E_INVALID"


def body(call: Call, swc: SwcPlan, rte: TestRte) -> list[Lines]:
    """What a call does."""
    for end in swc.requests:
        if (end.port, end.operation) == (call.port, call.element):
            return _result(end, call, swc) if call.kind == "Result" else _request(end, call, swc, rte)
    return _service(call, swc)


def _service(call: Call, swc: SwcPlan) -> list[Lines]:
    known = _SERVICES.get(call.element)
    given = [each.name for each in call.parameters]
    if known is None:
        return [*(lines(f"(void){name};") for name in given), lines("return E_OK;")]
    return [lines(f"return {known}({', '.join([*_bound(call, swc), *given])});")]


def _bound(call: Call, swc: SwcPlan) -> list[str]:
    """What a port says by itself: which event, which checkpoint of which entity, which block."""
    component = swc.component
    found = {each.port: [each.name] for each in component.diagnostic_events}
    found.update((each.port, [each.name]) for each in component.nv_blocks)
    for entity in component.supervised_entities:
        found.update((each.port, [entity.name, each.name]) for each in entity.checkpoints)
    return [c_string(name) for name in found.get(call.port, [])]


def _request(end: MethodEnd, call: Call, swc: SwcPlan, rte: TestRte) -> list[Lines]:
    place = _place(end, swc)
    raised = joined(lines(f"Os_Activate({number}U);")
                    for number in rte.events(swc, "CallReturns", port=end.port, element=end.operation))  # fmt: skip
    ready = joined([lines(f"{place}.is_ready = TRUE;"), raised])
    provider = rte.provider(swc, end.port)
    found = server(provider, end.operation) if provider else None
    unused = [lines(f"(void){each.name};") for each in call.parameters]
    if found is None:
        return [*unused, block(f"if ({place}.is_there != FALSE)", [ready]), lines("return RTE_E_OK;")]
    assert provider is not None
    runnable, answered = found
    is_gone = block(f"if (Os_HasEnded({rte.index(provider.swc)}U) != FALSE)", [lines("return RTE_E_OK;")])
    results = [
        f"{place}.value.{each.place}" if each.type.is_array else f"&{place}.value.{each.place}" for each in end.results
    ]
    given = ", ".join([*(each.name for each in call.parameters), *results])
    return [
        lines(f"extern {head(runnable, answered)};\n"),
        (Line("/* One that is gone answers nothing. */"), *is_gone),
        lines(f"{place}.status = {runnable.symbol}({given});"),
        ready,
        lines("return RTE_E_OK;"),
    ]


def _result(end: MethodEnd, call: Call, swc: SwcPlan) -> list[Lines]:
    place = _place(end, swc)
    copies = [
        lines(f"(void)memcpy({given.name}, &{place}.value.{each.place}, sizeof({place}.value.{each.place}));")
        for given, each in zip(call.parameters, end.results, strict=True)
    ]
    return [
        block(f"if ({place}.is_ready == FALSE)", [lines("return RTE_E_NO_DATA;")]),
        lines(f"{place}.is_ready = FALSE;"), *copies, lines(f"return {place}.status;"),
    ]  # fmt: skip
