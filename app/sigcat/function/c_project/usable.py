"""The values of an interface that a declaration can have; a finding for each of the others."""

from collections.abc import Iterator, Mapping

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.c_project.code_values import Value
from sigcat.function.c_project.declarations import CompilerError, Declarations, Place
from sigcat.function.c_project.project import Interface
from sigcat.limits import CODE_VALUES


def usable(interface: Interface, declarations: Declarations) -> tuple[Interface, tuple[Finding, ...]]:
    """The interface without values that VSS cannot hold, that the compiler does not understand, or that are too many."""
    wrong = {error.place: error for error in declarations.errors if not error.is_own}
    kept: list[tuple[Value, ...]] = []
    findings: list[Finding] = []
    for values in (interface.inputs, interface.outputs, interface.parameters):
        good = tuple(value for value in values if value.place not in wrong and not value.problem)
        most = CODE_VALUES - sum(map(len, kept))
        kept.append(good[:most])
        findings += (*_left_out(values, wrong), *_too_many(good, most))
    inputs, outputs, parameters = kept
    return interface._replace(inputs=inputs, outputs=outputs, parameters=parameters), tuple(findings)


def _left_out(values: tuple[Value, ...], wrong: Mapping[Place, CompilerError]) -> Iterator[Finding]:
    """A finding for each reason, at the first value that has it."""
    by_reason: dict[str, list[Value]] = {}
    for value in values:
        error = wrong.get(value.place)
        if error is not None:
            by_reason.setdefault(f"clang: {error.message}", []).append(value)
        elif value.problem:
            by_reason.setdefault(f"it {value.problem}", []).append(value)
    for reason, found in by_reason.items():
        first = found[0]
        more = f" and {len(found) - 1:,} more" if len(found) > 1 else ""
        if first.place in wrong:
            message = f"{first.expression!r}{more} must be understood to be imported; {reason}."
            yield codes.CODE_INVALID.finding(message, *first.place, wrong[first.place].column)
        else:
            message = f"{first.expression!r}{more} must hold a value of VSS to be imported; {reason}."
            fix = "Hand it over in a function before or after the call."
            yield codes.VALUE_LEFT_OUT.finding(message, *first.place, fix=fix)


def _too_many(values: tuple[Value, ...], most: int) -> Iterator[Finding]:
    if len(values) > most:
        first = values[most]
        message = f"A model may have {CODE_VALUES:,} values; those from {first.expression!r} on are left out."
        yield codes.VALUE_LEFT_OUT.finding(message, *first.place, fix="Import a model with fewer of them.")
