"""A field that names an error is declared once: whatever lists such fields has it."""

import re
from pathlib import Path

import pytest

from sigcat import codes
from sigcat.adapter.core.planned_core import derive
from sigcat.function.checks.definitions import used_by
from sigcat.function.checks.error_causes import check_error_causes
from sigcat.function.declaration.declaration import DataItem
from sigcat.function.declaration.form import key_of
from sigcat.function.function_json.error_fields import error_fields
from sigcat.function.function_json.interfaces.data_interfaces import Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.names import camel_case
from sigcat.registry.use import uses_of
from sigcat.web.views.code_view import code_view
from tests.adapter.core.functions import DATA_ERRORS
from tests.adapter.written import Json, error, function, queue, signal, step
from tests.function.shipped import interfaces, resolved

PACKAGE = Path(__file__).parents[2] / "app/sigcat"
CHECKED: Json = {"Timeout": "20", "Optional": True, "Min": 0, "Max": 5, "VssPath": "Vehicle.Speed"}


def naming(field: str, *declared: Json) -> FunctionJson:
    """A function whose input names the error `Broken` in a field."""
    fields = {**CHECKED, camel_case(field): "Broken"}
    item = signal("A", **fields) if field in error_fields(Signal) else queue("A", 3, **fields)
    return function(step(item, *declared))


@pytest.mark.parametrize("field", DATA_ERRORS)
def test_a_function_file_has_its_key(field: str) -> None:
    assert key_of(field) in {info.alias or key_of(name) for name, info in DataItem.model_fields.items()}


@pytest.mark.parametrize("field", DATA_ERRORS)
def test_the_core_has_the_condition_that_sets_it(field: str) -> None:
    plan = derive(resolved(naming(field, error("Broken")))).plan
    assert plan is not None
    assert [len(each.causes) for each in plan.errors] == [1]


@pytest.mark.parametrize(
    "field", [field for field in DATA_ERRORS if field != "timeout_error"]
)  # a separate rule has it
def test_its_error_has_to_be_declared(field: str) -> None:
    (problem,) = [each for each in check_error_causes(naming(field), ()) if each.rule == codes.SET_ERROR_UNDECLARED]
    assert f"`{key_of(field)}`" in problem.message


@pytest.mark.parametrize("field", DATA_ERRORS)
def test_what_it_names_is_used_and_follows_from_the_signal(field: str) -> None:
    made = naming(field, error("Broken"))
    assert "Broken" in used_by(made)
    (use,) = [each for each in uses_of(made, interfaces(), interfaces()) if each.path == "Vehicle.Speed"]
    assert use.leads_to == ("Broken",)


@pytest.mark.parametrize("field", DATA_ERRORS)
def test_the_page_of_the_code_says_what_sets_it(field: str) -> None:
    view = code_view(naming(field, error("Broken")))
    assert view is not None
    (row,) = [each for each in view.variables if each.name == "A"]
    assert any("sets Broken" in note for note in row.notes)


def test_few_files_name_a_field() -> None:
    """One of a function without a platform: the declaration, Function JSON, and the conditions of the core."""
    files = [*PACKAGE.rglob("*.py"), *PACKAGE.rglob("*.j2")]
    naming = {path for path in files if re.search(r"\be2e_?error\b", path.read_text("utf-8"), re.IGNORECASE)}
    platforms = {path for path in naming if re.search("autosar|ros2|fmi", path.relative_to(PACKAGE).as_posix())}
    assert 0 < len(naming - platforms) <= 3
    assert len(naming) <= 9
