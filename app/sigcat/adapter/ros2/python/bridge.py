"""The bridge: what Python needs of a core beside its header, in C, and the declarations of both for Python."""

import textwrap
from collections.abc import Iterable, Iterator
from hashlib import sha256

from sigcat.adapter.core.c.header import receive_heads
from sigcat.adapter.core.c.lines import Line, Lines, indented, joined, lines, spaced, wrapped
from sigcat.adapter.core.c.methods import answer_head, arguments_type, offered_head, results_type
from sigcat.adapter.core.c.parameters import settable
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.types import struct, types
from sigcat.adapter.core.c.values import declared
from sigcat.adapter.core.plan import CLASS, GLOBALS, CorePlan, Method
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.ros2.python.names import WIDEST
from sigcat.function.document.text_filters import block_comment, c_header, c_string, comment

_INTERNAL = ("_Verdict;", "_Origin;", "_Reception;", "_Clock;", "_Error;")
"""Ends of the types that only the core itself uses."""


def bridge_files(core: CorePlan) -> tuple[GeneratedFile, ...]:
    """Header and source, which are compiled with the core."""
    scope = Scope(core)
    return (
        GeneratedFile(f"{core.function}_bridge.h", _text(_header(scope))),
        GeneratedFile(f"{core.function}_bridge.{core.code.ending}", _text(_source(scope))),
    )


def _text(part: Lines) -> bytes:
    return ("\n".join(line.text for line in wrapped(part)) + "\n").encode()


def bridge_prefix(scope: Scope) -> str:
    """Prefix of its names: `CoreAcc_Bridge`."""
    return f"{scope.plan.function}_Bridge"


# -- declarations for Python --------------------------------------------------------------------------------------


def declarations(core: CorePlan) -> str:
    """Types and functions, as Python has to know them. The core itself stays opaque."""
    scope = Scope(core)
    p, b, s = scope.prefix, bridge_prefix(scope), scope.self_argument
    known = [part for part in types(scope) if not part[-1].text.endswith(_INTERNAL)]
    steps = [f"void {p}_{way}_{step.name}({s}{'' if way == 'Run' else ', uint64_t t'});"
             for step in core.steps for way in ("SetInput", "Begin", "Run", "GetOutput")]  # fmt: skip
    heads = [*receive_heads(scope), *(offered_head(each, scope) for each in core.methods if each.is_offered)]
    heads += [answer_head(each, scope) for each in core.requests]
    if settable(scope):
        heads.append(f"bool {p}_SetParameters({s}, const {p}_Parameters *parameters)")
    whole = spaced([
        lines(f"typedef struct {p} {p};"),
        *known,
        *(struct(f"{b}_{name}", members) for name, members in (("Out", _out(scope)), ("Publish", _publish(scope))) if members),
        *_types(scope),
        lines(f"""
            bool {p}_Init({s}, const {p}_Stored *stored, uint32_t ignition_cycle);
            void {p}_Start({s}, uint64_t t);
            {p}_Call {p}_NextCall({s}, uint64_t t);
            uint64_t {p}_NextTime(const {p} *self);
            void {p}_Supervise({s}, uint64_t t);
            void {p}_Published({s});
            void {p}_Terminate({s}, uint64_t t);
        """),
        lines("\n".join([*steps, *(f"{head};" for head in heads)])),
        lines("\n".join(f"{head};" for head, _ in _functions(scope))),
    ])  # fmt: skip
    return "\n".join(row for line in _without_comments(whole) for row in _rows_of(line.text))


def _rows_of(text: str) -> list[str]:
    """A line, on as many as a module of Python has room for."""
    return (
        textwrap.wrap(text, WIDEST, subsequent_indent="    ", break_long_words=False) if len(text) > WIDEST else [text]
    )


def _without_comments(part: Lines) -> Lines:
    """Units and paths stand where the values are used; a separate comment stays."""
    return tuple(line._replace(text=line.text.partition(" /* ")[0].rstrip()) for line in part if line.text[:2] != "/*")


def digest(core: CorePlan) -> str:
    """Key that distinguishes declarations."""
    return sha256(declarations(core).encode()).hexdigest()[:16]


def struct_names(core: CorePlan) -> tuple[str, ...]:
    """Structs whose layout Python compares."""
    return tuple(name for name, _ in _layouts(Scope(core)))


def _out(scope: Scope) -> list[Lines]:
    plan = scope.plan
    found = []
    for output in plan.outputs:
        wire, name = output.value.wire, output.named.name
        if output.queue is None:
            found.append(lines(f"{declared(wire, name)};"))
        else:
            values = declared(wire, f"values[{output.queue.length}]")
            found.append(lines(f"struct {{ uint32_t count; {values}; }} {name};"))
    return [*found, *(lines(f"{declared(each.wire, each.named.name)};") for each in plan.statuses)]


def out_names(core: CorePlan) -> tuple[str, ...]:
    """Members of `out`, in order; `publish` has the methods that are used beside them."""
    return tuple(each.named.name for each in (*core.outputs, *core.statuses))


def publish_names(core: CorePlan) -> tuple[str, ...]:
    """Members of `publish`, in order."""
    return (*out_names(core), *(each.named.name for each in core.requests))


def _publish(scope: Scope) -> list[Lines]:
    return [lines(f"bool {name};") for name in publish_names(scope.plan)]


# -- what it declares ---------------------------------------------------------------------------------------------


def _types(scope: Scope) -> Iterator[Lines]:
    b, p = bridge_prefix(scope), scope.prefix
    if scope.plan.errors:
        members = f"uint8_t state; {block_comment(f'{p}_ErrorState')}\nbool is_confirmed;\nuint16_t occurrences;\nuint16_t ignition_cycles;"
        yield struct(f"{b}_Error", [lines(members)], "What is known of an error.")
    if scope.plan.steps:
        members = "uint32_t missed;\nuint32_t dropped;"
        yield struct(f"{b}_Call", [lines(members)], "Activations of a call that did not run.")


def _functions(scope: Scope) -> Iterator[tuple[str, Lines]]:
    """Heads and bodies of all functions."""
    p, b, plan = scope.prefix, bridge_prefix(scope), scope.plan
    const = f"const {p} *self"
    yield from _objects(scope)
    if out_names(plan):
        yield f"void {b}_CopyOut({const}, void *out)", lines("memcpy(out, &self->out, sizeof(self->out));")
    if publish_names(plan):
        copied = lines("memcpy(publish, &self->publish, sizeof(self->publish));")
        yield f"void {b}_CopyPublish({const}, void *publish)", copied
    yield f"void {b}_CopyStored({const}, {p}_Stored *stored)", lines("*stored = self->stored;")
    if plan.errors:
        yield f"void {b}_CopyErrors({const}, {b}_Error *errors)", joined(_error(scope))
    if plan.steps:
        yield f"void {b}_CopyCalls({const}, {b}_Call *calls)", joined(_calls(scope))
    if settable(scope):
        yield f"void {b}_CopyParameters({const}, {p}_Parameters *parameters)", joined(
            _copied(f"parameters->{each.named.name}", f"self->parameter.{each.named.name}.value",
                    is_array=each.value.wire.length is not None)
            for each in settable(scope)
        )  # fmt: skip
    yield from (_request(method, scope) for method in plan.requests)
    yield f"const char *{b}_Digest(void)", lines(f"return {c_string(digest_mark(scope))};")
    yield f"const size_t *{b}_Layout(size_t *count)", _layout(scope)


def digest_mark(scope: Scope) -> str:
    """Stands for the digest, which is made of declarations that do not have it."""
    return f"@{scope.plan.function}@"


def _copied(target: str, source: str, *, is_array: bool) -> Lines:
    return lines(f"memcpy({target}, {source}, sizeof({target}));" if is_array else f"{target} = {source};")


def _objects(scope: Scope) -> Iterator[tuple[str, Lines]]:
    """Making and freeing. Where the function's data is global, there is one object."""
    p, b = scope.prefix, bridge_prefix(scope)
    new, free = f"{p} *{b}_New(void)", f"void {b}_Free({p} *self)"
    if scope.plan.code.signature == GLOBALS:
        yield new, lines(f"{p} *const self = {b}_IsTaken ? NULL : &{p}_Instance;\n{b}_IsTaken = true;\nreturn self;")
        yield free, lines(f"memset(self, 0, sizeof(*self));\n{b}_IsTaken = false;")
    elif scope.is_cpp:
        yield new, lines(f"return new (std::nothrow) {p}();")
        yield free, lines("delete self;")
    else:
        yield new, lines(f"return ({p} *)calloc(1U, sizeof({p}));")
        yield free, lines("free(self);")


def _error(scope: Scope) -> Iterator[Lines]:
    for index, error in enumerate(scope.plan.errors):
        name = error.named.name
        yield lines(f"""
            errors[{index}].state = (uint8_t)self->error.{name}.state;
            errors[{index}].is_confirmed = self->error.{name}.is_confirmed;
            errors[{index}].occurrences = self->stored.{name}.occurrences;
            errors[{index}].ignition_cycles = self->stored.{name}.ignition_cycles;
        """)


def _calls(scope: Scope) -> Iterator[Lines]:
    for index, step in enumerate(scope.plan.steps):
        missed = f"self->{step.name}.missed" if step.cycle is not None else "0U"
        yield lines(f"calls[{index}].missed = {missed};\ncalls[{index}].dropped = self->{step.name}.dropped;")


def _request(method: Method, scope: Scope) -> tuple[str, Lines]:
    place = f"self->method.{method.named.name}"
    arguments = f", {arguments_type(method, scope)} *arguments" if method.arguments else ""
    head = f"uint32_t {bridge_prefix(scope)}_CopyRequest_{method.named.name}(const {scope.prefix} *self{arguments})"
    copied = lines(f"*arguments = {place}.arguments;") if method.arguments else ()
    return head, joined([copied, lines(f"return {place}.number;")])


# -- layout -------------------------------------------------------------------------------------------------------


def _layouts(scope: Scope) -> Iterator[tuple[str, list[str]]]:
    """Structs and their members, in the order in which both sides list them."""
    p, b, plan = scope.prefix, bridge_prefix(scope), scope.plan
    yield from ((each.name, [field.name for field in each.fields]) for each in plan.structs)
    for method in plan.methods:
        for name, items in ((arguments_type, method.arguments), (results_type, method.results)):
            if items:
                yield name(method, scope), [each.name for each in items]
    if settable(scope):
        yield f"{p}_Parameters", [each.named.name for each in settable(scope)]
    kept = [each.named.name for each in plan.errors] + [each.named.name for each in plan.parameters]
    yield f"{p}_Stored", ["ignition_cycle", "has_cycle", *kept]
    if plan.errors:
        yield f"{b}_Error", ["state", "is_confirmed", "occurrences", "ignition_cycles"]
    if plan.steps:
        yield f"{b}_Call", ["missed", "dropped"]
    if out_names(plan):
        yield f"{b}_Out", list(out_names(plan))
    if publish_names(plan):
        yield f"{b}_Publish", list(publish_names(plan))


def _layout(scope: Scope) -> Lines:
    rows = [row for name, members in _layouts(scope) for row in _rows(name, members, scope)]
    return joined([
        lines("static const size_t layout[] = {"),
        tuple(Line(f"    {row}{',' if n < len(rows) else ''}") for n, row in enumerate(rows, 1)),
        lines("};\n\n*count = sizeof(layout) / sizeof(layout[0]);\nreturn layout;"),
    ])  # fmt: skip


def _rows(name: str, members: Iterable[str], scope: Scope) -> Iterator[str]:
    b, p = bridge_prefix(scope), scope.prefix
    group = {f"{b}_Out": "out", f"{b}_Publish": "publish"}.get(name)
    if group is None:
        yield f"sizeof({name})"
        yield from (f"offsetof({name}, {each}), sizeof((({name} *)0)->{each})" for each in members)
        return
    if scope.is_cpp:
        yield from _rows(f"decltype({p}::{group})", members, scope)
        return
    whole = f"(({p} *)0)->{group}"
    yield f"sizeof({whole})"
    for each in members:
        yield f"offsetof({p}, {group}.{each}) - offsetof({p}, {group}), sizeof({whole}.{each})"


# -- files --------------------------------------------------------------------------------------------------------


def _header(scope: Scope) -> Lines:
    b, guard = bridge_prefix(scope), f"{scope.macro.removesuffix('_ADAPTER')}_BRIDGE_H"
    return spaced([
        lines(f"""
            /*
             * What {comment(scope.plan.header_file)} does not have and Python needs: an object to work on, copies of its results, and the
             * layout of these copies.
             *
             * Generated by sigcat.
             */
        """),
        lines(f"#ifndef {guard}\n#define {guard}"),
        lines(f"#include <stddef.h>\n\n#include {c_header(scope.plan.header_file)}"),
        lines('#ifdef __cplusplus\nextern "C" {\n#endif'),
        *_types(scope),
        lines(f"/* An object to work on; NULL: there can be no further one. */\n{_heads(scope, ('New', 'Free'))}"),
        lines(f"/* Copies of its results. */\n{_heads(scope, ('Copy',))}"),
        lines(f"{block_comment(f'What {b} was generated from; sizes of structs, and places and sizes of their members.')}\n{_heads(scope, ('Digest', 'Layout'))}"),
        lines("#ifdef __cplusplus\n}\n#endif"),
        lines(f"#endif {block_comment(guard)}"),
    ])  # fmt: skip


def _heads(scope: Scope, begins: tuple[str, ...]) -> str:
    prefix = f"{bridge_prefix(scope)}_"
    heads = [head for head, _ in _functions(scope) if head.partition("(")[0].partition(prefix)[2].startswith(begins)]
    return "\n".join(f"{head};" for head in heads)


def _source(scope: Scope) -> Lines:
    plan, b = scope.plan, bridge_prefix(scope)
    is_global = plan.code.signature == GLOBALS
    standard = ["#include <new>"] if plan.code.signature == CLASS else [] if is_global else ["#include <stdlib.h>"]
    whole = spaced([
        lines(f"#include {c_header(f'{plan.function}_bridge.h')}"),
        lines("\n".join([*standard, "#include <string.h>"])),
        lines(f"static bool {b}_IsTaken = false;") if is_global else (),
        *((Line(head), Line("{"), *indented(body), Line("}")) for head, body in _functions(scope)),
    ])  # fmt: skip
    return tuple(line._replace(text=line.text.replace(digest_mark(scope), digest(plan))) for line in whole)
