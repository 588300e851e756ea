"""`sigcat gateway`: logs of python-can's writers are decoded as by cantools, and nothing is lost silently."""

import random
import struct
from typing import Any

import can
import cantools
import pytest

from sigcat.cli import main
from tests.gateway.logs import DBC, message, motion


@pytest.mark.parametrize("name", ["drive.log", "drive.asc", "drive.blf", "drive.log.gz", "drive.asc.gz"])
def test_every_form_of_log_gives_the_same_trace(run, log, name):
    """BLF and ASC count from the first frame, so it is at 0 here."""
    messages = [message(index / 100, motion(index * 100, index % 2, index / 10)) for index in range(20)]
    rows, told = run(log(messages, name), "--from-zero")
    assert rows[:2] == ["0.000000000,0.0,,0,0.0", "0.010000000,0.1,,1,1.0"]
    assert len(rows) == 20
    assert "20 frames in 0.190 s: 20 decoded" in told


def test_times_are_those_of_the_log(run, log):
    rows, _ = run(log([message(1436509052.249713, motion(1)), message(1436509052.250001, motion(2))]))
    assert [row.split(",")[0] for row in rows] == ["1436509052.249713000", "1436509052.250001000"]


def test_random_frames_are_decoded_as_cantools_decodes_them(run, log, tmp_path):
    chance = random.Random(7)
    frames = [chance.randbytes(8) for _ in range(500)]
    rows, _ = run(log([message(index / 1000, data) for index, data in enumerate(frames)]))
    reference: Any = cantools.database.load_string(DBC, "dbc")
    decode = reference.get_message_by_name("Motion").decode
    speeds = {row.split(",")[0]: row.split(",")[4] for row in rows}
    for index, data in enumerate(frames):
        expected = decode(data)["Speed"]
        cell = speeds.get(f"{index / 1000:.9f}", "")
        assert (cell == "") == (expected > 250), (expected, cell)
        assert cell == "" or struct.pack("<f", float(cell)) == struct.pack("<f", expected)


def test_a_multiplexed_signal_comes_with_its_part(run, log):
    identifier = 0x200
    messages = [
        can.Message(timestamp=index, arbitration_id=identifier, is_extended_id=True, data=bytes([page, 0xD2, 0x04, 0]))
        for index, page in enumerate((1, 0, 1))
    ]
    rows, told = run(log(messages))
    assert rows == ["1.000000000,,1234,,"]
    assert "3 decoded" in told


def test_a_frame_with_another_kind_of_identifier_is_another_frame(run, log):
    rows, told = run(log([can.Message(timestamp=1, arbitration_id=256, is_extended_id=True, data=motion(1))]), status=1)
    assert rows == []
    assert (
        "error B004 No frame of the log has a mapped signal: the database has none of its identifiers, such as 100x (1)."
        in told
    )


def sent(tmp_path, log, capsys, mapping, speeds, period=0.1):
    (tmp_path / "bus.dbc").write_text(DBC)
    (tmp_path / "one.vspec").write_text(f"Vehicle.Speed: {{type: sensor, datatype: float, {mapping}}}\n")
    path = log([message(index * period, motion(speed * 100)) for index, speed in enumerate(speeds)])
    given = ["gateway", str(path), "--dbc", str(tmp_path / "bus.dbc"), "-s", "vss", "-l", str(tmp_path / "one.vspec")]
    assert main(given) == 0
    rows = capsys.readouterr().out.splitlines()[1:]
    return [(round(float(time), 3), float(value)) for time, value in (row.split(",") for row in rows)]


SPEEDS = (1, 1, 1, 2, 2, 3, 3, 3)


@pytest.mark.parametrize(
    ("mapping", "times"),
    [
        ("network_serialization: {signal: Speed}", [0, 0.3, 0.5]),
        ("network_serialization: {signal: Speed, on_change: false}", [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]),
        ("network_serialization: {signal: Speed, interval_ms: 200}", [0, 0.2, 0.4, 0.6]),
        ("network_serialization: {signal: Speed, interval_ms: 250, on_change: true}", [0, 0.3, 0.6]),
        ("dbc2vss: {signal: Speed}", [0]),
        ("dbc2vss: {signal: Speed, interval_ms: 0}", [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]),
        ("dbc2vss: {signal: Speed, on_change: true}", [0, 0.3, 0.5]),
        ("dbc2vss: {signal: Speed, interval_ms: 200, on_change: true}", [0, 0.4, 0.6]),
        ("dbc: {signal: Speed, interval_ms: 200}", [0, 0.2, 0.4, 0.6]),
    ],
)
def test_values_are_sent_when_the_mapping_says(tmp_path, log, capsys, mapping, times):
    found = sent(tmp_path, log, capsys, mapping, SPEEDS)
    assert [time for time, _ in found] == times
    assert all(value == SPEEDS[round(time * 10)] for time, value in found)


def test_an_unchanged_value_begins_the_interval_anew_for_kuksa_alone(tmp_path, log, capsys):
    speeds = (1, 1, 1, 2, 2)
    kuksa = "dbc2vss: {signal: Speed, interval_ms: 200, on_change: true}"
    profile = "network_serialization: {signal: Speed, interval_ms: 200, on_change: true}"
    assert [time for time, _ in sent(tmp_path, log, capsys, kuksa, speeds)] == [0, 0.4]
    assert [time for time, _ in sent(tmp_path, log, capsys, profile, speeds)] == [0, 0.3]


def test_the_interval_begins_with_a_transformation_that_fails_for_kuksa_alone(tmp_path, log, capsys):
    speeds = (1, 2, 2, 2)
    failing = "{{signal: Speed, interval_ms: 200, {}transform: {{math: x / (x - 1)}}}}"
    kuksa, profile = failing.format(""), failing.format("on_change: false, ")
    assert [time for time, _ in sent(tmp_path, log, capsys, f"dbc2vss: {kuksa}", speeds)] == [0.2]
    assert [time for time, _ in sent(tmp_path, log, capsys, f"network_serialization: {profile}", speeds)] == [0.1, 0.3]


def test_the_interval_does_not_begin_with_a_value_outside_of_the_limits(tmp_path, log, capsys):
    """The KUKSA CAN provider drops such a value before it looks at the time."""
    found = sent(tmp_path, log, capsys, "dbc2vss: {signal: Speed, interval_ms: 200}", (300, 2, 2, 2))
    assert [time for time, _ in found] == [0.1, 0.3]


def test_no_number_is_no_change_of_no_number(tmp_path, log, capsys):
    (tmp_path / "bus.dbc").write_text(DBC)
    overlay = tmp_path / "one.vspec"
    overlay.write_text(
        "Vehicle.Acceleration.Longitudinal: {type: sensor, datatype: float, network_serialization: {signal: Acceleration}}\n"
    )
    nan = float("nan")
    path = log([message(index, motion(0, 0, value)) for index, value in enumerate((1.0, nan, nan, 2.0))])
    assert main(["gateway", str(path), "--dbc", str(tmp_path / "bus.dbc"), "-s", "vss", "-l", str(overlay)]) == 0
    assert capsys.readouterr().out.splitlines()[1:] == ["0.000000000,1.0", "1.000000000,nan", "3.000000000,2.0"]
