"""From functions to packages, messages, topics and nodes of ROS 2."""

import json

import jsonschema
import pytest

from sigcat.errors import UsageError
from sigcat.function.function_json.wire import document_schema, written
from sigcat.integration.ros2.model import Ros2Integration
from sigcat.integration.ros2.names import CONSTANT, FIELD, MESSAGE
from tests.integration.ros2.functions import (
    derived,
    document,
    example,
    examples,
)
from tests.reference_tools import checked_with


@checked_with("jsonschema", "Documents are valid under our schemas, and the schemas are valid")
def test_the_examples_are_derived_valid_under_our_schema():
    jsonschema.Draft202012Validator(document_schema(Ros2Integration)).validate(document(examples()))


def test_the_order_of_the_functions_does_not_matter():
    assert written(derived(examples()).model) == written(derived(examples()[::-1]).model)


def test_a_document_is_read_back_to_the_same_bytes():
    model = derived(examples()).model
    assert written(type(model).model_validate(json.loads(written(model)))) == written(model)


def test_every_name_is_one_of_rosidl():
    made = document(examples())
    packages = [*made["InterfacePackageList"], *made["NodePackageList"]]
    messages = [message for package in made["InterfacePackageList"] for message in package["Messages"]]
    fields = [field for message in messages for field in message["Fields"]]
    constants = [constant for message in messages for constant in message["Constants"]]
    for form, named in ((FIELD, packages), (MESSAGE, messages), (FIELD, fields), (CONSTANT, constants)):
        assert named
        assert [each["Name"] for each in named if not form.fullmatch(each["Name"])] == []


def test_a_set_has_each_function_once_and_one_at_least():
    with pytest.raises(UsageError, match="CoreAcc is "):
        derived([example("core_acc"), example("core_acc")])
    with pytest.raises(UsageError, match="No function to integrate"):
        derived([])


def test_a_set_has_the_version_that_its_functions_share():
    assert derived(examples()).model.info.version == "1.0.0"
    first, second, *_ = examples()
    other = second.model_copy(update={"info": second.info.model_copy(update={"version": "2.0.0"})})
    assert derived([first, other]).model.info.version is None
