"""Recordings of players have the format of the simulation: the same bits, the same text."""

import pytest

from sigcat.adapter.host.shapes import Array, Number, Record
from sigcat.comparison.running.recorded import read_recorded
from sigcat.errors import UsageError

FLOAT, DOUBLE, MODE = Number("float", ()), Number("double", ()), Number("uint8", (("OFF", 0), ("ACTIVE", 2)))


@pytest.mark.parametrize(
    ("text", "shape", "expected"),
    [
        ("0.400019497", FLOAT, "0.4000195"),
        ("-0", FLOAT, "-0.0"),
        ("0.10000000000000001", DOUBLE, "0.1"),
        ("NaN", FLOAT, "nan"),
        ("-Infinity", DOUBLE, "-inf"),
        ("1", Number("boolean", ()), "true"),
        ("ACTIVE", MODE, "ACTIVE"),
        ("2", MODE, "ACTIVE"),
        ("7", MODE, "7"),
        ("[1,0.400019497]", Array(FLOAT, 2), "[1.0,0.4000195]"),
        ('{"a": 1, "b": 2}', Record((("a", DOUBLE), ("b", MODE))), '{"a":1.0,"b":"ACTIVE"}'),
        ("what is this", DOUBLE, "what is this"),
    ],
)
def test_a_text_is_that_of_the_simulation(tmp_path, text, shape, expected):
    file = tmp_path / "recorded.csv"
    quoted = text.replace('"', '""')
    file.write_text(f'time,name,value\n5000,X,"{quoted}"\n')
    assert read_recorded(file, {"X": shape}) == {"X": ((5000, expected),)}


def test_values_of_a_name_stay_in_order_also_those_of_one_time(tmp_path):
    file = tmp_path / "recorded.csv"
    file.write_text('time,name,value\n1,X,"2"\n1,X,"1"\n1,Y,"3"\n2,X,"1"\n')
    assert read_recorded(file, {"X": DOUBLE})["X"] == ((1, "2.0"), (1, "1.0"), (2, "1.0"))


def test_a_row_that_was_cut_off_is_left_out(tmp_path):
    file = tmp_path / "recorded.csv"
    file.write_text('time,name,value\n1,X,"2"\n1,X')
    assert read_recorded(file, {"X": DOUBLE}) == {"X": ((1, "2.0"),)}


def test_nothing_was_recorded_where_there_is_no_file(tmp_path):
    assert read_recorded(tmp_path / "none.csv", {}) == {}


def test_a_damaged_row_before_others_is_an_error_at_its_line(tmp_path):
    file = tmp_path / "recorded.csv"
    file.write_text('time,name,value\n1,X,"2"\n1,X\n2,X,"1"\n')
    with pytest.raises(UsageError, match=r"recorded\.csv:3: the row must have time, name, value"):
        read_recorded(file, {"X": DOUBLE})
