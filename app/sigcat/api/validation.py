"""Why a value was refused, from an error of pydantic."""

from collections.abc import Mapping
from typing import Any


def reason_of(error: Mapping[str, Any]) -> str:
    """The reason as the rest of a sentence; where one of our validators refused the value, what that says."""
    if error["type"] == "bool_parsing":
        return "must be true or false"
    said = str(error["ctx"]["error"]) if error["type"] == "value_error" else str(error["msg"])
    return f"{said[:1].lower()}{said[1:]}".rstrip(".")
