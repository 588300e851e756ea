"""The datatypes of a document."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.function.document.problem import Problem
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import references
from sigcat.names import did_you_mean


def check_types(function: FunctionJson) -> Iterator[Problem]:
    """Every datatype that is referred to is defined."""
    defined = dict.fromkeys(datatype.reference for datatype in function.datatypes)
    for pointer, reference in references(function):
        if reference not in defined:
            message = f"The datatype must be one of the document's `Datatypes`, not {reference!r}."
            yield Problem(codes.TYPE_UNDEFINED, pointer, message, did_you_mean(reference, defined))
