"""The record of a rule is the one home of its code and severity; the code of sigcat names rules and nothing else."""

import ast
import re
from pathlib import Path

import pytest

from scripts.codes import codes_module
from sigcat.data import INTERFACE_RULES
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.record_faults import MAKERS

APP = Path(__file__).parents[2] / "app" / "sigcat"
TARGET = APP / "codes.py"
"""tests/test_generated.py compares it with the records."""
CODE = re.compile(r"[A-Z][0-9]{3}")
FILES = [file for file in sorted(APP.rglob("*.py")) if file != TARGET]
RULES = compiled_rules(INTERFACE_RULES)


def test_two_rules_of_one_name_are_refused():
    made_by_code = [rule for rule in RULES if rule.check == "function"]
    with pytest.raises(ValueError, match=made_by_code[0].name):
        codes_module((*RULES, made_by_code[0]))


CHALLENGE_METHOD = "S256"
"""How OAuth 2.0 names a hash (RFC 7636)."""


def test_no_other_file_has_a_code_in_it():
    """But for examples in the API's document, which are data."""
    assert len(FILES) > 200
    having_one = [file for file in FILES if CODE.search(file.read_text(encoding="utf-8"))]
    assert having_one
    found = {f"{file.relative_to(APP)}: {code}" for file in having_one for code in literal_codes(file)}
    assert found == set()


def test_every_code_is_reported_somewhere():
    text = "\n".join(file.read_text(encoding="utf-8") for file in FILES)
    constants = re.findall(r"^([A-Z0-9_]+) = RuleCode", TARGET.read_text(encoding="utf-8"), re.MULTILINE)
    assert len(constants) > 100
    assert [name for name in constants if f"codes.{name}" not in text] == []


def literal_codes(file):
    tree = ast.parse(file.read_text(encoding="utf-8"))
    examples = {
        id(item)
        for node in ast.walk(tree)
        if isinstance(node, ast.keyword) and node.arg == "examples"
        for item in ast.walk(node)
    }
    return [
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in examples
        if CODE.fullmatch(node.value) and node.value != CHALLENGE_METHOD
    ]


def test_the_readme_of_the_rules_has_every_maker_and_every_range_of_codes():
    text = (INTERFACE_RULES / "README.md").read_text(encoding="utf-8")
    ranges = {f"{rule.id[:2]}xx" for rule in RULES}
    assert {each for each in MAKERS if f"\n| `{each}` |" not in text} == set()
    assert {each for each in ranges if not re.search(rf"\n\|[^|]*\b{each}\b", text)} == set()
