"""The options of each export format as query parameters: a model for each, made from the table of exporters."""

from collections.abc import Mapping
from functools import cache
from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, create_model

from sigcat.api.requests.enumerations import enumeration
from sigcat.catalogue.exporting.exporter import Exporter, Option
from sigcat.catalogue.exporting.exporters import EXPORTERS
from sigcat.limits import PARAMETER_CHARACTERS, PARAMETER_VALUES
from sigcat.names import camel_case

Flag = Annotated[bool, BeforeValidator(lambda value: value == "" or value)]
"""True or false; `?pretty` alone is true."""
Text = Annotated[str, Field(max_length=PARAMETER_CHARACTERS)]
Number = Annotated[int, Field(ge=0, le=999_999_999)]
_TYPES: Mapping[str, Any] = {"flag": Flag, "switch": Flag, "text": Text, "name": Text, "identifier": Text, "texts": Text, "number": Number, "choice": Text}  # fmt: skip
"""By kind of the option. Those that name files of the machine a request cannot give."""


class ExportQuery(BaseModel):
    """Base of all: it refuses unknown options."""

    model_config = ConfigDict(frozen=True, extra="forbid")


@cache
def export_query(exporter: Exporter) -> type[ExportQuery]:
    """The model of a format's options."""
    offered = [option for option in exporter.options if option.kind in _TYPES]
    fields: dict[str, Any] = {_spelled(option): _field(option) for option in offered}
    return create_model(f"Export{camel_case(exporter.name)}Query", __base__=ExportQuery, **fields)


def given_options(query: ExportQuery, exporter: Exporter) -> dict[str, Any]:
    """Options as the exporter takes them, without those that have their default: whole clients send these too."""
    defaults = {_spelled(option): option for option in exporter.options}
    given = query.model_dump(exclude_defaults=True).items()
    return {defaults[name].name: value for name, value in given}


def _spelled(option: Option) -> str:
    return option.name.replace("-", "_")


def _field(option: Option) -> tuple[Any, Any]:
    kind: Any = _choices(option) if option.choices else _TYPES[option.kind]
    description = f"{option.text[:1].upper()}{option.text[1:]}."
    if option.kind == "texts":
        return list[kind] | None, Field(None, max_length=PARAMETER_VALUES, description=description)
    if option.default is None:
        return kind | None, Field(None, description=description)
    return kind, Field(option.default, description=description)


def _choices(option: Option) -> Any:
    """The same enumeration for all options that have these choices: in Go, values of two would be one name twice."""
    alike = (each for exporter in EXPORTERS.values() for each in exporter.options if each.choices == option.choices)
    return _enumeration(next(alike).name, option.choices)


@cache
def _enumeration(name: str, choices: tuple[str, ...]) -> Any:
    return enumeration(f"Export{camel_case(name)}", choices, "What an option of an export may be.")
