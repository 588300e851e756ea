"""Values: numbers, and arrays and structs of numbers, which are tuples of all their numbers in order."""

from collections.abc import Sequence

from tests.adapter.reference.values.number_format import Number

Value = Number | tuple[Number, ...]
"""A value as a variable has it, and as it is received and sent."""
Numbers = tuple[Number, ...]
"""The same with one form: a single number is a tuple of one."""


def numbers_of(value: Value) -> Numbers:
    """All numbers of a value."""
    return value if isinstance(value, tuple) else (value,)


def value_of(numbers: Sequence[Number], *, is_single: bool) -> Value:
    """The value of numbers."""
    return numbers[0] if is_single else tuple(numbers)
