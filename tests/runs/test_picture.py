"""A picture shows every value where it belongs, and no more than a picture can."""

import math
import xml.etree.ElementTree as ET

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from sigcat.adapter.host.shapes import Number
from sigcat.runs.recording.picture import HEIGHT, LEFT, WIDTH, picture
from sigcat.runs.recording.samples import Sample
from sigcat.runs.recording.svg_file import svg_text

SECOND = 10**9
MODES = Number("uint8", (("OFF", 0), ("ON", 1), ("FAULT", 5)))


DOUBLE = Number("double")


def drawn(values, shape=DOUBLE):
    return picture(["a"], {"a": shape}, {"a": "m/s^2"}, [Sample(time, "a", value) for time, value in values])


def test_a_value_holds_until_the_next_one():
    (panel,) = drawn([(0, 0.0), (SECOND, 10.0), (2 * SECOND, 10.0)]).panels
    assert panel.path == f"M{LEFT} 129H{LEFT + WIDTH / 2:g}V29H{LEFT + WIDTH}"
    assert panel.title == "a [m/s²]"


def test_nan_and_infinity_leave_a_gap():
    values = [(0, 1.0), (1, math.nan), (2, 3.0), (3, math.inf), (4, 1.0)]
    (panel,) = drawn([(time * SECOND, value) for time, value in values]).panels
    assert panel.path.count("M") == 3
    assert "nan" not in panel.path + str(panel.ticks)


def test_an_enumeration_has_its_symbols_on_its_axis():
    (panel,) = drawn([(0, 0), (SECOND, 5)], MODES).panels
    assert [tick.label for tick in panel.ticks] == ["OFF", "FAULT"]
    (panel,) = drawn([(0, True), (SECOND, False)], Number("boolean")).panels
    assert [tick.label for tick in panel.ticks] == ["false", "true"]


def test_a_peak_is_never_lost():
    values = [(number * 1000, 0.0) for number in range(100_000)]
    values[77_777] = (77_777_000, 9.0)
    (panel,) = drawn(values).panels
    assert len(panel.path) < 40_000
    top = min(float(part.partition("H")[0]) for part in panel.path.split("V")[1:])
    assert top < panel.top + 0.1 * HEIGHT


@example([(2**62, 0.0), (2**62 - 1, 0.0)])
@given(st.lists(st.tuples(st.integers(0, 2**62), st.floats()), max_size=20))
def test_whatever_comes_is_drawn_within_its_panel(values):
    made = drawn(sorted(values, key=lambda each: each[0]))
    (panel,) = made.panels
    assert all(LEFT <= tick.at <= LEFT + WIDTH for tick in made.ticks)
    assert all(panel.top - 1 <= tick.at <= panel.top + HEIGHT + 1 for tick in panel.ticks)
    assert "inf" not in panel.path
    assert "nan" not in panel.path
    ET.fromstring(svg_text(made))


@pytest.mark.parametrize("name", ['<script>"&', "ÄÖ"])
def test_names_are_escaped(name):
    made = picture([name], {name: MODES}, {}, [Sample(0, name, 1)])
    assert name in [element.text for element in ET.fromstring(svg_text(made)).iter()]
