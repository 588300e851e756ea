"""Sessions of people who are signed in to the pages. Only the hash of the secret in their cookie is kept."""

import datetime as dt
import secrets
from typing import NamedTuple

from sqlalchemy import Column, Connection, MetaData, String, Table, delete, insert, inspect, select

from sigcat.digest import digest_of
from sigcat.limits import SESSION_SECONDS
from sigcat.registry.storing.entry import now, time_text
from sigcat.registry.storing.tables import texts
from sigcat.registry.storing.tokens import Token, all_tokens

SESSIONS = Table(
    "sessions", MetaData(),
    Column("digest", String, primary_key=True),
    # `token` is the digest of the token that began it; empty for a person without one
    *texts("token", "name", "scopes", "owner", "begun", "ends", kind=String()),
)  # fmt: skip
"""It does not follow from the log, so it is made when the first session is."""


class Session(NamedTuple):
    """A person who is signed in."""

    token: Token
    form: str
    """Value that forms of the pages send: other sites cannot read it."""


def begin_session(connection: Connection, token: Token) -> str:
    """Store a new session, remove those that have ended, and return the secret for the cookie.

    The token has no digest for a person whom a provider of OpenID Connect vouches for.
    """
    SESSIONS.create(connection, checkfirst=True)
    connection.execute(delete(SESSIONS).where(SESSIONS.c.ends <= now()))
    secret = secrets.token_urlsafe(32)
    ends = time_text(dt.datetime.now(dt.UTC) + dt.timedelta(seconds=SESSION_SECONDS))
    person = {"token": token.digest, "name": token.name, "scopes": token.scopes, "owner": token.owner}
    connection.execute(insert(SESSIONS).values(digest=_digest(secret), **person, begun=now(), ends=ends))
    return secret


def find_session(connection: Connection, secret: str) -> Session | None:
    """The session of a cookie. One of a revoked or expired token is none."""
    if not inspect(connection).has_table(SESSIONS.name):
        return None
    row = connection.execute(select(SESSIONS).where(SESSIONS.c.digest == _digest(secret))).first()
    if row is None or row.ends <= now():
        return None
    token: Token | None = Token(row.name, "", row.scopes, row.owner, row.begun, "", "")
    if row.token:
        token = next((each for each in all_tokens(connection) if each.digest == row.token and not each.fault), None)
    return Session(token, _digest(f"form {secret}")) if token is not None else None


def end_session(connection: Connection, secret: str) -> None:
    """Remove a session."""
    connection.execute(delete(SESSIONS).where(SESSIONS.c.digest == _digest(secret)))


def _digest(text: str) -> str:
    return digest_of(text.encode("utf-8", "surrogateescape"))
