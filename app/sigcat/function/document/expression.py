"""Expressions of C that hold a value: `in.speed`, `((Bus *)in)->values[i + 1]`, `read_speed(1)`.

    expression = {"*" | "&" | "(" type ")"} operand {"." name | "->" name | "[" index "]"}
    operand    = name | "(" expression ")" | accessor "(" [argument {"," argument}] ")"
    index      = term {("+" | "-") term}
    term       = ["-"] number | operand {"." name | "->" name | "[" index "]"}
    argument   = ["-"] number | name
    type       = word {word} {"*"}

Nothing else: no text, no assignment, no comma, no operator with a side effect. An accessor is a function that the
document names.
"""

import re
from functools import lru_cache
from typing import NamedTuple

from sigcat.limits import EXPRESSION_CHARACTERS
from sigcat.reserved_words import C_KEYWORDS, is_of_integers

_TOKEN = re.compile(
    r" *(?:(?P<name>[A-Za-z_]\w*)|(?P<number>0[xX][0-9a-fA-F]+[uUlL]{0,3}|\d+[uUlL]{0,3})(?![\w.])"
    r"|(?P<sign>->|[.()\[\]*&+,-]))",
    re.ASCII,
)
_TYPE_WORDS = frozenset(
    ("struct", "union", "enum", "const", "volatile", "unsigned", "signed", "char", "short", "int", "long", "float",
     "double", "void", "bool")
)  # fmt: skip
_IDENTIFIER = re.compile(r"[A-Za-z_]\w*", re.ASCII)
PROGRAM = "main"
"""The function that a program begins with, which is not one of the code."""
_DEEPEST = 30
"""Brackets inside each other."""


class Expression(NamedTuple):
    """An expression that was read."""

    root: str
    """The name that it begins with, after casts: `in` of `((Bus *)in)->values[i]`."""
    calls: tuple[str, ...]
    """Names of the functions that it calls."""


@lru_cache(maxsize=4096)
def expression_of(text: str) -> Expression | None:
    """Read an expression; None if the text is not one."""
    tokens = _tokens(text)
    if tokens is None:
        return None
    reader = _Reader(tokens)
    try:
        root = reader.expression()
    except _Unfit:
        return None
    return Expression(root, tuple(reader.calls)) if reader.kind == "end" and root != PROGRAM else None


def may_hold_value(text: str) -> bool:
    """Whether a text is an expression."""
    return expression_of(text) is not None


def root_of(text: str) -> str | None:
    """The name that an expression begins with; None if the text is not an expression."""
    read = expression_of(text)
    return read.root if read else None


def is_identifier(text: str) -> bool:
    """Whether this can be the name of a variable, function or macro."""
    is_free = _is_free(text) and text != PROGRAM
    return bool(_IDENTIFIER.fullmatch(text)) and is_free and len(text) <= EXPRESSION_CHARACTERS


def _is_free(name: str) -> bool:
    return name not in C_KEYWORDS and not is_of_integers(name)


def _tokens(text: str) -> list[tuple[str, str]] | None:
    """Kinds and texts of the tokens; None where C has no such token, or none that names a value."""
    found, at, text = [], 0, text.rstrip(" ")
    while at < len(text) <= EXPRESSION_CHARACTERS:
        match = _TOKEN.match(text, at)
        if match is None:
            return None
        found.append((match.lastgroup or "", match[match.lastgroup or 0]))
        at = match.end()
    return found or None


class _Unfit(Exception):
    """The tokens are not an expression."""


class _Reader:
    """A recursive descent over the tokens: one method for each rule of the grammar."""

    def __init__(self, tokens: list[tuple[str, str]]) -> None:
        self._tokens = tokens
        self._at = 0
        self._depth = 0
        self.calls: list[str] = []

    @property
    def kind(self) -> str:
        return self._tokens[self._at][0] if self._at < len(self._tokens) else "end"

    @property
    def text(self) -> str:
        return self._tokens[self._at][1] if self._at < len(self._tokens) else ""

    def _take(self) -> str:
        text = self.text
        self._at += 1
        return text

    def _takes(self, *signs: str) -> bool:
        is_next = self.kind == "sign" and self.text in signs
        self._at += is_next
        return is_next

    def _require(self, sign: str) -> None:
        if not self._takes(sign):
            raise _Unfit

    def _name(self) -> str:
        if self.kind != "name" or not _is_free(self.text):
            raise _Unfit
        return self._take()

    def expression(self) -> str:
        """An expression; the name that it begins with."""
        while self._takes("*", "&") or self._cast():
            pass
        return self._with_parts(self._operand())

    def _cast(self) -> bool:
        """Skip a type in brackets, if an operand follows it."""
        start = self._at
        if self._takes("("):
            words = 0
            while self.kind == "name" and (self.text in _TYPE_WORDS or self.text not in C_KEYWORDS):
                self._at += 1
                words += 1
            while self._takes("*"):
                pass
            if words and self._takes(")") and (self.kind == "name" or self.text in ("(", "*", "&")):
                return True
        self._at = start
        return False

    def _operand(self) -> str:
        if self._takes("("):
            self._depth += 1
            if self._depth > _DEEPEST:
                raise _Unfit
            root = self.expression()
            self._require(")")
            self._depth -= 1
            return root
        name = self._name()
        if self._takes("("):
            self.calls.append(name)
            self._arguments()
        return name

    def _arguments(self) -> None:
        if self._takes(")"):
            return
        self._argument()
        while self._takes(","):
            self._argument()
        self._require(")")

    def _argument(self) -> None:
        if not self._number():
            self._name()

    def _number(self) -> bool:
        is_negative = self._takes("-")
        if self.kind == "number":
            self._at += 1
            return True
        if is_negative:
            raise _Unfit
        return False

    def _with_parts(self, root: str) -> str:
        while True:
            if self._takes(".", "->"):
                self._name()
            elif self._takes("["):
                self._index()
            else:
                return root

    def _index(self) -> None:
        self._depth += 1
        if self._depth > _DEEPEST:
            raise _Unfit
        self._term()
        while self._takes("+", "-"):
            self._term()
        self._require("]")
        self._depth -= 1

    def _term(self) -> None:
        if not self._number():
            self._with_parts(self._operand())
