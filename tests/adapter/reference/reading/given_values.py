"""Start values and defaults that a document gives: physical values in the code's unit, one for each number of a value."""

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sigcat.function.document.text import Text, json_of
from tests.adapter.reference.reading.scale import JsonNumber, exact
from tests.adapter.reference.reading.shape import Leaf, Shape

Given = tuple[Fraction | None, ...]
"""One for each number of a value; None where there is none."""


def given_values(number: JsonNumber | None, elements: Text | None, shape: Shape) -> Given:
    """Return the number for all elements or the elements; the elements take precedence."""
    if elements is not None:
        whole = json_of(elements)
        return tuple(_number(_at(whole, leaf), leaf) for leaf in shape.leaves)
    return tuple(None if shape.has_members else exact(number) for _ in shape.leaves)


def _at(whole: Any, leaf: Leaf) -> Any:
    """Return the JSON value at the place of a leaf; a list that is too short continues with its last value."""
    for key in leaf.path:
        if isinstance(whole, list) and isinstance(key, int):
            whole = whole[min(key, len(whole) - 1)] if whole else None
        elif isinstance(key, str):
            whole = whole.get(key) if isinstance(whole, Mapping) else None
    return whole


def _number(value: Any, leaf: Leaf) -> Fraction | None:
    if isinstance(value, str) and leaf.symbols is not None:
        return exact(leaf.symbols.get(value))
    if isinstance(value, bool):
        return Fraction(int(value))
    return exact(value) if isinstance(value, int | float) else None
