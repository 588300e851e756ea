"""Rules of a company, in a separate file."""

import json

import pytest

from sigcat.errors import InputRefused
from sigcat.rules.checks import CHECKS
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
  message: '{{name!r}} lacks the prefix; {{min: 0}} stays as it is.'
  source: ACME
"""


def test_a_company_adds_a_naming_convention_in_its_own_file(tree):
    own = tree / "own.yaml"
    own.write_text(OWN.format(pattern="Acme.*"))
    result = lint_paths([tree / "vspec"], LintOptions(rule_files=(own,), select=("ACME",)))
    assert [f.message for f in result.findings] == ["'Noise' lacks the prefix; {min: 0} stays as it is."]


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
        ("name", "{prefixes: [5]}", "Option 'prefixes' of rule ACME001 must be a list of names, not [5]."),
        ("path-depth", "{most: -1}", "Option 'most' of rule ACME001 must be a whole number from 0 to 1,000,000, not -1."),
        ("implied", "{attribute: ''}", "Option 'attribute' of rule ACME001 must be the name of an attribute, none within it, not ''."),
        ("required-fields", "{fields: {watchdog: {fields: 5}}}", "`fields` of field 'watchdog' must be a mapping, not 5."),
        ("required-fields", "{fields: {watchdog: {fields: {kind: {requird: true}}}}}", "Unknown key 'requird' of field 'kind'."),
        ("field-values", "{fields: {watchdog: {values: []}}}", "`values` of field 'watchdog' must be a list of at least one text, number or boolean, not []."),
        ("field-values", "{fields: {watchdog: {min: low}}}", "`min` of field 'watchdog' must be a number, not 'low'."),
        ("node-type", "{types: []}", "Option 'types' of rule ACME001 must be branch, sensor, actuator, attribute, struct or property, not []."),
        ("node-type", "{types: sensor}", "Option 'types' of rule ACME001 must be a list of texts, not 'sensor'."),
    ],
)  # fmt: skip
def test_an_option_of_another_kind_is_told_by_its_rule(tree, check, options, message):
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


ANYTHING: tuple[object, ...] = (
    "", " ", "(", "a.b", 5, -1, 10**30, 1.5, True, None, [], [5], [""], [None], [[]], [["a"]], [{}], ["("], {}, {"a": 5}, {5: {}},
    {"a": {}}, {"a": {"fields": 5}}, {"a": {"fields": {"b": 5}}}, {"a": {"fields": {"b": {"values": 5}}}}, {"a": {"datatype": 5}},
    {"a": {"datatype": []}}, {"a": {"values": 5}}, {"a": {"values": []}}, {"a": {"values": [[]]}}, {"a": {"min": "x"}},
    {"a": {"max": []}}, {"a": {"pattern": 5}}, {"a": {"pattern": "("}}, {"a": {"repairs": 5}}, {"a": {"repairs": {"x": 5}}},
    {"a": {"unit": 5}}, {"a": {"required": "yes"}}, {"a": {"title": []}},
)  # fmt: skip
SIGNALS = """
Cabin.Sound: {type: sensor, datatype: uint8, min: 0, max: 9, allowed: [1, 2, 2], default: 3, a: {b: [1, x]}, description: Noise, comment: v}
Cabin.Door: {type: branch, description: Doors., instances: ["Row[1,2]"], a: {b: {}}}
Cabin.Door.IsOpen: {type: sensor, datatype: boolean, a: [1, text], description: Noise}
"""


@pytest.mark.parametrize("check", CHECKS)
def test_options_of_any_kind_are_findings_or_work(tree, check):
    options = CHECKS[check].options
    usable = {name: _usable(kind) for name, kind in options.items() if name in CHECKS[check].required}
    given = [{**usable, name: value} for name in options for value in ANYTHING]
    record = {"name": "any", "title": "Any.", "severity": "warning", "why": "Any.", "check": check, "source": "ACME"}
    own = tree / "own.yaml"
    rules = {f"ACME{at:03}": {**record, "options": each} for at, each in enumerate([usable, *given], 1)}
    own.write_text(json.dumps(rules))
    (tree / "vspec" / "Cabin.vspec").write_text(CABIN + SIGNALS)
    found = lint_paths([tree / "vspec"], LintOptions(rule_files=(own,), select=("ACME",))).findings
    assert "ACME001" not in {f.path for f in found if f.rule == "L010"}


def _usable(kind):
    good = {
        "text": ".", "name": "description", "attribute": "description", "list of attributes": ["description"], "whole number": 3, "list of texts": ["."], "list of names": ["description"],
        "list of values": [1], "table of fields": {"description": {"required": True}},
    }  # fmt: skip
    word = kind.name.partition("`")[2].partition("`")[0]
    return good.get(kind.name) or ([word] if kind.name.startswith("list of") else word)


RECORD = (
    OWN.format(pattern="Acme.*") + "  good: |\n    Vehicle.Acme: {type: sensor, datatype: float, description: A.}\n"
)


@pytest.mark.parametrize(
    "text",
    [
        RECORD.replace("  check: name\n", ""),
        RECORD.replace("ACME001", "acme"),
        RECORD.replace("ACME001", "acme001"),
        RECORD.replace("ACME001", "'ACME001'").replace("why: They do.", ""),
        "rules:\n  - id: ACME001\n    title: T.\n    severity: warning\n    why: They do.\n    check: name\n",
        "ACME001: {name: a, title: T., severity: error, why: W., source: S}\n",
    ],
)
def test_a_file_of_rules_is_one_whatever_is_wrong_with_it(tree, text):
    own = tree / "own.yaml"
    own.write_text(text)
    for path in (own, tree):
        findings = lint_paths([path], LintOptions()).findings
        assert {(finding.rule, finding.line) for finding in findings if finding.file == str(own)} == {("L010", 1)}


def test_a_code_in_small_letters_is_written_in_capitals(tree):
    own = tree / "own.yaml"
    own.write_text(RECORD.replace("ACME001", "acme001"))
    assert [finding.fix for finding in lint_paths([own]).findings] == ["Write ACME001."]


@pytest.mark.parametrize(
    "text",
    [
        "Vehicle.Cabin.X: {type: sensor, datatype: float, severity: a, why: b, title: c, description: A.}\n",
        "C123: {severity: high}\n",
        "rules:\n- apiGroups: ['']\n  resources: [pods]\n",
        "rules:\n  a:\n    severity: warn\n    given: $\n",
    ],
)
def test_other_files_are_not_of_rules(tree, text):
    other = tree / "other.yaml"
    other.write_text(text)
    assert not any(finding.rule == "L010" for finding in lint_paths([tree]).findings)


def test_a_file_that_the_project_names_as_rules_is_one(tree):
    own = tree / "own.yaml"
    own.write_text("# none yet\n")
    assert lint_paths([own], LintOptions(rule_files=(own,))).findings == ()


@pytest.mark.parametrize(
    ("template", "fault", "fix"),
    [
        ("{nmae} is wrong.", "has the unknown placeholder {nmae}", "Did you mean 'name'? Use one of {path}, {name}, "),
        ("{name.__class__}", "has the unknown placeholder {name.__class__}", "Use one of {path}, {name}, {proposal}"),
        ("{name:>3} {}", "has the unknown placeholder {name:>3}", "Use one of "),
        ("{attribute} of {name}", "has the unknown placeholder {attribute}", "Use one of "),
        ("{name is wrong.", "has a brace without its other half", "Write placeholders such as {name} or {name!r}."),
        ("name} is {wrong.", "has a brace without its other half", "Write placeholders"),
    ],
)
@pytest.mark.parametrize("key", ["message", "fix"])
def test_a_broken_template_is_reported_at_its_line(tree, key, template, fault, fix):
    own = tree / "own.yaml"
    own.write_text(
        RECORD.replace("  message: '{name!r} lacks the prefix; {min: 0} stays as it is.'", f"  {key}: '{template}'")
    )
    finding = lint_paths([own]).findings[0]
    assert (finding.rule, finding.line, finding.column) == ("L010", 9, 3)
    assert finding.message == f"`{key}` {fault}."
    assert finding.fix.startswith(fix)
