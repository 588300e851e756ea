"""Words of Function JSON that say what an adapter does: one of a few, spelled as here."""

from collections.abc import Mapping

from sigcat import codes
from sigcat.function.document.problem import Problem, Problems
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import parts
from sigcat.names import did_you_mean, either

WORDS: Mapping[str, tuple[str, ...]] = {
    "kind": ("enumeration", "array", "struct"),
    "defined_by": ("Function", "Adapter"),
    "range_error_action": ("Default", "Init"),
    "timeout_start": ("Init", "First"),
    "timeout_value": ("Last", "Default", "Init"),
    "overflow": ("DropOldest", "DropNewest"),
    "unknown_action": ("Keep", "Initial"),
}
"""Fields of any model, with the words that they may have."""


def check_words(function: FunctionJson) -> Problems:
    """Every word that is none of those that are known."""
    for pointer, part in parts(function):
        for field, known in WORDS.items():
            info = type(part).model_fields.get(field)
            word = getattr(part, field) if info else None
            if info and word is not None and word not in known:
                key = info.alias or field
                message = f"`{key}` must be {either(known)}, not {word!r}."
                yield Problem(codes.ADAPTER_WORD_UNKNOWN, (*pointer, key), message, did_you_mean(word, known))
