"""The functions of an Integration JSON, with their places in it."""

from collections.abc import Sequence
from functools import cache

from sigcat.errors import InputRefused
from sigcat.findings import RuleCode
from sigcat.function.document.document import Document, Pointer, Position
from sigcat.function.document.read_json import read_json
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.source_functions import SOURCE_FUNCTIONS
from sigcat.limits import Limits


def source_functions(
    functions: Sequence[FunctionJson] | None, data: bytes, name: str, limits: Limits, rule: RuleCode, platform: str
) -> tuple[ResolvedFunction, ...]:
    """The functions of a document that was read and checked. Raises InputRefused if there are none."""
    if not functions:
        message = f"`{SOURCE_FUNCTIONS}` must have the functions that were integrated."
        fix = f"Write the document again with `sigcat integrate {platform}`."
        finding = rule.finding(message, name, 1, 1, pointer=f"/{SOURCE_FUNCTIONS}", fix=fix)
        raise InputRefused(f"{name} has no functions to generate adapters from.", (finding,))

    @cache
    def whole() -> Document:
        return read_json(data, name, limits)

    def of_function(index: int) -> Document:
        def position(pointer: Pointer, *, of_key: bool = False) -> Position:
            return whole().position((SOURCE_FUNCTIONS, index, *pointer), of_key=of_key)

        return Document(name, "", None, (), position)

    return tuple(ResolvedFunction(function, of_function(index)) for index, function in enumerate(functions))
