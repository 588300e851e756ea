"""Modes: which calls run (section 8)."""

from sigcat.adapter.core.c.lines import Line, Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Call, ModeIn, ModeOut, ModeValue
from sigcat.adapter.text_filters import block_comment


def mode_functions(scope: Scope) -> list[Lines]:
    """What happens to calls when the mode is taken."""
    mode = scope.plan.mode_in
    if mode is None:
        return []
    moded = [call for call in scope.plan.steps if is_moded(call, scope)]
    return [*(_drop(call, scope) for call in moded), _take_mode(mode, moded, scope)]


def runs_functions(scope: Scope) -> list[Lines]:
    """Which modes let each call run."""
    mode = scope.plan.mode_in
    return [_runs(call, mode, scope) for call in scope.plan.steps if mode and is_moded(call, scope)]


def is_moded(call: Call, scope: Scope) -> bool:
    """Whether a mode excludes the call."""
    mode = scope.plan.mode_in
    return mode is not None and any(each.name in (call.modes or ()) for each in mode.modes)


def condition(call: Call, scope: Scope) -> str:
    """The condition that a call may run."""
    return f"{scope.prefix}_Runs_{call.name}(self->mode.now)" if is_moded(call, scope) else "true"


def _runs(call: Call, mode: ModeIn, scope: Scope) -> Lines:
    excluded = [each for each in mode.modes if each.name in (call.modes or ())]
    text = " && ".join(f"(mode != {_constant(each)})" for each in excluded)
    head = f"static bool {scope.prefix}_Runs_{call.name}({mode.wire.c} mode)"
    return function(head, [lines(f"return {text};")], f"Whether {call.interface} runs in a mode.")


def _constant(mode: ModeValue) -> str:
    return f"{mode.number}U {block_comment(mode.name)}"


def dropped(call: Call, scope: Scope) -> Lines:
    """Activations that are due are dropped and counted, and the values that would have been taken with them."""
    place = f"self->{call.name}"
    if call.cycle is not None:
        cycle = time(call.cycle)
        return block(f"if (t >= {place}.release)", [lines(f"""
            const uint64_t releases = ((t - {place}.release) / {cycle}) + 1U;

            {place}.release += releases * {cycle};
            {place}.dropped = {scope.prefix}_Added({place}.dropped, releases);
        """)])  # fmt: skip
    queues = [item for item in call.inputs if item.queue and item.port in call.triggers]
    return joined([
        lines(f"{place}.dropped = {scope.prefix}_Added({place}.dropped, {place}.events);\n{place}.events = 0U;"),
        *(lines(f"{place}.in.{item.named.name}.waiting = 0U;") for item in queues),
    ])  # fmt: skip


def _drop(call: Call, scope: Scope) -> Lines:
    place = f"self->{call.name}"
    body = [
        dropped(call, scope),
        lines(f"""
            {place}.alive.verdict = {scope.constant("NOT_JUDGED")};
            {place}.alive.has_closed = false;
            {place}.alive.is_bad = false;
        """) if call.alive else (),
        *(lines(f"{scope.prefix}_Suspend(&self->error.{error.named.name});")
          for error in scope.plan.errors if error.call == call.name),
    ]  # fmt: skip
    head = f"static void {scope.prefix}_Exclude_{call.name}({scope.self_argument}, uint64_t t)"
    return function(head, body, f"The mode excludes {call.interface}: what is due is dropped, what was under way ends.")


def _take_mode(mode: ModeIn, moded: list[Call], scope: Scope) -> Lines:
    p, name = scope.prefix, mode.named.name
    received = f"self->received.{name}"
    known = joined([*(lines(f"case {each.number}U: {block_comment(each.name)}") for each in mode.modes),
                    _case(f"self->mode.now = {received}.value;\nself->mode.unknown = {scope.absent};")])  # fmt: skip
    initial = f"self->mode.now = {_constant(mode.initial)};\n" if mode.goes_to_initial else ""
    unknown = joined([lines("default:"), _case(f"{initial}self->mode.unknown = {scope.present};")])
    taken = block(f"if ({received}.reception.is_there)", [block(f"switch ({received}.value)", [known, unknown])])
    body = [lines(f"const {mode.wire.c} before = self->mode.now;") if moded else (), taken,
            *(_applied(call, scope) for call in moded)]  # fmt: skip
    head = f"static void {p}_TakeMode({scope.self_argument}, uint64_t t)"
    return function(head, body, mode.named.comment)


def _case(text: str) -> Lines:
    return tuple(Line(f"    {line.text}") for line in lines(f"{text}\nbreak;"))


def _applied(call: Call, scope: Scope) -> Lines:
    p = scope.prefix
    return choice([
        (f"!{condition(call, scope)}", lines(f"{p}_Exclude_{call.name}(self, t);")),
        (f"!{p}_Runs_{call.name}(before)", lines(f"{p}_Enter_{call.name}(self, t);")),
        ("", lines("/* it runs as before */")),
    ])  # fmt: skip


def written(scope: Scope) -> Lines:
    """The mode, written to its variable, as a number of the code."""
    mode = scope.plan.mode_in
    if mode is None or mode.variable is None:
        return ()
    variable = mode.variable
    if all(each.number == each.code for each in mode.modes):
        text = f"{scope.assigned(variable, 'self->mode.now')} {block_comment(mode.named.comment)}"
        return (Line(text, mode.named.pointer),)
    ways = [
        (f"self->mode.now == {_constant(each)}", lines(scope.assigned(variable, str(each.code)), mode.named.pointer))
        for each in mode.modes
    ]
    return choice([*ways[:-1], ("", ways[-1][1])])


# -- mode out -----------------------------------------------------------------------------------------------------


def mode_out_functions(scope: Scope) -> list[Lines]:
    """The mode that the function is in: sent on change, if it has a name."""
    mode = scope.plan.mode_out
    if mode is None:
        return []
    out, name = f"self->out.{mode.named.name}", mode.named.name
    switch = block(
        f"switch ({'(int64_t)' if scope.is_cpp else ''}{scope.variable(mode.variable)})",
        [
            *(_out_case(each, mode) for each in _first_of_each_code(mode)),
            lines("default:\n    is_named = false;\n    break;"),
        ],
        source=mode.named.pointer,
    )
    changed = lines(f"""
        if (is_named && (!self->mode_out.is_known || ({out} != mode))) {{
            {out} = mode;
            self->mode_out.is_known = true;
            self->publish.{name} = self->is_started;
        }}
    """)
    body = [lines(f"{mode.wire.c} mode = {out};\nbool is_named = true;"), switch, changed]
    return [function(f"static void {scope.prefix}_GiveMode({scope.self_argument})", body, mode.named.comment)]


def _first_of_each_code(mode: ModeOut) -> list[ModeValue]:
    return list({each.code: each for each in reversed(mode.modes)}.values())[::-1]


def _out_case(each: ModeValue, mode: ModeOut) -> Lines:
    return lines(f"""
        case {each.code}: {block_comment(each.name)}
            mode = {each.number}U;
            break;
    """, mode.named.pointer)  # fmt: skip
