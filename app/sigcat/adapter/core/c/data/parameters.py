"""Parameters: stored, checked, written to the code, and learned (section 11)."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.values.c_values import Ends, Transfer, Way, merged, transfer
from sigcat.adapter.core.plan import Parameter


class ParameterPlan(NamedTuple):
    """A parameter."""

    parameter: Parameter
    address: str
    """`&`, where a value is handed over by its address."""
    checked: Transfer
    """From an argument `value`."""
    written: Transfer
    """From the value that is used to the variable."""
    ways: Sequence[Way]
    learned: Transfer | None
    """From the variable to the stored value."""


def parameter_plan(parameter: Parameter, scope: Scope) -> ParameterPlan:
    """A parameter, as functions of the adapter use it."""
    name, value, wire = parameter.named.name, parameter.value, parameter.value.wire
    ends = Ends(
        source=f"self->parameter.{name}.value",
        target=parameter.variable,
        prefix=scope.prefix,
        name=name,
        pointer=parameter.named.pointer,
        put=scope.put,
    )
    checked = transfer(value, ends._replace(source="(*value)" if wire.is_one_struct else "value"))
    origin = f"self->parameter.{name}.origin == "
    ways = [Way(f"{origin}SIGCAT_RECEIVED", "converted"), Way("", "init")]
    if value.is_replaced and checked.has_range:
        ways.insert(1, Way(f"{origin}SIGCAT_REPLACEMENT", "replacement"))
    written = transfer(value, ends, {way.kind for way in ways})
    return ParameterPlan(
        parameter=parameter,
        address="&" if wire.is_one_struct else "",
        checked=checked,
        written=written,
        ways=merged(ways, written),
        learned=_learned(parameter, ends, scope),
    )


def _learned(parameter: Parameter, ends: Ends, scope: Scope) -> Transfer | None:
    if parameter.learned is None:
        return None
    back = ends._replace(
        source=parameter.variable,
        target=f"self->stored.{parameter.named.name}.value",
        name=f"{ends.name}_Learned",
        put="",
        is_read=scope.is_cpp,
        is_from_code=True,
    )
    return transfer(parameter.learned, back)
