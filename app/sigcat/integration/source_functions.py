"""The functions that an Integration JSON was made from: the same field on every platform."""

from typing import Any

from sigcat.function.function_json.wire import own

SOURCE_FUNCTIONS = "SourceFunctionList"
"""Name of the field on the wire."""


def source_functions() -> Any:
    """The field: `functions: tuple[FunctionJson, ...] | None = source_functions()`."""
    return own(
        SOURCE_FUNCTIONS,
        "The Function JSON of each function that was integrated: what adapters are generated from.",
        strict=False,
    )
