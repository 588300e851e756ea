"""A trace is read exactly: every value, or where and why it is none."""

import csv
import io

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat import limits
from sigcat.adapter.host.shapes import SECONDS, Array, Number, Record
from sigcat.errors import InputRefused
from sigcat.runs.recording import trace_file
from sigcat.runs.recording.trace_file import Known, moments, open_trace

KNOWN = Known(
    {
        "Vehicle.Speed": Number("float"),
        "Vehicle.Count": Number("uint8"),
        "Vehicle.IsOn": Number("boolean"),
        "Vehicle.Levels": Array(Number("double"), 2),
        "Vehicle.Point": Record((("X", Number("float")), ("Kind", Number("uint8", (("CAR", 0), ("TRUCK", 1)))))),
        "Demo_Mode_In": Number("uint8", (("OFF", 0), ("ON", 1))),
        "Demo_Step": SECONDS,
    },
    ("Vehicle.Mass",),
)


@pytest.fixture
def read(tmp_path):
    """The moments of a trace, and its findings."""

    def reading(data):
        file = tmp_path / "trace.csv"
        file.write_bytes(data.encode() if isinstance(data, str) else data)
        found = []
        try:
            trace = open_trace(file, KNOWN)
            findings = trace.findings
            for moment in moments(trace):
                found.append(moment)
        except InputRefused as refused:
            findings = refused.findings
        return found, [finding.line_of_text.removeprefix(f"{file}:") for finding in findings]

    return reading


def values(read, header, *rows):
    found, findings = read("\n".join([f"time,{header}", *rows]))
    assert findings == []
    return [(moment.time, *(value for _, value in moment.values)) for moment in found]


def test_an_empty_cell_is_no_new_value(read):
    rows = values(read, "Vehicle.Speed,Vehicle.Count", "0.1,1.5,", "0.2,,7", "0.3,,")
    assert rows == [(100_000_000, 1.5), (200_000_000, 7), (300_000_000,)]


def test_times_are_taken_to_the_nanosecond(read):
    texts = ["0", "0.000000001", "0.0000000014", "1e-8", "1700000000.123456789"]
    assert values(read, "Vehicle.Speed", *(f"{text}," for text in texts)) == [
        (0,), (1,), (1,), (10,), (1700000000123456789,),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("column", "cell", "value"),
    [
        ("Vehicle.Count", " 3.0 ", 3),
        ("Vehicle.IsOn", "TRUE", True),
        ("Vehicle.IsOn", "0.0", False),
        ("Vehicle.Levels", '"[1, 2.5]"', [1.0, 2.5]),
        ("Vehicle.Point", '"{""X"": 1, ""Kind"": ""TRUCK""}"', {"X": 1.0, "Kind": 1}),
        ("Demo_Mode_In", "ON", 1),
        ("Demo_Mode_In", "9", 9),
        ("Demo_Step", "0.0025", 2_500_000),
    ],
)
def test_a_cell_holds_a_value_of_its_column(read, column, cell, value):
    assert values(read, column, f"0,{cell}") == [(0, value)]


@pytest.mark.parametrize(
    "data",
    [
        b"\xef\xbb\xbftime,Vehicle.Speed\r\n0,1\r\n1,2\r\n",
        b"time,Vehicle.Speed\n\n0,1\n\n1,2",
        b'"time","Vehicle.Speed"\n"0","1"\n"1","2"\n',
        b"time,call,Vehicle.Speed\n0,Demo_Step,1\n1,,2\n",
    ],
)
def test_spreadsheets_write_it_in_several_ways(read, data):
    found, findings = read(data)
    assert [moment[:2] for moment in found] == [(0, (("Vehicle.Speed", 1.0),)), (10**9, (("Vehicle.Speed", 2.0),))]
    assert findings == []


def test_the_call_of_a_row_is_told_where_there_is_a_column_for_it(read):
    found, _ = read("time,call,Vehicle.Speed\n0,Demo_Step,1\n1,,2\n")
    assert [moment.call for moment in found] == ["Demo_Step", ""]
    (moment,), _ = read("time,Vehicle.Speed\n0,1\n")
    assert moment.call == ""


HEADERS = {
    "": "1:1: error T001 The trace has no header. Give the time of each row in seconds.",
    "Vehicle.Speed,time": "1:1: error T001 The first column must be `time`, not 'Vehicle.Speed'. Give the time of each row in seconds.",
    "time;Vehicle.Speed": "1:1: error T001 The first column must be `time`, not 'time;Vehicle.Speed'. Separate cells by commas.",
    "time,Vehicle.Sped": "1:6: error T002 The column 'Vehicle.Sped' is neither a signal of the catalogue nor an interface of the functions. Did you mean 'Vehicle.Speed'?",
    "time,,Vehicle.Speed": "1:6: error T002 The column '' is neither a signal of the catalogue nor an interface of the functions. Remove it.",
    "time,Vehicle.Speed, Vehicle.Speed": "1:20: error T001 The column 'Vehicle.Speed' must be in the header only once. Remove one of them.",
    "time,Vehicle.Mass": "1:6: info T003 Vehicle.Mass is left out: the functions do not receive it, or one of them provides it.",
}


@pytest.mark.parametrize(("header", "expected"), HEADERS.items())
def test_each_column_is_known(read, header, expected):
    assert read(f"{header}\n") == ([], [expected])


ROWS = {
    "0": "2:1: error T001 The row must have 8 cells, as the header has, not 1. Leave a cell empty that has no value. Write decimals with a point.",
    "-1,,,,,,,": "2:1: error T004 The time must be in seconds, from 0 to 9,223,372,036, not '-1'. Write a number alone, such as 0.5.",
    ",,,,,,,": "2:1: error T004 The time must be in seconds, from 0 to 9,223,372,036, not ''. Write a number alone, such as 0.5.",
    "nan,,,,,,,": "2:1: error T004 The time must be in seconds, from 0 to 9,223,372,036, not 'nan'. Write a number alone, such as 0.5.",
    "1e99999999999,,,,,,,": "2:1: error T004 The time must be in seconds, from 0 to 9,223,372,036, not '1e99999999999'. Write a number alone, such as 0.5.",
    "1_0,,,,,,,": "2:1: error T004 The time must be in seconds, from 0 to 9,223,372,036, not '1_0'. Write a number alone, such as 0.5.",
    "0,fast,,,,,,": "2:3: error T005 Vehicle.Speed must be a number, not 'fast'.",
    "0,1e39,,,,,,": "2:3: error T005 Vehicle.Speed must fit a float, not '1e39'.",
    "0,1e999,,,,,,": "2:3: error T005 Vehicle.Speed must fit a float, not '1e999'.",
    "0,１,,,,,,": "2:3: error T005 Vehicle.Speed must be a number, not '１'.",
    "0,,256,,,,,": "2:4: error T005 Vehicle.Count must be a whole number from 0 to 255, not '256'.",
    "0,,1.5,,,,,": "2:4: error T005 Vehicle.Count must be a whole number from 0 to 255, not '1.5'.",
    "0,,,2,,,,": "2:5: error T005 Vehicle.IsOn must be true or false, not '2'.",
    '0,,,,"[1]",,,': "2:6: error T005 Vehicle.Levels must be a list of 2 elements, not one of 1.",
    '0,,,,"[1, ""2""]",,,': "2:6: error T005 Vehicle.Levels must have a valid element 1: it must be a number, not '\"2\"'.",
    "0,,,,[1,,,": "2:6: error T005 Vehicle.Levels must be a JSON list, not '[1'.",
    '0,,,,,"{""X"": 1}",,': "2:7: error T005 Vehicle.Point must be a mapping with X, Kind, not '{\"X\": 1}'.",
    '0,,,,,"{""X"": 1, ""Kind"": ""C""}",,': "2:7: error T005 Vehicle.Point must have a valid Kind: it must be CAR or TRUCK, not 'C'.",
    '0,,,,,"{""X"": 1, ""Kind"": ""A"", ""X"": 2}",,': "2:7: error T005 Vehicle.Point must have each member once, and 'X' is given twice.",
    '0,,,,"[1, 2]",,ONN,': "2:16: error T005 Demo_Mode_In must be OFF or ON, not 'ONN'. Did you mean 'ON'?",
    "0,,,,,,,-1": "2:9: error T005 Demo_Step must be a time in seconds, from 0 to 9,223,372,036, not '-1'.",
    '0,,,,"[1, 2],,,': "2:6: error T001 A cell that begins with a quote must end with one, in the same row; a quote within is doubled. Remove the quote, or close it.",
    '0,1"2,,,,,,': "2:3: error T001 A cell that begins with a quote must end with one, in the same row; a quote within is doubled. Remove the quote, or close it.",
}


@pytest.mark.parametrize(("row", "expected"), ROWS.items())
def test_what_is_wrong_with_a_row_is_told_where_it_stands(read, row, expected):
    _, findings = read(f"{','.join(['time', *KNOWN.received])}\n{row}\n")
    assert findings == [expected]


def test_times_do_not_go_back(read):
    found, findings = read("time,Vehicle.Speed\n0.2,1\n0.1,2\n0.2,3\n")
    assert [moment.time for moment in found] == [200_000_000, 200_000_000]
    assert findings == [
        "3:1: error T004 The time must be at least 0.2, that of the row above, not '0.1'. Sort the rows by time."
    ]


def test_what_is_no_utf_8_is_told(read):
    assert read(b"time,Vehicle.Speed\n0,\xff\n")[1] == ["2:3: error T001 The file must be in UTF-8."]


def test_findings_of_all_rows_are_told_up_to_a_limit(read):
    rows = "\n".join(f"{number},x" for number in range(1000))
    assert len(read(f"time,Vehicle.Speed\n{rows}\n")[1]) == limits.TRACE_FINDINGS


def test_a_row_of_any_length_is_not_read_whole(read, monkeypatch):
    monkeypatch.setattr(trace_file, "TRACE_ROW_BYTES", 2**20)
    found, findings = read("time,Vehicle.Speed\n0," + "1" * 2**22 + "\n1,2\n")
    assert (found, findings) == ([], ["2:1: error T001 A row must be shorter than 1 MiB."])


@pytest.mark.parametrize("cell", ["[" * 100_000, "9" * 100_000, "[1," + "9" * 100_000 + "]", '{"X":' * 50_000])
@pytest.mark.parametrize("column", sorted(KNOWN.received))
def test_a_hostile_cell_is_a_finding(read, column, cell):
    quoted = cell.replace('"', '""')
    _, (finding,) = read(f'time,{column}\n0,"{quoted}"\n')
    assert finding.startswith(f"2:3: error T005 {column} must")
    assert len(finding) < 300


@given(st.lists(st.text(st.characters(exclude_characters="\r\n\0", codec="utf-8")), min_size=1, max_size=4))
def test_cells_are_taken_apart_as_a_reader_of_csv_does(cells):
    output = io.StringIO()
    csv.writer(output, lineterminator="\n").writerow(["", *cells])
    row = trace_file._row(output.getvalue().encode(), 1, "")
    assert isinstance(row, trace_file._Row)
    assert list(row.cells) == ["", *cells]
