"""The context struct: everything that one adapter knows."""

from collections.abc import Iterable

from sigcat.adapter.core.c import inputs, life, methods
from sigcat.adapter.core.c.lines import Line, Lines, block, indented, joined, lines, spaced
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.types import member
from sigcat.adapter.core.c.values import declared
from sigcat.adapter.core.plan import (
    CLASS,
    GLOBALS,
    Call,
    Input,
    Method,
    Output,
    Parameter,
    Port,
    Reaction,
    WireType,
)
from sigcat.adapter.text_filters import AnyText, block_comment


def context_struct(scope: Scope) -> Lines:
    plan, p = scope.plan, scope.prefix
    members = [
        _received(scope),
        *(_call_state(call, scope) for call in plan.steps),
        _group("mode", _mode_members(scope)),
        _group("mode_out", [lines("bool is_known;")] if plan.mode_out else []),
        _group("checkpoint", _checkpoint_members(scope)),
        _group("error", [lines(f"{p}_Error {each.named.name}; {block_comment(each.named.comment)}") for each in plan.errors]),
        _group("reaction", [_reaction(each, scope) for each in plan.reactions]),
        _group("method", [_request(each, scope) for each in plan.methods if not each.is_offered]),
        _group("parameter", [_parameter(each, scope) for each in plan.parameters]),
        lines(f"{p}_Stored stored;"),
        _group("out", _out(scope), "What is sent, in the catalogue's units."),
        _group("publish", _publish(scope), "What is to be sent now."),
        _objects(scope),
        lines("""
            uint64_t now; /* the last time that was given */
            bool is_ready; /* whether init was good */
            bool is_started;
            bool is_terminated;
        """),
    ]  # fmt: skip
    before = Line(block_comment(f"The adapter of one {plan.function}. Zero it before the first Init."))
    return (before, Line(f"typedef struct {p} {{"), *indented(spaced(members)), Line(f"}} {p};"))


def _group(name: str, members: Iterable[Lines], comment: AnyText = "") -> Lines:
    found = [member for member in members if member]
    if not found:
        return ()
    before = (Line(block_comment(comment)),) if comment else ()
    return (*before, *block("struct", found, f"}} {name};"))


def _received(scope: Scope) -> Lines:
    plan, p = scope.plan, scope.prefix
    status = [
        *((each.wire, each.name, each.comment) for each in plan.foreign_errors),
        *([(plan.mode_in.wire, plan.mode_in.named.name, plan.mode_in.named.comment)] if plan.mode_in else []),
    ]
    members = [
        *(_port(port, scope) for port in plan.ports),
        *(_received_member(wire, name, comment, p) for wire, name, comment in status),
    ]
    return _group("received", members, "What has been received, in the catalogue's units.")


def _port(port: Port, scope: Scope) -> Lines:
    e2e = f" {scope.prefix}_Verdict e2e;" if port.tells_of_rejection else ""
    reception = f"{scope.prefix}_Reception reception;{e2e}"
    if not inputs.is_kept(port):
        return lines(f"struct {{ {reception} }} {port.name}; {block_comment(port.comment)}")
    return lines(f"struct {{ {declared(port.wire, 'value')}; {reception} }} {port.name}; {block_comment(port.comment)}")


def _received_member(wire: WireType, name: str, comment: str, prefix: str) -> Lines:
    return lines(
        f"struct {{ {declared(wire, 'value')}; {prefix}_Reception reception; }} {name}; {block_comment(comment)}"
    )


def _call_state(call: Call, scope: Scope) -> Lines:
    p = scope.prefix
    members = [
        lines("uint64_t entered; /* when its clocks have started */"),
        lines("uint64_t release; /* when it is due next */") if call.cycle is not None else (),
        lines("uint64_t begun; /* when it was called last */"),
        lines("uint32_t events; /* that wait */") if call.cycle is None else (),
        lines("uint32_t missed;") if call.cycle is not None else (),
        lines("uint32_t dropped; /* activations that the mode excluded */"),
        lines("bool is_active; /* from the answer of NextCall to the end of GetOutput */"),
        lines("bool is_running; /* from Begin to GetOutput */") if call.deadline else (),
        lines("bool has_begun;") if call.debounce else (),
        lines("bool has_ended;") if any(call.name in other.previous for other in scope.plan.steps) else (),
        lines(f"{p}_Verdict overrun;") if call.overrun_error else (),
        _alive(call, scope),
        lines(f"{p}_Verdict deadline;") if call.deadline else (),
        _group("in", [_input_state(item, scope) for item in call.inputs]),
        _group("reaction", [
            lines(f"{p}_Clock {each.named.name};")
            for each in scope.plan.reactions if call.name in each.calls and each.time_out is not None
        ]),
        _group("out", [_output_state(output, scope) for output in call.outputs]),
    ]  # fmt: skip
    return (Line(block_comment(call.interface)), *block("struct", members, f"}} {call.name};"))


def _alive(call: Call, scope: Scope) -> Lines:
    if call.alive is None:
        return ()
    members = lines(f"""
        {scope.prefix}_Verdict verdict;
        uint64_t window; /* its beginning */
        uint32_t ends; /* in this window */
        bool has_closed; /* whether one has since it was judged */
        bool is_bad; /* whether one of those was */
    """)
    return block("struct", [members], "} alive;")


def _reaction(reaction: Reaction, scope: Scope) -> Lines:
    timed = lines(f"{scope.prefix}_Reception reception;") if reaction.time_out is not None else ()
    return _state([lines(f"{scope.prefix}_Verdict outside;"), timed], reaction.named.name)


def _parameter(parameter: Parameter, scope: Scope) -> Lines:
    members = [
        lines(f"{declared(parameter.value.wire, 'value')}; {block_comment(parameter.named.comment)}"),
        lines(f"{scope.prefix}_Origin origin;"),
        lines(f"{scope.prefix}_Verdict range;") if parameter.range_error else (),
    ]
    return block("struct", members, f"}} {parameter.named.name};")


def _input_state(item: Input, scope: Scope) -> Lines:
    p, queue = scope.prefix, item.queue
    members = [
        lines(
            f"{declared(item.value.wire, f'values[{queue.length}]')};\nuint32_t first;\nuint32_t waiting;\nbool is_overflown;"
        )
        if queue
        else (),
        _kept(item, scope),
        lines(f"{p}_Clock clock;") if item.time_out else (),
        lines(f"{p}_Verdict range;") if item.range_error else (),
        lines(f"{p}_Verdict overflow;") if queue and queue.overflow_error else (),
        lines(f"{p}_Verdict e2e;\nbool is_rejected;") if item.e2e_error else (),
        lines("bool is_set;") if item.is_reset else (),
    ]
    return _state(members, item.named.name)


def _kept(item: Input, scope: Scope) -> Lines:
    if not inputs.keeps(item):
        return ()
    count = inputs.places(item)
    return lines(f"{declared(item.value.wire, f'kept[{count}]')};\n{scope.prefix}_Origin origin[{count}];")


def _output_state(output: Output, scope: Scope) -> Lines:
    members = [
        lines(f"{scope.prefix}_Verdict range;") if output.range_error else (),
        lines(f"{scope.prefix}_Verdict overflow;") if output.queue and output.queue.overflow_error else (),
    ]
    return _state(members, output.named.name)


def _state(members: list[Lines], name: str) -> Lines:
    """What is known of an input or output, on one line if it is one thing."""
    whole = joined(members)
    if len(whole) == 1:
        return lines(f"struct {{ {whole[0].text} }} {name};")
    return block("struct", members, f"}} {name};") if whole else ()


def _mode_members(scope: Scope) -> list[Lines]:
    mode = scope.plan.mode_in
    return [lines(f"{mode.wire.c} now;\n{scope.prefix}_Verdict unknown;")] if mode else []


def _checkpoint_members(scope: Scope) -> list[Lines]:
    if not life.has_checkpoints(scope):
        return []
    plan = scope.plan
    verdicts = [
        lines(f"{scope.prefix}_Verdict {call.name};") for call in plan.calls if call.logical and call.logical.error
    ]
    return [lines("uint32_t active; /* 0: none */"), *verdicts]


def _request(method: Method, scope: Scope) -> Lines:
    members = [
        lines(f"{methods.arguments_type(method, scope)} arguments;") if method.arguments else (),
        lines(f"{methods.results_type(method, scope)} answer;") if method.results else (),
        lines("uint64_t since;\nuint32_t number;\nuint8_t status;\nbool is_answered;\nbool is_ok;"),
    ]
    return block("struct", members, f"}} {method.named.name};")


def _out(scope: Scope) -> list[Lines]:
    plan = scope.plan
    statuses = (member(each.wire, each.named.name, each.named.comment) for each in plan.statuses)
    return [*map(_out_member, plan.outputs), *statuses]


def _out_member(output: Output) -> Lines:
    wire, named = output.value.wire, output.named
    if output.queue is None:
        return member(wire, named.name, named.comment)
    values = declared(wire, f"values[{output.queue.length}]")
    return lines(f"struct {{ uint32_t count; {values}; }} {named.name}; {block_comment(named.comment)}")


def _publish(scope: Scope) -> list[Lines]:
    plan = scope.plan
    return [lines(f"bool {each.named.name};") for each in (*plan.outputs, *plan.statuses, *plan.requests)]


def _objects(scope: Scope) -> Lines:
    code = scope.plan.code
    if code.signature == GLOBALS:
        return ()
    held = _group("code", [lines(f"{each.type} {each.name};", ("Code",)) for each in code.objects],
                  "What the code of the function works on.")  # fmt: skip
    return joined([held, lines(f"{code.class_name} object;", ("Code",)) if code.signature == CLASS else ()])


def received_status(scope: Scope) -> list[tuple[str, WireType]]:
    """Errors of others, and the mode."""
    plan = scope.plan
    return [
        *((each.name, each.wire) for each in plan.foreign_errors),
        *([(plan.mode_in.named.name, plan.mode_in.wire)] if plan.mode_in else []),
    ]


def status_head(name: str, wire: WireType, scope: Scope) -> str:
    """The head of the function that takes a status."""
    return f"void {scope.prefix}_Receive_{name}({scope.self_argument}, {wire.c} value, uint64_t t)"
