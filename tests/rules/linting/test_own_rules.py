"""Rules of a company, in a file of its own."""

import pytest

from sigcat.errors import InputRefused
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions
from tests.rules.linting.conftest import CABIN

OWN = """\
ACME001:
  name: signal-without-prefix
  title: Names start with Acme.
  severity: warning
  why: They do.
  check: name
  nodes: {{types: [signals]}}
  options: {{pattern: '{pattern}'}}
  message: '{{name!r}} lacks the prefix; {{name.__class__}} stays as it is.'
  source: ACME
"""


def test_a_company_adds_a_naming_convention_in_its_own_file(tree):
    own = tree / "own.yaml"
    own.write_text(OWN.format(pattern="Acme.*"))
    result = lint_paths([tree / "vspec"], LintOptions(rule_files=(own,), select=("ACME",)))
    assert [f.message for f in result.findings] == ["'Noise' lacks the prefix; {name.__class__} stays as it is."]


def test_a_pattern_that_explodes_ends_its_rule_and_not_the_lint(tree):
    own = tree / "own.yaml"
    own.write_text(OWN.format(pattern="(a|a)+b"))
    (tree / "vspec" / "Cabin.vspec").write_text(f"{'a' * 60}: {{type: sensor, datatype: float, description: A.}}\n")
    result = lint_paths([tree / "vspec"], LintOptions(rule_files=(own,), select=("ACME", "L011")))
    assert [f.rule for f in result.findings] == ["L011"]


@pytest.mark.parametrize(
    "text",
    ["5", "- a", "acme: {}", "ACME1: {}", "ACME001: 5", "ACME001: {name: X}", "? [1]\n: {}\n", "A: &a [*a]\n",
     OWN.format(pattern=".").replace("severity: warning", "severity: fatal")],
)  # fmt: skip
def test_a_file_that_holds_no_rules_ends_the_lint(tree, text):
    own = tree / "own.yaml"
    own.write_text(text)
    with pytest.raises(InputRefused) as refused:
        lint_paths([tree / "vspec"], LintOptions(rule_files=(own,)))
    assert {(finding.rule, finding.file) for finding in refused.value.findings} == {("L010", str(own))}


@pytest.mark.parametrize(
    "text",
    [
        OWN.format(pattern="("),
        OWN.format(pattern=".").replace("check: name", "check: nmae"),
        OWN.format(pattern=".").replace("pattern", "pat"),
    ],
    ids=["pattern", "check", "option"],
)
def test_a_rule_that_cannot_be_checked_is_told_and_not_used(tree, text):
    own = tree / "own.yaml"
    own.write_text(text)
    found = lint_paths([tree / "vspec"], LintOptions(rule_files=(own,))).findings
    assert [(f.rule, f.file) for f in found if f.rule not in ("V105", "V106")] == [("L010", str(own))]


@pytest.mark.parametrize(
    ("check", "options", "message"),
    [
        ("text", "{attribute: enum, each: kye}", "Option 'each' of rule ACME001 must be key or value, not 'kye'."),
        ("text", "{attribute: comment, repair: dot}", "Option 'repair' of rule ACME001 must be capitalize, period or deprecation, not 'dot'."),
        ("name", "{case: loud}", "Option 'case' of rule ACME001 must be screaming, not 'loud'."),
        ("name-length", "{most: 9, target: C, of: paths}", "Option 'of' of rule ACME001 must be name or path, not 'paths'."),
        ("node-type", "{types: sensor}", "Option 'types' of rule ACME001 must be a list, not 'sensor'."),
    ],
)  # fmt: skip
def test_an_option_that_takes_one_of_a_few_words_takes_no_other(tree, check, options, message):
    own = tree / "own.yaml"
    text = OWN.format(pattern=".").replace("check: name", f"check: {check}")
    own.write_text(text.replace("options: {pattern: '.'}", f"options: {options}"))
    found = lint_paths([tree / "vspec"], LintOptions(rule_files=(own,), select=("ACME",))).findings
    assert [f.message for f in found] == [message]


def test_a_rule_that_cannot_be_used_is_told_where_only_that_rule_is_selected(tree):
    own = tree / "own.yaml"
    own.write_text(OWN.format(pattern=".").replace("check: name", "check: nmae"))
    result = lint_paths([tree / "vspec"], LintOptions(rule_files=(own,), select=("ACME",)))
    assert [f.rule for f in result.findings] == ["L010"]


def test_the_option_of_a_shipped_rule_can_be_changed(tree):
    cabin = CABIN + "Cabin.HasDoor: {type: attribute, datatype: boolean, description: Whether.}\n"
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    options = LintOptions(select=("V102",))
    assert len(lint_paths([tree / "vspec"], options).findings) == 1
    changed = options._replace(rule_options={"V102": {"prefixes": ["Is", "Has"]}})
    assert lint_paths([tree / "vspec"], changed).findings == ()
