"""The source: every function in the order of a reader, and those that they need before them."""

from sigcat.adapter.core.c import (
    context_struct,
    errors,
    inputs,
    life,
    methods,
    modes,
    outputs,
    parameters,
    schedule,
    supervision,
)
from sigcat.adapter.core.c.lines import Lines, code_of, function, joined, lines, spaced
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.sizes import sizes
from sigcat.adapter.core.c.small_functions import used_functions
from sigcat.adapter.core.c.values import declared
from sigcat.adapter.core.plan import GLOBALS, Extern, WireType
from sigcat.function.document.text_filters import block_comment, c_header, c_string


def source(scope: Scope, title: Lines, header_name: str) -> Lines:
    """The whole source."""
    body = _without_unused_tables(_functions(scope))
    text = code_of(joined(body))
    checks = sizes(scope)
    return spaced([
        title,
        _includes(text, header_name, is_cpp=scope.is_cpp, has_checks=bool(checks)),
        _mark(scope),
        _evaluation(scope),
        *_variables(scope),
        *checks,
        *used_functions(text, scope.prefix, scope.macro),
        *body,
    ])  # fmt: skip


def _includes(text: str, header_name: str, *, is_cpp: bool, has_checks: bool) -> Lines:
    known = (
        ("<float.h>", True),
        ("<math.h>", "_Quiet" in text or "_ToFloat(" in text),
        ("<stddef.h>", True),
        ("<string.h>", "mem" in text),
        ("<new>", is_cpp),
        ("<type_traits>", is_cpp and has_checks),
    )
    rows = [f"#include {c_header(header_name)}", "", *(f"#include {name}" for name, is_used in known if is_used)]
    return lines("\n".join(rows))


def _mark(scope: Scope) -> Lines:
    macro = scope.constant("MARK")
    return lines(f"""
        /* Points of measurement: 0 SetInput begins, 1 the call begins, 2 it has ended, 3 GetOutput ends, 4 Supervise. */
        #ifndef {macro}
        #define {macro}(self, point, call) ((void)0)
        #endif
    """)


def _evaluation(scope: Scope) -> Lines:
    return lines(f"""
        #if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD != 0)
        #error {c_string(f"{scope.plan.function}: doubles must be evaluated as doubles")}
        #endif
        #if defined(__FAST_MATH__)
        #error {c_string(f"{scope.plan.function}: -ffast-math changes results")}
        #endif
    """)


def _variables(scope: Scope) -> list[Lines]:
    plan = scope.plan
    if plan.code.signature != GLOBALS:
        return []
    held = [
        lines(f"{declared(WireType(each.type, each.length), scope.variable(each.name))};", ("Code",))
        for each in plan.code.objects
    ]
    here = [_extern(each, scope) for each in plan.code.externs if each.is_defined_here]
    there = [_extern(each, scope) for each in plan.code.externs if not each.is_defined_here]
    calls = [] if plan.code.headers else plan.calls
    prototypes = [
        lines(f"extern {'int' if call.success is not None else 'void'} {call.symbol}(void);", call.pointer)
        for call in calls
    ]
    return [
        joined([lines(block_comment(f"Of the code of {plan.function}.")), *there, *prototypes])
        if there or prototypes
        else (),
        joined([lines(block_comment(f"Imported by the code of {plan.function}.")), *held, *here])
        if held or here
        else (),
        lines(f"{scope.prefix} {scope.prefix}_Instance;"),
    ]


def _extern(each: Extern, scope: Scope) -> Lines:
    before = "" if each.is_defined_here else "extern "
    return lines(f"{before}{declared(WireType(each.c, each.length), scope.variable(each.name))};")


def _without_unused_tables(parts: list[Lines]) -> list[Lines]:
    """Tables of constants stand before what may use them; where a constant cannot come up, nothing does."""
    text = code_of(joined(parts))
    return [part for part in parts if not part[0].text.startswith("static const ") or text.count(_name(part)) > 1]


def _name(table: Lines) -> str:
    return table[0].text.partition("[")[0].rpartition(" ")[2]


def _functions(scope: Scope) -> list[Lines]:
    steps = scope.plan.steps
    return [part for part in (
        *inputs.receive_functions(scope),
        *_receive_status(scope),
        *(part for call in steps for part in inputs.take_functions(call, scope)),
        *(part for call in steps for part in outputs.give_functions(call, scope)),
        *parameters.parameter_functions(scope),
        parameters.set_function(scope),
        *modes.runs_functions(scope),
        *supervision.window_functions(scope),
        *supervision.checkpoint_functions(scope),
        *errors.error_functions(scope),
        *errors.reaction_functions(scope),
        *modes.mode_out_functions(scope),
        *schedule.enter_functions(scope),
        *modes.mode_functions(scope),
        *schedule.due_functions(scope),
        *methods.method_functions(scope),
        *(part for call in steps for part in schedule.call_functions(call, scope)),
        supervision.supervise_function(scope),
        *life.life_functions(scope),
    ) if part]  # fmt: skip


def _receive_status(scope: Scope) -> list[Lines]:
    found = []
    for name, wire in context_struct.received_status(scope):
        place = f"self->received.{name}"
        body = lines(f"""
            {place}.value = value;
            {place}.reception.time = {scope.prefix}_Now(self, t);
            {place}.reception.count++;
            {place}.reception.is_there = true;
        """)
        found.append(function(context_struct.status_head(name, wire, scope), [body]))
    return found
