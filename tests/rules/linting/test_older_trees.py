"""Linting trees of older releases, and overlays over them: they are read as the tools of their time read them."""

from pathlib import Path

import pytest

from sigcat.findings import Finding
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions

OLDER = Path(__file__).parents[2] / "catalogue" / "hosting" / "older"
UNITS = "units:\n  furlong:\n    label: furlong\n    description: How far a plough goes.\n    domain: distance\n"
TREE = "Vehicle:\n  type: branch\n  description: A vehicle.\n"
PART = "Way:\n  type: Sensor\n  datatype: float\n  unit: furlong\n  description: How far it went.\n"


def found(*paths: Path, base: Path | None = None) -> set[tuple[str, str]]:
    """Rules and severities of the findings about reading a tree; not those about style."""
    options = LintOptions(select=("V0", "U", "R"), base=base)
    return {(finding.rule, finding.severity) for finding in findings_of(paths, options)}


def findings_of(paths: tuple[Path, ...], options: LintOptions) -> tuple[Finding, ...]:
    return lint_paths(list(paths), options).findings


@pytest.fixture
def tree(tmp_path):
    (tmp_path / "units.yaml").write_text(UNITS)
    (tmp_path / "Part.vspec").write_text(PART)
    root = tmp_path / "VehicleSignalSpecification.vspec"
    root.write_text(f"{TREE}#include Part.vspec Vehicle\n")
    return root


def test_units_and_words_of_before_are_warnings(tree):
    assert found(tree.parent) == {("U005", "warning"), ("V026", "warning")}


def test_a_part_named_alone_is_read_as_its_tree_is(tree):
    assert found(tree.parent / "Part.vspec") == {("V026", "warning")}


def test_a_file_of_units_may_be_named_alone(tree):
    assert found(tree.parent / "units.yaml") == {("U005", "warning")}


def test_an_overlay_may_use_the_units_of_an_older_tree(tree, tmp_path):
    overlay = tmp_path / "overlays" / "more.vspec"
    overlay.parent.mkdir()
    overlay.write_text(PART.replace("Way", "Vehicle.More").replace("Sensor", "sensor"))
    assert found(overlay, base=tree) == set()
    overlay.write_text(overlay.read_text().replace("furlong", "fathom"))
    assert found(overlay, base=tree) == {("V006", "error")}


def test_an_overlay_over_a_tree_of_3_0_may_use_the_units_of_its_tools(tmp_path):
    overlay = tmp_path / "more.vspec"
    overlay.write_text(PART.replace("Way", "Vehicle.More").replace("Sensor", "sensor").replace("furlong", "MB/s"))
    assert found(overlay, base=OLDER / "no_units_as_in_3.0" / "VehicleSignalSpecification.vspec") == set()


def test_what_breaks_a_rule_is_graded_as_in_any_tree():
    rules = found(OLDER / "loose_checks")
    assert ("V008", "error") in rules
    assert ("U005", "warning") in rules


def test_words_of_before_are_errors_in_a_tree_of_today(tree):
    (tree.parent / "units.yaml").write_text(
        "furlong:\n  definition: Far.\n  unit: furlong\n  quantity: length\n  allowed-datatypes: [numeric]\n"
    )
    (tree.parent / "quantities.yaml").write_text("length:\n  definition: How far.\n")
    assert found(tree.parent) == {("V001", "error")}
