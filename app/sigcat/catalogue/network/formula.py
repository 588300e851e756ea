"""The formulas of mappings, `floor((x * 40) - 100)`: read by their own grammar and never evaluated as code.

Words and precedence are those of py-expression-eval, which both VSS's network serialization profile and the KUKSA CAN provider
name, so that a formula gives the same bits: `/` and `%` bind tighter than `*`, and `2 ^ 3 ^ 2` is 64. A formula that it refuses,
or that it computes without an operand, as `2 * -x`, is refused. Texts, lists and dice are not read.
"""

import math
import operator
import re
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from sigcat.findings import shown
from sigcat.limits import FORMULA_CHARACTERS, FORMULA_DEPTH
from sigcat.names import did_you_mean

_Term = Callable[[float], Any]
"""The value of a part of a formula, for an x: whole numbers stay whole."""


class BadFormula(Exception):
    """A text is not a formula; `at` is the character that is wrong, from 0."""

    def __init__(self, message: str, at: int, fix: str = "") -> None:
        super().__init__(message)
        self.at = at
        self.fix = fix


class Formula(NamedTuple):
    """A function of one number, which is called x."""

    text: str
    term: _Term

    def value(self, x: float) -> float | None:
        """The value for a number, whole if it is computed of whole numbers; None if there is none, as where it divides by 0."""
        try:
            found: float = self.term(x)
            float(found)  # not a complex number, and not a whole one beyond a double
        except (ArithmeticError, ValueError, TypeError):
            return None
        return found


@lru_cache(maxsize=4096)
def read_formula(text: str) -> Formula:
    """The formula of a text. Raises BadFormula."""
    if len(text) > FORMULA_CHARACTERS:
        raise BadFormula(f"it is longer than {FORMULA_CHARACTERS:,} characters", FORMULA_CHARACTERS)
    reader = _Reader(text, _tokens(text))
    term = reader.expression(0)
    if not reader.is_at_end:
        raise reader.unexpected("an operator")
    return Formula(text, term)


# -- words --------------------------------------------------------------------------------------------------------


class _Token(NamedTuple):
    text: str
    at: int


_TOKEN = re.compile(
    r"\s*(?:((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|([A-Za-z_]\w*)|(\*\*|==|!=|<=|>=|[-+*/%^<>(),∙•]))", re.ASCII
)
_OF_NUMBERS = "0123456789."
_SPACE = re.compile(r"\s*")


def _tokens(text: str) -> Sequence[_Token]:
    found: list[_Token] = []
    at = 0
    end = len(text.rstrip())
    while at < end:
        match = _TOKEN.match(text, at)
        if match is None:
            space = _SPACE.match(text, at)
            wrong = space.end() if space else at
            raise BadFormula(f"{shown(text[wrong])} has no meaning", wrong)
        word, begin = match[match.lastindex or 0], match.start(match.lastindex or 0)
        at = match.end()
        found.append(_Token(_spaced(word, text[at : at + 1], at) if word in _SPACED else word, begin))
    return found


def _spaced(word: str, next_: str, at: int) -> str:
    """An operator that is a word. `not(` is a function, which binds tighter than the operator `not `."""
    if next_ == " ":
        return f"{word} " if word == "not" else word
    if word == "not" and next_ == "(":
        return word
    raise BadFormula(f"a space must follow `{word}`", at)


_CONSTANTS = {"PI": math.pi, "E": math.e}
_MOST_BITS = 100_000
"""Bits of a whole number that a power may have."""


def _power(base: Any, exponent: Any) -> Any:
    if isinstance(base, int) and isinstance(exponent, int) and base.bit_length() * exponent > _MOST_BITS:
        raise OverflowError
    return base**exponent


def _and(left: Any, right: Any) -> Any:
    return right if left else left


def _or(left: Any, right: Any) -> Any:
    return left or right


_BINARY: Mapping[str, tuple[int, Callable[[Any, Any], Any]]] = {
    "or": (0, _or), "xor": (0, operator.xor), "and": (1, _and),
    "==": (3, operator.eq), "!=": (3, operator.ne), "<=": (3, operator.le), ">=": (3, operator.ge),
    "<": (3, operator.lt), ">": (3, operator.gt),
    "+": (4, operator.add), "-": (4, operator.sub),
    "*": (5, operator.mul), "∙": (5, operator.mul), "•": (5, operator.mul),
    "/": (6, operator.truediv), "%": (6, operator.mod),
    "^": (8, _power), "**": (8, _power),
}  # fmt: skip
"""Operators with their precedence; all of them go from left to right."""
_NEGATIVE, _NOT, _CALL = 5, 2, 8
"""Precedence of a sign, of `not` and of the call of a function with several arguments.

py-expression-eval computes an operator that it has read as soon as one of lower or equal precedence follows, also where its
second operand is still to come.
"""
_NOWHERE = -1
_SPACED = frozenset({"or", "xor", "and", "not"})
"""Words that py-expression-eval knows by the space behind them."""


def _if(condition: float, then: float, otherwise: float) -> float:
    return then if condition else otherwise


def _hypotenuse(a: float, b: float) -> float:
    return math.sqrt(a * a + b * b)


_MANY = 100
_FUNCTIONS: Mapping[str, tuple[int, int, Callable[..., float]]] = {
    **{name: (1, 1, getattr(math, name)) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp")},
    "sind": (1, 1, lambda x: math.sin(math.radians(x))),
    "cosd": (1, 1, lambda x: math.cos(math.radians(x))),
    "tand": (1, 1, lambda x: math.tan(math.radians(x))),
    "asind": (1, 1, lambda x: math.degrees(math.asin(x))),
    "acosd": (1, 1, lambda x: math.degrees(math.acos(x))),
    "atand": (1, 1, lambda x: math.degrees(math.atan(x))),
    "abs": (1, 1, abs), "ceil": (1, 1, math.ceil), "floor": (1, 1, math.floor), "round": (1, 1, round),
    "not": (1, 1, operator.not_),
    "log": (1, 2, math.log), "pow": (2, 2, math.pow), "atan2": (2, 2, math.atan2), "pyt": (2, 2, _hypotenuse),
    "min": (2, _MANY, min), "max": (2, _MANY, max), "if": (3, 3, _if),
}  # fmt: skip
"""Functions with the least and the greatest number of arguments."""
_CALLED = frozenset({"log", "pow", "atan2", "pyt", "min", "max", "if"})
"""Functions that py-expression-eval calls; the others are operators for it, which bind tightest."""


# -- grammar ------------------------------------------------------------------------------------------------------


class _Reader:
    """Reads words one after the other; what it gives computes the value. Terms of constants alone are computed once."""

    def __init__(self, text: str, tokens: Sequence[_Token]) -> None:
        self.text = text
        self.tokens = tokens
        self.next = 0
        self.depth = 0

    @property
    def is_at_end(self) -> bool:
        return self.next >= len(self.tokens)

    @property
    def word(self) -> str:
        """The word that comes; nothing at the end."""
        return "" if self.is_at_end else self.tokens[self.next].text

    def take(self) -> _Token:
        """The word that comes."""
        self.next += 1
        return self.tokens[self.next - 1]

    def unexpected(self, wanted: str) -> BadFormula:
        """Return the error at the next word."""
        if self.is_at_end:
            return BadFormula(f"{wanted} is missing at its end", len(self.text))
        token = self.tokens[self.next]
        return BadFormula(f"{wanted} must be in the place of {shown(token.text)}", token.at)

    def expect(self, word: str) -> None:
        """Take this word. Raises BadFormula if another one comes."""
        if self.word != word:
            raise self.unexpected(f"`{word}`")
        self.next += 1

    def expression(self, least: int, pending: int = _NOWHERE) -> _Term:
        """An expression of operators that bind at least so tight, behind an operator of a precedence that waits for it."""
        self.depth += 1
        if self.depth > FORMULA_DEPTH:
            raise BadFormula(f"it is nested deeper than {FORMULA_DEPTH} levels", self.tokens[self.next - 1].at)
        left = self.operand(pending)
        while not self.is_at_end and self.word in _BINARY and _BINARY[self.word][0] >= least:
            precedence, compute = _BINARY[self.take().text]
            left = _binary(compute, left, self.expression(precedence + 1, precedence))
        self.depth -= 1
        return left

    def operand(self, pending: int) -> _Term:
        """A number, x, a call, or an expression in parentheses, with the signs before it."""
        while self.word == "+":
            self.next += 1
        if self.is_at_end or self.word in (")", ",") or (self.word in _BINARY and self.word != "-"):
            raise self.unexpected("a number, x or a function")
        token = self.take()
        if token.text == "(":
            inner = self.expression(0)
            self.expect(")")
            return inner
        if token.text == "-":
            self.refuse_behind(pending, _NEGATIVE, token)
            return _unary(operator.neg, self.expression(_NEGATIVE + 1, _NEGATIVE))
        if token.text == "not ":
            self.refuse_behind(pending, _NOT, token)
            return _unary(operator.not_, self.expression(_NOT + 1, _NOT))
        return _constant(_number(token.text)) if token.text[0] in _OF_NUMBERS else self.named(token, pending)

    def refuse_behind(self, pending: int, precedence: int, token: _Token) -> None:
        """Raises BadFormula where py-expression-eval would compute the operator before this word without its operand."""
        if precedence <= pending:
            before = self.tokens[self.tokens.index(token) - 1].text
            fix = f"Put it in parentheses: `{before} ({token.text}…)`."
            raise BadFormula(f"py-expression-eval cannot read `{token.text}` behind `{before}`", token.at, fix)

    def named(self, token: _Token, pending: int) -> _Term:
        """x, a constant, or the call of a function."""
        if token.text == "x":
            return _x
        if token.text in _CONSTANTS:
            return _constant(_CONSTANTS[token.text])
        if token.text not in _FUNCTIONS:
            words = [*_FUNCTIONS, *_CONSTANTS, "x"]
            fix = did_you_mean(token.text, words) or f"The value is called x; functions are {', '.join(_FUNCTIONS)}."
            raise BadFormula(f"{shown(token.text)} is not a function", token.at, fix)
        if token.text in _CALLED:
            self.refuse_behind(pending, _CALL, token)
        return self.call(token)

    def call(self, token: _Token) -> _Term:
        """The call of a function."""
        least, most, compute = _FUNCTIONS[token.text]
        self.expect("(")
        terms = [self.expression(0)]
        while self.word == ",":
            self.next += 1
            terms.append(self.expression(0))
        self.expect(")")
        if not least <= len(terms) <= most:
            wanted = f"{least}" if least == most else f"{least} or more" if most == _MANY else f"{least} or {most}"
            raise BadFormula(f"`{token.text}` takes {wanted} values, not {len(terms)}", token.at)
        if len(terms) == 1:
            return _unary(compute, terms[0])
        return lambda x: compute(*[term(x) for term in terms])


def _x(x: float) -> float:
    return x


def _number(text: str) -> float:
    return int(text) if text.isdigit() else float(text)


def _constant(number: float) -> _Term:
    return lambda _: number


def _unary(compute: Callable[[Any], Any], term: _Term) -> _Term:
    return lambda x: compute(term(x))


def _binary(compute: Callable[[Any, Any], Any], left: _Term, right: _Term) -> _Term:
    return lambda x: compute(left(x), right(x))
