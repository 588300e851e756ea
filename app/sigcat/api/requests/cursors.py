"""Opaque cursors: where the next page of a list begins, and of which state of the catalogue."""

from base64 import urlsafe_b64decode, urlsafe_b64encode

from sigcat.errors import UsageError

_STATE_CHARACTERS = 12


def cursor_of(offset: int, digest: str) -> str:
    """The cursor of the page that begins at `offset`."""
    return urlsafe_b64encode(f"{digest[:_STATE_CHARACTERS]}:{offset}".encode()).decode().rstrip("=")


def offset_of(cursor: str, digest: str) -> int:
    """Return the start index of a cursor's page. Raises UsageError for one that is made up or of another state."""
    try:
        state, _, offset = urlsafe_b64decode(cursor + "=" * (-len(cursor) % 4)).decode("ascii").partition(":")
        number = int(offset)
    except ValueError:
        raise UsageError("The cursor must be a `next_cursor` of this service. Send it unchanged.") from None
    if state != digest[:_STATE_CHARACTERS] or number < 0:
        raise UsageError(
            "The cursor belongs to another search or another state of the catalogue. Start again without one."
        )
    return number
