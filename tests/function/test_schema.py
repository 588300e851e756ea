"""Our Function JSON is a superset of the published schema: what is valid there is accepted, and nothing more required."""

import json
from typing import Any

import jsonschema
import pytest

from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import Argument, MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, SafetyReaction
from sigcat.function.function_json.model import (
    Component,
    FunctionInfo,
    FunctionJson,
    MetaInfo,
    Mode,
    function_schema,
    to_json,
)
from sigcat.function.function_json.runnable import Contract, Runnable, Watchdog, WatchdogLimits
from sigcat.function.function_json.wire import WireModel
from tests.published.schemas import definitions, schema
from tests.reference_tools import checked_with

PUBLISHED = definitions("function_json")
MODELS: dict[str, type[WireModel]] = {
    "ArgTypeItem": Argument, "Component": Component, "DataQ": DataQueue, "Datatype": Datatype,
    "Error": ErrorInterface, "FunctionDetails": FunctionInfo, "MetaInfoItem": MetaInfo, "Method": MethodInterface,
    "Mode": Mode, "Parameter": ParameterInterface, "SafetyReaction": SafetyReaction, "Signal": Signal,
    "WatchdogConfig": WatchdogLimits, "WatchdogItem": Watchdog, "funcContract": Contract,
    "function": Runnable,
}  # fmt: skip


def wire_names(one: type[WireModel], *, required: bool) -> set[str]:
    return {str(f.alias) for f in one.model_fields.values() if f.is_required() or not required}


@pytest.mark.parametrize("name", MODELS)
def test_exactly_the_published_fields_are_required(name):
    assert wire_names(MODELS[name], required=True) == {n for n, field in PUBLISHED[name].items() if field.is_required}


def test_every_field_says_what_it_is_and_where_it_comes_from():
    models = [one for one in WireModel.__subclasses__() if one.__module__.startswith("sigcat.function.")]
    assert len(models) > len(MODELS)
    for one in models:
        for field in one.model_fields.values():
            extra = field.json_schema_extra
            assert field.description
            assert field.description.endswith(".")
            assert isinstance(extra, dict)
            assert extra["x-source"]


@pytest.mark.parametrize(
    ("one", "field", "unit"),
    [
        (Runnable, "cycle_time", "ms"),
        (Runnable, "stack_size", "bytes"),
        (ErrorInterface, "maturation_time", "ms"),
        (ErrorInterface, "reset_time", "ms"),
        (Signal, "timeout", "ms"),
    ],
)
def test_quantities_say_their_unit(one, field, unit):
    assert one.model_fields[field].json_schema_extra["x-unit"] == unit


@checked_with("jsonschema", "Documents are valid under our schemas, and the schemas are valid")
def test_the_schema_is_a_valid_one():
    jsonschema.Draft202012Validator.check_schema(function_schema())
    assert function_schema()["$schema"] == "https://json-schema.org/draft/2020-12/schema"


# -- against the published schema ---------------------------------------------------------------------------------


def sample(kind: str, *, null: bool) -> Any:
    """A value of a kind of the published schema: every field given, what may be null either null or not."""
    first, _, others = kind.partition(" or ")
    if null and "null" in others:
        return None
    if first.startswith("list of "):
        return [sample(first.removeprefix("list of "), null=null)] * 2
    if first in PUBLISHED:
        return {name: sample(field.kind, null=null) for name, field in PUBLISHED[first].items()}
    return SAMPLES[first]


SAMPLES = {
    "text": "text", "number": 1.5, "integer": 7, "boolean": True, "datatype name": "DT_UInt8", "date": "12.09.2025",
    "version": "1.0.0",
}  # fmt: skip


@checked_with("published", "Documents that are valid under their schemas are accepted, and stay valid")
@pytest.mark.parametrize("null", [True, False])
def test_what_is_valid_under_the_published_schema_is_accepted_and_stays_valid(null):
    document = sample("document", null=null)
    jsonschema.validate(document, schema("function_json"))
    function = FunctionJson.model_validate(document, by_name=False)
    again = json.loads(to_json(function))
    jsonschema.validate(again, schema("function_json"))
    if not null:
        assert again == document


@pytest.mark.parametrize("name", MODELS)
def test_every_published_field_is_known(name):
    assert set(PUBLISHED[name]) <= wire_names(MODELS[name], required=False)


def test_every_published_definition_has_a_model():
    assert PUBLISHED.keys() - {"document"} == set(MODELS)
    assert set(PUBLISHED["document"]) == wire_names(FunctionJson, required=True)
