"""The type of a variable in C: a name that goes into code as it is, and therefore cannot be any text."""

import re
from typing import Annotated

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from sigcat.function.document.field_types import C_VARIABLE_TYPE, Grammar
from sigcat.reserved_words import C_KEYWORDS

_NO_TYPES = C_KEYWORDS - {"signed", "unsigned", "char", "short", "int", "long", "float", "double", "bool"}


def _is_type_name(text: str) -> bool:
    return re.fullmatch(C_VARIABLE_TYPE, text) is not None and text.rpartition(" ")[2] not in _NO_TYPES


def _type_name(text: str) -> str:
    if not _is_type_name(text):
        raise PydanticCustomError("string_pattern_mismatch", "not a type", {"pattern": C_VARIABLE_TYPE})
    return text


_GRAMMAR = Grammar("the type of a variable in C", _is_type_name, "Write it as the header does, such as boolean_T.")
CTypeName = Annotated[str, Field(pattern=C_VARIABLE_TYPE), AfterValidator(_type_name), _GRAMMAR]
C_TYPE = (
    "Type of `variable` in C, such as boolean_T or volatile unsigned char, of an array that of its elements: an adapter that "
    "defines the variable gives it this type. That of the datatype if absent."
)
