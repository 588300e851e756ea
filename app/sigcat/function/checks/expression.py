"""Whether a text can be an expression of C that holds a value: `in.speed`, `((Bus *)in)->values[i + 1]`, `read_speed()`."""

import re

from sigcat.limits import EXPRESSION_CHARACTERS

_TOKEN = re.compile(
    r"\s*(?:(?P<name>[A-Za-z_]\w*)|(?P<number>\d[\w.]*)|(?P<member>->|\.)|(?P<open>[(\[])|(?P<close>[)\]])"
    r"|(?P<prefix>[*&])|(?P<operator><<|>>|[-+/%|^~,]))",
    re.ASCII,
)
_TYPES = frozenset(
    ("struct", "union", "enum", "const", "volatile", "unsigned", "signed", "char", "short", "int", "long", "float",
     "double", "void")
)  # fmt: skip
_KEYWORDS = frozenset(
    ("auto", "break", "case", "continue", "default", "do", "else", "extern", "for", "goto", "if", "inline", "register",
     "restrict", "return", "static", "switch", "typedef", "while")
)  # fmt: skip


def may_hold_value(text: str) -> bool:
    """Whether this can name a value in C. Operators stand in brackets only; the rest is left to the compiler."""
    tokens = _tokens(text)
    return tokens is not None and _is_complete(tokens)


def root_of(text: str) -> str | None:
    """The name that an expression begins with, casts left out: `in` of `((Bus *)in)->values[i]`; None if it has none."""
    tokens = _tokens(text) or []
    for index, (kind, name) in enumerate(tokens):
        if kind == "name" and name not in _TYPES and not _is_cast(tokens[index + 1 :]):
            return name
    return None


def _is_cast(following: list[tuple[str, str]]) -> bool:
    """Whether a name is a type in a cast, by the tokens after it: `*)in`."""
    rest = list(following)
    while rest and rest[0] == ("prefix", "*"):
        rest.pop(0)
    return len(rest) > 1 and rest[0] == ("close", ")") and rest[1][0] in ("name", "open", "prefix")


_IDENTIFIER = re.compile(r"[A-Za-z_]\w*", re.ASCII)


def is_identifier(text: str) -> bool:
    """Whether this can be the name of a variable, function or macro."""
    return bool(_IDENTIFIER.fullmatch(text)) and text not in _TYPES | _KEYWORDS and len(text) <= EXPRESSION_CHARACTERS


def _tokens(text: str) -> list[tuple[str, str]] | None:
    """Kinds and texts of the tokens; None where C has no such token, or none that names a value."""
    found, at, text = [], 0, text.rstrip()
    while at < len(text) <= EXPRESSION_CHARACTERS:
        match = _TOKEN.match(text, at)
        if match is None or match[match.lastgroup or 0] in _KEYWORDS:
            return None
        found.append((match.lastgroup or "", match[match.lastgroup or 0]))
        at = match.end()
    return found or None


def _is_complete(tokens: list[tuple[str, str]]) -> bool:
    """Whether every operand and every bracket stands where C has one."""
    waiting: list[str] = []
    before = "start"
    for kind, text in tokens:
        is_type = text in _TYPES
        if kind not in _following(before, is_inside=bool(waiting)) or (is_type and waiting[-1:] != [")"]):
            return False
        if kind == "open":
            waiting.append(")" if text == "(" else "]")
        elif kind == "close" and (not waiting or waiting.pop() != text):
            return False
        before = "type" if is_type else "prefix" if kind == "operator" else "group" if text == ")" else kind
    return not waiting and before in ("name", "close", "group")


def _following(before: str, *, is_inside: bool) -> frozenset[str]:
    """Kinds of tokens that may come next; outside of brackets nothing is calculated."""
    if is_inside:
        return _AFTER[before]
    return _AFTER[before] - {"operator"} - ({"prefix"} if before in ("name", "number", "close") else set())


_OPERAND = frozenset(("name", "number", "open", "prefix", "operator"))
_FOLLOWS = frozenset(("member", "open", "close", "prefix", "operator"))
_AFTER = {
    "start": _OPERAND,
    "open": _OPERAND | {"close"},
    "prefix": _OPERAND | {"close"},  # closed by a cast: (Bus *)
    "member": frozenset(("name",)),
    "name": _FOLLOWS,
    "number": _FOLLOWS - {"member", "open"},
    "type": _FOLLOWS | {"name"},
    "close": _FOLLOWS,
    "group": _FOLLOWS | {"name"},  # after a cast
}
"""Kinds of tokens that may follow, by the kind of the one before."""
