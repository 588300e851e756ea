"""The layout of a core: what its plan decides of the text of its functions."""

import re

from sigcat.adapter.core.core_files import core_files
from tests.adapter.core.subject import subject
from tests.adapter.written import FLOAT, function, on_event, output, parameter, signal, structure

POINT = structure("DT_Point", x=(FLOAT, -1, 1), y=FLOAT)
FUNCTIONS = re.compile(r"^(?P<head>[^\n]*\))\n\{\n(?P<body>.*?)^\}$", re.MULTILINE | re.DOTALL)


def bodies() -> dict[str, str]:
    """Bodies of functions by the ends of their names."""
    contents = signal("In"), output("Out"), parameter("Point", "DT_Point")
    made = subject(function(on_event(*contents), datatypes=(POINT,), Code={"Signature": "Globals", "Headers": ["f.h"]}))
    text = core_files(made.plan).source.data.decode()
    return {each["head"].partition("(")[0].rpartition("Adapter_")[2]: each["body"] for each in FUNCTIONS.finditer(text)}


def test_arguments_that_a_function_does_not_use_are_marked():
    found = bodies()
    assert "(void)self;" in found["Run_Step"]
    assert "(void)t;" in found["IsDue_Step"]
    assert not [name for name, body in found.items() if "(void)self;" in body and "self->" in body]


def test_an_empty_line_in_a_function_is_after_declarations():
    rows = [body.split("\n") for body in bodies().values()]
    before = [row[number - 1] for row in rows for number, text in enumerate(row[:-1]) if not text]
    assert before
    assert [text for text in before if not re.match(r" +(const )?\w+ \w+( = .*)?;$", text)] == []


def test_a_struct_is_copied_without_its_address():
    assert "self->parameter.Point.value = self->stored.Point.value;" in bodies()["Load_Point"]
