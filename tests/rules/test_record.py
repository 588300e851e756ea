"""Records of rules: what they must have, and what is said of those that cannot be used."""

import pytest

from sigcat.errors import InputRefused
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions
from sigcat.rules.record import parse_rules
from tests.rules.own_rule import OWN_RULE

EXAMPLES = "  good: 'A: {}'\n  bad: 'A.B.C.D: {}'\n"


def messages(text: str, *, trusted: bool = False) -> list[str]:
    return [finding.message for finding in parse_rules(text.encode(), "rules.yaml", trusted=trusted).findings]


def test_a_rule_of_a_company_needs_no_examples():
    assert messages(OWN_RULE) == []


@pytest.mark.parametrize(
    ("text", "is_accepted"),
    [
        (OWN_RULE, False),
        (OWN_RULE + "  good: 'A: {}'\n", False),
        (OWN_RULE + EXAMPLES, True),
        (OWN_RULE + "  example: false\n", True),
    ],
)
def test_a_shipped_rule_has_examples_or_says_that_none_is_a_text(text, is_accepted):
    expected = [] if is_accepted else ["Rule ACME001 must have `good` and `bad` examples."]
    assert messages(text, trusted=True) == expected


@pytest.mark.parametrize("key", ["name", "title", "severity", "why", "check", "source"])
def test_every_rule_says_what_it_is(key):
    lines = [line for line in OWN_RULE.splitlines(keepends=True) if not line.startswith(f"  {key}:")]
    assert messages("".join(lines)) == [f"Rule ACME001 must have a text as `{key}`."]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("scope: file", "`scope` must be one of node, tree, not 'file'."),
        ("default: maybe", "`default` must be true or false, not 'maybe'."),
        ("message: 2020-01-01", "`message` must be a text, not 2020-01-01."),
        ("nodes: [sensor]", "`nodes` must be a mapping, not ['sensor']."),
        ("nodes: {types: sensor}", "`types` must be a list of names, not 'sensor'."),
        ("nodes: {types: [signal]}", "Unknown name 'signal' in `types` of `nodes`."),
        ("nodes: {types: [sensor, brnch]}", "Unknown name 'brnch' in `types` of `nodes`."),
        ("nodes: {datatypes: [uint99]}", "Unknown name 'uint99' in `datatypes` of `nodes`."),
        ("nodes: {interfaces: [errors]}", "Unknown name 'errors' in `interfaces` of `nodes`."),
        ("sevirity: error", "Unknown field 'sevirity' of rule ACME001."),
    ],
)
def test_a_field_that_does_not_fit_says_what_it_must_be(line, message):
    assert messages(f"{OWN_RULE}  {line}\n") == [message]


def test_all_that_is_wrong_with_a_rule_is_told_at_once():
    text = """\
ACME001:
  name: Not_Kebab
  title: A rule.
  severity: fatal
  sevirity: error
  default: maybe
  nodes: {types: [brnch, nsor], datatypes: [uint99], tpyes: [], path: 1}
  check: pattern
  options: {patern: x}
  source: Us.
"""
    file = parse_rules(text.encode(), "rules.yaml", trusted=False)
    assert [(finding.line, finding.message) for finding in file.findings] == [
        (5, "Unknown field 'sevirity' of rule ACME001."),
        (1, "Rule ACME001 must have a text as `why`."),
        (6, "`default` must be true or false, not 'maybe'."),
        (4, "`severity` must be one of error, warning, info, not 'fatal'."),
        (2, "`name` must be in kebab-case, not 'Not_Kebab'."),
        (7, "Unknown field 'tpyes' in `nodes`."),
        (7, "`path` must be a glob such as Vehicle.Body.*, not 1."),
        (7, "Unknown name 'brnch' in `types` of `nodes`."),
        (7, "Unknown name 'nsor' in `types` of `nodes`."),
        (7, "Unknown name 'uint99' in `datatypes` of `nodes`."),
    ]


@pytest.mark.parametrize("way", ["the file is linted", "the configuration names it"])
def test_a_rule_that_lacks_a_field_has_its_options_checked_too(tmp_path, way):
    file = tmp_path / "rules.yaml"
    lines = [line for line in OWN_RULE.splitlines(keepends=True) if not line.startswith(("  why:", "  options:"))]
    file.write_text("".join(lines) + "  options: {nope: 1}\n", encoding="utf-8")
    if way == "the file is linted":
        findings = lint_paths([file]).findings
    else:
        with pytest.raises(InputRefused) as refused:
            lint_paths([tmp_path], LintOptions(rule_files=(file,)))
        findings = refused.value.findings
    told = " ".join(finding.message for finding in findings)
    assert "must have a text as `why`" in told
    assert "Unknown option 'nope'" in told


def test_a_rule_may_be_about_every_kind_of_node_that_there_is():
    nodes = "{types: [signals, branch, struct, property], datatypes: ['uint8[]', Types.Pose], interfaces: [error]}"
    assert messages(f"{OWN_RULE}  nodes: {nodes}\n") == []


@pytest.mark.parametrize(("line", "scope"), [("", "node"), ("  scope: tree\n", "tree")])
def test_a_rule_may_need_the_whole_tree(line, scope):
    (rule,) = parse_rules((OWN_RULE + line).encode(), "rules.yaml", trusted=False).rules
    assert rule.scope == scope
