"""Errors in a log are reported, and the valid part is read."""

import csv
import gc
import gzip
import random
import signal
import struct
import tracemalloc
from functools import lru_cache

import pytest

from sigcat.cli import main
from sigcat.gateway.live import read_bus
from tests.gateway.live_bus import sending
from tests.gateway.logs import DBC, MAPPINGS, PATHS, message, motion

# -- errors in a log ------------------------------------------------------------------------------------------------------


def test_what_is_no_value_is_counted_by_signal(run, log):
    rows, told = run(log([message(0, motion(30000, 7)), message(1, motion(1, 5))]))
    assert rows == ["0.000000000,0.5,,,", "1.000000000,0.5,,,0.01"]
    assert "Vehicle.Powertrain.Transmission.CurrentGear: 2 of 2 values left out, not among the listed values." in told
    assert "Vehicle.Speed: 1 of 2 values left out, outside of the limits that the database states." in told
    assert "6 values of mapped signals: 3 sent, 0 held back by interval or for being unchanged, 3 unfit" in told


def test_error_frames_requests_and_unknown_frames_are_counted(run, tmp_path):
    path = tmp_path / "drive.log"
    path.write_text(
        "(0.000000) can0 100#6400010000000000\n"
        "(0.100000) can0 20000004#0000000000000000\n"
        "(0.200000) can0 20000080#0000000000000000\n"
        "(0.300000) can0 100#R8\n"
        "(0.400000) can0 7FF#00\n"
        "(0.500000) can1 12345678#00\n"
    )  # fmt: skip
    rows, told = run(path)
    assert rows == ["0.000000000,0.0,,1,1.0"]
    assert (
        "6 frames in 0.500 s: 1 decoded, 2 with 2 identifiers that the database does not have, 2 error, 1 remote"
        in told
    )


def test_one_channel_can_be_chosen(run, tmp_path):
    path = tmp_path / "drive.log"
    path.write_text("(0.0) can0 100#6400010000000000\n(0.1) can1 100#C800010000000000\n")
    rows, told = run(path, "--channel", "can1")
    assert rows == ["0.100000000,0.0,,1,2.0"]
    assert "1 of other channels" in told


def test_lines_that_are_no_frames_are_told_and_the_others_are_read(run, tmp_path):
    path = tmp_path / "drive.log"
    path.write_text(
        "(0.0) can0 100#6400010000000000\nnonsense\n(0.1) can0 100#XY\n(0.2) can0 100#C800010000000000\n(0.3) ca"
    )
    rows, told = run(path)
    assert [row.split(",")[0] for row in rows] == ["0.000000000", "0.200000000"]
    assert [line.split(":")[1] for line in told.splitlines() if "B002" in line] == ["2", "3", "5"]


@pytest.mark.parametrize(
    ("name", "line", "why"),
    [
        ("drive.log", "(0.1) can0 101##1CF07" + "00" * 23, "25 bytes are not a valid length of a CAN FD frame"),
        ("drive.log", "(0.1) can0 100#64000100\0\0000000", "it has bytes that are not text"),
        ("drive.asc", "0.1 CANFD 1 Rx 100 1 0 f 64 64 00 01 00", "it has 4 of 64 bytes"),
        ("drive.asc", "0.1 CANFD 1 Rx 100 1 0 8 8 64 00 01 00 00 00 00 0", "it has 7 of 8 bytes"),
        ("drive.asc", "0.1 1 100 Rx d 8 64 00 \0 01 00 00 00 00 00", "it has bytes that are not text"),
    ],
)
def test_a_frame_that_was_cut_or_spoilt_is_told(run, tmp_path, name, line, why):
    path = tmp_path / name
    head = "date Mon Nov 23 10:00:00 2026\nbase hex timestamps absolute\n" if name.endswith("asc") else ""
    path.write_text(f"{head}{line}\n")
    rows, told = run(path, status=1)
    assert rows == []
    assert why in told


def test_of_many_bad_lines_a_hundred_are_told(run, tmp_path):
    path = tmp_path / "drive.log"
    path.write_text("nonsense\n" * 300 + "(0.2) can0 100#C800010000000000\n")
    rows, told = run(path)
    assert len(rows) == 1
    assert told.count("B002") == 101
    assert "200 more lines are not frames" in told


def test_a_line_without_end_is_left_out(run, tmp_path):
    path = tmp_path / "drive.log"
    path.write_text("(0.1) can0 100#" + "00" * 200_000 + "\n(0.2) can0 100#C800010000000000\n")
    rows, told = run(path)
    assert len(rows) == 1
    assert "drive.log:1:1: warning B002 The line is too long to be a frame." in told


@pytest.mark.parametrize("name", ["drive.blf", "drive.log.gz"])
def test_a_log_that_ends_in_the_middle_is_read_to_there(run, log, name):
    chance = random.Random(1)
    whole = log([message(index / 100, motion(index % 20000, 1, chance.random())) for index in range(9000)], name)
    data = whole.read_bytes()
    whole.write_bytes(data[: len(data) // 2])
    rows, told = run(whole)
    assert 1000 < len(rows) < 9000
    assert "warning B002 The log ends in the middle" in told


@pytest.mark.parametrize("data", [b"", b"LOGG", b"x" * 500, b"LOGG" + b"\xff" * 500])
def test_bytes_that_are_no_blf_are_told(run, tmp_path, data):
    path = tmp_path / "drive.blf"
    path.write_bytes(data)
    rows, told = run(path, status=1)
    assert rows == []
    assert told.count(": error B00") == 1


@pytest.mark.parametrize("name", ["drive.log", "drive.asc", "drive.trc", "drive.log.gz"])
@pytest.mark.parametrize(
    ("data", "kind", "fix"),
    [
        (b"\x7fELF\x02\x01\x01\0\0\0" + bytes(range(256)) * 50, "it is not a text.", "Name the file that "),
        (b"PK\x03\x04" + random.Random(1).randbytes(5000), "it is not a text.", "Name the file that "),
        (gzip.compress(b"(0.1) can0 100#00", mtime=0), "it is packed with gzip.", "Name it drive."),
        (b"LOGG" + bytes(140), "it is a BLF log.", "Name it drive."),
        ("(0.1) can0 100#00\n".encode("utf-16"), "it is a text in UTF-16.", "Save it as UTF-8."),
    ],
    ids=["ELF", "ZIP", "gzip", "BLF", "UTF-16"],
)
def test_a_file_that_is_no_text_is_one_finding(run, tmp_path, name, data, kind, fix):
    path = tmp_path / name
    path.write_bytes(gzip.compress(data) if name.endswith(".gz") else data)
    rows, told = run(path, status=1)
    assert rows == []
    assert [line for line in told.splitlines() if " B00" in line] == [
        line for line in told.splitlines() if kind in line
    ]
    assert f"log: {kind} {fix}" in told


def test_a_comment_in_another_encoding_is_text(run, tmp_path):
    path = tmp_path / "drive.asc"
    path.write_bytes("// Fahrer: Jürgen Müller\n0.1 1 100 Rx d 8 64 00 01 00 00 00 00 00\n".encode("latin-1"))
    rows, _ = run(path)
    assert len(rows) == 1


@pytest.mark.parametrize("name", ["drive.log", "drive.asc", "drive.log.gz"])
def test_any_bytes_are_a_log_or_are_told(run, tmp_path, name):
    chance = random.Random(3)
    for _ in range(20):
        path = tmp_path / name
        path.write_bytes(chance.randbytes(chance.randint(0, 2000)))
        rows, _ = run(path, status=1)
        assert rows == []


def test_a_container_that_unpacks_without_end_is_refused(run, log):
    import zlib

    whole = log([message(0, motion(1))], "drive.blf")
    header = whole.read_bytes()[:144]
    packed = zlib.compress(bytes(64 * 1024 * 1024), 9)
    body = struct.pack("<H6xL4x", 2, 64 * 1024 * 1024) + packed
    whole.write_bytes(header + struct.pack("<4sHHLL", b"LOBJ", 16, 1, 16 + len(body), 10) + body)
    _, told = run(whole, status=1)
    assert "a container unpacks to more than" in told


def test_a_short_frame_gives_what_it_holds(run, log):
    rows, told = run(log([message(0, motion(100)[:4])]))
    assert rows == ["0.000000000,,,1,1.0"]
    assert "warning B005 1 frame is shorter than Motion" in told


def test_frames_of_two_channels_may_be_a_little_out_of_order(run, tmp_path):
    path = tmp_path / "drive.log"
    path.write_text("(0.2) can0 100#6400010000000000\n(0.1) can1 100#C800010000000000\n")
    rows, told = run(path)
    assert [row.split(",")[0] for row in rows] == ["0.200000000", "0.200000000"]
    assert "info B003 1 frame has a time before" in told


def test_a_second_drive_in_the_log_is_not_played_after_the_first(run, tmp_path):
    path = tmp_path / "drive.log"
    path.write_text("(100.0) can0 100#6400010000000000\n(1.0) can0 100#C800010000000000\n")
    rows, told = run(path, status=1)
    assert len(rows) == 1
    assert "error B003 Frame 2 is of 1.000000 s, after one of 100.000000 s." in told


def test_asc_with_times_relative_to_the_line_before_is_added_up(run, tmp_path):
    lines = ["date Thu Apr 28 10:44:52.480 am 2022", "base hex  timestamps relative", "no internal events logged"]
    lines += [
        "0.500000 1  100             Rx   d 8 64 00 01 00 00 00 00 00",
        "0.250000 1  100             Rx   d 8 C8 00 01 00 00 00 00 00",
    ]
    path = tmp_path / "drive.asc"
    path.write_text("\n".join(lines) + "\n")
    rows, _ = run(path)
    assert [row.split(",")[0] for row in rows] == ["0.500000000", "0.750000000"]


def test_the_first_frame_of_an_asc_log_without_header_is_read(run, tmp_path):
    path = tmp_path / "drive.asc"
    path.write_text("0.500000 1  100             Rx   d 8 64 00 01 00 00 00 00 00\n")
    rows, _ = run(path)
    assert [row.split(",")[0] for row in rows] == ["0.500000000"]


# -- beside the log ------------------------------------------------------------------------------------------------------


def test_columns_of_another_trace_are_added_by_time(run, log, tmp_path):
    (tmp_path / "more.csv").write_text('time,Vehicle.Speed,Demo_Mode_In\n0.0,99,OFF\n0.005,,ON\n0.5,,"a,b"\n')
    rows, _ = run(log([message(0, motion(100)), message(0.01, motion(200))]), "--add", tmp_path / "more.csv")
    assert rows == [
        "0.000000000,0.5,,1,1.0,OFF",
        "0.005000000,,,,,ON",
        "0.010000000,0.5,,,2.0,",
        "0.500000000,,,,,a,b",
    ]


def test_what_comes_at_one_time_stands_in_one_row_unless_a_column_has_two_values(run, tmp_path):
    path = tmp_path / "drive.log"
    path.write_text("(0.1) can0 100#6400010000000000\n(0.1) can0 80000200#00D20400\n(0.1) can0 100#C800010000000000\n")
    path.write_text(path.read_text().replace("80000200", "00000200"))
    rows, _ = run(path)
    assert rows == ["0.100000000,0.0,1234,1,1.0", "0.100000000,0.0,,,2.0"]


@pytest.mark.parametrize("text", ["", "Vehicle.Speed\n1\n", "time,A\n1,2\n0,3\n", "time,A\nx,2\n", "time,A\n1\n"])
def test_a_trace_that_cannot_be_added_is_a_finding(run, log, tmp_path, text):
    (tmp_path / "more.csv").write_text(text)
    path = log([message(0, motion(100))])
    given = ["gateway", str(path), "--dbc", str(tmp_path / "bus.dbc"), "-s", "vss", "-l", str(tmp_path / "can.vspec")]
    assert main([*given, "--add", str(tmp_path / "more.csv"), "-o", str(tmp_path / "out.csv")]) == 1
    assert not (tmp_path / "out.csv").exists()


def test_what_is_missing_is_asked_for(run, log, tmp_path, capsys):
    path = str(log([message(0, motion(100))]))
    dbc = ["--dbc", str(tmp_path / "bus.dbc")]
    for given, told in (
        ([path], "name the CAN database: --dbc FILE"),
        ([path, *dbc, "-s", "vss"], "The catalogue maps no signal to CAN."),
        (dbc, "name a log, or a bus with --live INTERFACE:CHANNEL"),
        ([*dbc, "--live", "can0"], "--live must be INTERFACE:CHANNEL, such as socketcan:can0, not 'can0'"),
        (
            ["-s", "vss", *dbc, "-l", str(tmp_path / "can.vspec"), "--live", "nonsense:can0"],
            "nonsense:can0 cannot be opened",
        ),
        (
            [str(tmp_path / "bus.dbc"), *dbc, "-l", str(tmp_path / "can.vspec")],
            "must end in .asc, .blf, .csv, .db, .log, .mf4, .trc",
        ),
    ):
        assert main(["gateway", *given]) in {1, 2}
        assert told in capsys.readouterr().err


def test_a_mapping_that_the_linter_refuses_is_refused(run, log, tmp_path, capsys):
    path = str(log([message(0, motion(100))]))
    (tmp_path / "bad.vspec").write_text("Vehicle.Speed: {type: sensor, datatype: float, dbc2vss: {signal: Sped}}\n")
    given = ["gateway", path, "--dbc", str(tmp_path / "bus.dbc"), "-s", "vss", "-l", str(tmp_path / "bad.vspec")]
    assert main(given) == 1
    assert "error M101 The CAN database has no signal 'Sped'. Did you mean 'Speed'?" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["", "hello\n", "BO_ 12", DBC.replace("SG_ Speed", "SG_ Speed M M")])
def test_a_database_that_is_none_is_a_finding(run, log, tmp_path, capsys, text):
    path = str(log([message(0, motion(100))]))
    (tmp_path / "bad.dbc").write_text(text)
    main(["gateway", path, "--dbc", str(tmp_path / "bad.dbc"), "-s", "vss", "-l", str(tmp_path / "can.vspec")])
    told = capsys.readouterr().err
    assert "bad.dbc" in told or "M101" in told
    assert "internal error" not in told


def test_a_bus_is_listened_to(run, tmp_path):
    """One end of a virtual bus receives what the other sends, and the trace is written when the process receives a signal."""
    out = tmp_path / "live.csv"
    given = ["gateway", "--live", "virtual:drive", "--dbc", str(tmp_path / "bus.dbc"), "-s", "vss"]
    with sending("drive", [message(0.05 * n, motion(speed)) for n, speed in enumerate((100, 200, 300))]):
        assert main([*given, "-l", str(tmp_path / "can.vspec"), "-o", str(out)]) == 0
    with out.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["Vehicle.Speed"] for row in rows] == ["1.0", "2.0", "3.0"]
    assert [float(row["time"]) for row in rows] == [0, 0.05, 0.1]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_bus_is_listened_to_for_a_while():
    assert list(read_bus("virtual", "silent", 0.01)) == []


def test_a_log_of_any_size_takes_the_same_memory(tmp_path, monkeypatch):
    """A log that is four times as long takes the same memory."""
    from sigcat.catalogue.hosting.source import load
    from sigcat.catalogue.hosting.sources import source_of_tree
    from sigcat.gateway.logs.read import read_log
    from sigcat.gateway.prepare import prepare
    from sigcat.gateway.trace import lines_of, rows_of
    from sigcat.gateway.translation import Translation
    from sigcat.runs.recording import cells

    monkeypatch.setattr("sigcat.gateway.decoding._KNOWN_VALUES", 256)
    monkeypatch.setattr(cells, "_float_text", lru_cache(256)(cells._float_text.__wrapped__))
    (tmp_path / "bus.dbc").write_text(DBC)
    (tmp_path / "can.vspec").write_text(MAPPINGS)
    source = source_of_tree("vss")
    prepared = prepare(load(source._replace(overlays=(tmp_path / "can.vspec",))), [tmp_path / "bus.dbc"])

    def most_of(frames):
        path = tmp_path / "drive.log.gz"
        with gzip.open(path, "wt") as file:
            file.writelines(
                f"({i / 1000:.6f}) can0 {i % 2 * 256:03X}#{i % 25000:04X}010000{i:06X}\n" for i in range(frames)
            )
        translation = Translation(prepared.database, prepared.mapped)
        gc.collect()
        tracemalloc.start()
        rows = rows_of(translation.moments(read_log(path, []), "drive"))
        count = sum(1 for _ in lines_of(rows, PATHS))
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return count, most

    most_of(9_000)  # what is kept of a run is full
    few, most_of_few = most_of(4_000)
    many, most_of_many = most_of(16_000)
    assert (few, many) == (2_001, 8_001)
    assert most_of_many < 1.5 * most_of_few
