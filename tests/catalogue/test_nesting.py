"""Deep nesting is refused before libyaml, which would end the process; many shallow lists are not refused."""

import pytest

from sigcat.catalogue.reading.yaml_document import read_document

MANY = 5000
SHALLOW = "a: [LOW, 'HIGH, or higher', \"[not a list]\"]\n" * MANY


def rules(text):
    return [finding.rule for finding in read_document(text.encode(), "file").findings]


@pytest.mark.parametrize(
    "line", ["a: [1, 2]", "a: ['x]', \"[\"]", "a: []", "a: [x: y]", "a: {x: [1]}", "- - - a", "a: [[1], [2]]"]
)
def test_many_shallow_collections_are_read(line):
    assert rules("\n".join(f"k{number}:\n  {line}" for number in range(MANY))) == []


@pytest.mark.parametrize(
    "text",
    [
        "[" * MANY,
        "a: " + "{b: " * MANY,
        "- " * MANY + "a",
        "[\n" * MANY,
        "a: [x,\n" * MANY,
        "[ ']',\n" * MANY,
        "a: ['[x]', [b\n" * MANY,
        "a: [b] [c\n" * MANY,
        "a: ['b]\n ', [c]\n" * MANY,
        "# a: [b]\n" * MANY + "[" * MANY,
        "a: [b, # ]\n" * MANY,
    ],
)
def test_what_nests_deeply_or_may_is_counted_and_the_process_lives(text):
    assert rules(text) in (["R004"], ["R001"])
    assert rules(SHALLOW + text) in (["R004"], ["R001"])
