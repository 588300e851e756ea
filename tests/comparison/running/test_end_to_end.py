"""Age of the inputs of a value: the newest row that its call has seen, by the clock of the machine."""

from pathlib import Path

from sigcat.comparison.recording import CallTime
from sigcat.comparison.running.end_to_end import drive_start, read_end_to_end
from tests.comparison.ecocontrol import subject

TRACE = """\
time,Vehicle.Speed,Vehicle.Body.Horn.IsActive
0.000000000,10,
0.100000000,11,
0.150000000,,true
0.200000000,12,
"""
STATUS = "Vehicle.ADAS.EcoControl.Status"


def call(begin: int, end: int) -> CallTime:
    return CallTime("CoreAcc", "CoreAcc_Step", 0, end - begin, 1, begin)


def ages(folder: Path, *times: str, calls: tuple[CallTime, ...]) -> dict[str, tuple[int, ...]]:
    (folder / "trace.csv").write_text(TRACE)
    (folder / "times").write_text("\n".join(["at,name,row", *times, ""]))
    return dict(read_end_to_end(folder / "times", folder / "trace.csv", subject().prepared, calls))


def test_a_value_is_as_old_as_the_newest_row_before_its_call(tmp_path):
    times = ("1000,,0", "2000,,100000000", f"2700,{STATUS},")
    assert ages(tmp_path, *times, calls=(call(2100, 2600),))["CoreAcc"] == (700,)


def test_a_row_that_comes_while_the_call_runs_has_not_been_seen(tmp_path):
    times = ("1000,,0", "2200,,100000000", f"2700,{STATUS},")
    assert ages(tmp_path, *times, calls=(call(2100, 2600),))["CoreAcc"] == (1700,)


def test_a_row_that_has_nothing_for_the_function_is_none_that_it_depends_on(tmp_path):
    times = ("1000,,0", "2000,,150000000", f"2700,{STATUS},")
    assert ages(tmp_path, *times, calls=(call(2100, 2600),))["CoreAcc"] == (1700,)


def test_what_comes_before_any_call_has_ended_depends_on_no_row(tmp_path):
    assert ages(tmp_path, "1000,,0", f"1500,{STATUS},", calls=(call(1600, 1700),))["CoreAcc"] == ()


def test_statuses_are_left_out_as_they_come_when_they_change(tmp_path):
    times = ("1000,,0", "2700,CoreAcc_BrakePressureTimeout_ErrorSts,")
    assert ages(tmp_path, *times, calls=(call(2100, 2600),))["CoreAcc"] == ()


def test_a_line_that_was_cut_off_is_left_out(tmp_path):
    times = ("1000,,0", f"2700,{STATUS},", "28")
    assert ages(tmp_path, *times, calls=(call(2100, 2600),))["CoreAcc"] == (1700,)


def test_the_drive_starts_at_the_time_of_its_first_row(tmp_path):
    (tmp_path / "times").write_text("at,name,row\n5000000100,,100\n5000000350,,300\n")
    assert drive_start(tmp_path / "times") == 5_000_000_000
    assert drive_start(tmp_path / "none") == 0


def test_a_run_that_was_not_timed_has_none(tmp_path):
    assert read_end_to_end(tmp_path / "times", tmp_path / "trace.csv", subject().prepared, ()) == {}
