"""Numbers in another unit: exact if the decimal number ends, else with the digits that keep the meaning."""

from decimal import Context, Decimal
from fractions import Fraction

from sigcat.function.function_json.conversion import IDENTITY, Linear, of_text

_MOST_DIGITS = 17
"""Digits that tell any two doubles apart."""
_LONG = 21
"""Digits of a number without an end."""
_TINY = Fraction(10) ** (_LONG - 2)
"""A difference of this part of a number comes from its last digits."""
_ORIGIN_DIGITS = 4
"""Digits after the point of a number that a person wrote, at most."""
_SHARE = 20
"""A rounded limit differs from the exact one by at most this share of the last digit that was written."""


def converted(text: str, conversion: Linear) -> str | None:
    """Return a number of a document in another unit, such as `27.78` for `100` km/h in m/s; None if it is not a number.

    If a shorter number is converted to this one, it was probably the origin: going back restores it.
    """
    number = of_text(text)
    if number is None or conversion == IDENTITY:
        return text if number is not None else None
    exact, last_digit = conversion(number), _last_digit(text)
    return (
        _origin(exact, number, last_digit, conversion.inverse)
        or _ended(exact)
        or _near(exact, conversion.inverse, number, last_digit)
    )


def _origin(exact: Fraction, number: Fraction, last_digit: Fraction, inverse: Linear) -> str:
    """Return the short number that was converted to this one; empty if there is none."""
    for digits in range(_ORIGIN_DIGITS if last_digit < 1 else 0):
        text = _rounded(exact, digits)
        back = inverse(Fraction(text))
        if back == number or abs(back - number) * 2 > last_digit:
            continue
        if not _ended(back) and Fraction(_near(back, inverse.inverse, Fraction(text), _last_digit(text))) == number:
            return text
    return ""


def converted_value(text: str, conversion: Linear) -> str | None:
    """Return a number of a recording in another unit; None if it is not a number.

    A number without an end has more digits than a double, so that going back restores the recorded one.
    """
    number = of_text(text)
    if number is None:
        return None
    exact = conversion(number)
    long, short = (_significant(exact, digits) for digits in (_LONG, _MOST_DIGITS))
    return short if Fraction(short) == Fraction(long) or _is_tiny(Fraction(short) - exact, exact) else long


def _is_tiny(difference: Fraction, number: Fraction) -> bool:
    return abs(difference) * _TINY <= abs(number)


def _significant(number: Fraction, digits: int) -> str:
    """Return a number with so many significant digits, without zeros at its end."""
    context = Context(prec=digits)
    quotient = context.divide(Decimal(number.numerator), Decimal(number.denominator))
    text = format(quotient, "f")
    return text.rstrip("0").rstrip(".") if "." in text else text


def rounded(text: str) -> str:
    """Return the nearest whole number."""
    return str(round(Fraction(text)))


def is_whole(text: str) -> bool:
    """Whether a number is whole."""
    return Fraction(text).denominator == 1


def _near(exact: Fraction, inverse: Linear, number: Fraction, last_digit: Fraction) -> str:
    """Return the shortest number that leads back to the written one."""
    for digits in range(_MOST_DIGITS):
        text = _rounded(exact, digits)
        if abs(inverse(Fraction(text)) - number) * _SHARE <= last_digit:
            return text
    return _rounded(exact, _MOST_DIGITS)


def _ended(exact: Fraction) -> str:
    """Return a number in full; empty if it has no end, or too many digits."""
    text = _rounded(exact, _MOST_DIGITS)
    if Fraction(text) != exact:
        return ""
    return text.rstrip("0").rstrip(".")


def _rounded(number: Fraction, digits: int) -> str:
    scaled = round(number * 10**digits)
    return format(Decimal(scaled).scaleb(-digits), "f")


def _last_digit(text: str) -> Fraction:
    """Return the value of one in the last digit of a number as it is written."""
    mantissa, _, exponent = text.strip().lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    return Fraction(10) ** (min(int(exponent or 0), 0) - decimals)
