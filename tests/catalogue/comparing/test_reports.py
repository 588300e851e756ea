"""The formats of a comparison: a tree for terminals, Markdown for release notes, JSON for programs."""

import json
import re

import pytest

from sigcat.catalogue.comparing.bindings import BINDINGS
from sigcat.catalogue.comparing.diff_report import diff_data, markdown_report, text_report
from tests.catalogue.comparing.running import changes, sigcat, signal
from tests.catalogue.trees import ROOT

OLD = signal("Vehicle.A", max=10) + signal("Vehicle.Gone", deprecation="v2 no longer needed")
NEW = signal("Vehicle.A", max=20, datatype="double") + signal("Vehicle.New")


@pytest.fixture
def sides(tmp_path):
    for name, text in (("old", OLD), ("new", NEW)):
        (tmp_path / f"{name}.vspec").write_text(ROOT + text)
    return str(tmp_path / "old.vspec"), str(tmp_path / "new.vspec")


def test_the_data_of_a_change():
    data = diff_data(changes(signal("Vehicle.A", max=10), signal("Vehicle.B", max=20, fka="[Vehicle.A]")))
    assert data == {
        "summary": {"worst": "breaking", "total": 1, "breaking": 1, "risky": 0, "compatible": 0, "text": 0},
        "changes": [
            {
                "kind": "moved",
                "compatibility": "breaking",
                "rule": "moved",
                "path": "Vehicle.B",
                "old_path": "Vehicle.A",
                "type": "sensor",
                "paths": ["Vehicle.B"],
                "old_paths": ["Vehicle.A"],
                "signal_count": 1,
                "evidence": "fka",
                "is_guess": False,
                "attribute_changes": [
                    {
                        "name": "description",
                        "old_value": "Value of Vehicle.A.",
                        "new_value": "Value of Vehicle.B.",
                        "compatibility": "text",
                        "rule": "text",
                    },
                    {
                        "name": "max",
                        "old_value": 10,
                        "new_value": 20,
                        "compatibility": "risky",
                        "rule": "range-widened",
                    },
                ],
                "instances_added": [],
                "instances_removed": [],
                "note": None,
                "effects": ["id-changed"],
                "bindings": dict.fromkeys(BINDINGS, "breaking"),
            }
        ],
    }


def test_without_changes_there_is_no_worst_class():
    assert diff_data(())["summary"]["worst"] is None
    assert text_report(()) == "No differences.\n"
    assert markdown_report((), "a", "b") == "# Changes from `a` to `b`\n\nNo differences.\n"


def test_values_that_json_does_not_have_become_text():
    values = diff_data(changes(signal("Vehicle.A", x=".inf", y="2024-01-31"), signal("Vehicle.A")))
    assert [attribute["old_value"] for attribute in values["changes"][0]["attribute_changes"]] == ["inf", "2024-01-31"]
    json.dumps(values, allow_nan=False)


def test_the_command_writes_json_with_the_names_of_the_sides(sides, capsys):
    assert sigcat("diff", *sides, "--format", "json") == 0
    data = json.loads(capsys.readouterr().out)
    assert (data["old"], data["new"]) == sides
    assert [change["kind"] for change in data["changes"]] == ["changed", "removed", "added"]


def test_release_notes_have_the_worst_first():
    assert markdown_report(changes(OLD, NEW), "v1", "v2") == (
        "# Changes from `v1` to `v2`\n\n"
        "3 changes: 2 breaking, 1 compatible.\n\n"
        "## Breaking\n\n"
        "- Changed: `Vehicle.A`\n"
        "  - `datatype`: `float` → `double` (breaking)\n"
        "  - `max`: `10` → `20` (risky)\n"
        "- Removed: `Vehicle.Gone`\n"
        "  - its deprecation said: `v2 no longer needed`\n\n"
        "## Compatible\n\n"
        "- Added: `Vehicle.New`\n"
    )


@pytest.mark.parametrize("hostile", ["<script>x</script>", "a `` b ` c", "# x\\n- y", "[x](http://x)", "@all #1", "``"])
def test_nothing_in_a_tree_is_markup_in_the_release_notes(hostile):
    report = markdown_report(changes(signal("Vehicle.A"), signal("Vehicle.A", comment=f'"{hostile}"')), hostile, "b")
    outside = re.sub(r"(?<!`)(`+)(?!`).+?(?<!`)\1(?!`)", "", report)
    assert (
        outside
        == "# Changes from  to \n\n1 change: 1 text only.\n\n## Text only\n\n- Changed: \n  - : (none) →  (text only)\n"
    )


def test_nothing_in_a_tree_steers_the_terminal():
    report = text_report(changes(signal("Vehicle.A"), signal("Vehicle.A", comment=r'"\e[31m\nx\u202Ey"')))
    assert r"comment: (none) → \x1b[31m x\u202ey" in report


def test_colours_are_for_terminals_only(sides, capsys, monkeypatch):
    assert sigcat("diff", *sides) == 0
    assert "\x1b" not in capsys.readouterr().out
    assert "\x1b[1;31m[breaking]\x1b[0m" in text_report(changes(OLD, NEW), is_coloured=True)
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    for name, value, is_coloured in (("NO_COLOR", "1", False), ("TERM", "dumb", False), ("TERM", "xterm", True)):
        with monkeypatch.context() as patch:
            patch.delenv("NO_COLOR", raising=False)
            patch.setenv("TERM", "xterm")
            patch.setenv(name, value)
            assert sigcat("diff", *sides) == 0
            assert ("\x1b" in capsys.readouterr().out) is is_coloured


def test_a_long_text_is_shown_where_it_differs():
    long = "The same words again and again, " * 5
    report = text_report(
        changes(signal("Vehicle.A", comment=f"{long} old"), signal("Vehicle.A", comment=f"{long} new"))
    )
    assert re.search(r"comment: ….{20,30}old → ….{20,30}new", report)


@pytest.mark.parametrize(
    ("bound", "status"), [("breaking", 1), ("risky", 1), ("compatible", 1), ("text", 1), (None, 0)]
)
def test_a_breaking_change_fails_on_every_bound(sides, bound, status):
    assert sigcat("diff", *sides, *(["--fail-on", bound] if bound else [])) == status


@pytest.mark.parametrize(("bound", "status"), [("breaking", 0), ("risky", 0), ("compatible", 1), ("text", 1)])
def test_a_compatible_change_fails_on_what_is_no_worse(tmp_path, bound, status):
    for name, text in (("old", ""), ("new", signal("Vehicle.A"))):
        (tmp_path / f"{name}.vspec").write_text(ROOT + text)
    sides = [str(tmp_path / f"{name}.vspec") for name in ("old", "new")]
    assert sigcat("diff", *sides, "--fail-on", bound) == status


def test_only_some_classes_are_shown_while_all_can_fail(sides, capsys):
    assert sigcat("diff", *sides, "--only", "compatible", "--only", "text", "--fail-on", "breaking") == 1
    assert capsys.readouterr().out == "Vehicle\n  + New  [compatible]\n\n1 change: 1 compatible; 2 others not shown\n"


def test_no_change_of_a_class_is_not_no_difference(sides, capsys):
    assert sigcat("diff", *sides, "--only", "text") == 0
    assert capsys.readouterr().out == "No such changes; 3 others not shown.\n"


def test_the_report_goes_to_a_file(sides, tmp_path, capsys):
    assert sigcat("diff", *sides, "--format", "markdown", "-o", str(tmp_path / "notes.md")) == 0
    assert (tmp_path / "notes.md").read_text().startswith("<!-- sigcat diff -->\n# Changes from")
    assert capsys.readouterr().out == ""


def test_what_cannot_be_read_is_one_line_and_status_2(capsys):
    assert sigcat("diff", "missing.vspec", "also_missing.vspec") == 2
    assert capsys.readouterr().err == "sigcat: missing.vspec: there is no such file or folder\n"
