"""Inputs: received from any thread, and taken by the snapshots of calls (sections 2 to 5)."""

from sigcat.adapter.core.c.lines import Line, Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.literals import literal, time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import (
    Ends,
    as_argument,
    assigned,
    check,
    constant,
    flag,
    index,
    known_values,
    names_functions,
    stored,
    tables,
)
from sigcat.adapter.core.plan import Call, Input, Port
from sigcat.function.function_json.conversion import IDENTITY


def is_timed(port: Port) -> bool:
    """Whether the time of its values counts."""
    return any(item.time_out is not None for _, item in port.consumers)


def holds_init(port: Port) -> bool:
    """Whether the start value can stand among the received ones: the call sees the very same bits."""
    items = [item for _, item in port.consumers]
    return len(items) == 1 and is_direct(items[0]) and _is_same(items[0])


def _is_same(item: Input) -> bool:
    element = item.value.leaves[0].element
    return item.value.is_bare and element.source == element.target and element.conversion == IDENTITY


def is_direct(item: Input) -> bool:
    """Whether an input is but an assignment: nothing is checked, nothing is late, nothing waits."""
    is_plain = item.time_out is None and item.queue is None and not item.is_reset
    return is_plain and item.value.is_bare and not item.value.is_checked


# -- receive ------------------------------------------------------------------------------------------------------


def receive_functions(scope: Scope) -> list[Lines]:
    """One function for each signal."""
    return [_receive(port, scope) for port in scope.plan.ports]


def receive_head(port: Port, scope: Scope) -> str:
    """The head of the function that takes a value."""
    return (
        f"void {scope.prefix}_Receive_{port.name}({scope.self_argument}, {as_argument(port.wire, 'value')}, uint64_t t)"
    )


def _receive(port: Port, scope: Scope) -> Lines:
    place = f"self->received.{port.name}"
    waiting = [_pushed(call, item) for call, item in port.consumers if item.queue]
    kept = any(item.queue is None for _, item in port.consumers)
    now = f"{scope.prefix}_Now(self, t)"
    body = [
        stored(port.wire, "value", f"{place}.value") if kept else (),
        *waiting,
        lines(f"{place}.reception.time = {now};\n{place}.reception.count++;")
        if is_timed(port)
        else lines(f"(void){now};"),
        () if holds_init(port) else lines(f"{place}.reception.is_there = true;"),
        *(_triggered(call, scope) for call in port.triggers),
    ]
    return function(receive_head(port, scope), body, port.comment)


def _triggered(name: str, scope: Scope) -> Lines:
    call = next(step for step in scope.plan.steps if step.name == name)
    most = call.most_events if call.counts_events else 1
    return block(f"if (self->{name}.waiting < {most}U)", [lines(f"self->{name}.waiting++;")])


def _pushed(call: str, item: Input) -> Lines:
    """A value that waits for a call; a full queue loses the oldest one, or this one."""
    assert item.queue is not None
    queue, length = place_of(call, item), f"{item.queue.length}U"
    put = joined([
        stored(item.value.wire, "value", f"{queue}.values[({queue}.first + {queue}.waiting) % {length}]"),
        lines(f"{queue}.waiting++;"),
    ])  # fmt: skip
    if item.queue.drops_newest:
        return choice([(f"{queue}.waiting == {length}", lines(f"{queue}.is_overflown = true;")), ("", put)])
    drop = lines(f"""
        {queue}.first = ({queue}.first + 1U) % {length};
        {queue}.waiting--;
        {queue}.is_overflown = true;
    """)
    return joined([block(f"if ({queue}.waiting == {length})", [drop]), put])


def place_of(call: str, item: Input) -> str:
    """Where the state of an input is."""
    return f"self->{call}.in.{item.named.name}"


# -- take ---------------------------------------------------------------------------------------------------------


def ends_of(call: Call, item: Input, scope: Scope) -> Ends:
    """Where an input comes from and goes to."""
    source, target = f"self->received.{item.port}.value", scope.variable(item.variable)
    if item.queue:
        source = f"{place_of(call.name, item)}.values[{place_of(call.name, item)}.first]"
        target = f"{target}[taken]" if item.queue.values_per_step > 1 else target
    return Ends(source, target, f"{scope.prefix}_{call.name}_{item.named.name}", item.named.pointer)


def taken(call: Call, item: Input, scope: Scope) -> Lines:
    """An input in a snapshot: an assignment, or a call of its function."""
    if not is_direct(item):
        time = ", t" if item.time_out else ""
        return lines(f"{scope.prefix}_Take_{call.name}_{item.named.name}(self{time});")
    ends = ends_of(call, item, scope)
    value = _right_side(assigned(item.value, ends, scope.prefix))
    port = next(port for port in scope.plan.ports if port.name == item.port)
    if not holds_init(port):
        received = value if value.startswith("(") or " " not in value else f"({value})"
        value = (
            f"self->received.{item.port}.reception.is_there ? {received} : {_right_side(initial(call, item, scope))}"
        )
    return (Line(f"{ends.target} = {value}; /* {item.named.comment} */", item.named.pointer),)


def _right_side(assignment: Lines) -> str:
    return assignment[0].text.partition(" = ")[2].removesuffix(";")


def initial(call: Call, item: Input, scope: Scope) -> Lines:
    """The start value, put into the variable."""
    ends = ends_of(call, item, scope)
    if item.queue and item.queue.values_per_step > 1:
        target = scope.variable(item.variable)
        each = constant(item.value, "init", ends._replace(target=f"{target}[taken]"))
        return block(f"for (taken = 0U; taken < {item.queue.values_per_step}U; taken++)", [each])
    return constant(item.value, "init", ends)


def take_functions(call: Call, scope: Scope) -> list[Lines]:
    """What the snapshot of a call needs: a function for each input that is more than an assignment."""
    found: list[Lines] = []
    for item in call.inputs:
        ends = ends_of(call, item, scope)
        found += [tables(item.value, ends.names, kinds_of(item)), *names_functions(item.value, ends)]
        if not is_direct(item):
            found.append(_take_from_queue(call, item, scope) if item.queue else _take(call, item, scope))
    return [each for each in found if each]


def kinds_of(item: Input) -> tuple[str, ...]:
    """Constants that may stand in for a value."""
    return ("init", "default", "replacement") if item.value.is_replaced else ("init", "default")


def _head(call: Call, item: Input, scope: Scope) -> str:
    time = ", uint64_t t" if item.time_out else ""
    return f"static void {scope.prefix}_Take_{call.name}_{item.named.name}({scope.self_argument}{time})"


def _take(call: Call, item: Input, scope: Scope) -> Lines:
    """Received, checked, not late: converted. Otherwise a constant stands in."""
    ends, place = ends_of(call, item, scope), place_of(call.name, item)
    checked = item.value.is_checked
    received = joined([
        check(item.value, ends) if checked else (),
        lines(f"{place}.range = is_within ? {scope.absent} : {scope.present};") if item.range_error else (),
        lines(f"origin = is_within ? {scope.constant('RECEIVED')} : {scope.constant(_instead(item))};")
        if checked
        else lines(f"origin = {scope.constant('RECEIVED')};"),
    ])  # fmt: skip
    body = [
        lines(f"{scope.prefix}_Origin origin = {scope.constant('INIT')};"),
        index(item.value),
        known_values(item.value),
        flag(item.value) if checked else (),
        (Line(""),),
        block(f"if (self->received.{item.port}.reception.is_there)", [received]),
        _if_late(call, item, scope),
        _by_origin(call, item, ends, scope),
        _is_set(call, item, scope),
    ]
    return function(_head(call, item, scope), body, item.named.comment)


def _instead(item: Input) -> str:
    """Where the value comes from if the received one is out of range."""
    if item.value.is_replaced:
        return "REPLACEMENT"
    return "KEPT" if any(leaf.element.names is not None for leaf in item.value.leaves) else "RECEIVED"


def _if_late(call: Call, item: Input, scope: Scope) -> Lines:
    if item.time_out is None:
        return ()
    late = _late(call, item, scope)
    if item.time_out.substitute == "Last":
        return lines(f"(void){late};")
    return block(f"if ({late})", [lines(f"origin = {scope.constant(item.time_out.substitute.upper())};")])


def _late(call: Call, item: Input, scope: Scope) -> str:
    time_out = item.time_out
    assert time_out is not None
    clock, reception = f"&{place_of(call.name, item)}.clock", f"&self->received.{item.port}.reception"
    first = "true" if time_out.starts_with_first else "false"
    limits = f"{time(time_out.nanoseconds)}, {time_out.recovery}U, {first}"
    return f"{scope.prefix}_IsLate({clock}, {reception}, self->{call.name}.entered, {limits}, t)"


def _by_origin(call: Call, item: Input, ends: Ends, scope: Scope) -> Lines:
    """The value, from where it comes from."""
    ways = [("RECEIVED", assigned(item.value, ends, scope.prefix))]
    if item.value.is_replaced:
        ways.append(("REPLACEMENT", constant(item.value, "replacement", ends)))
    if item.time_out and item.time_out.substitute == "Default":
        ways.append(("DEFAULT", constant(item.value, "default", ends)))
    ways.append(("INIT", initial(call, item, scope)))
    keeps = item.value.is_checked and _instead(item) == "KEPT"
    last = ("", lines("/* the value before stays */")) if keeps else ("", ways.pop()[1])
    return choice([*((f"origin == {scope.constant(name)}", way) for name, way in ways), last])


def _is_set(call: Call, item: Input, scope: Scope) -> Lines:
    if not item.is_reset:
        return ()
    zero = literal(0, item.value.leaves[0].element.target)
    variable = scope.variable(item.variable)
    test = variable if zero == "false" else f"({variable} != {zero})"
    return lines(f"{place_of(call.name, item)}.is_set = {test};", item.named.pointer)


def _take_from_queue(call: Call, item: Input, scope: Scope) -> Lines:
    """Waiting values, oldest first."""
    queue = item.queue
    assert queue is not None
    place, ends = place_of(call.name, item), ends_of(call, item, scope)
    judged = lines(f"{place}.range = are_within ? {scope.absent} : {scope.present};")
    count = f"{scope.variable(queue.count_variable)} = taken;" if queue.count_variable else ""
    body = [
        lines("uint32_t taken;"),
        index(item.value),
        known_values(item.value),
        lines("bool are_within = true;") if item.range_error else (),
        (Line(""),),
        block(f"for (taken = 0U; (taken < {queue.values_per_step}U) && ({place}.waiting > 0U); taken++)",
              [_one_of_queue(call, item, ends, scope)]),
        block("if (taken > 0U)", [judged]) if item.range_error else (),
        lines(count, item.named.pointer) if count else (),
        lines(f"{place}.overflow = {place}.is_overflown ? {scope.present} : {scope.absent};") if queue.overflow_error else (),
        lines(f"{place}.is_overflown = false;"),
        _late_queue(call, item, ends, scope),
        _is_set(call, item, scope),
    ]  # fmt: skip
    return function(_head(call, item, scope), body, item.named.comment)


def _one_of_queue(call: Call, item: Input, ends: Ends, scope: Scope) -> Lines:
    place, length = place_of(call.name, item), item.queue.length if item.queue else 0
    put = assigned(item.value, ends, scope.prefix)
    if item.value.is_checked:
        instead = {
            "REPLACEMENT": [("", constant(item.value, "replacement", ends))], "KEPT": [], "RECEIVED": [("", put)],
        }[_instead(item)]  # fmt: skip
        put = joined([
            flag(item.value),
            check(item.value, ends),
            lines("are_within = are_within && is_within;") if item.range_error else (),
            put if _instead(item) == "RECEIVED" else choice([("is_within", put), *instead]),
        ])  # fmt: skip
    return joined([put, lines(f"{place}.first = ({place}.first + 1U) % {length}U;\n{place}.waiting--;")])


def _late_queue(call: Call, item: Input, ends: Ends, scope: Scope) -> Lines:
    if item.time_out is None:
        return ()
    late, substitute = _late(call, item, scope), item.time_out.substitute
    if substitute == "Last":
        return lines(f"(void){late};")
    return block(f"if ({late} && (taken == 0U))", [constant(item.value, substitute.lower(), ends)])
