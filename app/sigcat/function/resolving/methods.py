"""Methods that a call offers or uses."""

from collections.abc import Sequence

from sigcat import codes
from sigcat.catalogue.model.datatypes import element_of
from sigcat.function.declaration.declaration import ArgumentItem, MethodItem
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem
from sigcat.function.function_json.methods import Argument, MethodInterface
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.resolving.context import Context, Resolving
from sigcat.function.resolving.data_interfaces import ROLES
from sigcat.function.resolving.part import Part, written


def method(item: MethodItem, at: Pointer, context: Context) -> Resolving[Part[MethodInterface]]:
    """A method with its arguments; an argument of an unknown datatype is left out."""
    made = MethodInterface(
        name=item.name,
        description=item.description,
        role=ROLES[item.role],
        inputs=(yield from _arguments(item.inputs, (*at, "inputs"), context)),
        outputs=(yield from _arguments(item.outputs, (*at, "outputs"), context)),
    )
    return Part(made, Origin(at, written(item, at)))


def _arguments(items: Sequence[ArgumentItem], at: Pointer, context: Context) -> Resolving[tuple[Argument, ...]]:
    made = []
    for index, item in enumerate(items):
        argument = yield from _argument(item, (*at, index), context)
        if argument is not None:
            made.append(argument)
    return tuple(made)


def _argument(item: ArgumentItem, at: Pointer, context: Context) -> Resolving[Argument | None]:
    if element_of(item.datatype) not in context.datatypes:
        fix = context.hint(item.datatype, context.datatypes)
        yield Problem(codes.DATATYPE_UNFIT, (*at, "datatype"), f"Unknown datatype {item.datatype!r}.", fix)
        return None
    vocabulary = context.catalogue.vocabulary
    if item.unit is not None and vocabulary.unit(item.unit) is None:
        fix = context.hint(item.unit, [unit.key for unit in vocabulary.distinct_units])
        yield Problem(codes.UNIT_NOT_CONVERTIBLE, (*at, "unit"), f"Unknown unit {item.unit!r}.", fix)
    return Argument(name=item.name, datatype=context.types.reference(item.datatype), units=item.unit or "")
