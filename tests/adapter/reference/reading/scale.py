"""Scales: between the stored value of the code, the physical value, and the value in the catalogue's unit (section 4)."""

from dataclasses import dataclass
from fractions import Fraction

JsonNumber = int | float

_FINEST = 345
"""Decimal places of any double."""


def exact(number: str | JsonNumber | None) -> Fraction | None:
    """The number that is meant: 0.1 is a tenth."""
    if number is None or number == "":
        return None
    return Fraction(number.strip() if isinstance(number, str) else repr(number))


@dataclass(frozen=True)
class Scale:
    """`result = value × factor + offset`."""

    factor: Fraction = Fraction(1)
    offset: Fraction = Fraction(0)

    @property
    def is_identity(self) -> bool:
        """Whether results are as the values."""
        return self.factor == 1 and self.offset == 0

    def forward(self, value: Fraction) -> Fraction:
        """The result of a value."""
        return value * self.factor + self.offset

    def back(self, result: Fraction) -> Fraction:
        """The value of a result."""
        return (result - self.offset) / self.factor


def scale(factor: str | JsonNumber | None, offset: str | JsonNumber | None) -> Scale:
    """A scale as a document has it: absent is 1, and 0."""
    given = exact(factor)
    return Scale(Fraction(1) if given is None else given, exact(offset) or Fraction(0))


def shortest(number: Fraction, conversion: Scale) -> Fraction:
    """The result of a number that a document has as a double: of all that give this double, the shortest decimal."""
    result, double = conversion.forward(number), float(number)
    if conversion.is_identity:
        return result
    for places in range(-len(str(abs(round(result)))), _FINEST):
        candidate = round(result, places)
        if float(conversion.back(candidate)) == double:
            return candidate
    return result
