"""Conditions of a request on the version that the client holds (RFC 9110, 13.1)."""

from http import HTTPStatus

from starlette.exceptions import HTTPException


def refuse_unless_matched(if_match: str | None, etag: str) -> None:
    """Raises a 412 where the client wants a version that this is not. A weak tag is equal to none, not even to itself."""
    known = [each.strip() for each in ("*" if if_match is None else if_match).split(",")]
    if "*" in known or (etag in known and not etag.startswith("W/")):
        return
    detail = (
        "The header `If-Match` must be `*`, or the strong `ETag` of the current state. Leave it out; of a catalogue, "
        "`ID@VERSION` in the address is one version of it and no other."
    )
    raise HTTPException(HTTPStatus.PRECONDITION_FAILED, detail, headers={"ETag": etag})


def is_known(if_none_match: str, etag: str) -> bool:
    """Whether a client holds this state. The tag is weak: one state has several forms and encodings."""
    known = [each.strip().removeprefix("W/") for each in if_none_match.split(",")]
    return etag.removeprefix("W/") in known or "*" in known
