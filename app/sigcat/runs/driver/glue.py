"""A function, bound to the driver: a file in its own language that calls its adapter by name."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.lines import Line, Lines, block, joined, lines, spaced
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import GLOBALS, Call, Method, WireField, WireStruct, WireType
from sigcat.adapter.files import GeneratedFile
from sigcat.function.document.text_filters import c_header
from sigcat.runs.connections import Connections, Entry, Exit, Member, Server, answer_struct, request_struct
from sigcat.runs.driver.numbering import Numbers, bytes_of_largest
from sigcat.runs.kept import Kept


class _Glue(NamedTuple):
    """What is written: the names of a function, and what it receives, sends and keeps."""

    scope: Scope
    entries: tuple[Entry, ...]
    exits: tuple[tuple[int, Exit], ...]
    kept: tuple[tuple[int, Kept], ...]
    first_call: int
    largest: int
    """Bytes of the largest value that is sent or kept, or handed over with a request."""
    servers: Mapping[str, Server]
    """Who answers a method that it uses, by the name of what takes the answer."""

    @property
    def p(self) -> str:
        """What the names of the adapter begin with."""
        return self.scope.prefix

    @property
    def d(self) -> str:
        """What the names of this file begin with."""
        return f"{self.scope.plan.function}_Driver"

    @property
    def instance(self) -> str:
        return f"{self.p}_Instance" if self.scope.plan.code.signature == GLOBALS else f"{self.d}_Instance"

    @property
    def handed_over(self) -> list[WireStruct]:
        """Arguments and results of methods."""
        plan = self.scope.plan
        return [
            struct(each, plan) for each in plan.methods for struct in (request_struct, answer_struct)
            if struct(each, plan).fields
        ]  # fmt: skip

    @property
    def at(self) -> str:
        return f"&{self.instance}"


def glue_file(connections: Connections, numbers: Numbers, index: int) -> GeneratedFile:
    """The file of one function."""
    member = connections.members[index]
    glue = _Glue(
        Scope(member.plan),
        tuple(each for each in connections.entries if each.member == index),
        tuple((number, each) for number, each in enumerate(connections.exits) if each.member == index),
        tuple((number, each) for number, each in enumerate(numbers.kept) if each.member == index),
        numbers.first_call(index),
        bytes_of_largest(connections, numbers),
        {connections.entries[entry].receiver: server for entry, server in connections.servers.items()
         if connections.entries[entry].member == index},
    )  # fmt: skip
    text = "\n".join(line.text for line in _whole(glue, member))
    return GeneratedFile(f"{member.name}_driver.{member.plan.code.ending}", f"{text}\n".encode())


def _whole(glue: _Glue, member: Member) -> Lines:
    return spaced([
        lines(f'#include {c_header(member.plan.header_file)}\n#include "sigcat_driver.h"\n\n#include <string.h>'),
        _data(glue),
        *_struct_functions([*glue.scope.plan.structs, *glue.handed_over]),
        _restore(glue), _store(glue), _start_up(glue), _start(glue), _receive(glue),
        _next_call(glue), _next_time(glue),
        *(_of_calls(glue, what, "uint64_t t", "t") for what in ("SetInput", "Begin")),
        _of_calls(glue, "Run", "", ""), _of_calls(glue, "GetOutput", "uint64_t t", "t"),
        _plain(glue, "Supervise"), _send(glue), _serve(glue), _plain(glue, "Terminate"),
        _table(glue),
    ])  # fmt: skip


def _data(glue: _Glue) -> Lines:
    own = "" if glue.instance == f"{glue.p}_Instance" else f"static {glue.p} {glue.instance};\n"
    size = f"enum {{ SIGCAT_BYTES = {glue.largest} }};\n"
    kept = lines(f"{size}{own}static {glue.p}_Stored {glue.d}_Kept;\nstatic bool {glue.d}_HasKept;")
    answers = (_answer_data(glue, entry) for entry in glue.entries if entry.is_answer)
    return joined([kept, *answers])


def _answer_data(glue: _Glue, entry: Entry) -> Lines:
    name = f"{glue.d}_{entry.receiver}"
    return lines(f"static {entry.wire.c} {name}_Answer;\nstatic bool {name}_HasAnswer;")


def _function(head: str, body: Iterable[Lines]) -> Lines:
    return block(f"static {head}", body)


def _switch(number: str, cases: Sequence[tuple[str, Lines]], default: str = "break;") -> Lines:
    parts = [block(f"case {label}:", [body, lines("break;")]) for label, body in cases]
    return block(f"switch ({number})", [*parts, lines(f"default: {default}")])


# -- values -------------------------------------------------------------------------------------------------------


def _struct_functions(structs: Sequence[WireStruct]) -> list[Lines]:
    known = {struct.name for struct in structs}
    found = []
    for struct in structs:
        for way, bytes_, value in (("take", "const unsigned char", ""), ("put", "unsigned char", "const ")):
            body = joined(_field(field, way, known) for field in struct.fields)
            head = f"{bytes_} *{way}_{struct.name}({bytes_} *at, {value}{struct.name} *value)"
            found.append(_function(head, [body, lines("return at;")]))
    return found


def _field(field: WireField, way: str, known: set[str]) -> Lines:
    if field.c not in known:
        return lines(f"at = sigcat_{way}(at, &value->{field.name}, sizeof(value->{field.name}));")
    if field.length is None:
        return lines(f"at = {way}_{field.c}(at, &value->{field.name});")
    each = lines(f"at = {way}_{field.c}(at, &value->{field.name}[i]);")
    return block(f"for (uint32_t i = 0; i < {field.length}U; i++)", [each])


def _moved(wire: WireType, place: str, way: str) -> Lines:
    """A value taken from `at`, or put there; which is after it then."""
    if not wire.is_struct:
        return lines(f"at = sigcat_{way}(at, &{place}, sizeof({place}));")
    if wire.length is None:
        return lines(f"at = {way}_{wire.c}(at, &{place});")
    return block(f"for (uint32_t i = 0; i < {wire.length}U; i++)", [lines(f"at = {way}_{wire.c}(at, &{place}[i]);")])


def _declared(wire: WireType, name: str) -> str:
    return f"{wire.c} {name}{f'[{wire.length}]' if wire.length is not None else ''}"


# -- receiving and sending ----------------------------------------------------------------------------------------


def _receive(glue: _Glue) -> Lines:
    cases = []
    for number, entry in enumerate(glue.entries):
        if entry.is_answer:
            name = f"{glue.d}_{entry.receiver}"
            took = joined([_moved(entry.wire, f"{name}_Answer", "take"), lines(f"{name}_HasAnswer = true;")])
            cases.append((f"{number}U", took))
            continue
        value = "&value" if entry.wire.is_struct and entry.wire.length is None else "value"
        cases.append((f"{number}U", joined([
            lines(f"{_declared(entry.wire, 'value')};"),
            _moved(entry.wire, "value", "take"),
            lines(f"{glue.p}_Receive_{entry.receiver}({glue.at}, {value}, t);"),
        ])))  # fmt: skip
    head = f"void {glue.d}_Receive(uint32_t receiver, const unsigned char *at, uint64_t t)"
    return _function(head, [_switch("receiver", cases), lines("(void)at;\n(void)t;")])


def _send(glue: _Glue) -> Lines:
    largest = lines("unsigned char bytes[SIGCAT_BYTES];\nunsigned char *at = bytes;")
    parts = [block(f"if ({glue.instance}.publish.{each.field})", [_sent(glue, number, each)])
             for number, each in glue.exits]  # fmt: skip
    parts += [_answered(glue, entry) for entry in glue.entries if entry.is_answer]
    body = [largest, *parts, lines(f"(void)at;\n(void)bytes;\n{glue.p}_Published({glue.at});")]
    return _function(f"void {glue.d}_Send(void)", body)


def _asked(glue: _Glue, method: Method, server: Server) -> Lines:
    """A request is answered within the same time, by the function of the set that offers the method."""
    name, plan = method.named.name, glue.scope.plan
    request, answer = request_struct(method, plan), answer_struct(method, plan)
    place = f"{glue.instance}.method.{name}"
    given = ", &results" if answer.fields else ""
    taken = block("if (is_ok)", [lines(f"(void)take_{answer.name}(answer, &results);")]) if answer.fields else ()
    return block(f"if ({glue.instance}.publish.{name} && sigcat_is_there({server.member}U))", [
        lines("unsigned char answer[SIGCAT_BYTES];\nbool is_ok;"),
        lines(f"{answer.name} results;\n(void)memset(&results, 0, sizeof(results));") if answer.fields else (),
        lines(f"(void)put_{request.name}(bytes, &{place}.arguments);") if request.fields else (),
        lines(f"is_ok = sigcat_serves({server.member}U, {server.method}U, bytes, answer);"),
        taken,
        lines(f"{glue.p}_Answer_{name}({glue.at}, {place}.number, is_ok{given}, {glue.instance}.now);"),
    ])  # fmt: skip


def _serve(glue: _Glue) -> Lines:
    """What others of the set ask for."""
    cases = [
        (f"{number}U", _served(glue, method)) for number, method in enumerate(glue.scope.plan.methods)
        if method.is_offered
    ]  # fmt: skip
    head = f"bool {glue.d}_Serve(uint32_t method, const unsigned char *at, unsigned char *to)"
    unused = lines("(void)at;\n(void)to;")
    return _function(head, [lines("bool is_ok = false;"), _switch("method", cases), unused, lines("return is_ok;")])


def _served(glue: _Glue, method: Method) -> Lines:
    plan = glue.scope.plan
    request, answer = request_struct(method, plan), answer_struct(method, plan)
    given = "".join((", &arguments" if request.fields else "", ", &results" if answer.fields else ""))
    ok = glue.scope.constant("OK")
    return block("", [
        lines(f"{request.name} arguments;") if request.fields else (),
        lines(f"{answer.name} results;") if answer.fields else (),
        lines(f"(void)take_{request.name}(at, &arguments);") if request.fields else (),
        lines(f"is_ok = {glue.p}_Method_{method.named.name}({glue.at}{given}) == {ok};"),
        block("if (is_ok)", [lines(f"(void)put_{answer.name}(to, &results);")]) if answer.fields else (),
    ])  # fmt: skip


def _answered(glue: _Glue, entry: Entry) -> Lines:
    """A request is answered within the same time, as the trace said last."""
    if entry.receiver in glue.servers:
        method = next(each for each in glue.scope.plan.methods if each.named.name == entry.receiver)
        return _asked(glue, method, glue.servers[entry.receiver])
    name, number = f"{glue.d}_{entry.receiver}", f"{glue.instance}.method.{entry.receiver}.number"
    given = f"true, &{name}_Answer" if entry.wire.is_struct else f"{name}_Answer"
    answer = lines(f"{glue.p}_Answer_{entry.receiver}({glue.at}, {number}, {given}, {glue.instance}.now);")
    return block(f"if ({glue.instance}.publish.{entry.receiver} && {name}_HasAnswer)", [answer])


def _sent(glue: _Glue, number: int, each: Exit) -> Lines:
    place = f"{glue.instance}.out.{each.field}"
    tell = lines(f"sigcat_sends({number}U, bytes);")
    if not each.is_queue:
        return joined([lines("at = bytes;"), _moved(each.wire, place, "put"), tell])
    one = [lines("at = bytes;"), _moved(each.wire, f"{place}.values[k]", "put"), tell]
    return block(f"for (uint32_t k = 0; k < {place}.count; k++)", one)


# -- what is kept -------------------------------------------------------------------------------------------------

_COUNTS = ("occurrences", "ignition_cycles", "has_failed", "is_tested")


def _parts_of_kept(glue: _Glue, each: Kept, base: str) -> list[tuple[WireType, str]]:
    """The types and places of what is kept together."""
    place = f"{base}.{each.field}"
    if each.section == "parameters":
        wire = next(one.value.wire for one in glue.scope.plan.parameters if one.named.name == each.field)
        return [(wire, f"{place}.value")]
    if each.section == "errors":
        return [(WireType(""), f"{place}.{name}") for name in _COUNTS]
    return [(WireType(""), place)]


def _restore(glue: _Glue) -> Lines:
    known = {"ignitionCycle": "has_cycle", "parameters": "{}.is_there"}
    base, cases = f"{glue.d}_Kept", []
    for number, (_, each) in enumerate(glue.kept):
        flag = known.get(each.section, "").format(each.field)
        cases.append((f"{number}U", joined([
            *(_moved(wire, place, "take") for wire, place in _parts_of_kept(glue, each, base)),
            lines(f"{base}.{flag} = true;") if flag else (),
        ])))  # fmt: skip
    head = f"void {glue.d}_Restore(uint32_t item, const unsigned char *at)"
    return _function(head, [lines(f"{glue.d}_HasKept = true;"), _switch("item", cases), lines("(void)at;")])


def _store(glue: _Glue) -> Lines:
    base = f"{glue.instance}.stored"
    parts = []
    for number, each in glue.kept:
        put = joined([
            lines("at = bytes;"),
            *(_moved(wire, place, "put") for wire, place in _parts_of_kept(glue, each, base)),
            lines(f"sigcat_stores({number}U, bytes, (size_t)(at - bytes));"),
        ])  # fmt: skip
        parts.append(block(f"if ({base}.{each.field}.is_there)", [put]) if each.section == "parameters" else put)
    body = [lines("unsigned char bytes[SIGCAT_BYTES];\nunsigned char *at;"), *parts]
    return _function(f"void {glue.d}_Store(void)", body)


# -- life and calls -----------------------------------------------------------------------------------------------


def _start_up(glue: _Glue) -> Lines:
    kept = f"{glue.d}_HasKept ? &{glue.d}_Kept : NULL"
    body = lines(f"return {glue.p}_Init({glue.at}, {kept}, ignition_cycle);")
    return _function(f"bool {glue.d}_StartUp(uint32_t ignition_cycle)", [body])


def _start(glue: _Glue) -> Lines:
    return _plain(glue, "Start")


def _plain(glue: _Glue, what: str) -> Lines:
    return _function(f"void {glue.d}_{what}(uint64_t t)", [lines(f"{glue.p}_{what}({glue.at}, t);")])


def _next_call(glue: _Glue) -> Lines:
    cases = [f"case {glue.scope.call(call.name)}: return {number}U;" for number, call in enumerate(_steps(glue))]
    labels = tuple(Line(text) for text in (*cases, "default: return SIGCAT_NONE;"))
    body = block(f"switch ({glue.p}_NextCall({glue.at}, t))", [labels])
    return _function(f"uint32_t {glue.d}_NextCall(uint64_t t)", [body])


def _next_time(glue: _Glue) -> Lines:
    return _function(f"uint64_t {glue.d}_NextTime(void)", [lines(f"return {glue.p}_NextTime({glue.at});")])


def _of_calls(glue: _Glue, what: str, argument: str, value: str) -> Lines:
    arguments = ", ".join(filter(None, ("uint32_t call", argument)))
    cases = [
        (f"{number}U", lines(f"{glue.p}_{what}_{call.name}({', '.join(filter(None, (glue.at, value)))});"))
        for number, call in enumerate(_steps(glue))
    ]
    unused = lines(f"(void){value};") if value else ()
    return _function(f"void {glue.d}_{what}({arguments})", [_switch("call", cases), unused])


def _steps(glue: _Glue) -> tuple[Call, ...]:
    return glue.scope.plan.steps


def _table(glue: _Glue) -> Lines:
    plan, names = glue.scope.plan, (
        "Restore", "StartUp", "Start", "Receive", "NextCall", "NextTime", "SetInput", "Begin", "Run", "GetOutput",
        "Supervise", "Send", "Serve", "Terminate", "Store",
    )  # fmt: skip
    steps = len(plan.steps)
    init = f"{glue.first_call + steps}U" if plan.inits else "SIGCAT_NONE"
    terminate = f"{glue.first_call + steps + 1}U" if plan.terminates else "SIGCAT_NONE"
    values = ", ".join((init, terminate, f"{glue.first_call}U", *(f"{glue.d}_{name}" for name in names)))
    return lines(f"""
        #ifdef __cplusplus
        extern "C" const sigcat_function {glue.d};
        #endif
        const sigcat_function {glue.d} = {{{values}}};
    """)
