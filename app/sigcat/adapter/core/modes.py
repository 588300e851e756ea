"""Modes of a function (section 8): what is received and sent, and which calls run in them."""

from sigcat.adapter.core.errors import status_type
from sigcat.adapter.core.plan import ModeIn, ModeOut, ModeValue, Named
from sigcat.adapter.core.planning import Context, expression
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.interfaces.status_interfaces import ModeInterface


def mode_in(context: Context) -> ModeIn | None:
    """The mode that the function receives; None if it receives none."""
    found = _interface("In", context)
    if found is None:
        return None
    at, item = found
    modes = _modes(item, context)
    return ModeIn(
        named=Named("Mode_In", item.vss_path or item.name, at),
        wire=status_type(item.datatype, {}, context)[0],
        modes=modes,
        initial=next((mode for mode in modes if mode.name == item.initial), modes[0]),
        variable=expression(item.variable, item.name, (*at, "Variable"), context),
        goes_to_initial=item.unknown_action == "Initial",
        unknown_error=item.unknown_error,
    )


def mode_out(context: Context) -> ModeOut | None:
    """The mode that the function reports; None if no variable holds it."""
    found = _interface("Out", context)
    if found is None:
        return None
    at, item = found
    variable = expression(item.variable, item.name, (*at, "Variable"), context)
    if variable is None:
        return None
    name = Named("Mode_Out", item.vss_path or item.name, at)
    return ModeOut(name, status_type(item.datatype, {}, context)[0], _modes(item, context), variable)


def _interface(direction: str, context: Context) -> tuple[Pointer, ModeInterface] | None:
    for index, item in enumerate(context.function.mode_interfaces or ()):
        if item.direction == direction and item.modes:
            return ("ModeInterfaceList", index), item
    return None


def _modes(item: ModeInterface, context: Context) -> tuple[ModeValue, ...]:
    datatype = context.datatypes.get(item.datatype)
    numbers = {each.symbol: each.value for each in (datatype.symbols if datatype else None) or ()}
    code = {each.symbol: each.value for each in item.values or ()}
    return tuple(
        ModeValue(name, numbers.get(name, index), code.get(name, numbers.get(name, index)))
        for index, name in enumerate(item.modes)
    )


def excluded_in(call: str, context: Context) -> frozenset[str]:
    """Modes in which a call, given by its interface name, does not run."""
    return frozenset(mode.name for mode in context.function.modes or () if call not in mode.runnables)
