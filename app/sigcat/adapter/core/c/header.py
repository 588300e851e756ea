"""The header: types, what the adapter holds, and what the platform calls."""

from collections.abc import Iterable

from sigcat.adapter.core.c import errors, inputs, life, methods, parameters
from sigcat.adapter.core.c.lines import Line, Lines, block, indented, joined, lines, spaced
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import declared
from sigcat.adapter.core.identifiers import string
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
    WireField,
    WireStruct,
    WireType,
)


def header(scope: Scope, title: Lines) -> Lines:
    """The whole header."""
    guard = scope.constant("H")
    parts = [
        title,
        lines(f"#ifndef {guard}\n#define {guard}"),
        _includes(scope),
        _instances(scope),
        _extern_c(begins=True),
        *_types(scope),
        _context(scope),
        _single(scope),
        _hooks(scope),
        *_functions(scope),
        _extern_c(begins=False),
        lines(f"#endif /* {guard} */"),
    ]
    return spaced(parts)


def _extern_c(*, begins: bool) -> Lines:
    brace = 'extern "C" {' if begins else "}"
    return lines(f"#ifdef __cplusplus\n{brace}\n#endif")


def _includes(scope: Scope) -> Lines:
    own = [f"#include {string(name)}" for name in scope.plan.code.headers]
    return lines("\n".join(["#include <stdbool.h>", "#include <stdint.h>", *([""] if own else []), *own]), ("Code",))


def _instances(scope: Scope) -> Lines:
    if scope.plan.code.signature != GLOBALS:
        return ()
    macro = scope.constant("INSTANCES")
    return lines(f"""
        /* {scope.plan.function} keeps its data in global variables: a process has one of it. */
        #ifndef {macro}
        #define {macro} 1
        #endif
        #if {macro} != 1
        #error "{scope.plan.function} keeps its data in global variables: there can be one instance of it"
        #endif
    """)


def _single(scope: Scope) -> Lines:
    if scope.plan.code.signature != GLOBALS:
        return ()
    return lines(f"""
        /* The one instance. */
        extern {scope.prefix} {scope.prefix}_Instance;
    """)


def enumeration(name: str, constants: Iterable[tuple[str, str]]) -> Lines:
    """An enumeration; each constant with what it means."""
    found = list(constants)
    rows = [f"    {text}{',' if n < len(found) - 1 else ''}{f' /* {why} */' if why else ''}"
            for n, (text, why) in enumerate(found)]  # fmt: skip
    return tuple(Line(text) for text in ("typedef enum {", *rows, f"}} {name};"))


def struct(name: str, members: Iterable[Lines], comment: str = "") -> Lines:
    """A struct type."""
    before = (Line(f"/* {comment} */"),) if comment else ()
    return (*before, Line("typedef struct {"), *indented(joined(members)), Line(f"}} {name};"))


def _types(scope: Scope) -> list[Lines]:
    p, c, plan = scope.prefix, scope.constant, scope.plan
    calls = [(f"{c('NO_CALL')} = 0", "none is due"), *((scope.call(call.name), call.interface) for call in plan.steps)]
    found = [
        enumeration(f"{p}_Call", calls),
        enumeration(f"{p}_Verdict", [(f"{c('NOT_JUDGED')} = 0", ""), (c("ABSENT"), ""), (c("PRESENT"), "")]),
        enumeration(f"{p}_Origin", [(c(name), "") for name in
                    ("INIT", "RECEIVED", "DEFAULT", "REPLACEMENT")]) if uses_origin(scope) else (),
        *([_states(scope), _error(scope), _counts(scope)] if plan.errors else []),
        enumeration(f"{p}_Reply", [(c("OK"), ""), (c("EXCLUDED"), "the mode excludes it, or init has failed"),
                    (c("BAD_ARGUMENT"), "")]) if any(each.is_offered for each in plan.methods) else (),
        struct(f"{p}_Reception", [lines("uint64_t time;\nuint32_t count;\nbool is_there;")],
               "When a value was received last, and how many there were."),
        struct(f"{p}_Clock", [lines(f"{p}_Verdict verdict;\nuint32_t count;\nbool is_late;")],
               "Whether a value is late.") if uses_clock(scope) else (),
        *(_wire_struct(each) for each in plan.structs),
        *(part for method in plan.methods for part in _method_types(method, scope)),
        _parameters(scope),
        _stored(scope),
    ]  # fmt: skip
    return [part for part in found if part]


def uses_origin(scope: Scope) -> bool:
    """Whether any input is more than an assignment, or there are parameters."""
    has_inputs = any(not inputs.is_direct(item) for call in scope.plan.steps for item in call.inputs)
    return has_inputs or bool(scope.plan.parameters)


def uses_clock(scope: Scope) -> bool:
    """Whether anything can be late."""
    late_inputs = any(item.time_out for call in scope.plan.steps for item in call.inputs)
    return late_inputs or any(each.time_out is not None for each in scope.plan.reactions)


def _states(scope: Scope) -> Lines:
    names = ("NOT_TESTED", "PASSED", "PREFAILED", "FAILED", "HEALING")
    return enumeration(f"{scope.prefix}_ErrorState", [
        (f"{scope.constant(name)}{' = 0' if not number else ''}", "") for number, name in enumerate(names)
    ])  # fmt: skip


def _error(scope: Scope) -> Lines:
    p = scope.prefix
    members = lines(f"""
        {p}_ErrorState state;
        {p}_ErrorState before; /* that of before PREFAILED */
        uint64_t since; /* when PREFAILED or HEALING began */
        {p}_Verdict variable; /* what the function says */
        bool is_confirmed; /* for the fault memory */
        bool is_sent;
    """)
    return struct(f"{p}_Error", [members], "An error.")


def _counts(scope: Scope) -> Lines:
    members = lines("uint16_t occurrences;\nuint16_t ignition_cycles;\nbool has_failed;\nbool is_tested;")
    return struct(
        f"{scope.prefix}_Counts", [members], "Counts of an error, over ignition cycles; the flags are of this one."
    )


def _wire_struct(each: WireStruct) -> Lines:
    return struct(each.name, [_field(field) for field in each.fields], each.comment)


def _field(field: WireField) -> Lines:
    length = f"[{field.length}]" if field.length is not None else ""
    return lines(f"{field.c} {field.name}{length};{f' /* {field.comment} */' if field.comment else ''}")


def _member(wire: WireType, name: str, comment: str) -> Lines:
    return lines(f"{declared(wire, name)}; /* {comment} */")


def _method_types(method: Method, scope: Scope) -> list[Lines]:
    found = []
    for items, name in ((method.arguments, methods.arguments_type), (method.results, methods.results_type)):
        if items:
            members = [lines(f"{declared(each.value.wire, each.name)};") for each in items]
            found.append(struct(name(method, scope), members))
    return found


def _parameters(scope: Scope) -> Lines:
    members = [_member(each.value.wire, each.named.name, each.named.comment) for each in parameters.settable(scope)]
    if not members:
        return ()
    return struct(f"{scope.prefix}_Parameters", members, "Parameters, in the catalogue's units.")


def _stored(scope: Scope) -> Lines:
    counts = [lines(f"{scope.prefix}_Counts {each.named.name};") for each in scope.plan.errors]
    kept = [
        block("struct", [lines(f"{declared(each.value.wire, 'value')};\nbool is_there;")], f"}} {each.named.name};")
        for each in scope.plan.parameters
    ]
    members = [lines("uint32_t ignition_cycle;\nbool has_cycle;"), *counts, *kept]
    return struct(f"{scope.prefix}_Stored", members, "What is kept from one run to the next: stored by the platform.")


# -- the context --------------------------------------------------------------------------------------------------


def _context(scope: Scope) -> Lines:
    plan, p = scope.plan, scope.prefix
    members = [
        _received(scope),
        *(_call_state(call, scope) for call in plan.steps),
        _group("mode", _mode_members(scope)),
        _group("mode_out", [lines("bool is_known;")] if plan.mode_out else []),
        _group("checkpoint", _checkpoint_members(scope)),
        _group("error", [lines(f"{p}_Error {each.named.name}; /* {each.named.comment} */") for each in plan.errors]),
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
    before = Line(f"/* The adapter of one {plan.function}. Zero it before the first Init. */")
    return (before, Line(f"typedef struct {p} {{"), *indented(spaced(members)), Line(f"}} {p};"))


def _group(name: str, members: Iterable[Lines], comment: str = "") -> Lines:
    found = [member for member in members if member]
    if not found:
        return ()
    before = (Line(f"/* {comment} */"),) if comment else ()
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
    if not inputs.is_kept(port):
        return lines(f"struct {{ {scope.prefix}_Reception reception; }} {port.name}; /* {port.comment} */")
    return _received_member(port.wire, port.name, port.comment, scope.prefix)


def _received_member(wire: WireType, name: str, comment: str, prefix: str) -> Lines:
    return lines(f"struct {{ {declared(wire, 'value')}; {prefix}_Reception reception; }} {name}; /* {comment} */")


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
    return (Line(f"/* {call.interface} */"), *block("struct", members, f"}} {call.name};"))


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
        lines(f"{declared(parameter.value.wire, 'value')}; /* {parameter.named.comment} */"),
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
    found = [_out_member(output) for call in plan.steps for output in call.outputs]
    status = [*((each.wire, each.named) for each in plan.errors), *((each.wire, each.named) for each in plan.reactions)]
    status += [(plan.mode_out.wire, plan.mode_out.named)] if plan.mode_out else []
    return [*found, *(_member(wire, named.name, named.comment) for wire, named in status)]


def _out_member(output: Output) -> Lines:
    wire, named = output.value.wire, output.named
    if output.queue is None:
        return _member(wire, named.name, named.comment)
    values = declared(wire, f"values[{output.queue.length}]")
    return lines(f"struct {{ uint32_t count; {values}; }} {named.name}; /* {named.comment} */")


def _publish(scope: Scope) -> list[Lines]:
    plan = scope.plan
    names = [
        *(output.named.name for call in plan.steps for output in call.outputs),
        *(each.named.name for each in plan.errors),
        *(each.named.name for each in plan.reactions),
        *([plan.mode_out.named.name] if plan.mode_out else []),
        *(each.named.name for each in plan.methods if not each.is_offered),
    ]
    return [lines(f"bool {name};") for name in names]


def _objects(scope: Scope) -> Lines:
    code = scope.plan.code
    if code.signature == GLOBALS:
        return ()
    held = _group("code", [lines(f"{each.type} {each.name};", ("Code",)) for each in code.objects],
                  "What the code of the function works on.")  # fmt: skip
    return joined([held, lines(f"{code.class_name} object;", ("Code",)) if code.signature == CLASS else ()])


# -- functions ----------------------------------------------------------------------------------------------------


def _hooks(scope: Scope) -> Lines:
    plan = scope.plan
    names = dict.fromkeys(hook for call in plan.calls for hook in (*call.before, *call.after))
    if not names:
        return ()
    return joined([lines("/* Of the project: called before and after calls. */"),
                   *(lines(f"void {name}({scope.self_argument});") for name in names)])  # fmt: skip


def _functions(scope: Scope) -> list[Lines]:
    p, plan, s = scope.prefix, scope.plan, scope.self_argument
    used = [each for each in plan.methods if not each.is_offered]
    learns = f"bool {p}_SetParameters({s}, const {p}_Parameters *parameters);"
    found = [
        _prototypes("Once, first; NULL: nothing is stored. False: init of the function has failed.",
                    [f"bool {p}_Init({s}, const {p}_Stored *stored, uint32_t ignition_cycle);"]),
        _prototypes("Clocks start, t in ns.", [f"void {p}_Start({s}, uint64_t t);"]),
        _prototypes("A value has come. From any thread, under the lock.",
                    [f"{head};" for head in receive_heads(scope)]),
        _prototypes("Which call is due, until none is. Under the lock.",
                    [f"{p}_Call {p}_NextCall({s}, uint64_t t);", f"uint64_t {p}_NextTime(const {p} *self);"]),
        *(_prototypes(f"{call.interface}: all but Run under the lock.", [
            f"void {p}_SetInput_{call.name}({s}, uint64_t t);", f"void {p}_Begin_{call.name}({s}, uint64_t t);",
            f"void {p}_Run_{call.name}({s});", f"void {p}_GetOutput_{call.name}({s}, uint64_t t);",
        ]) for call in plan.steps),
        _prototypes("Now and then, also while a call runs. Under the lock.", [f"void {p}_Supervise({s}, uint64_t t);"]),
        _prototypes("A request has come, and no call runs.",
                    [f"{methods.offered_head(each, scope)};" for each in plan.methods if each.is_offered]),
        _prototypes("The answer to a request. Under the lock.", [f"{methods.answer_head(each, scope)};" for each in used]),
        _prototypes("All of them, or none if one is out of range. Under the lock.", [learns] if parameters.settable(scope) else []),
        _prototypes("What `publish` names has been sent.", [f"void {p}_Published({s});"]),
        _prototypes("At the end. No call may run; afterwards, `stored` is to be stored.",
                    [f"void {p}_Terminate({s}, uint64_t t);"]),
    ]  # fmt: skip
    return [part for part in found if part]


def _prototypes(comment: str, heads: list[str]) -> Lines:
    return tuple(Line(text) for text in (f"/* {comment} */", *heads)) if heads else ()


def receive_heads(scope: Scope) -> list[str]:
    """Heads of all functions that take what comes."""
    return [
        *(inputs.receive_head(port, scope) for port in scope.plan.ports),
        *(errors.reaction_head(reaction, scope) for reaction in scope.plan.reactions),
        *(status_head(name, wire, scope) for name, wire in received_status(scope)),
    ]


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
