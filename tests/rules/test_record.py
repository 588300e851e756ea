"""Records of rules: what they must have, and what is said of those that cannot be used."""

import pytest

from sigcat.rules.record import parse_rules

RECORD = """\
ACME001:
  name: short-path
  title: Paths are short.
  severity: warning
  why: Long paths do not fit our displays.
  check: path-depth
  options: {most: 3}
  source: ACME
"""
EXAMPLES = "  good: 'A: {}'\n  bad: 'A.B.C.D: {}'\n"


def messages(text: str, *, trusted: bool = False) -> list[str]:
    return [finding.message for finding in parse_rules(text.encode(), "rules.yaml", trusted=trusted).findings]


def test_a_rule_of_a_company_needs_no_examples():
    assert messages(RECORD) == []


@pytest.mark.parametrize(
    ("text", "is_accepted"),
    [
        (RECORD, False),
        (RECORD + "  good: 'A: {}'\n", False),
        (RECORD + EXAMPLES, True),
        (RECORD + "  example: false\n", True),
    ],
)
def test_a_shipped_rule_has_examples_or_says_that_none_is_a_text(text, is_accepted):
    expected = [] if is_accepted else ["Rule ACME001 must have `good` and `bad` examples."]
    assert messages(text, trusted=True) == expected


@pytest.mark.parametrize("key", ["name", "title", "severity", "why", "check", "source"])
def test_every_rule_says_what_it_is(key):
    lines = [line for line in RECORD.splitlines(keepends=True) if not line.startswith(f"  {key}:")]
    assert messages("".join(lines)) == [f"Rule ACME001 must have a text as `{key}`."]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("scope: file", "`scope` must be one of node, tree, not 'file'."),
        ("default: maybe", "`default` must be true or false, not 'maybe'."),
        ("nodes: [sensor]", "`nodes` must be a mapping, not ['sensor']."),
        ("nodes: {types: sensor}", "`types` must be a list of names, not 'sensor'."),
        ("sevirity: error", "Unknown field 'sevirity' of rule ACME001."),
    ],
)
def test_a_field_that_does_not_fit_says_what_it_must_be(line, message):
    assert messages(f"{RECORD}  {line}\n") == [message]


@pytest.mark.parametrize(("line", "scope"), [("", "node"), ("  scope: tree\n", "tree")])
def test_a_rule_may_need_the_whole_tree(line, scope):
    (rule,) = parse_rules((RECORD + line).encode(), "rules.yaml", trusted=False).rules
    assert rule.scope == scope
