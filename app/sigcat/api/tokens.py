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
_WRITTEN = re.compile(r"([A-Za-z0-9._-]{1,64}):([a-z+]+):([0-9a-f]{64})")


class Token(NamedTuple):
    """What is kept of a token."""

    name: str
    scopes: frozenset[str]
    digest: str
    """SHA-256 of the token, in hexadecimal digits."""

    def __str__(self) -> str:
        return f"{self.name}:{'+'.join(sorted(self.scopes))}:{self.digest}"


def new_token(name: str, scopes: Iterable[str]) -> tuple[str, Token]:
    """A fresh token, shown once, and what is kept of it."""
    secret = f"sigcat_{secrets.token_urlsafe(32)}"
    return secret, token_from_text(f"{name}:{'+'.join(scopes)}:{_digest(secret)}")


def token_from_text(text: str) -> Token:
    """The token that a setting describes. Raises ValueError, which does not repeat the text."""
    match = _WRITTEN.fullmatch(text)
    if match is None:
        raise ValueError("a token must be NAME:SCOPE+SCOPE:SHA-256; `sigcat config --new-token NAME` makes one")
    unknown = set(match[2].split("+")) - set(SCOPES)
    if unknown:
        raise ValueError(f"a scope must be {' or '.join(SCOPES)}, not {min(unknown)!r}")
    return Token(match[1], frozenset(match[2].split("+")), match[3])


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
