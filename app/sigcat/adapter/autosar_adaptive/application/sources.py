"""The functions of an Integration JSON, with where they stand in it."""

from functools import cache

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.function.document.document import Document, Pointer, Position
from sigcat.function.document.read_json import read_json
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from sigcat.limits import Limits

LIST = "SourceFunctionList"


def source_functions(model: IntegrationModel, data: bytes, name: str, limits: Limits) -> tuple[ResolvedFunction, ...]:
    """The functions. Raises InputRefused if there are none."""
    if not model.functions:
        message = f"`{LIST}` must have the functions that were integrated."
        fix = "Write the document anew with `sigcat integrate autosar-adaptive`."
        finding = codes.NOT_WRITABLE_AS_ARXML.finding(message, name, 1, 1, pointer=f"/{LIST}", fix=fix)
        raise InputRefused(f"{name} has no functions to generate an application from.", (finding,))

    @cache
    def whole() -> Document:
        return read_json(data, name, limits)

    def of_function(index: int) -> Document:
        def position(pointer: Pointer, *, of_key: bool = False) -> Position:
            return whole().position((LIST, index, *pointer), of_key=of_key)

        return Document(name, "", None, (), position)

    return tuple(ResolvedFunction(function, of_function(index)) for index, function in enumerate(model.functions))
