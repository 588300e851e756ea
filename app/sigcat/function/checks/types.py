"""The datatypes of a document."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.primitive_types import integer_range
from sigcat.function.function_json.walk import references
from sigcat.names import did_you_mean


def check_types(function: FunctionJson) -> Iterator[Problem]:
    """Every datatype that is referred to is defined, and its type in C holds the values of an enumeration."""
    defined = dict.fromkeys(datatype.reference for datatype in function.datatypes)
    for pointer, reference in references(function):
        if reference not in defined:
            message = f"The datatype must be one of the document's `Datatypes`, not {reference!r}."
            yield Problem(codes.TYPE_UNDEFINED, pointer, message, did_you_mean(reference, defined))
    for index, datatype in enumerate(function.datatypes):
        ends = integer_range(datatype.c_definition)
        for number, each in enumerate(datatype.symbols or ()):
            if ends is not None and not ends[0] <= each.value <= ends[1]:
                at = ("Datatypes", index, "Symbols", number, "Value")
                message = f"`Value` of {each.symbol!r} must be from {ends[0]} to {ends[1]}, as {datatype.c_definition} holds it."
                yield Problem(codes.SYMBOL_OUT_OF_RANGE, at, message, subject=Subject("datatype", datatype.reference))
