"""Content by its digest, which is checked whenever content is read."""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Any

from sqlalchemy import Connection, Select, bindparam, or_, select

from sigcat import codes
from sigcat.digest import digest_of
from sigcat.registry.reference import refused
from sigcat.registry.storing.tables import CONTENTS

_DATA = select(CONTENTS.c.data).where(CONTENTS.c.digest == bindparam("of"))


def content_of(connection: Connection, digest: str) -> bytes:
    """Return content. Raises InputRefused if the database has other content, or none."""
    return _checked(digest, connection.execute(_DATA, {"of": digest}).scalar())


def stored(connection: Connection, digests: Sequence[str]) -> frozenset[str]:
    """Return those of the digests that have content."""
    values = {f"of{number}": digest for number, digest in enumerate(digests)}
    return frozenset(connection.execute(_stored(len(digests)), values).scalars())


@lru_cache(maxsize=8)
def _stored(count: int) -> Select[str]:
    """The digests that there are, of a number of them. A list as one parameter takes three times as long."""
    return select(CONTENTS.c.digest).where(or_(*(CONTENTS.c.digest == bindparam(f"of{each}") for each in range(count))))


def all_content(connection: Connection) -> Iterator[tuple[str, bytes]]:
    """Yield all content by digest, in order. Raises InputRefused as `content_of` does."""
    for digest, data in connection.execute(select(CONTENTS).order_by(CONTENTS.c.digest)):
        yield digest, _checked(digest, data)


def _checked(digest: str, data: Any) -> bytes:
    if not isinstance(data, bytes) or digest_of(data) != digest:
        message = f"The registry does not have the content {digest[:12]} as it was published."
        fix = "Run `sigcat registry verify`, and restore the database from a backup or an export."
        raise refused(codes.LOG_CHANGED.finding(message, fix=fix))
    return data
