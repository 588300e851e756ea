"""Types of the header: enumerations, structs, and what is stored."""

from collections.abc import Iterable

from sigcat.adapter.core.c import inputs, methods, parameters
from sigcat.adapter.core.c.lines import Line, Lines, block, indented, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import declared
from sigcat.adapter.core.plan import (
    Method,
    WireField,
    WireStruct,
    WireType,
)
from sigcat.adapter.text_filters import AnyText, block_comment


def enumeration(name: str, constants: Iterable[tuple[str, str]]) -> Lines:
    """An enumeration; each constant with what it means."""
    found = list(constants)
    rows = [f"    {text}{',' if n < len(found) - 1 else ''}{f' {block_comment(why)}' if why else ''}"
            for n, (text, why) in enumerate(found)]  # fmt: skip
    return tuple(Line(text) for text in ("typedef enum {", *rows, f"}} {name};"))


def struct(name: str, members: Iterable[Lines], comment: AnyText = "") -> Lines:
    """A struct type."""
    before = (Line(block_comment(comment)),) if comment else ()
    return (*before, Line("typedef struct {"), *indented(joined(members)), Line(f"}} {name};"))


def types(scope: Scope) -> list[Lines]:
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
        {p}_ErrorState before; /* the last one */
        uint64_t since; /* when it began */
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
    return lines(f"{field.c} {field.name}{length};{f' {block_comment(field.comment)}' if field.comment else ''}")


def member(wire: WireType, name: str, comment: str) -> Lines:
    return lines(f"{declared(wire, name)}; {block_comment(comment)}")


def _method_types(method: Method, scope: Scope) -> list[Lines]:
    found = []
    for items, name in ((method.arguments, methods.arguments_type), (method.results, methods.results_type)):
        if items:
            members = [lines(f"{declared(each.value.wire, each.name)};") for each in items]
            found.append(struct(name(method, scope), members))
    return found


def _parameters(scope: Scope) -> Lines:
    members = [member(each.value.wire, each.named.name, each.named.comment) for each in parameters.settable(scope)]
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
