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
    looped,
    names_functions,
    passing,
    stored,
    tables,
)
from sigcat.adapter.core.plan import Call, Input, Port
from sigcat.function.document.text_filters import block_comment
from sigcat.function.function_json.conversion import IDENTITY

UINT8_MOST = 255


def holds_init(port: Port) -> bool:
    """Whether the start value can stand among the received ones: the call sees the very same bits."""
    return received_init(port) is not None


def received_init(port: Port) -> str | None:
    """The number that the conversion makes the start value of, to the bit; None if none is known for certain."""
    items = [item for _, item in port.consumers]
    if len(items) > 1 or not items[0].is_direct:
        return None
    (leaf,) = items[0].value.leaves
    element, init = leaf.element, leaf.init[0]
    if element.source == element.target and element.conversion == IDENTITY:
        return literal(init, element.target)
    keeps_zero = not element.conversion.offset and element.conversion.factor > 0  # a negative factor makes it -0.0
    return literal(0, element.source) if init == 0 and keeps_zero else None


def place_of(call: str, item: Input) -> str:
    """Member with the state of an input."""
    return f"self->{call}.in.{item.named.name}"


# -- receive ------------------------------------------------------------------------------------------------------


def receive_head(port: Port, scope: Scope) -> str:
    """The head of the function that takes a value."""
    return (
        f"void {scope.prefix}_Receive_{port.name}({scope.self_argument}, {as_argument(port.wire, 'value')}, uint64_t t)"
    )


def reject_head(port: Port, scope: Scope) -> str:
    """The head of the function that reports a message which is not accepted."""
    return f"void {scope.prefix}_Reject_{port.name}({scope.self_argument}, uint64_t t)"


def lose_head(port: Port, scope: Scope) -> str:
    """The head of the function that reports values which the platform has lost."""
    return f"void {scope.prefix}_Lose_{port.name}({scope.self_argument}, uint64_t t)"


# -- check --------------------------------------------------------------------------------------------------------


def judged(call: Call, item: Input, scope: Scope) -> Lines:
    """Whether an input is late, whether values were lost, and whether messages were rejected: in each snapshot."""
    place, found = place_of(call.name, item), list[Lines]()
    if item.time_out:
        first = "true" if item.time_out.starts_with_first else "false"
        times = f"self->{call.name}.entered, {time(item.time_out.nanoseconds)}"
        reception = f"&self->received.{item.port}.reception"
        found.append(lines(
            f"{scope.prefix}_Judge(&{place}.clock, {reception}, {times}, {item.time_out.recovery}U, {first}, t);"
        ))  # fmt: skip
    if item.queue:
        verdict = f"{place}.overflow = {place}.is_overflown ? {scope.present} : {scope.absent};\n"
        found.append(lines(f"{verdict if item.queue.overflow_error else ''}{place}.is_overflown = false;"))
    if item.e2e_error:
        found.append(
            lines(f"""
            {place}.e2e = {place}.is_rejected ? {scope.present} : self->received.{item.port}.e2e;
            {place}.is_rejected = false;
        """)
        )
    return joined(found)


# -- take ---------------------------------------------------------------------------------------------------------


def ends_of(call: Call, item: Input, scope: Scope, place: str = "place") -> Ends:
    """Source and target of an input."""
    source, target = f"self->received.{item.port}.value", scope.variable(item.variable)
    if item.keeps:
        source = f"{place_of(call.name, item)}.kept[{place if item.places > 1 else '0'}]"
    if item.places > 1:
        target = f"{target}[{place}]"
    return Ends(source, target, f"{scope.prefix}_{call.name}_{item.named.name}", item.named.pointer, put=scope.put)


def taken(call: Call, item: Input, scope: Scope) -> Lines:
    """An input in a snapshot: an assignment, or a call of its function."""
    if not item.is_direct:
        return lines(f"{scope.prefix}_Take_{call.name}_{item.named.name}(self);")
    ends = ends_of(call, item, scope)
    value = _right_side(assigned(item.value, ends, scope.prefix))
    port = next(port for port in scope.plan.ports if port.name == item.port)
    if not holds_init(port):
        received = value if value.startswith("(") or " " not in value else f"({value})"
        value = (
            f"self->received.{item.port}.reception.is_there ? {received} : {_right_side(initial(call, item, scope))}"
        )
    return (Line(f"{ends.target} = {value}; {block_comment(item.named.comment)}", item.named.pointer),)


def _right_side(assignment: Lines) -> str:
    return assignment[0].text.partition(" = ")[2].removesuffix(";")


def initial(call: Call, item: Input, scope: Scope) -> Lines:
    """The start value, put into the variable, and none in the count of a queue."""
    count = item.queue.count_variable if item.queue else None
    none = lines(f"{scope.variable(count)} = 0;", item.named.pointer) if count else ()
    each = constant(item.value, "init", ends_of(call, item, scope))
    if item.places > 1:
        each = block(f"for (place = 0U; place < {item.places}U; place++)", [each])
    return joined([each, none])


def take_functions(call: Call, scope: Scope) -> list[Lines]:
    """Functions for the snapshot of a call: one for each input that is more than an assignment."""
    found: list[Lines] = []
    for item in call.inputs:
        ends = ends_of(call, item, scope)
        kinds = ("init", "default", "replacement") if item.value.is_replaced else ("init", "default")
        found += [*tables(item.value, ends.names, kinds), *names_functions(item.value, ends)]
        if not item.is_direct:
            found.append(_take_from_queue(call, item, scope) if item.queue else _take(call, item, scope))
    return [each for each in found if each]


def _head(call: Call, item: Input, scope: Scope) -> str:
    return f"static void {scope.prefix}_Take_{call.name}_{item.named.name}({scope.self_argument})"


def _take(call: Call, item: Input, scope: Scope) -> Lines:
    """Received, checked, not late: converted. Otherwise a constant replaces it."""
    ends, place = ends_of(call, item, scope), place_of(call.name, item)
    is_there = f"self->received.{item.port}.reception.is_there"
    if item.keeps:
        received, first, later = _kept(call, item, scope), "", lines(f"origin = {place}.origin[0];")
    else:
        received, first, later = _originated(call, item, ends, scope), f" = {scope.constant('INIT')}", ()
    body = [
        lines(f"{scope.prefix}_Origin origin{first};"),
        index(item.value),
        known_values(item.value),
        flag(item.value) if item.value.is_checked else (),
        block(f"if ({is_there})", [received]),
        later,
        _if_late(call, item, scope),
        _by_origin(item, ends, scope),
        _is_set(call, item, scope),
    ]
    return function(_head(call, item, scope), body, item.named.comment)


def _range(call: Call, item: Input, scope: Scope, flag_name: str = "is_within") -> Lines:
    if not item.range_error:
        return ()
    return lines(f"{place_of(call.name, item)}.range = {flag_name} ? {scope.absent} : {scope.present};")


def _originated(call: Call, item: Input, ends: Ends, scope: Scope) -> Lines:
    """Source of the value once a value was received."""
    received = scope.constant("RECEIVED")
    if not item.value.is_checked:
        return lines(f"origin = {received};")
    instead = scope.constant(item.instead)
    return joined([
        check(item.value, ends),
        _range(call, item, scope),
        lines(f"origin = is_within ? {received} : {instead};") if instead != received else lines(f"origin = {received};"),
    ])  # fmt: skip


def _kept(call: Call, item: Input, scope: Scope) -> Lines:
    """The received value, kept if every number of it has a name."""
    place = place_of(call.name, item)
    received = ends_of(call, item, scope)._replace(source=f"self->received.{item.port}.value")
    good = joined([
        stored(item.value.wire, _handed(item, received.source), f"{place}.kept[0]"),
        lines(f"{place}.origin[0] = {scope.constant('RECEIVED')};"),
    ])  # fmt: skip
    return joined(
        [check(item.value, received), _range(call, item, scope), block(f"if ({passing(item.value)})", [good])]
    )


def _handed(item: Input, source: str) -> str:
    return f"&{source}" if item.value.wire.is_struct and item.value.wire.length is None else source


def _if_late(call: Call, item: Input, scope: Scope) -> Lines:
    if item.time_out is None or item.time_out.substitute == "Last":
        return ()
    late = f"{place_of(call.name, item)}.clock.is_late"
    return block(f"if ({late})", [lines(f"origin = {scope.constant(item.time_out.substitute.upper())};")])


def _by_origin(item: Input, ends: Ends, scope: Scope) -> Lines:
    """The value, from where it comes from."""
    ways = [("RECEIVED", assigned(item.value, ends, scope.prefix, is_new=item.keeps))]
    if item.value.is_replaced:
        ways.append(("REPLACEMENT", constant(item.value, "replacement", ends)))
    if item.time_out and item.time_out.substitute == "Default":
        ways.append(("DEFAULT", constant(item.value, "default", ends)))
    last = ("", constant(item.value, "init", ends))
    return choice([*((f"origin == {scope.constant(name)}", way) for name, way in ways), last])


def _is_set(call: Call, item: Input, scope: Scope) -> Lines:
    """Whether any number of the variable is not 0."""
    if not item.is_reset:
        return ()
    place, variable = f"{place_of(call.name, item)}.is_set", scope.variable(item.variable)
    is_one = item.value.leaves[0].length is None and item.places == 1
    found = [] if is_one else [lines(f"{place} = false;")]
    for leaf in item.value.leaves:
        target = f"{variable}{'[place]' if item.places > 1 else ''}{leaf.target}"
        zero = literal(0, leaf.element.target)
        is_cast = scope.is_cpp and leaf.element.is_enumeration
        number = f"({leaf.element.target.c}){target}" if is_cast else target
        test = number if zero == "false" else f"({number} != {zero})"
        before = f"{place} || " if found else ""
        each = looped(leaf, lines(f"{place} = {before}{test};", item.named.pointer))
        if item.places > 1:
            each = block(f"for (place = 0U; place < {item.places}U; place++)", [each])
        found.append(each)
    return joined(found)


# -- queues -------------------------------------------------------------------------------------------------------


def _take_from_queue(call: Call, item: Input, scope: Scope) -> Lines:
    """Waiting values, oldest first."""
    assert item.queue is not None
    queue = place_of(call.name, item)
    judged_range = block("if (taken > 0U)", [_range(call, item, scope, "are_within")]) if item.range_error else ()
    body = [
        lines("uint32_t taken;"),
        lines("uint32_t place;") if item.places > 1 else (),
        index(item.value),
        known_values(item.value),
        lines("bool are_within = true;") if item.range_error else (),
        block(
            f"for (taken = 0U; (taken < {item.places}U) && ({queue}.waiting > 0U); taken++)",
            [_one_of_queue(call, item, scope)],
        ),
        judged_range,
        _shown(call, item, scope),
        _is_set(call, item, scope),
    ]
    return function(_head(call, item, scope), body, item.named.comment)


def _one_of_queue(call: Call, item: Input, scope: Scope) -> Lines:
    """One value that waits, kept in the place that it gets."""
    queue, length = place_of(call.name, item), item.queue.length if item.queue else 0
    place = "taken" if item.places > 1 else "0"
    first = ends_of(call, item, scope)._replace(source=f"{queue}.values[{queue}.first]")
    keep = joined([
        stored(item.value.wire, _handed(item, first.source), f"{queue}.kept[{place}]"),
        lines(f"{queue}.origin[{place}] = {scope.constant('RECEIVED')};"),
    ])  # fmt: skip
    if item.value.is_checked:
        replaced = lines(f"{queue}.origin[{place}] = {scope.constant('REPLACEMENT')};")
        ways = {
            "REPLACEMENT": [("is_within", keep), ("", replaced)],
            "KEPT": [(passing(item.value), keep)],
            "RECEIVED": [("", keep)],
        }
        keep = joined([
            flag(item.value),
            check(item.value, first),
            lines("are_within = are_within && is_within;") if item.range_error else (),
            choice(ways[item.instead]),
        ])  # fmt: skip
    return joined([keep, lines(f"{queue}.first = ({queue}.first + 1U) % {length}U;\n{queue}.waiting--;")])


def _shown(call: Call, item: Input, scope: Scope) -> Lines:
    """Write the stored values, or their replacement, to the variable, and the number of values."""
    assert item.queue is not None
    queue, ends = place_of(call.name, item), ends_of(call, item, scope)
    place = "place" if item.places > 1 else "0"
    ways = [(f"{queue}.origin[{place}] == {scope.constant('RECEIVED')}",
             assigned(item.value, ends, scope.prefix, is_new=True))]  # fmt: skip
    if item.value.is_replaced:
        replaced = constant(item.value, "replacement", ends)
        ways.append((f"{queue}.origin[{place}] == {scope.constant('REPLACEMENT')}", replaced))
    count = scope.variable(item.queue.count_variable) if item.queue.count_variable else ""
    narrow = "uint8_t" if item.places <= UINT8_MOST else "uint16_t"  # so that it fits whatever holds the count
    if item.time_out and item.time_out.substitute != "Last":
        substitute = constant(item.value, item.time_out.substitute.lower(), ends)
        ways.insert(0, (f"{queue}.clock.is_late", substitute))
        counted = f"{count} = {queue}.clock.is_late ? ({narrow})0 : ({narrow})taken;"
    else:
        counted = f"{count} = ({narrow})taken;"
    each = choice([*ways, ("", constant(item.value, "init", ends))])
    if item.places > 1:
        each = block(f"for (place = 0U; place < {item.places}U; place++)", [each])
    return joined([each, lines(counted, item.named.pointer) if count else ()])
