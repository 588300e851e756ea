"""Runs of the Python API: the rows of `sigcat simulate`, one by one and as an Arrow table."""

import csv
import io
import subprocess
import sys

import pytest

import sigcat
from sigcat.cli import main
from sigcat.data import EXAMPLES
from tests.needs import c_compiler

FUNCTION, DRIVE = EXAMPLES / "wheel_speed_calculation/function.yaml", EXAMPLES / "wheel_speed_calculation/drive.csv"


@pytest.fixture(scope="module")
def run():
    functions = sigcat.open_catalogue().resolve(FUNCTION)
    return sigcat.simulate(functions, DRIVE, duration=3)


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    file = tmp_path_factory.mktemp("run") / "run.csv"
    assert main(["simulate", str(FUNCTION), "--trace", str(DRIVE), "--duration", "3", "-o", str(file)]) == 0
    return list(csv.DictReader(io.StringIO(file.read_text())))


@c_compiler
def test_the_rows_are_those_of_the_command(run, recorded):
    rows = list(run)
    assert [(row.time, row.call) for row in rows] == [
        (round(float(each["time"]) * 1e9), each["call"]) for each in recorded
    ]
    assert [set(row.values) for row in rows] == [
        {name for name, cell in each.items() if cell and name not in ("time", "call")} for each in recorded
    ]
    assert run.columns == tuple(recorded[0])[2:]
    assert run.units["Vehicle.Chassis.Axle.Row1.Wheel.Left.Speed"] == "km/h"


@c_compiler
def test_each_iteration_yields_the_same_rows_and_may_end_early(run):
    iterator = iter(run)
    first = next(iterator)
    iterator.close()
    assert next(iter(run)) == first
    assert list(run) == list(run)


@c_compiler
def test_the_table_has_the_rows_with_null_where_nothing_was_sent(run):
    table = run.table()
    rows = list(run)
    assert table.column_names == ["time", "call", *run.columns]
    assert table["call"].to_pylist() == [row.call for row in rows]
    assert table["time"].cast("int64").to_pylist() == [row.time for row in rows]
    for name in run.columns:
        assert table[name].to_pylist() == [row.values.get(name) for row in rows]


def test_arrays_and_structs_have_types_of_arrow():
    import pyarrow as pa

    from sigcat.adapter.host.shapes import Array, Number, Record
    from sigcat.python_api.rows import Row, arrow_table

    place = Record((("X", Number("double")), ("IsSet", Number("boolean"))))
    value = [{"X": 1.5, "IsSet": True}, {"X": 2.5, "IsSet": False}]
    table = arrow_table([Row(0, "", {"Places": value}), Row(1, "", {})], {"Places": Array(place, 2)})
    assert table["Places"].to_pylist() == [value, None]
    assert table.schema.field("Places").type == pa.list_(pa.struct([("X", pa.float64()), ("IsSet", pa.bool_())]), 2)


@c_compiler
def test_a_run_that_stops_raises_after_the_rows_so_far(tmp_path, capfd):
    for file in FUNCTION.parent.iterdir():
        if file.is_file():
            (tmp_path / file.name).write_bytes(file.read_bytes())
    code = (tmp_path / "WheelSpeedCalculation.c").read_text()
    hostile = "#include <stdio.h>\n#include <stdlib.h>\nstatic int calls;\n" + code.replace(
        "void WheelSpeedCalculation_step(void)\n{",
        'void WheelSpeedCalculation_step(void)\n{ puts("step"); if (calls++ == 3) abort();',
        1,
    )
    assert hostile.count("abort") == 1
    (tmp_path / "WheelSpeedCalculation.c").write_text(hostile)
    functions = sigcat.open_catalogue().resolve(tmp_path / "function.yaml")
    rows: list[object] = []
    with pytest.raises(sigcat.InputRefused) as stopped:
        rows.extend(sigcat.simulate(functions, DRIVE, duration=3))
    assert len(rows) > 1
    assert "SIGABRT" in stopped.value.findings[0].message
    assert capfd.readouterr() == ("", "")


def test_without_pyarrow_a_table_says_what_to_install():
    code = (
        "import sys; sys.modules['pyarrow'] = None\n"
        "from sigcat.python_api.rows import arrow_table\n"
        "import sigcat\n"
        "try: arrow_table([], {})\n"
        "except sigcat.UsageError as error: print(error)"
    )
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert printed == "An Arrow table needs the package `pyarrow`: run `pip install pyarrow`\n"
