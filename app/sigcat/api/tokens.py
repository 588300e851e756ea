"""Tokens: who may do what. Only their hashes are kept.

A token is 256 random bits, so a plain hash of it cannot be turned back; passwords would need a slow one.
"""

import hashlib
import hmac
import re
import secrets
from collections.abc import Iterable
from typing import Literal, NamedTuple, get_args

Scope = Literal["read", "reload"]
SCOPES: tuple[Scope, ...] = get_args(Scope)
_NAME = r"[A-Za-z0-9._-]{1,64}"
_WRITTEN = re.compile(rf"({_NAME}):([a-z+]+):([0-9a-f]{{64}})")


class Token(NamedTuple):
    """A token, as it is stored."""

    name: str
    scopes: frozenset[str]
    digest: str
    """SHA-256 of the token, in hexadecimal digits."""

    def __str__(self) -> str:
        return f"{self.name}:{'+'.join(sorted(self.scopes))}:{self.digest}"


def new_token(name: str, scopes: Iterable[str]) -> tuple[str, Token]:
    """A fresh token, shown once, and what is kept of it. Raises ValueError for a name or scope that cannot be used."""
    if not re.fullmatch(_NAME, name):
        raise ValueError(
            f"the name of a token must be letters, digits, '.', '_' and '-', at most 64, not {name[:80]!r}"
        )
    chosen = frozenset(scopes)
    _refuse_unknown(chosen)
    secret = f"sigcat_{secrets.token_urlsafe(32)}"
    return secret, Token(name, chosen, _digest(secret))


def token_from_text(text: str) -> Token:
    """The token that a setting describes. Raises ValueError, which does not repeat the text."""
    match = _WRITTEN.fullmatch(text)
    if match is None:
        raise ValueError("a token must be NAME:SCOPE+SCOPE:SHA-256; `sigcat config --new-token NAME` makes one")
    scopes = frozenset(match[2].split("+"))
    _refuse_unknown(scopes)
    return Token(match[1], scopes, match[3])


def _refuse_unknown(scopes: frozenset[str]) -> None:
    if unknown := scopes - set(SCOPES):
        raise ValueError(f"a scope must be {' or '.join(SCOPES)}, not {min(unknown)!r}")


def bearer(authorization: str, tokens: Iterable[Token]) -> Token | None:
    """The token of an `Authorization` header, if it is one of these."""
    kind, _, secret = authorization.partition(" ")
    return token_named(secret.strip(), tokens) if kind.lower() == "bearer" else None


def token_named(secret: str, tokens: Iterable[Token]) -> Token | None:
    """The token that was presented. Every one is compared, and each in the same time."""
    digest = _digest(secret)
    found = None
    for token in tokens:
        if hmac.compare_digest(token.digest, digest):
            found = token
    return found


def _digest(secret: str) -> str:
    return hashlib.sha256(secret.encode("utf-8", "surrogateescape")).hexdigest()
