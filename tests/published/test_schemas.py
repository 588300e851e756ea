"""Restated facts of the published schemas are those of the schemas."""

import json

import jsonschema
import pytest

from tests.needs import published, published_files
from tests.published.schemas import definitions, restated, schema
from tests.reference_tools import checked_with

FILES = {
    "function_json": "function_json_schema.json",
    "autosar_adaptive": "integration_schema_adaptive_autosar.json",
    "ros2": "integration_schema_ros2.json",
}


@pytest.mark.parametrize("name", FILES)
def test_it_is_a_json_schema(name):
    jsonschema.Draft202012Validator.check_schema(schema(name))


@checked_with("published", "Nothing of their schemas is omitted or added")
@published_files
@pytest.mark.parametrize("name", FILES)
def test_nothing_is_left_out_or_added(name):
    assert definitions(name) == restated(json.loads(published(FILES[name])))
