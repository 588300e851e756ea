"""Property tests have fixed examples; what a search finds becomes one of them."""

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.internal.conjecture import providers

from tests import properties

ROOT = Path(__file__).parents[1]
NAME = "tests/test_other.py::test_small"


def test_examples_depend_on_nothing_but_the_test():
    assert settings().database is None
    assert settings().derandomize is not properties.IS_SEARCH
    assert not len(providers._get_local_constants()), "constants of modules that happen to be imported"


def test_each_example_of_the_file_is_of_a_test_that_is_there():
    for name in properties.names():
        file, _, test = name.partition("::")
        assert f"def {test}(" in (ROOT / file).read_text("utf-8")


def test_a_failure_of_a_search_is_tried_in_every_later_run(tmp_path, monkeypatch):
    file = tmp_path / "found.json"
    file.write_text("{}\n")
    monkeypatch.setattr(properties, "FILE", file)
    monkeypatch.setattr(properties, "IS_SEARCH", True)
    failed = item()
    with pytest.raises(AssertionError):
        failed.obj()
    properties.note(failed)
    report: Any = SimpleNamespace(user_properties=failed.user_properties, failed=True)
    assert "was added" in properties.write(report)
    assert properties.write(report) == "", "it is there already"
    assert properties.found(NAME) == [{"number": 1000}]
    later = item(examples=1)
    with pytest.raises(AssertionError):
        later.obj()


def item(examples=1000):
    """A property test as pytest collects it."""

    @settings(max_examples=examples, derandomize=True)
    @given(st.integers(0, 1100))
    def small(number):
        assert number < 1000

    made: Any = SimpleNamespace(nodeid=f"{NAME}[case]", obj=small, user_properties=[], add_marker=str)
    properties.prepare([made])
    return made
