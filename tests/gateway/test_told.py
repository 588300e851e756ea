"""Mistakes in mappings and logs are reported in terms of CAN, or the input is used as written."""

import gzip
import struct

import can
import pytest

from sigcat.catalogue.network.can_database import read_can_database
from sigcat.cli import main

DBC = """\
VERSION ""
BU_: Gateway
BO_ 256 Motion: 4 Gateway
 SG_ Speed : 0|16@1+ (0.01,0) [0|250] "km/h" Gateway
 SG_ Mass : 16|16@1+ (1,0) [0|0] "kg" Gateway
"""
BODY = (
    DBC.replace("Motion", "Body")
    .replace("0.01", "1")
    .replace("Speed", "Width")
    .replace("Mass", "Height")
    .replace("0|250", "0|0")
)
MAPPINGS = """\
Vehicle.Speed: {type: sensor, datatype: float, network_serialization: {signal: Speed, on_change: false, default: 7}}
Vehicle.Width: {type: attribute, datatype: uint16, network_serialization: {signal: Width}}
"""


@pytest.fixture
def run(tmp_path, capsys):
    """The lines of the trace, and the reported lines."""

    def running(log, *options, mappings=MAPPINGS, dbc=DBC, status=0):
        for name, text in {"bus.dbc": dbc, "body.dbc": BODY, "can.vspec": mappings}.items():
            (tmp_path / name).write_text(text)
        path = log if not isinstance(log, str) else tmp_path / "drive.log"
        if isinstance(log, str):
            path.write_text(log)
        out = tmp_path / "trace.csv"
        given = [str(each).replace("TMP", str(tmp_path)) for each in options]
        if "--dbc" not in given:
            given += ["--dbc", str(tmp_path / "bus.dbc")]
        given += ["-s", "vss", "-l", str(tmp_path / "can.vspec"), "-o", str(out)]
        assert main(["gateway", str(path), *given]) == status
        rows = out.read_text().splitlines() if out.exists() else []
        return rows, capsys.readouterr().err.replace(f"{tmp_path}/", "")

    return running


ONE = MAPPINGS.splitlines()[0].replace(", default: 7", "") + "\n"


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("Motion: 4", "Motion: 99999999", 3),
        ("0|16@1+", "0|99999999@1+", 4),
        ("0|16@1+", "99999999|16@1+", 4),
        ("16|16@1+", f"16|{'9' * 5000}@1+", 5),
    ],
    ids=("message", "signal", "start", "more digits than a number has"),
)
def test_a_size_that_no_message_has_is_refused_at_its_line(run, old, new, line):
    """cantools would lay out each bit, for minutes and in gigabytes."""
    _, told = run("", dbc=DBC.replace(old, new), status=1)
    assert f"bus.dbc:{line}: error B001 A message or signal must have a size or a start of at most " in told


def test_a_size_that_no_message_has_is_refused_in_other_forms(tmp_path):
    files = {
        "a.kcd": '<Message id="0x100" length="8" name="M"><Signal name="S" offset="0" length="99999999"/></Message>',
        "a.sym": "{SENDRECEIVE}\n[M]\nID=100h\nLen=99999999\n",
        "a.arxml": "<I-SIGNAL><LENGTH>99999999</LENGTH></I-SIGNAL>",
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text)
        (finding,) = read_can_database([tmp_path / name]).findings
        assert finding.message.endswith("not 99999999.")


def test_each_channel_may_have_a_database_of_its_own(run):
    """Both buses have identifier 100."""
    log = "(1.0) can0 100#64000000\n(1.1) can1 100#D2040000\n(1.2) can2 100#D2040000\n"
    rows, told = run(log, "--dbc", "can0=TMP/bus.dbc", "--dbc", "can1=TMP/body.dbc")
    assert rows[1:] == ["1.000000000,1.0,", "1.100000000,,1234"]
    assert "1 with an identifier that the database does not have" in told


def test_a_default_stands_until_a_value_comes(run):
    """It comes with the first value of another signal, and once."""
    log = "(1.0) can1 100#D2040000\n(1.1) can0 100#64000000\n"
    rows, told = run(log, "--dbc", "can0=TMP/bus.dbc", "--dbc", "can1=TMP/body.dbc")
    assert rows[1:] == ["1.000000000,7.0,1234", "1.100000000,1.0,"]
    assert "2 values of mapped signals: 2 sent and 1 defaults" in told


@pytest.mark.parametrize(
    ("text", "status", "told"),
    [
        (
            "time,Vehicle.Sped\n1,2\n",
            0,
            "more.csv:1:1: warning T001 The catalogue has no signal 'Vehicle.Sped'. Did you mean 'Vehicle.Speed'?",
        ),
        ("time,abc\n1,2\n", 0, "The catalogue has no signal 'abc'."),
        ("time,Vehicle.CurbWeight\n1,abc\n", 1, "A cell must be"),
        ("time,Demo_Mode_In\n1,ON\n", 0, ""),
    ],
)
def test_columns_that_are_added_are_signals_with_values(run, tmp_path, text, status, told):
    (tmp_path / "more.csv").write_text(text)
    _, words = run("(1.0) can0 100#64000000\n", "--add", "TMP/more.csv", mappings=ONE, status=status)
    assert told in words
    assert told or "warning" not in words


def test_two_clocks_that_are_years_apart_are_told(run, tmp_path):
    (tmp_path / "more.csv").write_text("time,Vehicle.Width\n0,2\n")
    log = "(1700000000.0) can0 100#64000000\n"
    told = run(log, "--add", "TMP/more.csv", mappings=ONE)[1]
    assert "The trace begins at 0 s, and the log at 1,700,000,000 s: their rows do not meet. Count the log" in told
    assert "do not meet" not in run(log, "--add", "TMP/more.csv", "--from-zero", mappings=ONE)[1]


def test_a_blf_that_is_damaged_in_the_middle_is_an_error(run, tmp_path):
    path = tmp_path / "drive.blf"
    with can.Logger(str(path)) as logger:
        for index in range(20_000):
            data = struct.pack("<HH", index % 25_000, index * 7919 % 65536)
            logger.on_message_received(
                can.Message(timestamp=index / 100, arbitration_id=256, is_extended_id=False, data=data)
            )
    damaged = bytearray(path.read_bytes())
    damaged[len(damaged) // 2 : len(damaged) // 2 + 64] = bytes(64)
    path.write_bytes(damaged)
    rows, told = run(path, mappings=ONE, status=1)
    assert len(rows) > 100
    assert "drive.blf: error B002 The log is damaged: " in told
    assert "What follows was not read." in told


@pytest.mark.parametrize("line", ["(0.1) can0", "nonsense of four words", "(x) can0 100#00", "(0.1) can0 100#XY"])
def test_words_of_libraries_are_no_help(run, line):
    told = run(f"(0.0) can0 100#64000000\n{line}\n", mappings=ONE)[1]
    assert "drive.log:2:1: warning B002 The line is not a frame: it must be like `(0.100000) can0 1A0#0102`." in told
    assert "unpack" not in told


def test_a_database_that_is_none_says_where_in_its_own_words(run):
    told = run("(0.0) can0 100#64000000\n", dbc=DBC + "nonsense here\n", status=1)[1]
    assert "bus.dbc:6: error B001 The file must be a CAN database: nothing begins like 'nonsense" in told.replace(
        ":7", ":6"
    )
    assert ">>!<<" not in told


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("drive.blf", b"no log at all", "error B002 The file must be a BLF log: it does not begin as one."),
        ("drive.blf", b"", "error B002 The file must be a BLF log: it is empty."),
        ("drive.blf", b"LOGG\x00", "warning B002 The log ends in the middle: its header is not whole."),
        ("drive.blf", b"LOGG" + bytes(4), "error B002 The log is damaged: its header says that it has 0 bytes."),
        ("drive.log.gz", b"(0.0) can0 100#64", "error B002 The file must be packed with gzip, as its name says, and is not."),
        ("drive.log.gz", gzip.compress(b"(0.0) can0 100#64", mtime=0)[:-4], "warning B002 The log ends in the middle: the packed file"),
        ("drive.log.gz", b"\x1f\x8b" + bytes(20), "error B002 The log is damaged: gzip cannot unpack it."),
    ],
)  # fmt: skip
def test_a_file_that_is_no_log_of_its_form_is_called_so(run, tmp_path, name, content, said):
    (tmp_path / name).write_bytes(content)
    told = run(tmp_path / name, mappings=ONE, status=1)[1]
    assert f"{name}: {said}" in told
    assert told.count(": error B00") == 1


@pytest.mark.parametrize(
    ("text", "said"),
    [("", "and it is empty."), ("\n \n", "and it is empty."), ('VERSION ""\n', "must have messages, and has none.")],
)
def test_a_database_without_anything_is_called_so(run, text, said):
    told = run("(0.0) can0 100#64000000\n", dbc=text, status=1)[1]
    assert said in told
    assert "M101" not in told


@pytest.mark.parametrize("mapping", ["null", "{}", "{message: Motion}", "5"])
def test_a_mapping_that_is_none_is_told_at_its_line(run, mapping):
    told = run("(0.0) can0 100#64000000\n", mappings=f"Vehicle.Speed:\n  dbc2vss: {mapping}\n", status=1)[1]
    assert "can.vspec:2:12: error M00" in told


def test_a_factor_of_0_is_an_error_at_its_line(run):
    told = run("(1.0) can0 100#64000000\n", mappings=ONE, dbc=DBC.replace("(1,0)", "(0,0)"), status=1)[1]
    assert (
        "bus.dbc:5: error B001 The factor of Motion.Mass must not be 0. Write the factor of one step, such as 1."
        in told
    )


def test_where_no_value_is_left_the_reason_is_told_and_not_another_bus(run):
    told = run("(1.0) can0 100#64000000\n", mappings=ONE, dbc=DBC.replace("(0.01,0)", "(1000,0)"), status=1)[1]
    reason = "Most often, values of Vehicle.Speed are outside of the limits that the database states (1)."
    assert f"no trace is written. {reason} Check limits and factors of the database, and the mappings." in told


def test_a_mapping_under_both_of_its_names_is_an_error(run):
    both = "Vehicle.Speed: {type: sensor, datatype: float, dbc: {signal: Speed}, dbc2vss: {signal: Speed}}\n"
    told = run("(1.0) can0 100#64000000\n", mappings=both, status=1)[1]
    assert "error M010 `dbc` and `dbc2vss` cannot be used together. Remove `dbc`." in told


def test_signals_that_share_bits_are_told(run):
    overlapping = DBC.replace("Mass : 16|16", "Mass : 8|16")
    told = run("(1.0) can0 100#64000000\n", mappings=ONE, dbc=overlapping)[1]
    assert "bus.dbc: warning B010 The signals Mass and Speed are overlapping in message Motion. Correct" in told


def test_a_form_without_a_report_is_a_mistake(run):
    told = run("(1.0) can0 100#64000000\n", "--format", "sarif", status=2)[1]
    assert "--format is for --report: name its file" in told
