"""Function JSON is accepted wherever its declaration was: it carries what the declaration defines."""

import json
from pathlib import Path

import jsonschema
import pytest

from sigcat.data import INTERFACE_RULES
from sigcat.file_kind import is_json
from sigcat.findings import Finding
from sigcat.function.function_file import check_function, checked_file
from sigcat.function.function_json.model import to_json
from sigcat.rules.record import load_rule_files
from tests.function.shipped import FUNCTIONS, interfaces
from tests.published.schemas import schema

RULES = load_rule_files([INTERFACE_RULES / "function.yaml"], trusted=True)
EXAMPLES = dict.fromkeys(
    text.encode()
    for rule in RULES
    for example in (*rule.good, *rule.bad)
    for text in ([example] if isinstance(example, str) else example["files"].values())
    if not is_json(text.encode(), "function")
)
FILES = (*FUNCTIONS, *sorted(Path(__file__).parent.glob("*.function.yaml")))


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}-{path.name}")
def test_what_sigcat_writes_has_nothing_to_be_said_about(path):
    made = checked_file(path.read_bytes(), path.name, interfaces()).sound_function
    assert made is not None
    assert check_function(to_json(made), "function.json", interfaces()) == ()


def errors(findings: tuple[Finding, ...]) -> set[str]:
    return {finding.rule for finding in findings if finding.severity == "error"}


def test_the_function_json_of_every_declaration_in_the_rules_has_no_error_that_the_declaration_has_not():
    """Most examples are a part of a function: undeclared errors are reported for both."""
    published = jsonschema.Draft202012Validator(schema("function_json"))
    count = 0
    for text in EXAMPLES:
        checked = checked_file(text, "function.yaml", interfaces())
        if checked.function is None or checked.is_incomplete:
            continue
        count += 1
        made = to_json(checked.function)
        assert errors(check_function(made, "function.json", interfaces())) <= errors(checked.findings), text.decode()
        published.validate(json.loads(made))
    assert count > len(RULES) // 2
