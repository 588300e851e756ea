"""Content by its digest, which is checked whenever content is read."""

from collections.abc import Iterator
from typing import Any

from sqlalchemy import Connection, bindparam, select

from sigcat import codes
from sigcat.digest import digest_of
from sigcat.registry.reference import refused
from sigcat.registry.storing.tables import CONTENTS

_DIGEST = select(CONTENTS.c.digest).where(CONTENTS.c.digest == bindparam("of"))
_DATA = select(CONTENTS.c.data).where(CONTENTS.c.digest == bindparam("of"))


def content_of(connection: Connection, digest: str) -> bytes:
    """Return content. Raises InputRefused if the database has other content, or none."""
    return _checked(digest, connection.execute(_DATA, {"of": digest}).scalar())


def has_content(connection: Connection, digest: str) -> bool:
    """Whether there is content with a digest."""
    return connection.execute(_DIGEST, {"of": digest}).first() is not None


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
