"""Common base of the models of wire formats: fields with a meaning, and finite numbers."""

import math
from functools import cache
from typing import Annotated, Any, TypeVar, cast

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    PlainValidator,
    SerializerFunctionWrapHandler,
    Strict,
    WithJsonSchema,
    model_serializer,
)
from pydantic_core import PydanticCustomError

from sigcat.function.document.field_types import TYPE_REFERENCE

T = TypeVar("T")
Listed = Annotated[tuple[T, ...], Strict(False)]
"""A list: its elements are of one kind."""

PUBLISHED = "published function schema 1.0.0"
TABLE = "paper, glossary, table of interface fields"
OWN = "sigcat"
"""Sources of fields: the authors' schema, what the paper's table has beyond it, and what later stages need."""


PHYSICAL = "that of `Units`"
"""Unit of a field that holds a value of the signal itself."""


def described(alias: str, description: str, *, default: Any = ..., unit: str = "none", source: str = PUBLISHED, **more: Any) -> Any:  # fmt: skip
    """A field with its name on the wire, its description, its unit and the source that it comes from."""
    extra: dict[str, Any] = {"x-source": source, "x-unit": unit}
    return Field(default, alias=alias, description=description, json_schema_extra=extra, **more)


def optional(alias: str, description: str, **more: Any) -> Any:
    """A field that may be absent."""
    return described(alias, description, default=None, **more)


def tabled(alias: str, description: str, **more: Any) -> Any:
    """An optional field of the paper's table that the published schema lacks."""
    return optional(alias, description, source=TABLE, **more)


def own(alias: str, description: str, **more: Any) -> Any:
    """An optional field that the published schema lacks."""
    return optional(alias, description, source=OWN, **more)


def always(alias: str, description: str, **more: Any) -> Any:
    """A field that the published schema lacks and that is wherever its model is."""
    return described(alias, description, source=OWN, **more)


def own_fields(*models: type[BaseModel]) -> tuple[str, ...]:
    """Return the names of the fields that the published schema lacks."""
    fields = [field for model in models for field in model.model_fields.values()]
    return tuple(
        str(field.alias) for field in fields if cast("dict[str, Any]", field.json_schema_extra)["x-source"] == OWN
    )


class WireModel(BaseModel):
    """A frozen value of a wire format. Fields that it does not know are kept, as the published schema allows them.

    A field without a value is left out when it is written, unless the schema requires it.
    """

    model_config = ConfigDict(
        extra="allow",
        frozen=True,
        strict=True,
        validate_by_name=True,
        validate_by_alias=True,
        serialize_by_alias=True,
        defer_build=True,
    )

    @model_serializer(mode="wrap")
    def _without_absent(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        optional = _optional(type(self))
        written = cast("dict[str, Any]", handler(self))
        return {name: value for name, value in written.items() if value is not None or name not in optional}


def written(model: BaseModel) -> bytes:
    """A document as UTF-8 text with a stable layout: the same values give the same bytes."""
    return model.model_dump_json(indent=2, by_alias=True).encode() + b"\n"


def document_schema(model: type[BaseModel]) -> dict[str, Any]:
    """JSON Schema (2020-12) of a document."""
    schema = model.model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


@cache
def _optional(model: type[BaseModel]) -> frozenset[str | None]:
    """Names of the fields that may be absent, in Python and on the wire."""
    fields = model.model_fields.items()
    return frozenset(name for key, field in fields if not field.is_required() for name in (key, field.alias))


def _number(value: Any) -> int | float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise PydanticCustomError("number_type", "Input should be a number")
    if isinstance(value, float) and not math.isfinite(value):
        raise PydanticCustomError("number_type", "Input should be a finite number")
    return value


def _integer(value: Any) -> int:
    number = _number(value)
    if number != int(number):
        raise PydanticCustomError("integer_type", "Input should be a whole number")
    return int(number)


Number = Annotated[int | float, PlainValidator(_number), WithJsonSchema({"type": "number"})]
"""A JSON number; whole numbers stay whole numbers, so that they are written as they were given."""
Integer = Annotated[int, PlainValidator(_integer), WithJsonSchema({"type": "integer"})]
"""A JSON integer; as in JSON Schema, `1.0` is one."""
Count = Annotated[Integer, Field(ge=0, le=2**16 - 1)]
"""A number of occurrences, within the range of a core's counters."""
WrittenWhole = Annotated[int | float, PlainValidator(_number), WithJsonSchema({"type": "integer"})]
"""A number that is written as an integer, as the published schema has it; any number is read."""
TypeReference = Annotated[str, Field(pattern=r"^DT_[A-Za-z0-9]+$"), TYPE_REFERENCE]
