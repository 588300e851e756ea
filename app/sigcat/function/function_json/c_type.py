"""The type of a variable in C: a name that goes into code as it is, and therefore cannot be any text."""

import re
from typing import Annotated

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from sigcat.function.document.field_types import Grammar

C_TYPE_PATTERN = (
    r"^(volatile )?((un)?signed|((un)?signed )?(char|short|int|long|long long|short int|long int|long long int)|float|double|_Bool"
    r"|((enum|struct) )?[A-Za-z_][A-Za-z0-9_]{0,127})$"
)
_OTHER_WORDS = frozenset(
    ("auto", "break", "case", "const", "continue", "default", "do", "else", "enum", "extern", "for", "goto", "if", "inline",
     "register", "restrict", "return", "static", "struct", "switch", "typedef", "union", "void", "volatile", "while")
)  # fmt: skip
"""Words of C that are not the name of a type which a variable can have."""


def _is_type_name(text: str) -> bool:
    return re.fullmatch(C_TYPE_PATTERN, text) is not None and text.rpartition(" ")[2] not in _OTHER_WORDS


def _type_name(text: str) -> str:
    if not _is_type_name(text):
        raise PydanticCustomError("string_pattern_mismatch", "not a type", {"pattern": C_TYPE_PATTERN})
    return text


_GRAMMAR = Grammar("the type of a variable in C", _is_type_name, "Write it as the header does, such as boolean_T.")
CTypeName = Annotated[str, Field(pattern=C_TYPE_PATTERN), AfterValidator(_type_name), _GRAMMAR]
C_TYPE = (
    "Type of `variable` in C, such as boolean_T or volatile unsigned char, of an array that of its elements: an adapter that "
    "defines the variable gives it this type. That of the datatype if absent."
)
