"""Outputs: from the variables of the code to what is sent (sections 4 and 5)."""

from sigcat.adapter.core.c.lines import Line, Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import (
    Ends,
    assigned,
    check,
    constant,
    flag,
    index,
    known_values,
    names_functions,
    passing,
    tables,
)
from sigcat.adapter.core.plan import Call, Output
from sigcat.function.document.text_filters import block_comment


def ends_of(call: Call, output: Output, scope: Scope) -> Ends:
    """Source and target of an output."""
    source, target = scope.variable(output.variable), f"self->out.{output.named.name}"
    if output.queue:
        target = f"{target}.values[given]"
        source = f"{source}[given]" if output.queue.count_variable else source
    names = f"{scope.prefix}_{call.name}_{output.named.name}"
    return Ends(source, target, names, output.named.pointer, is_read=scope.is_cpp)


def given(call: Call, output: Output, scope: Scope) -> Lines:
    """An output after a call: an assignment, or a call of its function."""
    if not output.is_direct:
        return lines(f"{scope.prefix}_Give_{call.name}_{output.named.name}(self);")
    (line,) = assigned(output.value, ends_of(call, output, scope), scope.prefix, quiet=True)
    return (Line(f"{line.text} {block_comment(output.named.comment)}", line.source),)


def initial(call: Call, output: Output, scope: Scope) -> Lines:
    """Values to send before the first call."""
    ends = ends_of(call, output, scope)
    if output.queue:
        return ()
    return constant(output.value, "init", ends)


def give_functions(call: Call, scope: Scope) -> list[Lines]:
    """A function for each output that is more than an assignment."""
    found: list[Lines] = []
    for output in call.outputs:
        ends = ends_of(call, output, scope)
        kinds = ("init", "default", "replacement") if output.value.is_replaced else ("init", "default")
        found += [*tables(output.value, ends.names, kinds), *names_functions(output.value, ends)]
        if not output.is_direct:
            found.append(_give(call, output, ends, scope))
    return [each for each in found if each]


def _give(call: Call, output: Output, ends: Ends, scope: Scope) -> Lines:
    place = f"self->{call.name}.out.{output.named.name}"
    head = f"static void {scope.prefix}_Give_{call.name}_{output.named.name}({scope.self_argument})"
    inner = _give_queue(output, place, ends, scope) if output.queue else _give_one(output, place, ends, scope)
    return function(head, inner, output.named.comment)


def _give_one(output: Output, place: str, ends: Ends, scope: Scope) -> list[Lines]:
    return [
        index(output.value),
        known_values(output.value),
        flag(output.value) if output.value.is_checked else (),
        _one(output, ends, scope),
        _verdict(output, "is_within", place, scope),
    ]


def _give_queue(output: Output, place: str, ends: Ends, scope: Scope) -> list[Lines]:
    is_checked = output.value.is_checked
    one = [
        flag(output.value) if is_checked else (),
        _one(output, ends, scope),
        lines("are_within = are_within && is_within;") if is_checked and output.range_error else (),
    ]
    return [
        lines("uint32_t given;\nuint32_t count = 1U;"),
        index(output.value),
        known_values(output.value),
        lines("bool are_within = true;") if is_checked and output.range_error else (),
        (Line(""),),
        _counted(output, place, scope),
        block("for (given = 0U; given < count; given++)", one),
        lines(f"self->out.{output.named.name}.count = count;"),
        _verdict(output, "are_within", place, scope),
    ]


def _verdict(output: Output, all_within: str, place: str, scope: Scope) -> Lines:
    return lines(f"{place}.range = {all_within} ? {scope.absent} : {scope.present};") if output.range_error else ()


def _counted(output: Output, place: str, scope: Scope) -> Lines:
    """Number of values that the call has written: at most as many as there is room for."""
    queue = output.queue
    assert queue is not None
    if queue.count_variable is None:
        return lines(f"{place}.overflow = {scope.absent};") if queue.overflow_error else ()
    verdict = f"{place}.overflow = (count > {queue.length}U) ? {scope.present} : {scope.absent};\n"
    return lines(f"""
count = (uint32_t){scope.variable(queue.count_variable)};
{verdict if queue.overflow_error else ""}if (count > {queue.length}U) {{
    count = {queue.length}U;
}}
""", output.named.pointer)  # fmt: skip


def _one(output: Output, ends: Ends, scope: Scope) -> Lines:
    """One value, checked and converted."""
    put = assigned(output.value, ends, scope.prefix, quiet=True)
    if not output.value.is_checked:
        return put
    keeps = any(leaf.element.names is not None for leaf in output.value.leaves) and not output.value.is_replaced
    if output.value.is_replaced:
        put = choice([("is_within", put), ("", constant(output.value, "replacement", ends))])
    elif keeps:
        put = choice([(passing(output.value), put), ("", lines("/* what was sent before stays */"))])
    return joined([check(output.value, ends), put])
