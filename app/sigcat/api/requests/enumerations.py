"""Parameters that take one of a few values, which a table of another room lists."""

from collections.abc import Collection
from typing import Annotated, Any

from pydantic import AfterValidator, Field
from typing_extensions import TypeAliasType

from sigcat.names import either


def enumeration(name: str, values: Collection[str], description: str) -> Any:
    """A type with these values, which has a schema of this name: generated clients would make one up."""

    described = Field(description=description, json_schema_extra={"enum": list(values)})
    return TypeAliasType(name, Annotated[str, described, one_of(values)])


def one_of(values: Collection[str]) -> AfterValidator:
    """Return a validator that refuses other values, for an operation that takes only some of an enumeration."""

    def known(value: str) -> str:
        if value not in values:
            raise ValueError(f"must be {either(values)}, not {value[:100]!r}")
        return value

    return AfterValidator(known)
