"""Answers in the form that a client accepts: JSON, YAML, and CSV where there are rows."""

import csv
import io
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from http import HTTPStatus
from itertools import chain, islice
from typing import Any

import yaml
from fastapi import Request
from fastapi.responses import Response
from pydantic import BaseModel, TypeAdapter
from starlette.exceptions import HTTPException

JSON, YAML, CSV = "application/json", "application/yaml", "text/csv"
ANY = "*/*"
VARY_OF_304 = "Accept, Accept-Encoding"
"""`Vary` of an answer that is not sent again: any client may ask for it compressed."""
_PLAIN = TypeAdapter(Any).serializer
"""Writes plain data a fifth faster than `pydantic_core.to_json`."""
_DUMPER: Any = getattr(yaml, "CSafeDumper", yaml.SafeDumper)


class _Dumper(_DUMPER):  # type: ignore[misc]
    """Writes what occurs twice, such as a place, twice: readers of other languages do not all know aliases."""

    def ignore_aliases(self, data: Any) -> bool:  # noqa: ARG002
        return True


_LONGEST = 1000
"""Characters of a header that count, and that are remembered."""
_QUALITY = re.compile(r"[01](\.\d{0,3})?")
_PIECE = 2_000
"""Values that are written as YAML in some milliseconds."""
_NULL = " null\n"
_FORMULA = ("=", "+", "-", "@", "\t", "\r")


Data = BaseModel | Mapping[str, Any]
"""Data to send: a model of `schemas.py`, or plain data as such a model would write it."""


def answer(request: Request, model: Data, rows: Iterable[Mapping[str, Any]] | None = None) -> Response:
    """A model in the form that the client accepts; as CSV, its rows, if it has some."""
    headers = caching_headers(request)
    accepted = request.headers.get("accept", "*/*")
    if accepted in (ANY, JSON):
        return Response(json_bytes(model), media_type=JSON, headers=headers)
    media_type = chosen_type(accepted, (JSON, YAML) if rows is None else (JSON, YAML, CSV))
    if media_type == CSV and rows is not None:
        return Response(csv_text(list(rows)), media_type=CSV, headers=headers)
    return Response(written(model, media_type), media_type=media_type, headers=headers)


def is_table(request: Request) -> bool:
    """Whether the client likes CSV best."""
    accepted = request.headers.get("accept", "*/*")
    return accepted != "*/*" and chosen_type(accepted, (JSON, YAML, CSV)) == CSV


def csv_parts(columns: Iterable[str], lines: Iterable[Iterable[Any]]) -> Iterator[bytes]:
    """A table that is sent while it is made."""
    return (csv_lines(block).encode() for block in _blocks(chain([columns], lines), 500))


def rows(models: Iterable[BaseModel]) -> Iterator[dict[str, Any]]:
    """Models as rows of a table, made when they are needed."""
    return (model.model_dump(mode="json", by_alias=True) for model in models)


def offered(*, is_table: bool = False) -> dict[int | str, dict[str, Any]]:
    """The `responses` of an operation that answers as YAML too and, if it is a table, as CSV."""
    content: dict[str, Any] = {YAML: {}}
    if is_table:
        content[CSV] = {"schema": {"type": "string"}}
    return {200: {"description": "Successful Response", "content": content}}


def _blocks(lines: Iterable[Iterable[Any]], size: int) -> Iterator[list[Iterable[Any]]]:
    waiting = iter(lines)
    while block := list(islice(waiting, size)):
        yield block


def caching_headers(request: Request) -> dict[str, str]:
    """The headers of a catalogue's state; the form of the answer depends on what is accepted."""
    caching: dict[str, str] = getattr(request.state, "caching", {})
    return {**caching, "Vary": "Accept"}


def written(model: Data, media_type: str) -> bytes:
    """A model as JSON or YAML."""
    if media_type == JSON:
        return json_bytes(model)
    data = model.model_dump(mode="json", by_alias=True) if isinstance(model, BaseModel) else model
    return yaml_text(data).encode("utf-8")


def json_bytes(model: Data) -> bytes:
    """A model as JSON; it was validated when it was made."""
    if isinstance(model, BaseModel):
        return model.__pydantic_serializer__.to_json(model, by_alias=True)
    return _PLAIN.to_json(model)


def yaml_text(data: Any) -> str:
    """Plain data as YAML. Much of it is written in pieces: other threads wait while the library writes one."""
    if not isinstance(data, dict | list) or _counted(data, _PIECE) <= _PIECE:
        return str(yaml.dump(data, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=1000))
    if len(data) > 1:
        return "".join(yaml_text(half) for half in _halves(data))
    if isinstance(data, list):
        return f"- {_indented(yaml_text(data[0]))}\n"
    (name, value), *_ = data.items()
    text = yaml_text(value)
    return f"{yaml_text({name: None}).removesuffix(_NULL)}\n" + (
        text if isinstance(value, list) else f"  {_indented(text)}\n"
    )


def _counted(data: Any, most: int) -> int:
    """Count the values inside each other, no further than to `most`."""
    count = 1
    for item in data.values() if isinstance(data, dict) else data if isinstance(data, list) else ():
        if count > most:
            break
        count += _counted(item, most - count)
    return count


def _halves(data: Any) -> tuple[Any, Any]:
    """A list, or a mapping, as two: written one after the other they are the whole."""
    middle = len(data) // 2
    if isinstance(data, list):
        return data[:middle], data[middle:]
    entries = list(data.items())
    return dict(entries[:middle]), dict(entries[middle:])


def _indented(text: str) -> str:
    """All lines but the first further in, without the end of the last one."""
    return text.removesuffix("\n").replace("\n", "\n  ")


def chosen_type(accepted: str, offered: Sequence[str]) -> str:
    """The offered media type that an `Accept` header likes best; the first offered of equals. Raises a 406 if none."""
    liked = liked_types(accepted, tuple(offered))
    if not liked:
        raise HTTPException(HTTPStatus.NOT_ACCEPTABLE, f"The header `Accept` must allow {' or '.join(offered)}.")
    return liked[0]


def liked_types(accepted: str, offered: tuple[str, ...] = (JSON, YAML, CSV)) -> tuple[str, ...]:
    """The offered media types that an `Accept` header allows, the best one first, of equals in the order of the offer.

    Two headers for which this is equal get the same answer, whatever a route offers of these types.
    """
    return _liked_types(accepted[:_LONGEST], offered)


@lru_cache(256)
def _liked_types(accepted: str, offered: tuple[str, ...]) -> tuple[str, ...]:
    wishes = _wishes(accepted) or [("*/*", 1.0)]
    weights = {media_type: _weight(media_type, wishes) for media_type in offered}
    return tuple(sorted((each for each in offered if weights[each] > 0), key=lambda each: -weights[each]))


def accepts_gzip(accepted: str) -> bool:
    """Whether an `Accept-Encoding` header allows gzip: by name, or by `*` where it is not named (RFC 9110, 12.5.3)."""
    return _accepts_gzip(accepted[:_LONGEST])


@lru_cache(256)
def _accepts_gzip(accepted: str) -> bool:
    weights = dict(_wishes(accepted))
    return weights.get("gzip", weights.get("*", 0.0)) > 0


def csv_text(rows: Sequence[Mapping[str, Any]]) -> str:
    """Rows under the names of their columns."""
    columns = list(dict.fromkeys(name for row in rows for name in row))
    return csv_lines([columns, *([row.get(name) for name in columns] for row in rows)])


def csv_lines(rows: Iterable[Iterable[Any]]) -> str:
    """Lines of CSV. A text that a spreadsheet would take for a formula gets an apostrophe in front (OWASP)."""
    buffer = io.StringIO()
    csv.writer(buffer, lineterminator="\r\n").writerows([_cell(value) for value in row] for row in rows)
    return buffer.getvalue()


def _cell(value: Any) -> Any:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict | list):
        value = yaml.dump(value, Dumper=_DUMPER, default_flow_style=True, allow_unicode=True, width=10**6).strip()
    return f"'{value}" if isinstance(value, str) and value.startswith(_FORMULA) else value


def _wishes(header: str) -> list[tuple[str, float]]:
    """Names with their quality, of a header that lists what a client accepts."""
    return [_wish(part) for part in header.split(",") if part.strip()]


def _wish(part: str) -> tuple[str, float]:
    name, *parameters = (each.strip().lower() for each in part.split(";"))
    quality = next((each[2:] for each in parameters if each.startswith("q=")), "1")
    return name, float(quality) if _QUALITY.fullmatch(quality) else 1.0


def _weight(media_type: str, wishes: Iterable[tuple[str, float]]) -> float:
    """Quality of the most specific wish that the type fits."""
    family = f"{media_type.partition('/')[0]}/*"
    fitting = [(wish == media_type, wish == family, quality) for wish, quality in wishes
               if wish in (media_type, family, "*/*")]  # fmt: skip
    return max(fitting)[2] if fitting else 0.0
