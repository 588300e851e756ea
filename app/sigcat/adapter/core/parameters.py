"""Parameters of a function (section 11). One that several calls list is one parameter."""

from collections.abc import Sequence

from sigcat import codes
from sigcat.adapter.core.core_values import value_of
from sigcat.adapter.core.interfaces import named
from sigcat.adapter.core.plan import Parameter
from sigcat.adapter.core.planning import Context, ListedCall, expression
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.function_json.interfaces.data_interfaces import ParameterInterface

LEARNED = "LearningParameter"


def parameters_of(calls: Sequence[ListedCall], context: Context) -> tuple[Parameter, ...]:
    """The parameters of all calls, which are given with their short names and pointers."""
    found: dict[str, Parameter] = {}
    by_variable: dict[str, str] = {}
    for call, at, item in _listed(calls):
        known = by_variable.get(item.variable or "")
        if known is not None:
            found[known] = found[known]._replace(calls=(*found[known].calls, call))
            continue
        made = _parameter(item, at, call, found, context)
        if made is not None:
            found[made.named.name] = made
            by_variable[made.variable] = made.named.name
    return tuple(found.values())


def _listed(calls: Sequence[ListedCall]) -> list[tuple[str, Pointer, ParameterInterface]]:
    return [
        (name, (*at, "funcContractList", index, "ParameterList", number), item)
        for name, at, call in calls
        for index, contract in enumerate(call.contracts or ())
        for number, item in enumerate(contract.parameters or ())
    ]


def _parameter(
    item: ParameterInterface, at: Pointer, call: str, taken: dict[str, Parameter], context: Context
) -> Parameter | None:
    if item.variable is None:
        subject = Subject("data", item.vss_path or item.name)
        message = f"{item.name} must have a variable of the C code."
        context.report(codes.VARIABLE_MISSING, at, message, "Give `variable`, such as `parameters.gain`.", subject)
        return None
    variable = expression(item.variable, item.name, (*at, "Variable"), context)
    value = value_of(item, at, context, to_code=True)
    if variable is None or value is None:
        return None
    back = value_of(item, at, context, to_code=False)
    assert back is not None
    return Parameter(
        named=named(item, at, taken),
        key=item.key or item.name,
        variable=variable,
        value=value,
        learned=back if item.attribute == LEARNED else None,
        calls=(call,),
        range_error=item.range_error,
    )
