"""Our Function JSON is a superset of the published schema: what is valid there is accepted, and nothing more required."""

import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from sigcat.function.function_json import model
from sigcat.function.function_json.model import FunctionJson, function_schema, to_json
from sigcat.function.function_json.wire import WireModel

PUBLISHED = Path(__file__).parents[3] / "shared/seeds/zf-artifacts/function_json_schema.json"
MODELS: dict[str, type[WireModel]] = {
    "ArgTypeItem": model.Argument, "Component": model.Component, "DataQ": model.DataQueue, "Datatype": model.Datatype,
    "Error": model.Error, "FunctionDetails": model.FunctionInfo, "MetaInfoItem": model.MetaInfo, "Method": model.Method,
    "Mode": model.Mode, "Parameter": model.Parameter, "SafetyReaction": model.SafetyReaction, "Signal": model.Signal,
    "WatchdogConfig": model.WatchdogLimits, "WatchdogItem": model.Watchdog, "funcContract": model.Contract,
    "function": model.Runnable,
}  # fmt: skip
REQUIRED = {
    "ArgTypeItem": "Name Datatype Units",
    "Component": "Name functionList",
    "DataQ": "Name Description Role AsilInfo QueueLength Datatype Factor Offset InitValue Units",
    "Datatype": "typeRef category cDef",
    "Error": "Name Description Datatype Dependancy OccurenceCountLimit IgnitionCountLimit MaturationTime Severity",
    "FunctionDetails": "FunctionName FunctionResponsible Description",
    "MetaInfoItem": "",
    "Method": "Name Description Role InDataTypeList OutDataTypeList",
    "Mode": "Name Description RunnablesList",
    "Parameter": "Name Description Datatype Asillevel Min Max Default InitValue RangeErrorAction Interfacetype "
    "Attribute Units",
    "SafetyReaction": "Name Description Datatype ErrorList",
    "Signal": "Name Description Role Datatype",
    "WatchdogConfig": "Min Max Ref ErrorName",
    "WatchdogItem": "AliveSupervision DeadlineSupervision LogicalSupervision",
    "funcContract": "SignalList DataQList MethodList ParameterList ErrorList SafetyReactionList",
    "function": "Name Description Runtype Watchdog Scheduling Priority",
}


def wire_names(one: type[WireModel], *, required: bool) -> set[str]:
    return {str(f.alias) for f in one.model_fields.values() if f.is_required() or not required}


@pytest.mark.parametrize("name", MODELS)
def test_exactly_the_published_fields_are_required(name):
    assert wire_names(MODELS[name], required=True) == set(REQUIRED[name].split())


def test_every_field_says_what_it_is_and_where_it_comes_from():
    models = [one for one in vars(model).values() if isinstance(one, type) and issubclass(one, WireModel)]
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
        (model.Runnable, "cycle_time", "ms"),
        (model.Runnable, "stack_size", "bytes"),
        (model.Error, "maturation_time", "ms"),
        (model.Error, "reset_time", "ms"),
        (model.Signal, "timeout", "ms"),
    ],
)
def test_quantities_say_their_unit(one, field, unit):
    assert one.model_fields[field].json_schema_extra["x-unit"] == unit


def test_the_schema_is_a_valid_one():
    jsonschema.Draft202012Validator.check_schema(function_schema())
    assert function_schema()["$schema"] == "https://json-schema.org/draft/2020-12/schema"


# -- against the published schema itself --------------------------------------------------------------------------


def sample(schema: Any, root: Any, *, null: bool) -> Any:
    """A document that the schema allows: every property given, what may be null either null or not."""
    if "$ref" in schema:
        return sample(root["$defs"][schema["$ref"].rpartition("/")[2]], root, null=null)
    if "anyOf" in schema:
        may_be_null = {"type": "null"} in schema["anyOf"]
        return None if null and may_be_null else sample(schema["anyOf"][0], root, null=null)
    kind = schema["type"]
    if kind == "object":
        return {name: sample(part, root, null=null) for name, part in schema["properties"].items()}
    if kind == "array":
        return [sample(schema["items"], root, null=null)] * 2
    patterns = {"DT_": "DT_UInt8", r"\d{2}": "12.09.2025", r"\d+": "1.0.0"}
    text = next((value for start, value in patterns.items() if start in schema.get("pattern", "")), "text")
    return {"string": text, "number": 1.5, "integer": 7, "boolean": True}[kind]


@pytest.fixture(scope="module")
def published():
    if not PUBLISHED.exists():
        pytest.skip("the published schema is not here")
    return json.loads(PUBLISHED.read_text(encoding="utf-8"))


@pytest.mark.parametrize("null", [True, False])
def test_what_is_valid_under_the_published_schema_is_accepted_and_stays_valid(published, null):
    document = sample(published, published, null=null)
    jsonschema.validate(document, published)
    function = FunctionJson.model_validate(document, by_name=False)
    again = json.loads(to_json(function))
    jsonschema.validate(again, published)
    if not null:
        assert again == document


@pytest.mark.parametrize("name", MODELS)
def test_every_published_field_is_known(published, name):
    fields = published["$defs"][name]
    assert set(fields["properties"]) <= wire_names(MODELS[name], required=False)
    assert set(fields.get("required", ())) == wire_names(MODELS[name], required=True)


def test_every_published_definition_has_a_model(published):
    assert set(published["$defs"]) == set(MODELS)
    assert set(published["required"]) == wire_names(FunctionJson, required=True)
