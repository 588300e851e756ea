"""Scenarios share a drive as far as they can; what was sent in the time of each is cut out of it."""

from pathlib import Path

import pytest

from sigcat.comparison.faults.drives import faulty_drives, grouped, read_texts, watched, write_texts
from sigcat.comparison.faults.scenario import Killed, Scenario, Spoilt
from sigcat.comparison.recording import Built, CallTime, Recording
from sigcat.errors import UsageError


def scenario(name: str, start: int, end: int, *, kills: bool = False) -> Scenario:
    killed = (Killed("F", start),) if kills else ()
    return Scenario(name, name, "", start, end, (Spoilt("value", "A", start, end, "9"),), (), killed)


def names(groups: tuple[tuple[Scenario, ...], ...]) -> list[list[str]]:
    return [[each.name for each in group] for group in groups]


def test_scenarios_that_kill_nobody_share_a_drive_in_order_of_time():
    assert names(grouped([scenario("b", 20, 30), scenario("a", 0, 20)])) == [["a", "b"]]


def test_the_last_one_of_a_drive_may_kill():
    assert names(grouped([scenario("k", 30, 40, kills=True), scenario("a", 0, 20)])) == [["a", "k"]]


def test_who_kills_before_others_has_a_drive_alone():
    found = grouped([scenario("k", 0, 10, kills=True), scenario("a", 0, 20), scenario("l", 20, 30, kills=True)])
    assert names(found) == [["a", "l"], ["k"]]


def test_a_drive_has_all_its_faults_and_ends_with_its_last_scenario(tmp_path):
    trace = tmp_path / "drive.csv"
    trace.write_text("time,A,B\n0.000000000,1,\n0.000000015,2,\n1.000000000,3,\n")
    (drive,) = faulty_drives([scenario("a", 0, 10), scenario("k", 15, 20, kills=True)], trace, tmp_path / "faults")
    assert drive.drive.end_ns == 20
    assert [(kill.function, kill.time_ns) for kill in drive.drive.kills] == [("F", 15)]
    assert drive.drive.trace.read_text() == "time,A,B\n0.000000000,9,\n0.000000015,9,\n1.000000000,3,\n"


def test_a_trace_is_written_as_it_was_read(tmp_path):
    drive, copy = Path("examples/ecocontrol/drive.csv"), tmp_path / "copy.csv"
    write_texts(read_texts(drive), copy)
    assert copy.read_text() == drive.read_text()


def test_what_is_no_trace_is_refused(tmp_path):
    other = tmp_path / "other.csv"
    other.write_text("name,A\nx,1\n")
    with pytest.raises(UsageError, match="is not a trace"):
        read_texts(other)


def test_what_is_watched_begins_with_the_scenario_and_ends_before_its_end(tmp_path):
    sent = {"X": ((9, "a"), (10, "b"), (19, "c"), (20, "d")), "Y": ((0, "a"),)}
    calls = (CallTime("F", "F_Step", 9, 3, 1), CallTime("F", "F_Step", 10, 3, 1))
    recording = Recording("p", "lock step", Built("p", tmp_path, (), 0, 0), sent, calls)
    found = watched(recording, scenario("a", 10, 20))
    assert found.sent == {"X": ((10, "b"), (19, "c"))}
    assert [call.time_ns for call in found.calls] == [10]
