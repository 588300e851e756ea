"""The header: types, what the adapter holds, and what the platform calls."""

from sigcat.adapter.core.c import errors, inputs, methods, parameters
from sigcat.adapter.core.c.context_struct import context_struct, received_status, status_head
from sigcat.adapter.core.c.lines import Line, Lines, code_of, joined, lines, spaced
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.types import types
from sigcat.adapter.core.plan import (
    GLOBALS,
)
from sigcat.function.document.text_filters import block_comment, c_header, c_string


def header(scope: Scope, title: Lines) -> Lines:
    """The whole header."""
    guard = scope.constant("H")
    parts = [
        title,
        lines(f"#ifndef {guard}\n#define {guard}"),
        _includes(scope),
        _instances(scope),
        _extern_c(begins=True),
        *types(scope),
        context_struct(scope),
        _single(scope),
        _hooks(scope),
        *_functions(scope),
        _extern_c(begins=False),
        lines(f"#endif {block_comment(guard)}"),
    ]
    return spaced(_without_unused_verdict(parts, f"{scope.prefix}_Verdict"))


def _without_unused_verdict(parts: list[Lines], name: str) -> list[Lines]:
    """Where nothing can be wrong, nothing is judged."""
    if code_of(joined(parts)).count(name) > 1:
        return parts
    return [part for part in parts if name not in code_of(part)]


def _extern_c(*, begins: bool) -> Lines:
    brace = 'extern "C" {' if begins else "}"
    return lines(f"#ifdef __cplusplus\n{brace}\n#endif")


def _includes(scope: Scope) -> Lines:
    own = [f"#include {c_header(name)}" for name in scope.plan.code.headers]
    return lines("\n".join(["#include <stdbool.h>", "#include <stdint.h>", *([""] if own else []), *own]), ("Code",))


def _instances(scope: Scope) -> Lines:
    if scope.plan.code.signature != GLOBALS:
        return ()
    macro = scope.constant("INSTANCES")
    return lines(f"""
        {block_comment(f"{scope.plan.function} keeps its data in global variables: a process has one of it.")}
        #ifndef {macro}
        #define {macro} 1
        #endif
        #if {macro} != 1
        #error {c_string(f"{scope.plan.function} keeps its data in global variables: there can be one instance of it")}
        #endif
    """)


def _single(scope: Scope) -> Lines:
    if scope.plan.code.signature != GLOBALS:
        return ()
    return lines(f"""
        /* The one instance. */
        extern {scope.prefix} {scope.prefix}_Instance;
    """)


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
        _prototypes("A message has come that end-to-end protection does not accept. From any thread, under the lock.",
                    [f"{inputs.reject_head(each, scope)};" for each in plan.ports if each.tells_of_rejection]),
        _prototypes("Values of a queue were lost before they came here. From any thread, under the lock.",
                    [f"{inputs.lose_head(each, scope)};" for each in plan.ports if each.tells_of_loss]),
        _prototypes("Which call is due, until none is. Under the lock.",
                    [f"{p}_Call {p}_NextCall({s}, uint64_t t);", f"uint64_t {p}_NextTime(const {p} *self);"]),
        *(_prototypes(f"{call.interface}: all but Run under the lock.", [
            f"void {p}_SetInput_{call.name}({s}, uint64_t t);", f"void {p}_Begin_{call.name}({s}, uint64_t t);",
            f"void {p}_Run_{call.name}({s});", f"void {p}_GetOutput_{call.name}({s}, uint64_t t);",
        ]) for call in plan.steps),
        _prototypes("At NextTime, and once in each longest duration of a call that runs (section 10). Under the lock.", [f"void {p}_Supervise({s}, uint64_t t);"]),
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
    return tuple(Line(text) for text in (block_comment(comment), *heads)) if heads else ()


def receive_heads(scope: Scope) -> list[str]:
    """Heads of all functions that take what comes."""
    return [
        *(inputs.receive_head(port, scope) for port in scope.plan.ports),
        *(errors.reaction_head(reaction, scope) for reaction in scope.plan.reactions),
        *(status_head(name, wire, scope) for name, wire in received_status(scope)),
    ]
