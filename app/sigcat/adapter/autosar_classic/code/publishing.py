"""What the core has to send, handed over to the RTE; errors to the diagnosis."""

from sigcat.adapter.autosar_classic.code.names import at_core, core_object, enter, function, leave, static
from sigcat.adapter.autosar_classic.code.plan import DataEnd, MethodEnd, ModeEnd, SwcPlan, Told
from sigcat.adapter.autosar_classic.code.values import Copy, by_value
from sigcat.adapter.core.c.lines import Lines, block, joined, lines, spaced
from sigcat.function.document.text_filters import block_comment

_TURNS = 2
"""Calls of the DEM for one error each time that a runnable publishes: the verdict, and one change of it meanwhile."""


def functions(swc: SwcPlan) -> list[Lines]:
    """One for what the core may say at any time, one for the outputs of each call, for each request and each verdict."""
    return [
        *(_request(each, swc) for each in swc.requests),
        *(_send(step.name, swc) for step in swc.core.steps if _outputs(step.name, swc)),
        *(_tell(each, swc) for each in swc.told),
        _publish(swc),
    ]


def _outputs(call: str, swc: SwcPlan) -> list[DataEnd]:
    return [end for end in swc.sent if end.call == call]


def _send(call: str, swc: SwcPlan) -> Lines:
    head = f"static void {static(swc, f'Send_{call}')}(void)"
    ends = _outputs(call, swc)
    reasons = [
        "A value that is not taken is followed by that of the next step." if any(_is_repeated(each, swc) for each in ends) else "",
        "A receiver whose queue is full is told so by its RTE." if any(each.is_queue for each in ends) else "",
    ]  # fmt: skip
    comment = " ".join(filter(None, ["What the call provides.", *reasons]))
    return function(head, [_sent(end, swc) for end in ends], comment)


def _is_repeated(end: DataEnd, swc: SwcPlan) -> bool:
    """Whether each step of a cycle sends it anew."""
    return not end.is_queue and any(step.name == end.call and step.cycle for step in swc.core.steps)


def _is_kept(end: DataEnd, swc: SwcPlan) -> bool:
    """Whether others would have an old value until it changes, if the RTE does not take it."""
    return not end.is_queue and not _is_repeated(end, swc)


def unsent(swc: SwcPlan) -> Lines:
    """What is sent again until it is taken."""
    kept = [lines(f"boolean {end.place}; {block_comment(end.comment)}") for end in swc.sent if _is_kept(end, swc)]
    if swc.mode_out:
        kept.append(lines(f"boolean {swc.mode_out.place}; /* mode */"))
    told = [lines(f"boolean {each.error.named.name}; {block_comment(each.error.named.comment)}") for each in swc.told]
    return spaced([
        _flags("What the RTE has not taken: it is sent again with what comes next.", "Unsent", kept, swc),
        _flags("Verdicts that the diagnosis has not taken: it is told again.", "Untold", told, swc),
    ])  # fmt: skip


def _flags(comment: str, name: str, flags: list[Lines], swc: SwcPlan) -> Lines:
    return (
        joined([lines(block_comment(comment)), block("static struct", flags, f"}} {static(swc, name)};")])
        if flags
        else ()
    )


def sends(call: str, swc: SwcPlan) -> list[Lines]:
    """Sends the outputs of a call that has ended, and notes what it asks for; in the exclusive area."""
    core = core_object(swc)
    return [
        lines(f"{static(swc, f'Send_{call}')}();") if _outputs(call, swc) else (),
        *(lines(f"const boolean asks_{each.method.named.name} = {core}.publish.{each.method.named.name} ? TRUE : FALSE;")
          for each in _used(call, swc)),
    ]  # fmt: skip


def requests(call: str, swc: SwcPlan) -> list[Lines]:
    """Requests of a call that has ended; outside of the exclusive area."""
    return [
        block(f"if (asks_{each.method.named.name} != FALSE)", [lines(f"{_request_name(each, swc)}();")])
        for each in _used(call, swc)
    ]


def _used(call: str, swc: SwcPlan) -> list[MethodEnd]:
    return [each for each in swc.requests if each.method.call == call]


def _publish(swc: SwcPlan) -> Lines:
    body = [
        enter(swc),
        *(_noted_status(each, swc) for each in swc.told),
        lines("") if swc.told else (),
        *(_sent(end, swc, is_again=True) for end in swc.sent if _is_kept(end, swc)),
        _switched(swc.mode_out, swc) if swc.mode_out else (),
        lines(f"{swc.core.type_name}_Published({at_core(swc)});"),
        leave(swc),
        *(_told(each, swc) for each in swc.told),
    ]
    head = f"static void {static(swc, 'Publish')}(void)"
    return function(
        head, body, "What the core may say at any time. The diagnosis is told outside of the exclusive area."
    )


def _noted_status(told: Told, swc: SwcPlan) -> Lines:
    name = told.error.named.name
    untold = f"{static(swc, 'Untold')}.{name}"
    said = f"{core_object(swc)}.publish.{name}"
    return lines(f"const boolean tells_{name} = ({said} || ({untold} != FALSE)) ? TRUE : FALSE;")


def _failed(told: Told, core: str) -> str:
    return f"({core}.out.{told.error.named.name} == {told.error.failed}U)"


def _sent(end: DataEnd, swc: SwcPlan, *, is_again: bool = False) -> Lines:
    """Sent if the core says so; or again, if it was not taken."""
    core = core_object(swc)
    place = f"{core}.out.{end.place}"
    api = "Send" if end.is_queue else "Write"
    if end.has_count:
        each = _given(end, f"{place}.values[k]", api, swc)
        sent = block(f"for (uint32 k = 0U; k < {place}.count; k++)", [each])
    else:
        sent = _given(end, place, api, swc)
    return block(f"if ({_wanted(end.place, is_said=not is_again or not end.call, is_again=is_again, swc=swc)})", [sent])


def _wanted(place: str, *, is_said: bool, is_again: bool, swc: SwcPlan) -> str:
    said, again = f"{core_object(swc)}.publish.{place}", f"({_unsent(place, swc)} != FALSE)"
    if is_said and is_again:
        return f"{said} || {again}"
    return said if is_said else again.removeprefix("(").removesuffix(")")


def _unsent(place: str, swc: SwcPlan) -> str:
    return f"{static(swc, 'Unsent')}.{place}"


def _until_taken(place: str, call: str, swc: SwcPlan) -> Lines:
    return lines(
        f"const Std_ReturnType status = {call};\n\n{_unsent(place, swc)} = (status != RTE_E_OK) ? TRUE : FALSE;"
    )


def _given(end: DataEnd, source: str, api: str, swc: SwcPlan) -> Lines:
    copy = Copy(swc.core, to_core=False)
    given = copy.number(source, end.type) if end.type.is_number else by_value(end.type, "value")
    call = f"Rte_{api}_{end.name}({given})"
    sent = _until_taken(end.place, call, swc) if _is_kept(end, swc) else lines(f"(void){call};")
    if end.type.is_number:
        return sent
    return joined(
        [
            lines(f"{end.type.name} value;\n"),
            copy.of("value", source, end.type, end.wire.c),
            sent,
        ]
    )


def _switched(mode: ModeEnd, swc: SwcPlan) -> Lines:
    """A transition that waits may leave no room for this one: the mode is said until it is taken."""
    switch = f"Rte_Switch_{mode.name}(({mode.type}){core_object(swc)}.out.{mode.place})"
    wanted = _wanted(mode.place, is_said=True, is_again=True, swc=swc)
    return block(f"if ({wanted})", [_until_taken(mode.place, switch, swc)])


def _told(told: Told, swc: SwcPlan) -> Lines:
    name = told.error.named.name
    return block(f"if (tells_{name} != FALSE)", [lines(f"{static(swc, f'Tell_{name}')}();")])


def _tell(told: Told, swc: SwcPlan) -> Lines:
    """Report outside of the exclusive area, where other runnables may change the verdict meanwhile.

    The loop has a bound. A verdict that has changed again after the last turn is noted, and the next runnable reports it.
    """
    name, failed = told.error.named.name, _failed(told, core_object(swc))
    status = "(has_failed != FALSE) ? DEM_EVENT_STATUS_FAILED : DEM_EVENT_STATUS_PASSED"
    untold = f"{static(swc, 'Untold')}.{name}"
    body = [
        lines("boolean is_last = FALSE;"),
        lines(""),
        block(f"for (uint32 turn = 0U; (turn < {_TURNS}U) && (is_last == FALSE); turn++)", [
            enter(swc), lines(f"const boolean has_failed = {failed} ? TRUE : FALSE;"), leave(swc),
            lines(f"const Std_ReturnType status = Rte_Call_{told.port}_{told.operation}({status});"), lines(""),
            enter(swc),
            lines(f"is_last = ({failed} == (has_failed != FALSE)) ? TRUE : FALSE;\n"
                  f"{untold} = ((status != RTE_E_OK) || (is_last == FALSE)) ? TRUE : FALSE;"),
            leave(swc),
        ]),
    ]  # fmt: skip
    comment = f"{told.error.named.comment}: a verdict that changes meanwhile is reported too, a further change by the next runnable."
    return function(f"static void {static(swc, f'Tell_{name}')}(void)", body, comment)


# -- methods that the function uses -------------------------------------------------------------------------------


def _request_name(end: MethodEnd, swc: SwcPlan) -> str:
    return static(swc, f"Request_{end.method.named.name}")


def _request(end: MethodEnd, swc: SwcPlan) -> Lines:
    """A request that nobody takes is answered at once: it has failed."""
    name, core = end.method.named.name, core_object(swc)
    place = f"{core}.method.{name}"
    copy = Copy(swc.core, to_core=False)
    parts: list[Lines] = [lines(f"{each.type.name} given_{each.name};") for each in end.arguments]
    fills = [
        copy.of(f"given_{each.name}", f"{place}.arguments.{each.place}", each.type, each.wire.c)
        for each in end.arguments
    ]
    given = ", ".join(by_value(each.type, f"given_{each.name}") for each in end.arguments)
    results = ", &none" if end.results else ""
    none = (
        [lines(f"{swc.core.type_name}_{name}_Results none;\n\n(void)memset(&none, 0, sizeof(none));")]
        if end.results else []
    )  # fmt: skip
    failed = block(f"if (Rte_Call_{end.name}({given}) != RTE_E_OK)", [
        *none,
        enter(swc),
        lines(f"{swc.core.type_name}_Answer_{name}({at_core(swc)}, {place}.number, false{results}, {static(swc, 'Now')}());"),
        leave(swc),
    ])  # fmt: skip
    locked = [enter(swc), *fills, leave(swc)] if fills else []
    body = [*parts, lines("") if parts else (), *locked, failed]
    return function(f"static void {_request_name(end, swc)}(void)", body, end.method.named.comment)
