"""Values of a trace outside of the range of their signal are passed on, with a note for each column."""

import io

import pytest

from sigcat.adapter.host.ranges import Range, range_of
from sigcat.adapter.host.shapes import Array, Number, Shape, packing
from sigcat.adapter.toolchain import toolchain
from sigcat.runs.building.library import convert_library
from sigcat.runs.driver.tables import Target
from sigcat.runs.recording.outside import OutsideValues
from sigcat.runs.recording.trace_file import Known, moments, open_trace
from sigcat.runs.running.converted_input import convert_csv
from sigcat.runs.running.written_input import moment_bytes

SHAPES: dict[str, Shape] = {
    **{name: Number(name) for name in ("uint8", "int16", "int64", "uint64", "float", "double", "boolean")},
    "levels": Array(Number("float"), 2),
}
RANGES = {"uint8": (1, 5), "int16": (-7, None), "int64": (-5, 5), "uint64": (None, 9), "float": (None, 0.1), "double": (0.5, 2), "levels": (0, 1)}  # fmt: skip
TRACES = {
    "within": ("uint8,int16,float,double\n0,1,-7,0.1,0.5\n1,5,9,,2\n", []),
    "without a range": ("boolean\n0,true\n", []),
    "below and above": ("uint8\n0,0\n1,3\n2,9\n", [("uint8: 2 values are outside of the range 1 to 5 of the signal, the first at 0 s.", 2, 3)]),
    "below": ("int16,uint64\n0,-8,9\n1,-9,10\n", [
        ("int16: 2 values are outside of the range from -7 of the signal, the first at 0 s.", 2, 3),
        ("uint64: 1 value is outside of the range up to 9 of the signal, the first at 1 s.", 3, 6)]),
    "no number": ("double\n0,1\n\n0.5,nan\n", [("double: 1 value is outside of the range 0.5 to 2 of the signal, the first at 0.5 s.", 4, 5)]),
    "in rows of both readers": ('int64,levels\n0,6,\n1,-6,"[0.5,2]"\n2,7,\n', [
        ("int64: 3 values are outside of the range -5 to 5 of the signal, the first at 0 s.", 2, 3),
        ("levels: 1 value is outside of the range 0 to 1 of the signal, the first at 1 s.", 3, 6)]),
    "an empty cell after one": ("uint8,int16\n0,9,0\n1,,-8\n", [
        ("uint8: 1 value is outside of the range 1 to 5 of the signal, the first at 0 s.", 2, 3),
        ("int16: 1 value is outside of the range from -7 of the signal, the first at 1 s.", 3, 4)]),
}  # fmt: skip


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    found = convert_library(tmp_path_factory.mktemp("library"), toolchain())
    assert found is not None
    return found


@pytest.mark.parametrize("reader", ["Python", "C"])
@pytest.mark.parametrize(("text", "expected"), TRACES.values(), ids=TRACES)
def test_a_note_counts_the_values_outside(text, expected, reader, tmp_path, library):
    file = tmp_path / "trace.csv"
    file.write_text(f"time,{text}")
    trace = open_trace(file, Known(SHAPES, ()))
    held = {name: range_of(*limits, SHAPES[name]) for name, limits in RANGES.items()}
    outside = OutsideValues({name: each for name, each in held.items() if each is not None})
    targets = [Target("VALUE", 0, index, packing(shape)) for index, shape in enumerate(SHAPES.values())]
    by_column = {name: [index] for index, name in enumerate(SHAPES)}
    written, plain = io.BytesIO(), b"".join(moment_bytes(each, by_column, targets) for each in moments(trace))
    if reader == "C":
        convert_csv(written, trace, by_column, targets, library, outside)
    else:
        written.writelines(moment_bytes(each, by_column, targets) for each in outside.looked_at(moments(trace)))
    assert written.getvalue() == plain
    found = sorted(outside.findings(trace), key=lambda each: each.line)
    assert [(each.message, each.line, each.column) for each in found] == expected
    assert {(each.rule, each.severity) for each in found} <= {("T008", "info")}


def test_a_limit_is_the_number_that_the_datatype_holds():
    held = range_of(None, 0.1, Number("float"))
    assert held is not None
    assert held.holds(0.10000000149011612)
    assert not held.holds(float("nan"))


@pytest.mark.parametrize("shape", [Number("uint8", (("ON", 1),)), Number("float")])
def test_an_enumeration_and_a_signal_without_limits_have_no_range(shape):
    assert range_of(None if shape.datatype == "float" else 0, None, shape) is None


def test_a_range_may_have_one_end():
    assert Range(least=0).holds([0, 1e300])
