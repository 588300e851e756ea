"""`sigcat gateway TRACE --send`: what the catalogue maps to CAN is sent there, as cantools would decode it."""

import random
from typing import Any

import can
import cantools
import pytest
from can.interfaces.virtual import VirtualBus

from sigcat.cli import main

DBC = """\
VERSION ""
BU_: Gateway
BO_ 256 Wish: 8 Gateway
 SG_ Tilt : 0|8@1+ (0.02,0) [0|5] "V" Gateway
 SG_ Speed : 8|16@1+ (0.01,0) [0|300] "km/h" Gateway
 SG_ Gear : 24|3@1+ (1,0) [0|0] "" Gateway
 SG_ Level : 27|5@1- (1,0) [0|0] "" Gateway
 SG_ Exact : 32|32@1- (1,0) [0|0] "" Gateway
BO_ 2147484160 Page: 3 Gateway
 SG_ Number M : 0|8@1+ (1,0) [0|0] "" Gateway
 SG_ Mass m3 : 8|16@1+ (1,0) [0|0] "kg" Gateway
 SG_ Height m4 : 15|16@0+ (1,0) [0|0] "mm" Gateway
BO_ 258 Other: 1 Gateway
 SG_ Light : 0|1@1+ (1,0) [0|1] "" Gateway
 SG_ Alive : 1|4@1+ (1,0) [0|15] "" Gateway
BO_ 259 Again: 2 Gateway
 SG_ Light : 8|1@1+ (1,0) [0|1] "" Gateway
BA_DEF_ SG_ "GenSigStartValue" INT 0 100000;
BA_DEF_DEF_ "GenSigStartValue" 0;
BA_ "GenSigStartValue" SG_ 258 Alive 9;
SIG_VALTYPE_ 256 Exact : 1;
VAL_ 256 Gear 0 "PARK" 1 "DRIVE" 7 "SNA" ;
"""
TILT, SPEED, GEAR = (
    "Vehicle.Body.Mirrors.DriverSide.Tilt",
    "Vehicle.Speed",
    "Vehicle.Powertrain.Transmission.CurrentGear",
)
LIGHT = "Vehicle.Body.Lights.Beam.Low.IsOn"


@pytest.fixture
def send(tmp_path, capsys):
    """Frames of a trace, by time, message and values, and the reported lines."""
    (tmp_path / "bus.dbc").write_text(DBC)
    reference: Any = cantools.database.load_string(DBC, "dbc")

    def sending(mappings, columns, rows, *options, status=0):
        overlay, trace, log = tmp_path / "can.vspec", tmp_path / "trace.csv", tmp_path / "out.log"
        overlay.write_text("".join(f"{path}: {{{text}}}\n" for path, text in mappings.items()))
        trace.write_text("\n".join([",".join(("time", *columns)), *rows]) + "\n")
        given = [str(trace), "--dbc", str(tmp_path / "bus.dbc"), "-s", "vss", "-l", str(overlay), "--send", str(log)]
        assert main(["gateway", *given, *options]) == status
        if status:
            return [], capsys.readouterr().err.replace(f"{tmp_path}/", "")
        with can.LogReader(log) as read:
            frames = [
                (
                    round(each.timestamp, 6),
                    reference.decode_message(
                        each.arbitration_id,
                        bytes(each.data),
                        decode_choices=False,
                        force_extended_id=each.is_extended_id,
                    ),
                )
                for each in read
            ]
        return frames, capsys.readouterr().err.replace(f"{tmp_path}/", "")

    return sending


def test_a_formula_a_list_and_a_name_make_numbers_of_the_network(send):
    frames, told = send(
        {
            TILT: "type: actuator, datatype: int8, vss2dbc: {signal: Tilt, transform: {math: (x+100)/40}}",
            LIGHT: "type: actuator, datatype: boolean, vss2dbc: {signal: Gear, transform: {mapping: "
            "[{from: true, to: DRIVE}, {from: false, to: 0}]}}",
        },
        (TILT, LIGHT),
        ["0,-20,", "0.1,,true", "0.2,100,false"],
    )
    found = [(time, values["Tilt"], values["Gear"]) for time, values in frames]
    assert found == [(0.0, 2.0, 0), (0.1, 2.0, 1), (0.2, 5.0, 0)]
    assert "4 values towards CAN: 4 sent in 3 frames, 0 held back by interval or for being unchanged, 0 unfit" in told


@pytest.mark.parametrize(
    ("mapping", "times"),
    [
        ("vss2dbc: {signal: Speed}", [0, 0.1, 0.2, 0.3, 0.4, 0.5]),
        ("vss2dbc: {signal: Speed, on_change: true}", [0, 0.3, 0.5]),
        ("vss2dbc: {signal: Speed, interval_ms: 250}", [0, 0.25, 0.5]),
        ("network_serialization: {signal: Speed}", [0, 0.3, 0.5]),
        ("network_serialization: {signal: Speed, on_change: false}", [0, 0.1, 0.2, 0.3, 0.4, 0.5]),
        ("network_serialization: {signal: Speed, interval_ms: 250}", [0, 0.25, 0.5]),
        ("network_serialization: {signal: Speed, interval_ms: 350, on_change: true}", [0, 0.35, 0.7]),
    ],
)
def test_values_are_sent_when_the_mapping_says_and_the_last_one_always(send, mapping, times):
    """A change within the interval is sent when it is over: else the bus would keep an old value."""
    rows = [f"{time},{value}" for time, value in zip((0, 0.1, 0.2, 0.3, 0.4, 0.5), (1, 1, 1, 2, 2, 3), strict=True)]
    frames, _ = send({SPEED: f"type: actuator, datatype: float, {mapping}"}, (SPEED,), rows)
    assert [time for time, _ in frames] == times
    assert frames[-1][1]["Speed"] == 3


def test_random_values_come_back_as_cantools_decodes_them(send):
    chance = random.Random(5)
    numbers = [(chance.randrange(30001), chance.randrange(-16, 16), chance.uniform(-1e3, 1e3)) for _ in range(300)]
    frames, _ = send(
        {
            SPEED: "type: actuator, datatype: float, vss2dbc: {signal: Speed}",
            TILT: "type: actuator, datatype: int8, vss2dbc: {signal: Level}",
            "Vehicle.Acceleration.Longitudinal": "type: actuator, datatype: float, vss2dbc: {signal: Exact}",
        },
        (SPEED, TILT, "Vehicle.Acceleration.Longitudinal"),
        [f"{time},{raw / 100},{level},{exact!r}" for time, (raw, level, exact) in enumerate(numbers)],
    )
    assert [(round(values["Speed"] * 100), values["Level"]) for _, values in frames] == [each[:2] for each in numbers]
    assert all(abs(values["Exact"] - exact) <= 1e-4 for (_, values), (*_, exact) in zip(frames, numbers, strict=True))


def test_a_representation_is_read_from_right_to_left(send):
    frames, _ = send(
        {
            GEAR: "type: sensor, datatype: int8, network_serialization: {signal: Gear, transform: "
            "{representation: [{value: 0, text: PARK}, {value: 5, text: DRIVE}]}}"
        },
        (GEAR,),
        ["0,0", "1,5", "2,4"],
    )
    assert [values["Gear"] for _, values in frames] == [0, 1]


def test_signals_that_nothing_sets_have_what_the_database_says_that_they_begin_with(send):
    frames, _ = send(
        {LIGHT: "type: actuator, datatype: boolean, vss2dbc: {signal: Light, message: Other}"}, (LIGHT,), ["0,true"]
    )
    assert [dict(values) for _, values in frames] == [{"Light": 1, "Alive": 9}]


def test_signals_that_nothing_sets_have_what_a_file_says(send, tmp_path):
    (tmp_path / "defaults.json").write_text('{"Speed": 12.5, "Gear": "DRIVE", "Others": 1}')
    tilt = "type: actuator, datatype: int8, vss2dbc: {signal: Tilt}"
    frames, told = send({TILT: tilt}, (TILT,), ["0,2"], "--defaults", str(tmp_path / "defaults.json"))
    assert dict(frames[0][1]) == {"Tilt": 2.0, "Speed": 12.5, "Gear": 1, "Level": 0, "Exact": 0.0}
    assert "defaults.json:1:1: warning B009 The CAN database has no signal 'Others'." in told


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "defaults.json:1:2: error B009 The file must be JSON."),
        ("[]", "defaults.json:1:1: error B009 The file must be a JSON object."),
        ('{\n"Speed": 301}', "defaults.json:2:1: error B009 The default 301 of Speed is outside of the limits"),
        ('{"Gear": "R"}', "error B009 The default 'R' of Gear is a text that the database has no number for."),
        ('{"Gear": [1]}', "error B009 Gear must have a number or a name"),
        ('{"Level": 99}', "error B009 The default 99 of Level is not held by the datatype."),
    ],
)
def test_defaults_that_cannot_be_sent_are_refused(send, tmp_path, text, said):
    (tmp_path / "defaults.json").write_text(text)
    tilt = "type: actuator, datatype: int8, vss2dbc: {signal: Tilt}"
    _, told = send({TILT: tilt}, (TILT,), ["0,2"], "--defaults", str(tmp_path / "defaults.json"), status=1)
    assert said in told
    assert not (tmp_path / "out.log").exists()


@pytest.mark.parametrize(
    ("message", "sent"), [("", [{"Light": 1, "Alive": 9}, {"Light": 1}]), (", message: Again", [{"Light": 1}])]
)
def test_a_signal_of_two_messages_is_sent_in_both_unless_the_mapping_names_one(send, message, sent):
    mapping = f"type: actuator, datatype: boolean, vss2dbc: {{signal: Light{message}}}"
    frames, told = send({LIGHT: mapping}, (LIGHT,), ["0,true"])
    assert [dict(values) for _, values in frames] == sent
    assert ("2 messages have a signal Light: `Other` and `Again`. It is sent in all of them." in told) == (not message)


@pytest.mark.parametrize(("cells", "sent"), [(["0,36", "1,655.35"], [36]), (["0,655.35"], [])])
def test_a_marker_of_a_representation_is_not_sent_as_a_number(send, cells, sent):
    speed = "network_serialization: {signal: Speed, transform: {representation: [{value: 65535, text: SNA}]}}"
    frames, told = send({SPEED: f"type: sensor, datatype: float, {speed}"}, (SPEED,), cells)
    assert [values["Speed"] for _, values in frames] == sent
    assert "1 values not sent to CAN, outside of the limits" in told


def test_a_part_of_a_multiplexed_message_is_sent_with_its_number(send):
    frames, _ = send(
        {
            "Vehicle.CurbWeight": "type: attribute, datatype: uint16, network_serialization: {signal: Mass}",
            "Vehicle.Height": "type: attribute, datatype: uint16, network_serialization: {signal: Height}",
        },
        ("Vehicle.CurbWeight", "Vehicle.Height"),
        ["0,1500,1600", "1,1510,"],
    )
    assert [dict(values) for _, values in frames] == [
        {"Number": 3, "Mass": 1500}, {"Number": 4, "Height": 1600}, {"Number": 3, "Mass": 1510},
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("cell", "why"),
    [("300.01", "outside of the limits"), ("nan", "not held by the datatype"), ("word", "no value of the datatype")],
)
def test_what_the_network_cannot_hold_is_not_sent_and_is_told(send, cell, why):
    speed = {SPEED: "type: actuator, datatype: float, vss2dbc: {signal: Speed}"}
    frames, told = send(speed, (SPEED, "Vehicle.Width"), [f"0,{cell},1", "1,300,"])
    assert [values["Speed"] for _, values in frames] == [300]
    assert f"{SPEED}: 1 values not sent to CAN, {why}" in told
    assert "info B005 Nothing maps to CAN: Vehicle.Width." in told


def test_a_formula_of_the_profile_is_not_turned_round(send):
    mappings = {
        SPEED: "type: sensor, datatype: float, network_serialization: {signal: Speed, transform: {math: x * 2}}",
        LIGHT: "type: actuator, datatype: boolean, vss2dbc: {signal: Light, message: Other}",
    }
    frames, told = send(mappings, (SPEED, LIGHT), ["0,3,true"])
    assert len(frames) == 1
    assert f"Nothing maps to CAN: {SPEED}." in told


class Clock:
    """A clock that only sleeping moves."""

    def __init__(self) -> None:
        self.now = 1000.0

    def monotonic(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds


def test_a_bus_gets_the_frames_at_their_times(tmp_path, monkeypatch):
    (tmp_path / "bus.dbc").write_text(DBC)
    (tmp_path / "can.vspec").write_text(f"{SPEED}: {{type: actuator, datatype: float, vss2dbc: {{signal: Speed}}}}\n")
    (tmp_path / "trace.csv").write_text(f"time,{SPEED}\n5,1\n5.3,2\n")
    clock = Clock()
    monkeypatch.setattr("sigcat.gateway.bus.time", clock)
    sent: list[tuple[float, int]] = []
    send = VirtualBus.send

    def noted(bus: Any, message: can.Message, timeout: float | None = None) -> None:
        sent.append((clock.now, message.data[1]))
        send(bus, message, timeout)

    monkeypatch.setattr(VirtualBus, "send", noted)
    with can.Bus(interface="virtual", channel="sending") as bus:
        given = [str(tmp_path / "trace.csv"), "--dbc", str(tmp_path / "bus.dbc"), "-s", "vss"]
        assert main(["gateway", *given, "-l", str(tmp_path / "can.vspec"), "--send", "virtual:sending"]) == 0
        received = [bus.recv(0) for _ in sent]
    assert [each.data[1] for each in received if each] == [100, 200]
    assert sent == [(1000.0, 100), (pytest.approx(1000.3), 200)]


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--send", "can0"], "--send must be INTERFACE:CHANNEL, such as socketcan:can0, or a log"),
        (["--send", "nonsense:can0"], "nonsense:can0 cannot be opened"),
        ([], "a trace goes to CAN: name a bus or a log with --send"),
    ],
)
def test_where_it_goes_has_to_be_said(tmp_path, capsys, options, told):
    (tmp_path / "bus.dbc").write_text(DBC)
    (tmp_path / "can.vspec").write_text(f"{SPEED}: {{type: actuator, datatype: float, vss2dbc: {{signal: Speed}}}}\n")
    (tmp_path / "trace.csv").write_text(f"time,{SPEED}\n5,1\n")
    given = [str(tmp_path / "trace.csv"), "--dbc", str(tmp_path / "bus.dbc"), "-s", "vss"]
    assert main(["gateway", *given, "-l", str(tmp_path / "can.vspec"), *options]) == 2
    assert told in capsys.readouterr().err
