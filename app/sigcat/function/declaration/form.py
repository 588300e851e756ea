"""Common form of the parts of `function.yaml`: spelling of keys, and kinds of values."""

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from sigcat.asil import Level
from sigcat.function.document.field_types import Free
from sigcat.function.function_json.wire import Integer, Number
from sigcat.names import camel_case

Asil = Level
Text = Free
Natural = Annotated[Integer, Field(ge=0)]
Duration = Annotated[Number, Field(ge=0)]


def required(description: str, **more: Any) -> Any:
    """A key that has to be there."""
    return Field(description=description, **more)


def possible(description: str, **more: Any) -> Any:
    """A key that may be left out, and has no default."""
    return Field(None, description=description, **more)


def key_of(name: str) -> str:
    """Spelling in the file: `range_error_action` → `rangeErrorAction`, as in the attributes of overlays."""
    capitalized = camel_case(name)
    return capitalized[:1].lower() + capitalized[1:]


class DeclarationModel(BaseModel):
    """A part of the file. Keys that it does not know are refused, so that a typing error cannot pass unseen."""

    model_config = ConfigDict(
        extra="forbid", frozen=True, strict=True, alias_generator=key_of, validate_by_name=False, defer_build=True
    )
