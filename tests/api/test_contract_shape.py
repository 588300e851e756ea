"""Properties of the OpenAPI document that give generated clients good types."""

import itertools
import json
from collections import defaultdict
from collections.abc import Iterator, Mapping
from typing import Any

import pytest

from sigcat.api.openapi_document import operations
from sigcat.api.openapi_shapes import not_null
from sigcat.api.requests.export_options import export_query
from sigcat.catalogue.exporting.exporters import EXPORTERS
from sigcat.function.function_json.model import function_schema
from tests.api.test_openapi import DOCUMENT

Schema = Mapping[str, Any]
SCHEMAS: Mapping[str, Schema] = DOCUMENT["components"]["schemas"]
OPERATIONS = {each["operationId"]: (path, each) for path, _, each in operations(DOCUMENT)}
OF_FUNCTIONS = {*function_schema()["$defs"], "FunctionJson"}
"""Schemas of Function JSON: fields without a value are left out there, as its authors have it."""

OTHERWISE = {
    ("DataQueue", "Factor"): "The published schema has a number in a queue and a text in a signal.",
    ("DataQueue", "Offset"): "Likewise.",
    ("SafetyReaction", "ErrorList"): "The published schema has names here, and error interfaces in a contract.",
}
"""Fields of another type than their name has elsewhere, and why that cannot be changed."""

TAKEN = frozenset((
    "Any", "Array", "Boolean", "Class", "Client", "Config", "Configuration", "Date", "Dict", "Enum", "Error", "Event",
    "Exception", "File", "Function", "Integer", "Kind", "List", "Map", "Method", "Model", "Number", "Object", "Option",
    "Optional", "Parameter", "Promise", "Record", "Request", "Response", "Result", "Set", "Status", "String", "Symbol",
    "Tuple", "Type", "Union", "Unset", "Value",
))  # fmt: skip
"""Names that languages and generated clients have already."""


def _kind(schema: Schema) -> Any:
    """Return the values that a schema allows, without its descriptions and bounds."""
    if "$ref" in schema:
        return schema["$ref"]
    if "anyOf" in schema:
        return sorted(map(str, map(_kind, schema["anyOf"])))
    if schema.get("type") == "array":
        return ["array of", _kind(schema["items"])]
    return [schema.get("type"), schema.get("format"), schema.get("enum")]


def _parameters() -> Iterator[tuple[str, dict[str, Any]]]:
    for name, (_, operation) in OPERATIONS.items():
        yield from ((name, parameter) for parameter in operation.get("parameters", ()))


def _within(schema: Schema, at: str) -> Iterator[tuple[str, Schema]]:
    """A schema and all that it holds, without following references."""
    yield at, schema
    parts = {
        **schema.get("properties", {}),
        **{key: schema[key] for key in ("items", "additionalProperties") if key in schema},
    }
    parts.update({str(number): each for number, each in enumerate(schema.get("anyOf", ()))})
    for name, part in parts.items():
        if isinstance(part, dict):
            yield from _within(part, f"{at}.{name}")


def _written_in_place() -> Iterator[tuple[str, Schema]]:
    """Every schema that stands where it is used, and so has no name."""
    for name, schema in SCHEMAS.items():
        yield from itertools.islice(_within(schema, name), 1, None)
    for name, parameter in _parameters():
        yield from _within(parameter["schema"], f"{name}({parameter['name']})")
    for name, (_, operation) in OPERATIONS.items():
        answers = [content for each in operation["responses"].values() for content in each.get("content", {}).values()]
        for content in (*answers, *operation.get("requestBody", {}).get("content", {}).values()):
            yield from _within(content["schema"], name)


def test_one_name_has_one_type_over_all_schemas_though_it_may_be_null_in_some() -> None:
    types: dict[str, dict[str, list[str]]] = defaultdict(lambda: defaultdict(list))
    for name, schema in SCHEMAS.items():
        for field, kind in schema.get("properties", {}).items():
            if (name, field) not in OTHERWISE:
                types[field][json.dumps(_kind(not_null(dict(kind))))].append(name)
    assert {field: dict(kinds) for field, kinds in types.items() if len(kinds) > 1} == {}


def test_the_exceptions_are_needed() -> None:
    for name, field in OTHERWISE:
        others = [
            each["properties"][field]
            for other, each in SCHEMAS.items()
            if other != name and field in each.get("properties", ())
        ]
        assert _kind(SCHEMAS[name]["properties"][field]) not in map(_kind, others)


def test_one_name_has_one_type_over_all_parameters() -> None:
    types: dict[str, set[str]] = defaultdict(set)
    for _, parameter in _parameters():
        types[parameter["name"]].add(json.dumps(_kind(parameter["schema"])))
    assert {name: kinds for name, kinds in types.items() if len(kinds) > 1} == {}


def test_every_field_of_an_answer_is_always_there() -> None:
    for name in sorted(SCHEMAS.keys() - OF_FUNCTIONS):
        assert set(SCHEMAS[name].get("properties", ())) == set(SCHEMAS[name].get("required", ())), name


def test_an_answer_may_have_more_fields_one_day() -> None:
    assert [name for name, schema in SCHEMAS.items() if schema.get("additionalProperties") is False] == []


@pytest.mark.parametrize("name", sorted(OF_FUNCTIONS))
def test_what_is_left_out_of_function_json_is_not_null_too(name: str) -> None:
    optional = SCHEMAS[name]["properties"].keys() - set(SCHEMAS[name].get("required", ()))
    assert not [field for field in optional if "null" in str(_kind(SCHEMAS[name]["properties"][field]))]


@pytest.mark.parametrize(
    ("row", "whole"),
    [
        ("NodeSummary", "Node"),
        ("NodeSummary", "TreeNode"),
        ("NodeSummary", "SearchHit"),
        ("CatalogueSummary", "Catalogue"),
        ("RuleSummary", "Rule"),
    ],
)
def test_what_a_row_of_a_list_has_the_thing_itself_has(row: str, whole: str) -> None:
    fields = SCHEMAS[row]["properties"].items()
    assert fields <= SCHEMAS[whole]["properties"].items()


def test_no_schema_has_a_name_that_generated_clients_have_already() -> None:
    assert not TAKEN & SCHEMAS.keys()
    assert not [name for name in SCHEMAS if "_" in name or "-" in name]


def test_every_object_and_enumeration_has_a_name() -> None:
    nameless = [at for at, schema in _written_in_place() if schema.get("type") == "object" or "enum" in schema]
    assert nameless == []


def test_no_two_enumerations_have_a_value_in_common() -> None:
    """In Go and C each value has a separate name."""
    values = [value.upper() for schema in SCHEMAS.values() for value in schema.get("enum", ())]
    assert sorted(set(values)) == sorted(values)


def test_titles_are_left_out() -> None:
    assert not [at for at, schema in _written_in_place() if isinstance(schema.get("title"), str)]


# -- parameters ---------------------------------------------------------------------------------------------------


def test_parameters_are_those_of_the_address_then_the_catalogue_then_the_rest() -> None:
    for name, (path, operation) in OPERATIONS.items():
        given = [(each["in"], each["name"]) for each in operation.get("parameters", ())]
        in_path = [each for where, each in given if where == "path"]
        ordered = sorted(in_path, key=lambda each, path=path: path.index(f"{{{each}}}"))  # type: ignore[misc]
        rest = [each for each in given if each[0] == "query" and each[1] != "catalogue"]
        catalogue = [each for each in given if each == ("query", "catalogue")]
        assert given == [*(("path", each) for each in ordered), *catalogue, *rest], name


def test_two_parameters_stand_in_the_same_order_everywhere() -> None:
    pairs: set[tuple[str, str]] = set()
    for _, operation in OPERATIONS.values():
        pairs.update(itertools.combinations([each["name"] for each in operation.get("parameters", ())], 2))
    assert not {(one, other) for one, other in pairs if (other, one) in pairs}


def test_no_parameter_is_null() -> None:
    assert not [f"{name}({each['name']})" for name, each in _parameters() if "null" in str(_kind(each["schema"]))]


def test_every_text_and_every_list_of_a_request_has_a_bound() -> None:
    bounds = {"string": "maxLength", "array": "maxItems", "integer": "minimum"}
    for name, parameter in _parameters():
        for at, schema in _within(parameter["schema"], f"{name}({parameter['name']})"):
            kind = schema.get("type")
            assert kind is None or kind not in bounds or bounds[kind] in schema, at


def test_every_operation_may_be_too_busy_and_says_when_to_come_again() -> None:
    for name, (_, operation) in OPERATIONS.items():
        responses = operation["responses"]
        assert {"422", "429", "500", "503"} <= responses.keys(), name
        assert all("Retry-After" in responses[status]["headers"] for status in ("429", "503")), name


@pytest.mark.parametrize("name", EXPORTERS)
def test_an_export_has_the_options_of_its_format_and_no_others(name: str) -> None:
    path, operation = OPERATIONS[f"export_{name}"]
    assert path.endswith(f"/export/{name}")
    assert [each["name"] for each in operation["parameters"][1:]] == list(export_query(EXPORTERS[name]).model_fields)
    offered = {
        each.name.replace("-", "_")
        for each in EXPORTERS[name].options
        if each.kind not in ("input", "output", "folder", "state")
    }
    assert {each["name"] for each in operation["parameters"][1:]} == offered
