"""Methods that a call offers or uses."""

from sigcat import codes
from sigcat.catalogue.model.datatypes import element_of
from sigcat.catalogue.model.near_units import advice
from sigcat.function.declaration.declaration import ArgumentItem, MethodItem
from sigcat.function.document.document import Pointer
from sigcat.function.document.text import Text
from sigcat.function.function_json.interfaces.methods import Argument, MethodInterface
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.data_interfaces import ROLES
from sigcat.function.resolving.part import Part, each, origin_of, values_of, written
from sigcat.function.resolving.values.numbers import plain_text
from sigcat.names import did_you_mean


def method(item: MethodItem, at: Pointer, context: Context) -> Part[MethodInterface]:
    """A method with its arguments; an argument of an unknown datatype is left out."""
    inputs = each(item.inputs, (*at, "inputs"), context, _argument)
    outputs = each(item.outputs, (*at, "outputs"), context, _argument)
    made = MethodInterface(
        name=item.name,
        description=Text(item.description),
        role=ROLES[item.role],
        inputs=values_of(inputs),
        outputs=values_of(outputs),
        symbol=item.symbol,
        timeout=plain_text(item.timeout),
        request_variable=item.request_variable,
        status_variable=item.status_variable,
    )
    lists: dict[str | int, Origin] = {
        "InDataTypeList": origin_of(inputs, at),
        "OutDataTypeList": origin_of(outputs, at),
    }
    return Part(made, Origin(at, {**written(item, at), **lists}))


def _argument(item: ArgumentItem, at: Pointer, context: Context) -> Part[Argument]:
    if element_of(item.datatype) not in context.datatypes:
        fix = did_you_mean(item.datatype, context.datatypes)
        context.report(codes.DATATYPE_UNFIT, (*at, "datatype"), f"Unknown datatype {item.datatype!r}.", fix)
        return Part(None, Origin(at))
    vocabulary = context.catalogue.vocabulary
    if item.unit is not None and vocabulary.is_unknown(item.unit):
        fix = advice(item.unit, vocabulary)
        context.report(codes.UNIT_NOT_CONVERTIBLE, (*at, "unit"), f"Unknown unit {item.unit!r}.", fix)
    made = Argument(
        name=item.name,
        datatype=context.types.reference(item.datatype),
        units=item.unit or "",
        variable=item.variable,
    )
    return Part(made, Origin(at, written(item, at)))
