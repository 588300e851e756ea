"""Parameters: stored, checked, written to the code, and learned (section 11)."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.values.c_values import Transfer, Way, from_variable, merged, to_variable, transfer
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
    (name, _, pointer), value, wire = parameter.named, parameter.value, parameter.value.wire
    ends = to_variable(f"self->parameter.{name}.value", parameter.variable, name, pointer, scope)
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
        learned=_learned(parameter, scope),
    )


def _learned(parameter: Parameter, scope: Scope) -> Transfer | None:
    if parameter.learned is None:
        return None
    name, _, pointer = parameter.named
    target = f"self->stored.{name}.value"
    return transfer(parameter.learned, from_variable(parameter.variable, target, f"{name}_Learned", pointer, scope))
