"""Logs in python-can's other forms: its own CSV and SQLite, PCAN's TRC, and MDF 4."""

import sqlite3
from importlib.util import find_spec

import can
import pytest

from tests.gateway.logs import message, motion

mdf = pytest.mark.skipif(not find_spec("asammdf"), reason="logs in MDF: `pip install asammdf`")
FORMS = ["drive.csv", "drive.db", "drive.trc", "drive.csv.gz", "drive.trc.gz", pytest.param("drive.mf4", marks=mdf)]


@pytest.mark.parametrize("name", FORMS)
def test_every_form_of_log_gives_the_same_trace(run, log, name):
    messages = [message(1436509052 + index / 100, motion(index * 100, index % 2, index / 10)) for index in range(20)]
    rows, told = run(log(messages, name), "--from-zero")
    assert rows[:2] == ["0.000000000,0.0,,0,0.0", "0.010000000,0.1,,1,1.0"]
    assert len(rows) == 20
    assert "20 frames in 0.190 s: 20 decoded" in told


@pytest.mark.parametrize(
    ("name", "wrong", "why"),
    [
        ("drive.csv", "1.5,0x100,0,0,0,8", "it must be like `0.1,0x1a0,0,0,0,2,AQI=`"),
        ("drive.trc", "      9     500.000 DT  1     0100 Rx -  8    64 00 01", "it has 3 of 8 bytes"),
        ("drive.trc", "      9     500.000 DT  1     0100", "it must be like `1 100.000 DT 1 01A0 Rx - 2 01 02`"),
    ],
)
def test_a_line_that_is_no_frame_is_reported_and_the_others_are_read(run, log, name, wrong, why):
    path = log([message(1, motion(100)), message(1.01, motion(200))], name)
    lines = path.read_text().splitlines()
    path.write_text("\n".join([*lines[:-1], wrong, lines[-1]]) + "\n")
    rows, told = run(path, "--from-zero")
    assert [row.split(",")[-1] for row in rows] == ["1.0", "2.0"]
    assert f"{name}:{len(lines)}:1: warning B002 The line is not a frame: {why}" in told


def test_half_a_byte_of_a_trc_is_no_byte(run, tmp_path):
    path = tmp_path / "drive.trc"
    line = "{}) {:.1f} Rx 0100 8 64 00 {} 00 00 00 00 00\n"
    path.write_text(f";$FILEVERSION=1.1\n;$STARTTIME=40000\n;\n{line.format(1, 5, '01')}{line.format(2, 6, '1')}")
    rows, told = run(path, "--from-zero")
    assert len(rows) == 1
    assert "drive.trc:5:1: warning B002 The line is not a frame: its data has half a byte." in told


@pytest.mark.parametrize(
    ("name", "said"), [("drive.db", "file is not a database"), pytest.param("drive.mf4", "", marks=mdf)]
)
def test_a_file_that_is_something_else_is_called_so(run, tmp_path, name, said):
    (tmp_path / name).write_bytes(b"no log at all, but some bytes" * 50)
    _, told = run(tmp_path / name, status=1)
    assert f"{name}: error B002 The file must be a {name[6:].upper()} log: {said}" in told


def test_rows_of_another_table_are_no_frames(run, tmp_path):
    with sqlite3.connect(tmp_path / "drive.db") as database:
        database.execute("CREATE TABLE messages (a, b)")
        database.execute("INSERT INTO messages VALUES (1, 2)")
    database.close()
    _, told = run(tmp_path / "drive.db", status=1)
    assert "drive.db: error B002 The log is damaged: frame 1 cannot be read" in told


def test_a_trace_is_no_log_in_csv(run, tmp_path):
    (tmp_path / "drive.csv").write_text("time,Vehicle.Speed\n0,1\n")
    _, told = run(tmp_path / "drive.csv", status=2)
    assert "a trace goes to CAN: name a bus or a log with --send" in told


def test_an_error_frame_is_counted(run, log):
    path = log([message(1, motion(100)), can.Message(timestamp=2, is_error_frame=True)], "drive.csv")
    assert "1 decoded, 1 error" in run(path)[1]
