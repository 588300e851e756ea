"""`sigcat gateway --to`: signals of CAN are sent to running functions, all of them, and their outputs are sent back."""

import os
import shlex
import struct
import sys
from pathlib import Path

import can
import pytest
from can.interfaces.virtual import channels

from sigcat.adapter.host.shapes import Number
from sigcat.cli import main
from sigcat.players.program import Program
from tests.gateway.live_bus import sending
from tests.waiting import wait_until

DBC = """\
VERSION ""
BU_: Gateway
BO_ 256 Motion: 4 Gateway
 SG_ Speed : 0|16@1+ (0.01,0) [0|250] "km/h" Gateway
 SG_ Mass : 16|16@1+ (1,0) [0|0] "kg" Gateway
BO_ 257 Wish: 2 Gateway
 SG_ Wish : 0|16@1+ (0.01,0) [0|500] "km/h" Gateway
"""
MAPPINGS = """\
Vehicle.Speed: {type: sensor, datatype: float, network_serialization: {signal: Speed, on_change: false}}
Vehicle.CurbWeight: {type: attribute, datatype: uint16, network_serialization: {signal: Mass}}
Vehicle.Wish:
  type: actuator
  datatype: float
  description: What functions wish.
  vss2dbc: {signal: Wish, on_change: true}
"""
PLAYER = Path(__file__).with_name("player.py")


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    """A run with a replacement of the player; its input, and the reported lines."""
    for name, text in {"bus.dbc": DBC, "can.vspec": MAPPINGS, "functions.json": "{}"}.items():
        (tmp_path / name).write_text(text)
    script = tmp_path / "player"
    script.write_text(f'#!/bin/sh\nexec {shlex.join([sys.executable, str(PLAYER)])} "$0" "$@"\n')
    script.chmod(0o755)

    def running(*options, player="", status=0, log=None, datatype="float"):
        program = Program("SOME/IP", script, {**os.environ, "PLAYER": player}, {"Vehicle.Speed": Number(datatype)})
        monkeypatch.setattr("sigcat.players.program.build_player", lambda *_: program)
        path = tmp_path / "drive.log"
        path.write_text(
            "".join(f"({at:.6f}) can0 100#{struct.pack('<HH', *data).hex()}\n" for at, data in log or DRIVE)
        )
        given = [] if "--live" in options else [str(path)]
        given += ["--dbc", str(tmp_path / "bus.dbc"), "-s", "vss", "-l", str(tmp_path / "can.vspec")]
        assert main(["gateway", *given, "--to", str(tmp_path / "functions.json"), *map(str, options)]) == status
        rows = (tmp_path / "given.csv").read_text().splitlines() if (tmp_path / "given.csv").exists() else []
        return rows, capsys.readouterr().err.replace(f"{tmp_path}/", "")

    return running


DRIVE = [(100.0, (100, 1500)), (100.05, (200, 1500)), (100.1, (200, 1510))]


def test_every_value_is_handed_over_at_its_time_since_the_first_one_and_counted(run):
    rows, told = run()
    assert rows == [
        "time_ns\tVehicle.Speed\tVehicle.CurbWeight",
        "0\t1.0\t",
        "50000000\t2.0\t",
        "100000000\t2.0\t",
    ]
    assert "drive.log: 3 values of 1 signals sent over SOME/IP, 3 received" in told
    assert "drive.log: info B007 No function receives Vehicle.CurbWeight." in told


def test_values_that_are_not_of_the_functions_datatype_are_not_sent(run):
    log = [(100.0, (100, 1500)), (100.05, (150, 1500)), (100.1, (250, 1500))]
    rows, told = run(status=1, datatype="uint8", log=log)
    assert rows[1:] == ["0\t1\t", "50000000\t\t", "100000000\t\t"]
    assert "Vehicle.Speed must be a whole number from 0 to 255, not '1.5': 2 values were not sent." in told
    assert "drive.log: 1 values of 1 signals sent over SOME/IP" in told


def test_what_functions_send_is_a_trace(run, tmp_path):
    run("--recorded", tmp_path / "recorded.csv", "-o", tmp_path / "trace.csv")
    assert (tmp_path / "recorded.csv").read_text() == (
        "time,Vehicle.Wish\n0.000000000,2.0\n0.050000000,4.0\n0.100000000,4.0\n"
    )
    assert (tmp_path / "trace.csv").read_text() == (
        "time,Vehicle.Speed,Vehicle.CurbWeight\n0.000000000,1.0,1500\n0.050000000,2.0,\n0.100000000,2.0,1510\n"
    )


def test_what_functions_send_goes_back_to_can(run, tmp_path):
    _, told = run("--send", tmp_path / "wish.log", "--lock-step")
    frames = [line.split()[:3] for line in (tmp_path / "wish.log").read_text().splitlines()]
    assert [(time_, data) for time_, _, data in frames] == [("(0.000000)", "101#C800"), ("(0.050000)", "101#9001")]
    assert "3 values towards CAN: 2 sent in 2 frames, 1 held back" in told


def test_a_default_of_a_signal_that_the_database_lacks_is_reported_once(run, tmp_path):
    (tmp_path / "defaults.json").write_text('{"Others": 1}')
    _, told = run("--send", tmp_path / "wish.log", "--defaults", tmp_path / "defaults.json", "--lock-step")
    assert told.count("The CAN database has no signal 'Others'") == 1


def test_in_real_time_too(run, tmp_path):
    run("--send", tmp_path / "wish.log")
    assert "101#9001" in (tmp_path / "wish.log").read_text().splitlines()[-1]


@pytest.mark.parametrize(
    ("player", "told"),
    [
        ("dies", "functions.json: error B007 Not every component runs. Start them before the gateway"),
        ("breaks", "functions.json: error B007 It breaks."),
        ("loses", "drive.log: error B007 Of 3 values, 2 were sent over SOME/IP."),
        ("alone", "drive.log: error B007 Of 3 values, 2 were sent while a process was gone that functions run in."),
    ],
)
def test_functions_that_are_not_reached_are_told(run, player, told):
    assert told in run(player=player, status=1)[1]


def test_a_bus_is_carried_as_frames_come_once_everybody_listens(run, tmp_path):
    """The gateway listens as soon as its player is ready."""
    listeners = []

    def player_is_ready():
        wait_until((tmp_path / "player_waits").exists, "the player has started")
        listeners.extend(channels["carried"])
        (tmp_path / "player_goes_on").touch()

    speeds = [struct.pack("<HH", speed, 1) for speed in (100, 200)]
    frames = [can.Message(0.05 * n, 256, is_extended_id=False, data=data) for n, data in enumerate(speeds)]
    with sending("carried", frames, first=player_is_ready):
        rows, _ = run("--live", "virtual:carried", player="late")
    assert [row.split("\t")[1] for row in rows] == ["Vehicle.Speed", "1.0", "2.0"]
    assert len(listeners) == 1, "the sender alone"


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--lock-step"], "--lock-step is for --to"),
        (["--recorded", "x.csv"], "--recorded is for --to"),
        (["--send", "virtual:x"], "--send is for a trace (.csv), or for what functions send"),
        (
            ["--to", "functions.json", "--live", "virtual:x", "--lock-step"],
            "--lock-step is for a log: a bus does not wait",
        ),
    ],
)
def test_options_that_do_not_belong_together_are_told(tmp_path, capsys, options, told):
    (tmp_path / "drive.log").write_text("")
    assert main(["gateway", str(tmp_path / "drive.log"), "--dbc", "x.dbc", *options]) == 2
    assert told in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("", ""),
        ("{}", ""),
        ("[1]", ""),
        ("nonsense", ""),
        ('{"FmiInformation": {}}', "; it is Integration JSON for FMI"),
        ('{"ApplicationInformation": {}}', "; it is Integration JSON for AUTOSAR Classic"),
    ],
)
def test_a_document_without_a_player_is_refused(run, tmp_path, capsys, text, kind):
    (tmp_path / "drive.log").write_text("(0.1) can0 100#64000000\n")
    (tmp_path / "functions.json").write_text(text)
    given = [
        str(tmp_path / "drive.log"),
        "--dbc",
        str(tmp_path / "bus.dbc"),
        "-s",
        "vss",
        "-l",
        str(tmp_path / "can.vspec"),
    ]
    assert main(["gateway", *given, "--to", str(tmp_path / "functions.json")]) == 2
    message = capsys.readouterr().err
    assert (
        "must be Integration JSON, as `sigcat integrate autosar-adaptive` or `sigcat integrate ros2` writes it"
        in message
    )
    assert kind in message
