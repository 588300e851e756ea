"""Numbers, dates, units and paths as readers expect to see them."""

import pytest
from markupsafe import Markup

from sigcat.web.template_filters import breakable, count, datatype, date, marked, number, scalar, unit, with_code


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (-20, "−20"), (999, "999"), (1673, "1,673"), (-1234567, "−1,234,567"), (0.1 + 0.2, "0.3"),
        (20.94, "20.94"), (True, "True"), ("-1", "-1"), (1e300, "1e+300"),
    ],
)  # fmt: skip
def test_numbers_have_a_real_minus_and_commas_between_thousands(value: object, shown: str) -> None:
    assert number(value) == shown


@pytest.mark.parametrize(("value", "shown"), [(2026, "2026"), (-9999, "−9999"), (65535, "65,535"), ("text", "text")])
def test_four_digits_of_a_value_stay_together_as_they_may_be_a_year(value: object, shown: str) -> None:
    assert scalar(value) == shown


def test_a_count_stays_with_its_noun() -> None:
    assert [count(1, "node"), count(2, "branch", "branches"), count(1673, "node")] == [
        "1\u00a0node",
        "2\u00a0branches",
        "1,673\u00a0nodes",
    ]


@pytest.mark.parametrize(
    ("key", "shown"), [("m/s^2", "m/s²"), ("cm^3", "cm³"), ("s^-1", "s⁻¹"), ("km/h", "km/h"), ("kg^10m", "kg¹⁰m")]
)
def test_exponents_of_units_are_raised(key: str, shown: str) -> None:
    assert unit(key) == shown


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("12.09.2025", "12\u00a0September\u00a02025"), ("2025-03-01", "1\u00a0March\u00a02025"), ("31.02.2025", "31.02.2025"),
        ("soon", "soon"), ("", ""),
    ],
)  # fmt: skip
def test_dates_are_written_in_words(text: str, shown: str) -> None:
    assert date(text) == shown


def test_a_path_may_break_behind_its_dots_and_is_copied_as_it_is() -> None:
    shown = breakable(marked("Vehicle.<b>.Speed", ["speed"]))
    assert shown == Markup("Vehicle.&lt;b&gt;.<wbr><mark>Speed</mark>")
    assert breakable("a/b.vspec", "/") == "a/<wbr>b.vspec"


def test_what_stands_between_backticks_is_code_and_never_markup() -> None:
    assert with_code("Add `<b>`.") == "Add <code>&lt;b&gt;</code>."
    assert with_code("one ` only") == "one ` only"


@pytest.mark.parametrize(
    ("values", "shown"),
    [
        ({"datatype": "float[]", "arraysize": 4}, "float[4]"), ({"datatype": "float[]"}, "float[]"),
        ({"datatype": "uint8", "arraysize": 4}, "uint8"), ({}, ""),
    ],
)  # fmt: skip
def test_an_array_is_shown_with_its_size(values: dict[str, object], shown: str) -> None:
    assert datatype(values) == shown
