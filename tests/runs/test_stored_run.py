"""A stored run is read as far as possible, in little memory; unreadable parts are reported, and the rest is shown."""

import math
import tracemalloc
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.adapter.host.shapes import Array, Number
from sigcat.errors import InputRefused
from sigcat.integration.reading import read_functions
from sigcat.limits import RUN_BYTES, RUN_CHANGES
from sigcat.runs.columns import Column, FunctionColumns, columns_of
from sigcat.runs.recording.series import SeriesCollector
from sigcat.runs.stored_run import CallTimes, StoredRun, read_run
from tests.function.shipped import FUNCTIONS, interfaces

SECOND = 10**9
VERDICT = Number("uint8", (("PASSED", 0), ("FAILED", 1)))
SPEED = Column("Speed", "signal", Number("double"), "m/s", True, True, None)
LOST = Column("Lost", "error", VERDICT, "", True, True, 0)
REACTION = Column("Cond", "safety reaction", VERDICT, "", True, False, 0)
FUNCTION = FunctionColumns({each.name: each for each in (SPEED, LOST, REACTION)}, ("F_Init", "F_Step"))
NAMES = ("Speed", "Lost", "Cond")


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "drive.csv"


def read(file: Path, *rows: str) -> StoredRun:
    file.write_text("\n".join(["time,call,Speed,Other,Lost,Cond", *rows, ""]))
    return read_run(file, "here/drive.csv", NAMES, FUNCTION)


# -- rows ---------------------------------------------------------------------------------------------------------


def test_values_and_calls_of_the_function_are_read(file: Path) -> None:
    run = read(
        file,
        "1,F_Init,,,,PASSED",
        "2,F_Step,0.5,7,PASSED,",
        "2,G_Step,,8,,FAILED",
        "3,F_Step,0.5,,,",
        "5.5,F_Step,2,,FAILED,FAILED",
        "9,,,,,PASSED",
    )
    assert run.findings == ()
    assert (run.first, run.last, run.rows) == (SECOND, 9 * SECOND, 6)
    assert run.series["Speed"].points == ((2 * SECOND, 0.5), (5_500_000_000, 2.0))
    assert (run.series["Speed"].total, run.series["Speed"].least, run.series["Speed"].greatest) == (3, 0.5, 2.0)
    assert [value for _, value in run.series["Lost"].points] == [0, 1]
    assert run.calls == (
        CallTimes("F_Init", 1, SECOND, SECOND, 0, 0),
        CallTimes("F_Step", 3, 2 * SECOND, 5_500_000_000, 2_500_000_000, 3 * SECOND),
    )


def test_a_reaction_that_another_function_decided_is_not_this_ones(file: Path) -> None:
    run = read(file, "1,F_Init,,,,PASSED", "2,G_Step,,8,,FAILED", "3,,,,,FAILED")
    assert run.series["Cond"].points == ((SECOND, 0), (3 * SECOND, 1))


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        (["1,F_Step,0.5,,,", "2,F_St"], "The row must have 6 cells"),
        (["1,F_Step,0.5,,,", "2,F_Step,fast,,,"], "Speed must be a number, not 'fast'"),
        (["1,F_Step,0.5,,,", "nan,F_Step,1,,,"], "The time must be in seconds"),
        (["1,F_Step,0.5,,,", "0.5,F_Step,1,,,"], "The time must be at least 1, that of the row above"),
        (["1,F_Step,0.5,,,", '2,"F_Step,1,,,'], "A cell that begins with a quote"),
        (["1,F_Step,0.5,,,", "2,F_Step,,,MAYBE,"], "Lost must be PASSED or FAILED"),
    ],
)
def test_what_cannot_be_read_is_told_and_the_rest_is_there(file: Path, rows: list[str], said: str) -> None:
    run = read(file, *rows)
    assert run.series["Speed"].points[0] == (SECOND, 0.5)
    (finding,) = run.findings
    assert (finding.file, finding.line) == ("here/drive.csv", 3)
    assert said in finding.message


def test_a_file_that_was_cut_within_its_last_cell_does_not_look_whole(file: Path) -> None:
    file.write_text("time,call,Speed\n1,F_Step,19.21875\n2,F_Step,19.2")
    run = read_run(file, "here/drive.csv", ("Speed",), FUNCTION)
    assert [value for _, value in run.series["Speed"].points] == [19.21875]
    (finding,) = run.findings
    assert (finding.file, finding.line) == ("here/drive.csv", 3)
    assert "it was cut" in finding.message


def test_bytes_that_are_no_text_end_it(file: Path) -> None:
    file.write_bytes(b"time,call,Speed\n1,F_Step,0.5\n2,F_Step,\xff\n3,F_Step,2\n")
    run = read_run(file, "drive.csv", ("Speed",), FUNCTION)
    assert [value for _, value in run.series["Speed"].points] == [0.5]
    assert "UTF-8" in run.findings[0].message


def test_a_header_with_a_column_twice_is_refused_without_the_place_of_the_file(file: Path) -> None:
    file.write_text("time,call,Speed,Speed\n")
    with pytest.raises(InputRefused) as refused:
        read_run(file, "drive.csv", ("Speed",), FUNCTION)
    assert [finding.file for finding in refused.value.findings] == ["drive.csv"]
    assert str(file.parent) not in str(refused.value)


def test_a_larger_file_is_not_read(file: Path) -> None:
    with file.open("wb") as data:
        data.truncate(RUN_BYTES + 1)
    with pytest.raises(InputRefused, match="at most 16 MiB"):
        read_run(file, "drive.csv", ("Speed",), FUNCTION)


def test_a_file_that_was_changed_meanwhile_has_no_such_column(file: Path) -> None:
    file.write_text("time,call\n1,F_Step\n")
    assert read_run(file, "drive.csv", NAMES, FUNCTION).series == {}


# -- series -------------------------------------------------------------------------------------------------------


def collected(values: list[tuple[int, float]]) -> SeriesCollector:
    collector = SeriesCollector()
    for time, value in values:
        collector.add(time, value)
    return collector


def test_of_very_many_values_few_are_kept_and_no_peak_is_lost() -> None:
    tracemalloc.start()
    collector = SeriesCollector()
    for number in range(50_000):
        collector.add(number * 1000, {27_777: 9.0, 38_888: math.nan}.get(number, number % 2 / 10))
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    series = collector.series
    assert (series.total, series.change_total) == (50_000, 50_000)
    assert len(series.points) <= 12_000
    assert len(series.changes) == RUN_CHANGES
    assert (27_777_000, 9.0) in series.points
    assert any(math.isnan(value) for _, value in series.points)
    assert (series.least, series.greatest) == (0.0, 9.0)
    assert most < 4_000_000


def test_nothing_but_nan_has_no_smallest_value() -> None:
    series = collected([(1, math.nan), (2, math.nan), (3, math.inf)]).series
    assert len(series.points) == 2
    assert math.isnan(series.least)
    assert math.isnan(series.greatest)


@given(st.lists(st.tuples(st.integers(0, 2**62), st.floats()), min_size=1, max_size=50))
def test_whatever_comes_the_first_and_the_last_value_stand(values: list[tuple[int, float]]) -> None:
    values.sort(key=lambda each: each[0])
    series = collected(values).series
    assert repr(series.first + 0.0) == repr(values[0][1] + 0.0)
    assert series.last == values[-1][1] or math.isnan(values[-1][1])
    assert series.total == len(values)


# -- columns ------------------------------------------------------------------------------------------------------


def columns_of_example(name: str) -> FunctionColumns:
    file = next(path for path in FUNCTIONS if path.parent.name == name)
    resolved = read_functions([(file.read_bytes(), str(file))], interfaces())[0]
    return columns_of(resolved[0])


def test_a_function_knows_its_columns() -> None:
    columns = columns_of_example("core_acc")
    kinds = {name: (column.kind, column.is_sent) for name, column in columns.columns.items()}
    assert kinds["Vehicle.ADAS.EcoControl.Status"] == ("signal", True)
    assert kinds["Vehicle.ADAS.EcoControl.AccelerationProposal"] == ("signal", False)
    assert kinds["CoreAcc_AliveError_ErrorSts"] == ("error", True)
    assert kinds["EcoControlMpc_DeadlineError_ErrorSts"] == ("error", False)
    assert kinds["AccReqInvalid_SftyCondSts"] == ("safety reaction", True)
    assert kinds["CoreAcc_Mode_Out"] == ("mode", True)
    assert columns.calls == ("CoreAcc_Init", "CoreAcc_Step", "CoreAcc_Terminate")
    altitude = columns_of_example("eco_control_mpc").columns["Vehicle.ADAS.Map.Horizon.Altitude"]
    assert isinstance(altitude.shape, Array)
