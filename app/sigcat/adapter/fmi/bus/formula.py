"""A formula of a mapping as an expression of C: sums, products, quotients by constants, and rounding."""

from math import isfinite
from typing import Any, NamedTuple, NoReturn

from sigcat.catalogue.network.formula import read_formula

OPERATIONS = "+, -, *, / by a constant, abs, floor, ceil and round"


class CFormula(NamedTuple):
    """A formula, and the expression of C that has its values."""

    text: str
    expression: str
    is_rounded: bool
    """Whether it has no value for a number that is not finite."""
    is_constant: bool


def in_c(text: str) -> CFormula | None:
    """The formula in C; None if it has other operations. It must be one that `read_formula` accepts."""
    x = _Term("x")
    try:
        found = read_formula(text).term(x)  # type: ignore[arg-type]  # it computes an expression in place of a number
        term = found if isinstance(found, _Term) else _Term(_literal(found))
    except (ArithmeticError, ValueError, TypeError):
        return None
    return CFormula(text, term.text, term.is_rounded, is_constant=not isinstance(found, _Term))


def _literal(number: Any) -> str:
    """A number of a formula as a double."""
    if isinstance(number, bool) or not isinstance(number, int | float):
        raise TypeError
    if not isfinite(number):
        raise ValueError  # C has no literal of it
    return repr(float(number))


class _Term:
    """A part of a formula that depends on x. Operations that are not here raise TypeError, as Python does."""

    __hash__ = None  # type: ignore[assignment]

    def __init__(self, text: str, *, is_rounded: bool = False) -> None:
        self.text = text
        self.is_rounded = is_rounded

    def _with(self, operator: str, other: Any, *, is_reversed: bool = False) -> "_Term":
        text = other.text if isinstance(other, _Term) else _literal(other)
        left, right = (text, self.text) if is_reversed else (self.text, text)
        is_rounded = self.is_rounded or (isinstance(other, _Term) and other.is_rounded)
        return _Term(f"({left} {operator} {right})", is_rounded=is_rounded)

    def __add__(self, other: Any) -> "_Term":
        return self._with("+", other)

    def __radd__(self, other: Any) -> "_Term":
        return self._with("+", other, is_reversed=True)

    def __sub__(self, other: Any) -> "_Term":
        return self._with("-", other)

    def __rsub__(self, other: Any) -> "_Term":
        return self._with("-", other, is_reversed=True)

    def __mul__(self, other: Any) -> "_Term":
        return self._with("*", other)

    def __rmul__(self, other: Any) -> "_Term":
        return self._with("*", other, is_reversed=True)

    def __truediv__(self, other: Any) -> "_Term":
        if isinstance(other, _Term) or other == 0:
            raise TypeError
        return self._with("/", other)

    def __neg__(self) -> "_Term":
        return _Term(f"(-{self.text})", is_rounded=self.is_rounded)

    def __abs__(self) -> "_Term":
        return _Term(f"fabs({self.text})", is_rounded=self.is_rounded)

    def __floor__(self) -> "_Term":
        return self._rounded("floor")

    def __ceil__(self) -> "_Term":
        return self._rounded("ceil")

    def __round__(self) -> "_Term":
        return self._rounded("rint")

    def _rounded(self, function: str) -> "_Term":
        """A whole number: a whole zero has no sign."""
        return _Term(f"({function}({self.text}) + 0.0)", is_rounded=True)

    def _unordered(self, _: object) -> NoReturn:
        raise TypeError

    __eq__ = __ne__ = __lt__ = __le__ = __gt__ = __ge__ = _unordered

    def __bool__(self) -> bool:
        raise TypeError
