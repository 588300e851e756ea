"""Methods that a function offers or uses (section 12)."""

from collections.abc import Sequence

from sigcat import codes
from sigcat.adapter.core.core_values import value_of
from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.plan import Argument, Method, Named, Value
from sigcat.adapter.core.planning import Context, ListedCall, expression, nanoseconds
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.document.text import Text
from sigcat.function.function_json.interfaces.data_interfaces import Signal
from sigcat.function.function_json.interfaces.methods import Argument as DeclaredArgument
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.role import CONSUMER


def methods_of(calls: Sequence[ListedCall], context: Context) -> tuple[Method, ...]:
    """The methods of all calls, which are given with their short names and pointers."""
    found: dict[str, Method] = {}
    for name, at, call in calls:
        for index, contract in enumerate(call.contracts or ()):
            for number, item in enumerate(contract.methods or ()):
                where = (*at, "funcContractList", index, "MethodList", number)
                made = _method(item, where, name, context)
                if made is not None:
                    found.setdefault(made.named.name, made)
    return tuple(found.values())


def _method(item: MethodInterface, at: Pointer, call: str, context: Context) -> Method | None:
    is_offered = item.role != CONSUMER
    missing = item.symbol is None if is_offered else item.request_variable is None
    if missing:
        wanted = "symbol" if is_offered else "requestVariable"
        message = f"The method {item.name} must have a {'function' if is_offered else 'variable'} of the C code."
        context.report(codes.VARIABLE_MISSING, at, message, f"Give `{wanted}`.", Subject("method", item.name))
        return None
    inputs, outputs = (*at, "InDataTypeList"), (*at, "OutDataTypeList")
    arguments = _arguments(item.inputs, inputs, context, is_received=is_offered)
    results = _arguments(item.outputs, outputs, context, is_received=not is_offered)
    return Method(
        named=Named(identifier(item.name), item.name, at),
        call=call,
        is_offered=is_offered,
        symbol=item.symbol,
        arguments=arguments,
        results=results,
        time_out=nanoseconds(item.timeout, (*at, "Timeout"), context),
        request_variable=expression(item.request_variable, item.name, (*at, "RequestVariable"), context),
        status_variable=expression(item.status_variable, item.name, (*at, "StatusVariable"), context),
    )


def _arguments(
    items: tuple[DeclaredArgument, ...], at: Pointer, context: Context, *, is_received: bool
) -> tuple[Argument, ...]:
    """Arguments or results. Those that the function receives are checked."""
    made = []
    for index, item in enumerate(items):
        where = (*at, index)
        if item.variable is None:
            message = f"The argument {item.name} must have a variable of the C code."
            context.report(codes.VARIABLE_MISSING, where, message, "Give `variable`.")
            continue
        variable = expression(item.variable, item.name, (*where, "Variable"), context)
        value = value_of(_as_signal(item), where, context, to_code=is_received)
        if variable is not None and value is not None:
            made.append(Argument(identifier(item.name), variable, value if is_received else _unchecked(value)))
    return tuple(made)


def _unchecked(value: Value) -> Value:
    """A value whose enumerations pass as the numbers that they are."""
    leaves = (leaf._replace(element=leaf.element._replace(names=None)) for leaf in value.leaves)
    return value._replace(leaves=tuple(leaves))


def _as_signal(item: DeclaredArgument) -> Signal:
    """An argument has neither its own range nor unit: a signal whose catalogue is the code."""
    return Signal(name=item.name, description=Text(""), role=CONSUMER, datatype=item.datatype)
