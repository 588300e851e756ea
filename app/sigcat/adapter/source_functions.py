"""The functions of an Integration JSON, with where they stand in it."""

from collections.abc import Sequence
from functools import cache

from sigcat.errors import InputRefused
from sigcat.findings import RuleCode
from sigcat.function.checks.types import check_types
from sigcat.function.document.document import Document, Pointer, Position
from sigcat.function.document.read_json import read_json
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.source_functions import SOURCE_FUNCTIONS
from sigcat.limits import Limits


def source_functions(
    functions: Sequence[FunctionJson] | None, data: bytes, name: str, limits: Limits, rule: RuleCode, platform: str
) -> tuple[ResolvedFunction, ...]:
    """The functions of a document. Raises InputRefused if there are none, or they use datatypes that they do not have."""
    if not functions:
        message = f"`{SOURCE_FUNCTIONS}` must have the functions that were integrated."
        fix = f"Write the document anew with `sigcat integrate {platform}`."
        finding = rule.finding(message, name, 1, 1, pointer=f"/{SOURCE_FUNCTIONS}", fix=fix)
        raise InputRefused(f"{name} has no functions to generate adapters from.", (finding,))

    @cache
    def whole() -> Document:
        return read_json(data, name, limits)

    def of_function(index: int) -> Document:
        def position(pointer: Pointer, *, of_key: bool = False) -> Position:
            return whole().position((SOURCE_FUNCTIONS, index, *pointer), of_key=of_key)

        return Document(name, "", None, (), position)

    found = tuple(ResolvedFunction(function, of_function(index)) for index, function in enumerate(functions))
    if findings := tuple(
        finding._replace(pointer=f"/{SOURCE_FUNCTIONS}/{index}{finding.pointer}")
        for index, each in enumerate(found)
        for finding in each.findings(check_types(each.function))
    ):
        raise InputRefused(f"{name} has functions that lack datatypes.", findings)
    return found
