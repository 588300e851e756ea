"""Formulas of mappings mean what py-expression-eval makes of them, and nothing else can be said in them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.catalogue.network.formula import BadFormula, read_formula
from sigcat.limits import FORMULA_CHARACTERS, FORMULA_DEPTH


@pytest.mark.parametrize(
    ("text", "x", "value"),
    [
        ("floor((x*40)-100)", 2, -20),
        ("floor(x+0.5)", 2.5, 3),
        ("(x+100)/40", 20, 3),
        ("x", 7, 7),
        ("2+3*x", 4, 14),
        ("10-3-2", 0, 5),
        ("-x^2", 3, -9),
        ("2^3^2", 0, 64),
        ("2 ** 3", 0, 8),
        ("-7 % 3", 0, -1),
        ("(-7) % 3", 0, 2),
        ("1e3 + .5", 0, 1000.5),
        ("2*(-x)", 3, -6),
        ("min(x, 3, 2)", 5, 2),
        ("if(x > 10, 1, 0)", 11, 1),
        ("x >= 3 and x < 5", 4, 1),
        ("not x", 0, 1),
        ("x == 1 or x == 2", 3, 0),
        ("round(x)", 2.5, 2),
        ("sqrt(x) + abs(-x)", 4, 6),
        ("log(x, 2)", 8, 3),
        ("E * 0 + PI * 0 + 1", 8, 1),
        ("6 xor x", 3, 5),
        ("x * 2 + 1", 2**62 + 1, 2**63 + 3),
    ],
)
def test_a_formula_has_a_value(text, x, value):
    assert read_formula(text).value(x) == value


def test_a_division_comes_before_a_product_as_with_py_expression_eval():
    """3 × (0.1 ÷ 3) has other bits than (3 × 0.1) ÷ 3."""
    assert read_formula("3*x/3").value(0.1) == 3 * (0.1 / 3)
    assert 3 * (0.7 / 3) != 3 * 0.7 / 3 or read_formula("3*x/3").value(0.7) == 3 * (0.7 / 3)


@pytest.mark.parametrize(
    "text", ["1/x", "sqrt(x-1)", "log(x)", "9^9^9^9^9", "x % 0", "floor(1e308*10)", "x xor 1", "(x-8)^0.5"]
)
def test_where_a_formula_has_no_value_there_is_none(text):
    assert read_formula(text).value(0.0) is None


@pytest.mark.parametrize(
    ("text", "why", "at"),
    [
        ("", "a number, x or a function is missing at its end", 0),
        ("x +", "a number, x or a function is missing at its end", 3),
        ("(x", "`)` is missing at its end", 2),
        ("x y", "an operator must be in the place of 'y'", 2),
        ("x)", "an operator must be in the place of ')'", 1),
        ("__import__('os')", '"\'" has no meaning', 11),
        ("y * 2", "'y' is not a function", 0),
        ("flor(x)", "'flor' is not a function", 0),
        ("min(x)", "`min` takes 2 or more values, not 1", 0),
        ("x.real", "'.' has no meaning", 1),
        ("x[0]", "'[' has no meaning", 1),
        ("x; x", "';' has no meaning", 1),
        ("½", "'½' has no meaning", 0),
        ("random(x)", "'random' is not a function", 0),
    ],
)
def test_what_is_no_formula_is_refused_at_its_character(text, why, at):
    with pytest.raises(BadFormula) as refused:
        read_formula(text)
    assert (str(refused.value), refused.value.at) == (why, at)


def test_a_function_that_was_meant_is_proposed():
    with pytest.raises(BadFormula) as refused:
        read_formula("flor(x)")
    assert "floor" in refused.value.fix


@pytest.mark.parametrize("text", ["(" * 5000 + "x", "-" * (FORMULA_DEPTH + 1) + "x", "x" + "+x" * FORMULA_CHARACTERS])
def test_a_formula_is_bounded(text):
    with pytest.raises(BadFormula):
        read_formula(text)


def test_a_long_chain_is_computed():
    terms = FORMULA_CHARACTERS // 2
    assert read_formula("+".join("x" * terms)).value(1.0) == terms


@given(st.text(alphabet="x0123456789.+-*/%^()<>=!, eEPIminaxflor_", max_size=40), st.floats())
def test_any_text_is_a_formula_or_is_refused(text, x):
    try:
        value = read_formula(text).value(x)
    except BadFormula as refused:
        assert 0 <= refused.at <= len(text)  # noqa: PT017
    else:
        assert value is None or isinstance(value, int | float)
