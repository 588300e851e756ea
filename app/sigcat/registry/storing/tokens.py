"""Tokens of the service: who may write. Only their hashes are kept, and exports do not have them.

A token is 256 random bits, so a plain hash of it cannot be turned back; passwords would need a slow one.
"""

import datetime as dt
import re
import secrets
from collections.abc import Collection
from typing import Literal, NamedTuple, get_args

from sqlalchemy import Column, Connection, MetaData, String, Table, insert, inspect, select, update

from sigcat.digest import digest_of
from sigcat.errors import UsageError
from sigcat.names import did_you_mean, either
from sigcat.registry.reference import date_fault
from sigcat.registry.storing.entry import is_past
from sigcat.registry.storing.tables import texts

Scope = Literal["read", "publish", "approve", "administer"]
SCOPES: tuple[Scope, ...] = get_args(Scope)
_NAME = re.compile(r"[A-Za-z0-9._-]{1,64}", re.ASCII)

TOKENS = Table(
    "tokens", MetaData(),
    Column("name", String, primary_key=True),
    Column("digest", String, nullable=False, unique=True),
    *texts("scopes", "owner", "created", "expires", "revoked", kind=String()),
)  # fmt: skip
"""It does not follow from the log, so it is made when the first token is."""


class Token(NamedTuple):
    """A token, as it is stored."""

    name: str
    digest: str
    """SHA-256 of the token, in hexadecimal digits."""
    scopes: str
    """Separated by `+`."""
    owner: str
    """Team whose functions it may publish; empty: all."""
    created: str
    expires: str
    """Last day on which it is valid; empty: no end."""
    revoked: str
    """Time from which on it is refused; empty: it is not."""

    def has(self, scope: Scope) -> bool:
        """Whether it has a scope: `administer` includes all others, and each includes `read`."""
        scopes = self.scopes.split("+")
        return scope == "read" or scope in scopes or "administer" in scopes

    @property
    def fault(self) -> str:
        """Why it is refused; empty if it is not."""
        if self.revoked:
            return "revoked"
        return "expired" if is_past(self.expires) else ""


def create_token(connection: Connection, name: str, scopes: Collection[str], owner: str, expires: str) -> str:
    """Store a new token, and return it: it is shown once. Raises UsageError."""
    _check(name, scopes, expires)
    TOKENS.create(connection, checkfirst=True)
    if connection.execute(select(TOKENS.c.name).where(TOKENS.c.name == name)).first() is not None:
        raise UsageError(f"there is a token {name!r} already: choose another name")
    secret = f"sigcat_{secrets.token_urlsafe(32)}"
    created = dt.datetime.now(dt.UTC).isoformat(timespec="seconds")
    token = Token(name, digest_of(secret.encode()), "+".join(sorted(set(scopes))), owner, created, expires, "")
    connection.execute(insert(TOKENS).values(**token._asdict()))
    return secret


def _check(name: str, scopes: Collection[str], expires: str) -> None:
    if not _NAME.fullmatch(name):
        message = "the name of a token must be letters, digits, '.', '_' and '-', at most 64"
        raise UsageError(f"{message}, not {name[:80]!r}")
    if unknown := set(scopes) - set(SCOPES):
        raise UsageError(f"a scope must be {either(SCOPES)}, not {min(unknown)[:80]!r}")
    if expires and (fault := date_fault(expires)):
        raise UsageError(f"the date {fault}")


def revoke_token(connection: Connection, name: str) -> None:
    """Refuse a token from now on. It stays in the list. Raises UsageError."""
    known = {each.name for each in all_tokens(connection)}
    if name not in known:
        raise UsageError(f"unknown token {name[:80]!r}. {did_you_mean(name, known)}".rstrip())
    now = dt.datetime.now(dt.UTC).isoformat(timespec="seconds")
    connection.execute(update(TOKENS).where(TOKENS.c.name == name, TOKENS.c.revoked == "").values(revoked=now))


def all_tokens(connection: Connection) -> tuple[Token, ...]:
    """All tokens by name, also those that are refused."""
    if not inspect(connection).has_table(TOKENS.name):
        return ()
    return tuple(Token(*row) for row in connection.execute(select(TOKENS).order_by(TOKENS.c.name)))


def find_token(connection: Connection, secret: str) -> Token | None:
    """The token that was presented, also one that is refused."""
    digest = digest_of(secret.encode("utf-8", "surrogateescape"))
    return next((each for each in all_tokens(connection) if secrets.compare_digest(each.digest, digest)), None)
