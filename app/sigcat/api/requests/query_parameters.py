"""Query parameters that an operation does not have are refused, in the same way by all of them: none is ignored silently."""

from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from typing import Any
from urllib.parse import unquote_to_bytes

from fastapi import Request
from fastapi.dependencies.models import Dependant
from fastapi.exceptions import RequestValidationError
from pydantic import BaseModel

from sigcat.errors import UsageError
from sigcat.limits import PROPOSAL_CHARACTERS
from sigcat.names import did_you_mean


def _parameters(dependant: Dependant) -> Iterator[tuple[str, Any]]:
    """Names and types of all query parameters that a route takes, including those of its dependencies."""
    for field in dependant.query_params:
        kind: Any = field.field_info.annotation
        if isinstance(kind, type) and issubclass(kind, BaseModel):
            yield from ((name, info.annotation) for name, info in kind.model_fields.items())
        else:
            yield field.alias, kind
    for each in dependant.dependencies:
        yield from _parameters(each)


async def refuse_unknown(request: Request) -> None:
    """A dependency: raises RequestValidationError for parameters that the route does not have."""
    refuse_unless_known(request)


def refuse_unless_known(request: Request, also: Iterable[str] = ()) -> None:
    """Raises RequestValidationError for parameters that the route does not have, and that are not among these."""
    if query := request.scope["query_string"]:
        _refuse_unless_utf8(query)
        known = dict(_parameters(request.scope["route"].dependant))
        refuse_others(request.query_params, {*known, *also})
        lists = {name for name, kind in known.items() if _is_list(kind)}
        _refuse_repeated((name for name, _ in request.query_params.multi_items()), {*lists, *also})


def _refuse_unless_utf8(query: bytes) -> None:
    """Raises RequestValidationError for parameters with bytes that are not UTF-8, or that are not percent-encoded."""
    wrong = [part.partition(b"=")[0] for part in query.split(b"&") if not _is_utf8(part)]
    if wrong:
        raise RequestValidationError([_not_utf8(name) for name in dict.fromkeys(wrong)])


def _is_utf8(part: bytes) -> bool:
    try:
        unquote_to_bytes(part).decode()
    except UnicodeDecodeError:
        return False
    return part.isascii()


def _not_utf8(name: bytes) -> dict[str, Any]:
    shown = unquote_to_bytes(name[:300]).decode(errors="replace")[:100]
    return {"type": "string_unicode", "loc": ("query", shown), "msg": "Must be percent-encoded UTF-8", "input": ""}


def _is_list(annotation: Any) -> bool:
    return "list" in str(annotation).casefold() or "sequence" in str(annotation).casefold()


def _refuse_repeated(given: Iterable[str], lists: Collection[str]) -> None:
    """Raises UsageError for a parameter with one value that is given several: only one of them could count."""
    for name, count in Counter(given).items():
        if count > 1 and name not in lists:
            raise UsageError(f"The parameter {name[:100]!r} is given {count} times; it takes one value.")


def refuse_others(given: Iterable[str], known: Collection[str]) -> None:
    """Raises RequestValidationError for names of parameters that are not known."""
    unknown = dict.fromkeys(name for name in given if name not in known)
    if unknown:
        raise RequestValidationError([_unknown(name, known) for name in unknown])


def _unknown(name: str, known: Iterable[str]) -> dict[str, Any]:
    hint = did_you_mean(name[:PROPOSAL_CHARACTERS], known)
    return {
        "type": "extra_forbidden",
        "loc": ("query", name[:100]),
        "msg": "Unknown parameter",
        "input": "",
        "ctx": {"hint": hint},
    }
