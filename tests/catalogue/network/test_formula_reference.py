"""Random formulas have the values that py-expression-eval gives them, whole numbers and truth values too."""

import math
import random
import re
from pathlib import Path
from typing import Any

import pytest
from py_expression_eval import Parser

from sigcat.catalogue.network.formula import (
    _BINARY,
    _CONSTANTS,
    _FUNCTIONS,
    BadFormula,
    Formula,
    read_formula,
)

NUMBERS = ("0", "1", "2", "3", "7", "10", "100", "0.5", ".25", "3.6", "1e3", "2.5E-2", "PI", "E", "65535")
BINARY = ("+", "-", "*", "/", "%", "==", "!=", "<", ">", "<=", ">=", " and ", " or ", " xor ", "∙", "•")
ONE = ("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "abs", "ceil", "floor", "round", "exp", "sind", "cosd", "tand",
       "asind", "acosd", "atand", "log", "not")  # fmt: skip
TWO = ("min", "max", "pow", "atan2", "pyt", "log")
EXPONENTS = ("2", "3", "0.5", "x", "(-1)", "sqrt(4)", "min(x,2)", "-1")
XS = (0, 1, -1, 2, 5, 255, 0.0, 0.1, -2.5, 3.75, 1e6, True, False)
SMALL = tuple(x for x in XS if abs(x) < 10)
WIDE = (2**63 - 1, 2**64 - 1, -(2**63), 2**53 + 1, 1e300, -1e-300)
"""Numbers without powers: the reference computes them without a bound."""


def formula(chance: random.Random, depth: int) -> str:
    def part() -> str:
        return formula(chance, depth - 1)

    space = chance.choice(["", " "])
    forms = [
        lambda: f"{part()}{space}{chance.choice(BINARY)}{space}{part()}",
        lambda: f"{part()} {chance.choice(['^', '**'])} {chance.choice(EXPONENTS)}",
        lambda: f"{chance.choice(['-', '+', 'not ', '- '])}{part()}",
        lambda: f"({part()})",
        lambda: f"{chance.choice(ONE)}({part()})",
        lambda: f"{chance.choice(TWO)}({part()}, {part()})",
        lambda: f"if({part()},{part()},{part()})",
    ]
    if not depth or chance.random() < 0.3:
        return chance.choice(["x", chance.choice(NUMBERS)])
    return chance.choices(forms, [30, 6, 8, 10, 8, 6, 2])[0]()


def reference(text: str, x: float) -> Any:
    """The value of py-expression-eval; None if it has none."""
    try:
        found = Parser().parse(text).evaluate({"x": x})
        float(found)
    except Exception:  # noqa: BLE001 — it raises what it meets
        return None
    return found


def is_same(one: Any, other: Any) -> bool:
    if isinstance(one, float) and isinstance(other, float) and math.isnan(one):
        return math.isnan(other)
    return type(one) is type(other) and one == other and repr(one) == repr(other)


def read(text: str) -> Formula | str:
    """The formula, or why it is refused."""
    try:
        return read_formula(text)
    except BadFormula as refused:
        return str(refused)


def check(count: int, seed: int) -> None:
    chance = random.Random(seed)
    accepted = 0
    for _ in range(count):
        text = formula(chance, 4)
        xs = chance.sample(SMALL if "^" in text or "**" in text else XS + WIDE, 3)
        found = read(text)
        if isinstance(found, str):
            assert "py-expression-eval cannot read" in found or all(reference(text, x) is None for x in xs), (
                text,
                found,
            )
            continue
        accepted += 1
        for x in xs:
            assert is_same(found.value(x), reference(text, x)), (text, x, found.value(x), reference(text, x))
    assert accepted > count // 2


def test_random_formulas_have_the_values_of_the_reference():
    check(1_500, seed=1)


def test_very_many_random_formulas_have_the_values_of_the_reference():
    check(27_000, seed=27)


@pytest.mark.parametrize(
    "text", ["2*-x", "x/-2", "x^-1", "--x", "- -x", "not not x", "-not x", "x == not x", "2^log(x)", "x**min(x,2)",
             "x and(x)", "x or(x)", "true", "min(3, 2*-x)"],
)  # fmt: skip
def test_what_the_reference_cannot_read_is_refused(text):
    with pytest.raises(BadFormula):
        read_formula(text)


@pytest.mark.parametrize(
    "text", ["2+-x", "2--x", "2*+x", "x == -1", "-sin(x)", "2^sin(x)", "not(x)", "x and not x", "2*min(x,3)"]
)
def test_what_looks_like_it_is_not(text):
    assert is_same(read_formula(text).value(5), reference(text, 5))


def test_a_power_is_bounded():
    assert read_formula("9^9^9^9^9").value(0) is None
    assert read_formula("(2^64)^100 > 3").value(0) is True


PAGE = (Path(__file__).parents[3] / "docs/reference/formulas.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"\| `([^`]+)` \| (\S+) \|$", PAGE, re.MULTILINE)


@pytest.mark.parametrize(("text", "value"), EXAMPLES)
def test_the_examples_of_the_page_are_true(text, value):
    assert repr(read_formula(text).value(0)) == repr(reference(text, 0)) == value


def test_the_page_has_every_operator_and_function():
    named = {each.partition("(")[0] for each in re.findall(r"`([^`\n]+)`", PAGE)}
    assert set(_BINARY) | set(_FUNCTIONS) | set(_CONSTANTS) <= named
    precedences = dict(re.findall(r"^\| `([^` ]+)`[^|]*\| (\d) \|", PAGE, re.MULTILINE))
    assert {
        name: str(_BINARY[name][0]) for name in precedences if name in _BINARY and name != "-"
    }.items() <= precedences.items()
