"""A function is checked against a catalogue with a wrong value anywhere: findings, never an exception."""

from functools import cache

import pytest

from sigcat.catalogue.composing.add_overlays import with_overlays
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.function.sets.check_set import check_functions
from tests.function.shipped import FUNCTIONS, interfaces

FILES = [(path.read_bytes(), str(path)) for path in FUNCTIONS]
DATA_ATTRIBUTES = {
    "type",
    "datatype",
    "arraysize",
    "min",
    "max",
    "unit",
    "default",
    "allowed",
    "enum",
    "pattern",
    "deprecation",
}
VALUES = (".inf", "1e400", "abc", "true", "''", "-1", "[.nan]", "{a: 1}")


@cache
def examples():
    """One node of each kind that the examples use."""
    text = "".join(data.decode() for data, _ in FILES)
    found: dict[object, str] = {}
    for path, node in interfaces().nodes.items():
        own = ".Function." in path
        if path in text or (own and path.rpartition(".")[2] in text):
            category = path.split(".")[-2] if own else "data"
            found.setdefault(
                (category, node.values.get("datatype"), "allowed" in node.values, "unit" in node.values), path
            )
    return tuple(found.values())


def test_there_are_examples():
    assert len(examples()) > 12


@pytest.mark.parametrize("value", VALUES)
def test_a_wrong_value_of_the_catalogue_is_no_error_of_sigcat(value):
    for path in examples():
        used = [(data, name) for data, name in FILES if path.rpartition(".")[2].encode() in data][:1]
        for attribute in sorted({*interfaces().nodes[path].values, *DATA_ATTRIBUTES}):
            overlay = layer_from_text(f"{path}:\n  {attribute}: {value}\n".encode(), "overlay.vspec")
            check_functions(used, with_overlays(interfaces(), [overlay]), is_whole=False)
