"""`sigcat gateway`: a value is carried exactly or is reported as lost, and a log without a usable value replaces no trace."""

import csv
import json
import math
import struct

import can
import pytest

from sigcat.cli import main

DBC = """\
VERSION ""
BU_: Gateway
BO_ 256 Steps: 8 Gateway
 SG_ Fine : 0|12@1- (0.05,0) [-102.4|102.35] "" Gateway
 SG_ Rounded : 16|8@1+ (0.3333,0) [0|85] "" Gateway
BO_ 257 Whole: 8 Gateway
 SG_ Unsigned : 0|64@1+ (1,0) [0|18446744073709551615] "" Gateway
BO_ 258 Signed: 8 Gateway
 SG_ Signed : 0|64@1- (1,0) [0|0] "" Gateway
BO_ 259 Pages: 4 Gateway
 SG_ Page M : 0|8@1+ (1,0) [0|0] "" Gateway
 SG_ Mass m0 : 8|16@1+ (1,0) [0|0] "kg" Gateway
 SG_ Common : 24|8@1+ (1,0) [0|0] "" Gateway
BO_ 260 Real: 4 Gateway
 SG_ Real : 0|32@1- (1,0) [0|0] "" Gateway
SIG_VALTYPE_ 260 Real : 1;
"""
OTHER = DBC.replace("BO_ 256 Steps", "BO_ 256 Others").replace("Fine", "Coarse")
INTEGERS = (1234567890123456789, 2**63 - 1, 0)


@pytest.fixture
def run(tmp_path, capsys):
    """The values of the one signal that is mapped, the status and the reported lines."""
    (tmp_path / "bus.dbc").write_text(DBC)
    report = tmp_path / "report.json"

    def running(log, mapping, datatype="double", *options):
        (tmp_path / "can.vspec").write_text(
            f"Vehicle.A: {{type: sensor, datatype: {datatype}, description: A., {mapping}}}\n"
        )
        out = tmp_path / "trace.csv"
        given = ["gateway", log, "--dbc", tmp_path / "bus.dbc", "-s", "vss", "-l", tmp_path / "can.vspec", "-o", out]
        status = main([*map(str, given), "--report", str(report), *options])
        rows = list(csv.DictReader(out.read_text().splitlines())) if out.exists() else []
        found = [
            f"{each['severity']} {each['rule']} {each['message']}"
            for each in json.loads(report.read_text())["findings"]
        ]
        capsys.readouterr()
        return [row["Vehicle.A"] for row in rows], status, found

    return running


@pytest.fixture
def log(tmp_path):
    """A log of frames of one identifier, a second apart."""

    def writing(identifier, *frames, name="drive.log", channels=(0,)):
        path = tmp_path / name
        with can.Logger(str(path)) as logger:
            for index, data in enumerate(frames):
                channel = channels[index % len(channels)]
                logger.on_message_received(
                    can.Message(
                        timestamp=index, arbitration_id=identifier, is_extended_id=False, data=data, channel=channel
                    )
                )
        return path

    return writing


def mapped(signal, more=""):
    return f"dbc2vss: {{signal: {signal}, interval_ms: 0{more}}}"


# -- exact --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("identifier", "signal", "datatype", "form", "numbers"),
    [
        (257, "Unsigned", "uint64", "<Q", (*INTEGERS, 2**64 - 1)),
        (258, "Signed", "int64", "<q", (*INTEGERS, -(2**63))),
    ],
)
def test_whole_numbers_of_64_bits_are_exact(run, log, identifier, signal, datatype, form, numbers):
    values, status, found = run(log(identifier, *(struct.pack(form, n) for n in numbers)), mapped(signal), datatype)
    assert (values, status) == ([str(number) for number in numbers], 0)
    assert found == [], "the datatype holds all that the signal can be"


def test_whole_numbers_of_64_bits_stay_exact_in_a_formula(run, log):
    more = ", transform: {math: x - 1}"
    values, _, _ = run(log(257, struct.pack("<Q", 2**63 + 1)), mapped("Unsigned", more), "uint64")
    assert values == [str(2**63)]


@pytest.mark.parametrize("raw", [0x7FF, 0x800])
def test_a_value_at_the_limit_is_the_limit(run, log, raw):
    values, _, _ = run(log(256, struct.pack("<Q", raw)), mapped("Fine"))
    assert values == ["102.35" if raw == 0x7FF else "-102.4"]


def test_a_step_that_was_meant_by_a_rounded_limit_is_taken_and_the_next_one_is_not(run, log):
    frames = (struct.pack("<HBxL", 0, raw, 0) for raw in (255, 254))
    values, _, _ = run(log(256, *frames), mapped("Rounded"))
    assert [float(value) for value in values] == pytest.approx([84.9915, 84.6582])


# -- lost values are reported -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(("datatype", "more"), [("boolean", ""), ("uint8", ", transform: {math: 'x >= 1'}")])
def test_no_number_is_neither_true_nor_0(run, log, datatype, more):
    frames = [struct.pack("<f", number) for number in (math.nan, 1.0)]
    values, _, found = run(log(260, *frames), mapped("Real", more), datatype)
    assert values == ["true" if datatype == "boolean" else "1"]
    assert any(each.startswith("info B005 Vehicle.A: 1 of 2 values left out, ") for each in found)


def test_a_signal_none_of_whose_values_is_taken_is_told(run, log):
    values, status, found = run(log(257, struct.pack("<Q", 2**40)), mapped("Unsigned"), "uint8")
    assert (values, status) == ([], 1)
    assert "warning B005 Vehicle.A: 1 of 1 values left out, not held by the datatype." in found


def test_of_a_frame_with_an_undefined_multiplexer_the_rest_is_taken(run, log):
    frames = [bytes([page, 1, 0, 7]) for page in (9, 0, 9)]
    values, status, found = run(log(259, *frames), mapped("Common"), "uint8")
    assert (values, status) == (["7", "7", "7"], 0)
    assert found == [
        "warning B005 2 frames of Pages: multiplexer Page is 9; 0 is defined. What does not hang on it was taken."
    ]


def test_a_signal_that_never_came_is_told(run, log, tmp_path):
    log_of_common = log(259, bytes([9, 1, 0, 7]))
    more = f"{mapped('Common')}}}\nVehicle.B: {{type: sensor, datatype: uint16, description: B., {mapped('Mass')}"
    _, status, found = run(log_of_common, more, "uint8")
    assert status == 0
    assert "info B005 1 of 2 mapped signals never came: Vehicle.B." in found


# -- logs ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("line", ["(1.0) can0 103#0901000", "(1.0) can0 103##1090", "(1.0) can0 103#090 R"])
def test_a_line_of_candump_that_ends_within_a_byte_is_no_frame(run, tmp_path, line):
    path = tmp_path / "drive.log"
    path.write_text(f"(0.0) can0 103#00010007\n{line}")
    values, _, found = run(path, mapped("Page"), "uint8")
    assert values == ["0"]
    assert "warning B002 The line is not a frame: its data ends in the middle of a byte." in found


@pytest.mark.parametrize(("cut", "has"), [("00 01 0", 2), ("00 01 00", 3), ("00 01 00 0", 3)])
def test_a_line_of_asc_that_was_cut_is_no_frame(run, tmp_path, cut, has):
    path = tmp_path / "drive.asc"
    start = "base hex  timestamps absolute\n0.5 1  103             Rx   d 4 05 01 00 07\n"
    path.write_text(f"{start}0.6 1  103             Rx   d 4 {cut}")
    values, _, found = run(path, mapped("Page"), "uint8")
    assert values == ["5"]
    assert f"warning B002 The line is not a frame: it has {has} of 4 bytes." in found


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("0.6 1  103             Rx   d 4 05 2 00 07\n", "'2' is not a whole byte"),
        ("0.6 1  103             Rx   d 4 05 2 00 07 Length = 4 BitCount = 5\n", "'2' is not a whole byte"),
        (
            "0.6 CANFD   1 Rx        103                                  1 0 4  4 05 2 00 07 0 0\n",
            "'2' is not a whole byte",
        ),
        ("0.6 1  103             Rx   d 4", "it has 0 of 4 bytes"),
        ("0.6 1  103             Rx", "it has no line break, and no frame up to its end"),
        ("0.6", "it has no line break, and no frame up to its end"),
    ],
)
def test_half_a_byte_and_a_cut_last_line_of_asc_are_no_frame(run, tmp_path, line, why):
    path = tmp_path / "drive.asc"
    start = "base hex  timestamps absolute\n0.5 1  103             Rx   d 4 05 01 00 07\n"
    path.write_text(f"{start}{line}")
    values, _, found = run(path, mapped("Page"), "uint8")
    assert values == ["5"]
    assert f"warning B002 The line is not a frame: {why}." in found


def test_bytes_of_asc_may_be_decimal(run, tmp_path):
    path = tmp_path / "drive.asc"
    path.write_text("base dec  timestamps absolute\n0.5 1  259             Rx   d 4 5 1 0 200\n")
    assert run(path, mapped("Common"), "uint8")[0] == ["200"]


def test_a_last_line_of_candump_without_a_line_break_is_read_and_reported(run, tmp_path):
    path = tmp_path / "drive.log"
    path.write_text("(0.0) can0 103#00010007\n(0.1) can0 103#0101")
    values, _, found = run(path, mapped("Page"), "uint8")
    assert values == ["0", "1"]
    cut = "The last line has no line break: the log may have been cut there. Its frame was read."
    assert f"warning B002 {cut}" in found


NOTHING = "error B004 No readable frame found: no trace is written."


@pytest.mark.parametrize(
    ("name", "data"), [("e.log", b""), ("e.asc", b""), ("j.log", b"junk\n"), ("j.blf", b"LOGGjunk")]
)
def test_a_log_that_yields_nothing_replaces_no_trace(run, tmp_path, name, data):
    (tmp_path / name).write_bytes(data)
    (tmp_path / "trace.csv").write_text("time,Vehicle.A\n0,5\n")
    values, status, found = run(tmp_path / name, mapped("Page"), "uint8")
    assert (values, status) == (["5"], 1)
    assert any(line == NOTHING or line.startswith("error B002 The log is damaged") for line in found)


@pytest.mark.parametrize("name", ["drive.asc", "drive.blf"])
def test_channels_are_named_as_the_log_names_them(run, log, name):
    """python-can writes its channel 0 as 1, as Vector's logs begin to count."""
    path = log(259, *(bytes([0, 0, 0, number]) for number in (1, 2)), name=name, channels=(0, 1))
    assert run(path, mapped("Common"), "uint8", "--channel", "1")[0] == ["1"]
    assert run(path, mapped("Common"), "uint8", "--channel", "2")[0] == ["2"]
    values, status, found = run(path, mapped("Common"), "uint8")
    assert (values, status) == (["1", "2"], 0)
    assert found == ["warning B004 Frames of Pages come on the channels 1, 2; their values are merged."]


def test_channels_of_the_log_are_listed_for_one_that_it_lacks(run, log):
    path = log(259, bytes(4), bytes(4), name="drive.asc", channels=(0, 1))
    assert run(path, mapped("Common"), "uint8", "--channel", "3")[1:] == (
        1,
        ["error B004 No frame is of channel 3: there are 1, 2."],
    )


# -- databases ----------------------------------------------------------------------------------------------------


def test_two_databases_that_contradict_each_other_are_refused(run, log, tmp_path, capsys):
    (tmp_path / "other.dbc").write_text(OTHER)
    path = log(259, bytes(4))
    _, status, found = run(path, mapped("Common"), "uint8", "--dbc", str(tmp_path / "other.dbc"))
    assert (status, len(found)) == (1, 1)
    assert found[0].startswith("error B001 Others has the identifier 100, which Steps has in ")
    assert found[0].endswith("bus.dbc.")
    given = [
        "lint",
        "-s",
        "vss",
        tmp_path / "can.vspec",
        "--dbc",
        tmp_path / "bus.dbc",
        "--dbc",
        tmp_path / "other.dbc",
    ]
    assert main([*map(str, given)]) == 1
    assert "B001" in capsys.readouterr().out


@pytest.mark.parametrize("name", ["bus.dbc", "copy.dbc"])
def test_databases_that_say_the_same_are_one(run, log, tmp_path, name):
    (tmp_path / "copy.dbc").write_text(DBC)
    values, status, found = run(log(259, bytes(4)), mapped("Common"), "uint8", "--dbc", str(tmp_path / name))
    assert (values, status, found) == (["0"], 0, [])
