"""What is restated of the published schemas is what stands in them."""

import json

import jsonschema
import pytest

from tests.judges import judged_by
from tests.needs import published, published_files
from tests.published.schemas import definitions, restated, schema

FILES = {
    "function_json": "function_json_schema.json",
    "autosar_adaptive": "integration_schema_adaptive_autosar.json",
    "ros2": "integration_schema_ros2.json",
}


@pytest.mark.parametrize("name", FILES)
def test_it_is_a_json_schema(name):
    jsonschema.Draft202012Validator.check_schema(schema(name))


@judged_by("published", "Nothing of their schemas is left out or added")
@published_files
@pytest.mark.parametrize("name", FILES)
def test_nothing_is_left_out_or_added(name):
    assert definitions(name) == restated(json.loads(published(FILES[name])))
