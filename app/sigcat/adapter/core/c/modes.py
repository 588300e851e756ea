"""Modes: which calls run (section 8)."""

from sigcat.adapter.core.c.lines import Line, Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.identifiers import comment
from sigcat.adapter.core.plan import Call, ModeIn, ModeOut, ModeValue


def mode_functions(scope: Scope) -> list[Lines]:
    """Which calls a mode lets run, and what happens when it changes."""
    mode = scope.plan.mode_in
    if mode is None:
        return []
    runs = [_runs(call, mode, scope) for call in scope.plan.steps if is_moded(call)]
    return [*runs, _enter(scope), _leave(scope), _take_mode(mode, scope)]


def is_moded(call: Call) -> bool:
    """Whether a mode excludes the call."""
    return bool(call.modes)


def condition(call: Call, scope: Scope) -> str:
    """The condition that a call may run."""
    if scope.plan.mode_in is None or not is_moded(call):
        return "true"
    return f"{scope.prefix}_Runs_{call.name}(self->mode.now)"


def _runs(call: Call, mode: ModeIn, scope: Scope) -> Lines:
    excluded = [each for each in mode.modes if each.name in (call.modes or ())]
    text = " && ".join(f"(mode != {_constant(each)})" for each in excluded) or "true"
    head = f"static bool {scope.prefix}_Runs_{call.name}({mode.wire.c} mode)"
    return function(head, [lines(f"return {text};")], f"Whether {call.interface} runs in a mode.")


def _constant(mode: ModeValue) -> str:
    return f"{mode.number}U /* {comment(mode.name)} */"


def _enter(scope: Scope) -> Lines:
    """A call that comes back into the mode: its clocks and windows start anew."""
    found = [
        block(f"if ({scope.prefix}_Runs_{call.name}(mode) && !{scope.prefix}_Runs_{call.name}(self->mode.now))",
              [lines(f"{scope.prefix}_Enter_{call.name}(self, t);"), _window(call)])
        for call in scope.plan.steps if is_moded(call)
    ]  # fmt: skip
    mode = scope.plan.mode_in
    assert mode is not None
    head = f"static void {scope.prefix}_EnterCalls({scope.self_argument}, {mode.wire.c} mode, uint64_t t)"
    return function(head, found, "Calls that come back: their clocks and windows start anew.")


def _window(call: Call) -> Lines:
    return lines(f"self->{call.name}.window = t;") if call.alive else ()


def _leave(scope: Scope) -> Lines:
    found = [_left(call, scope) for call in scope.plan.steps if is_moded(call)]
    mode = scope.plan.mode_in
    assert mode is not None
    head = f"static void {scope.prefix}_LeaveCalls({scope.self_argument}, {mode.wire.c} mode)"
    return function(head, found, "Calls that the mode excludes from now on: what waits is dropped.")


def _left(call: Call, scope: Scope) -> Lines:
    suspended = [
        lines(f"{scope.prefix}_Suspend(&self->error.{error.named.name});")
        for error in scope.plan.errors if error.call == call.name
    ]  # fmt: skip
    return (
        block(
            f"if (!{scope.prefix}_Runs_{call.name}(mode) && {scope.prefix}_Runs_{call.name}(self->mode.now))", suspended
        )
        if suspended
        else ()
    )


def _take_mode(mode: ModeIn, scope: Scope) -> Lines:
    p, name = scope.prefix, mode.named.name
    received = f"self->received.{name}"
    known = joined([*(lines(f"case {each.number}U: /* {comment(each.name)} */") for each in mode.modes),
                    indented_break(f"self->mode.unknown = {scope.absent};")])  # fmt: skip
    instead = f"{mode.initial.number}U" if mode.goes_to_initial else "self->mode.now"
    unknown = joined([lines("default:"),
                      indented_break(f"mode = {instead};\nself->mode.unknown = {scope.present};")])  # fmt: skip
    body = [
        lines(f"{mode.wire.c} mode = {received}.value;\n"),
        block("switch (mode)", [known, unknown]),
        block("if (mode != self->mode.now)", [
            lines(f"{p}_LeaveCalls(self, mode);\n{p}_EnterCalls(self, mode, t);\nself->mode.now = mode;"),
        ]),
    ]  # fmt: skip
    whole = block(f"if ({received}.reception.is_there)", body)
    head = f"static void {p}_TakeMode({scope.self_argument}, uint64_t t)"
    return function(head, [whole], mode.named.comment)


def indented_break(text: str) -> Lines:
    """Statements of a case, and its end."""
    return tuple(Line(f"    {line.text}") for line in lines(f"{text}\nbreak;"))


def written(scope: Scope) -> Lines:
    """The mode, written to its variable, as a number of the code."""
    mode = scope.plan.mode_in
    if mode is None or mode.variable is None:
        return ()
    target = scope.variable(mode.variable)
    if all(each.number == each.code for each in mode.modes):
        return lines(f"{target} = self->mode.now; /* {mode.named.comment} */", mode.named.pointer)
    ways = [
        (f"self->mode.now == {_constant(each)}", lines(f"{target} = {each.code};", mode.named.pointer))
        for each in mode.modes
    ]
    return choice([*ways[:-1], ("", ways[-1][1])])


def mode_out_functions(scope: Scope) -> list[Lines]:
    """The mode that the function is in: sent on change, if it has a name."""
    mode = scope.plan.mode_out
    if mode is None:
        return []
    cases = [_out_case(each, mode) for each in mode.modes]
    switch = block(f"switch ({scope.variable(mode.variable)})", [*cases, lines("default:\n    break;")])
    changed = lines(f"""
        if (self->out.{mode.named.name} != mode) {{
            self->out.{mode.named.name} = mode;
            self->publish.{mode.named.name} = true;
        }}
    """)
    body = [lines(f"{mode.wire.c} mode = self->out.{mode.named.name};\n"), switch, changed]
    return [function(f"static void {scope.prefix}_GiveMode({scope.self_argument})", body, mode.named.comment)]


def _out_case(each: ModeValue, mode: ModeOut) -> Lines:
    return lines(f"""
        case {each.code}: /* {comment(each.name)} */
            mode = {each.number}U;
            break;
    """, mode.named.pointer)  # fmt: skip
