"""What a user gets from linting files and folders: which findings, where, and what each kind of file is."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sigcat.catalogue.composing.compose import compose, compose_part, read_catalogue
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.data import INTERFACE_RULES, OVERLAYS, ROOT_FILE, VSPEC
from sigcat.errors import InputRefused, NotFound, UsageError
from sigcat.findings import Finding
from sigcat.rules.engine import found_in
from sigcat.rules.linting.baseline import baseline_text
from sigcat.rules.linting.configuration import find_configuration, read_configuration
from sigcat.rules.linting.discovery import discover
from sigcat.rules.linting.fixes import fixed_files
from sigcat.rules.linting.lint import lint_paths, lint_text
from sigcat.rules.linting.options import LintOptions, PerFile
from sigcat.rules.linting.selection import rules_for
from sigcat.rules.record import load_rules, parse_rules
from sigcat.rules.report import FORMATS, report, sources_of
from sigcat.rules.rule_set import RuleSet
from tests.needs import OFFICIAL, RELEASES, official_releases

TREE = """\
Vehicle:
  type: branch
  description: A vehicle.
#include Cabin.vspec Vehicle
"""
CABIN = """\
Cabin:
  type: branch
  description: The cabin.

Cabin.Noise:
  type: sensor
  datatype: float
  description: noise in the cabin
"""
EVERY_RULE = RuleSet(load_rules(INTERFACE_RULES))


@pytest.fixture
def tree(tmp_path):
    (tmp_path / "vspec").mkdir()
    (tmp_path / "overlays").mkdir()
    (tmp_path / "vspec" / "VehicleSignalSpecification.vspec").write_text(TREE)
    (tmp_path / "vspec" / "Cabin.vspec").write_text(CABIN)
    (tmp_path / ".git").mkdir()
    return tmp_path


def overlay(folder: Path, name: str, text: str) -> Path:
    path = folder / "overlays" / name
    path.write_text(text)
    return path


def told(result: Any) -> list[tuple[str, int, int, str]]:
    return [(Path(f.file).name, f.line, f.column, f.rule) for f in result.findings]


def test_a_folder_is_linted_as_the_tree_that_stands_in_it(tree):
    result = lint_paths([tree / "vspec"])
    assert told(result) == [("Cabin.vspec", 8, 16, "V105"), ("Cabin.vspec", 8, 16, "V106")]
    assert {Path(name).name for name in result.files} == {"VehicleSignalSpecification.vspec", "Cabin.vspec"}
    assert result.findings[0].path == "Vehicle.Cabin.Noise"


def test_a_part_that_is_named_alone_knows_its_place_in_the_tree(tree):
    result = lint_paths([tree / "vspec" / "Cabin.vspec"])
    assert told(result) == [("Cabin.vspec", 8, 16, "V105"), ("Cabin.vspec", 8, 16, "V106")]
    assert result.findings[0].path == "Vehicle.Cabin.Noise"


def test_a_file_that_is_included_from_several_folders_has_one_name(tree):
    (tree / "vspec" / "include").mkdir()
    (tree / "vspec" / "include" / "part.vspec").write_text("Part: {type: branch, description: a part.}\n")
    (tree / "vspec" / "Body").mkdir()
    (tree / "vspec" / "Body" / "Body.vspec").write_text(
        "Body: {type: branch, description: Body.}\n#include ../include/part.vspec Body\n"
    )
    root = tree / "vspec" / "VehicleSignalSpecification.vspec"
    root.write_text(TREE + "#include Body/Body.vspec Vehicle\n#include include/part.vspec Vehicle\n")
    result = lint_paths([root], LintOptions(select=("V105",)))
    assert {f.file for f in result.findings if f.rule == "V105"} == {str(root.parent / "include" / "part.vspec"), str(root.parent / "Cabin.vspec")}  # fmt: skip


def test_a_part_is_linted_once_when_its_tree_is_named_too(tree):
    both = [tree / "vspec" / "Cabin.vspec", tree / "vspec" / "VehicleSignalSpecification.vspec"]
    assert len(lint_paths(both).findings) == 2


def test_parts_that_include_each_other_are_all_linted(tree):
    (tree / "vspec" / "Cabin.vspec").write_text(CABIN + "#include Seat.vspec Cabin\n")
    (tree / "vspec" / "Seat.vspec").write_text("Seat: {type: branch, description: seats.}\n")
    result = lint_paths([tree / "vspec" / "Cabin.vspec", tree / "vspec" / "Seat.vspec"])
    assert ("Seat.vspec", 1, 35, "V105") in told(result)
    assert [f.path for f in result.findings if "Seat" in f.file] == ["Vehicle.Cabin.Seat"]


def test_an_overlay_is_checked_over_the_tree_beside_it_and_told_alone(tree):
    path = overlay(tree, "more.vspec", "Vehicle.Cabin.Nois: {max: 5}\n")
    result = lint_paths([path])
    assert told(result) == [("more.vspec", 1, 1, "O101")]
    assert "Did you mean 'Vehicle.Cabin.Noise'" in result.findings[0].fix


@pytest.mark.parametrize("place", ["overlays/more.vspec", "more.vspec"])
def test_a_tree_of_any_name_with_units_beside_it_is_the_one_that_overlays_are_made_for(tmp_path, place):
    (tmp_path / "overlays").mkdir()
    (tmp_path / ".git").mkdir()
    (tmp_path / "truck.vspec").write_text(TREE.replace("Cabin.vspec", "parts/Cabin.vspec"))
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "Cabin.vspec").write_text(CABIN)
    unit = "{definition: Metre, unit: metre, quantity: length, allowed-datatypes: [numeric]}"
    (tmp_path / "units.yaml").write_text(f"m: {unit}\n")
    (tmp_path / "quantities.yaml").write_text("length: {definition: How long.}\n")
    (tmp_path / place).write_text("Vehicle.Cabin.Nois: {max: 5}\n")
    result = lint_paths([tmp_path / place])
    assert told(result) == [("more.vspec", 1, 1, "O101")]
    assert "Did you mean 'Vehicle.Cabin.Noise'" in result.findings[0].fix


def test_an_overlay_without_a_tree_is_checked_over_the_shipped_one(tmp_path):
    path = tmp_path / "mine.vspec"
    path.write_text("Vehicle.Sped: {max: 5}\n")
    result = lint_paths([path])
    assert told(result) == [("mine.vspec", 1, 1, "O101")]
    assert "Vehicle.Speed" in result.findings[0].fix


def test_an_overlay_may_refer_to_what_the_one_beside_it_defines(tree):
    branches = "".join(
        f"{path}: {{type: branch, description: A branch.}}\n"
        for path in ("Vehicle.Function", "Vehicle.Function.F", "Vehicle.Function.F.Error")
    )
    error = "Vehicle.Function.F.Error.{}: {{type: sensor, datatype: boolean, description: E., maturationTime: 1, \
severity: S, resetTime: 1, resetCondition: R{}}}\n"
    overlay(tree, "a.vspec", branches + error.format("One", ""))
    second = overlay(tree, "b.vspec", error.format("Two", ", dependency: [F_One_ErrorSts]"))
    assert lint_paths([second], LintOptions(ignore=("V118",))).findings == ()


def test_an_overlay_may_write_below_an_instance(tree):
    cabin = CABIN + 'Cabin.Seat: {type: branch, instances: ["Row[1,2]", [Left, Right]], description: Seats.}\n'
    cabin += "Cabin.Seat.Heat: {type: sensor, datatype: float, description: Heat.}\n"
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    text = "Vehicle.Cabin.Seat.Row1.Left.Heat: {type: sensor, datatype: float, max: 5, description: Heat.}\n"
    assert lint_paths([overlay(tree, "more.vspec", text)]).findings == ()


def test_a_path_that_does_not_exist_is_refused(tmp_path):
    with pytest.raises(NotFound, match="does not exist"):
        lint_paths([tmp_path / "nothing"])


def test_files_that_are_no_vspec_files_are_passed_over_in_folders(tree):
    (tree / "vspec" / "compose.yaml").write_text("services: {web: {image: nginx}}\n")
    (tree / "vspec" / "package.json").write_text("{}\n")
    kinds = {source.path.name: source.kind for source in discover([tree / "vspec"])}
    assert kinds["compose.yaml"] == kinds["package.json"] == "other"


def test_rule_files_and_function_files_are_known_by_their_content(tree):
    (tree / "own.yaml").write_text("ACME001:\n  name: x\n  check: name\n")
    (tree / "f.json").write_text('{"FunctionInfo": {}}')
    kinds = {source.path.name: source.kind for source in discover([tree])}
    assert (kinds["own.yaml"], kinds["f.json"]) == ("rules", "function")
    assert "L010" in [f.rule for f in lint_paths([tree / "own.yaml"]).findings]


def test_function_files_go_to_the_check_that_is_given(tree):
    path = tree / "f.json"
    path.write_text('{"FunctionInfo": {}}')
    seen: list[tuple[Sequence[tuple[bytes, str]], bool]] = []

    def check(files: Sequence[tuple[bytes, str]], is_whole: bool) -> list[Finding]:
        seen.append((files, is_whole))
        return []

    lint_paths([path], LintOptions(check_functions=check))
    lint_paths([tree], LintOptions(check_functions=check))
    files = [(b'{"FunctionInfo": {}}', str(path))]
    assert seen == [(files, False), (files, True)]


@pytest.mark.parametrize(
    "data",
    [b"", b"\xff\xfe", b"\x00" * 40, b"[" * 50_000, b"a: &a [*a]\n", b"- 1\n", b"? {}\n: 1\n", b"Vehicle: 5\n",
     b"\t", b"%YAML 9\n---\n", b"Vehicle:\n  type: [branch]\n", b"Vehicle: {min: .nan, type: sensor}\n",
     b"Vehicle.A: {type: branch, instances: 'Row[1,999999999999]'}\n", b"'#include': {type: branch}\n#include /\n",
     b"Vehicle: {type: branch, description: [1], deprecation: 5, unit: [x], allowed: {a: b}, enum: [1]}\n",
     b"Vehicle.Function.X.Scheduling.Step: {aliveSupervision: 5, supervisionType: {a: 1}, ASILlevel: [A]}\n",
     b"Vehicle.Function.X.Error.E: {dependency: {a: [1]}, maturationTime: yes}\n"],
)  # fmt: skip
def test_whatever_the_bytes_are_there_are_findings_and_no_traceback(tmp_path, data):
    path = tmp_path / "bad.vspec"
    path.write_bytes(data)
    result = lint_paths([path], LintOptions(extend_select=("P", "I", "V")))
    assert result.findings
    for form in FORMATS:
        assert report(result.findings, form, sources_of(result.findings))


def test_posted_text_gets_the_findings_of_an_overlay():
    base = read_catalogue(ROOT_FILE)
    findings = lint_text(b"Vehicle.Speed: {max: x}\n", "posted", base, RuleSet(rules_for(LintOptions())))
    assert [(f.file, f.line, f.column, f.rule) for f in findings] == [("posted", 1, 22, "V004")]


# -- which rules ---------------------------------------------------------------------------------------------------


def test_select_replaces_the_default_set_and_extend_select_adds_to_it(tree):
    def codes(**options: Any) -> set[str]:
        return {f.rule for f in lint_paths([tree / "vspec"], LintOptions(**options)).findings}

    assert codes(select=("V106",)) == {"V106"}
    assert codes(ignore=("V105",)) == {"V106"}
    assert codes(extend_select=("I104",)) == {"V105", "V106", "I104"}
    assert codes(severities={"V1": "off"}) == set()


def test_an_unknown_code_is_refused_with_the_nearest_one(tree):
    with pytest.raises(UsageError, match="X999"):
        lint_paths([tree], LintOptions(select=("X999",)))


def test_a_severity_may_hold_for_a_folder_only(tree):
    entry = PerFile("vspec/**", {"V105": "error", "V106": "off"})
    result = lint_paths([tree / "vspec"], LintOptions(per_file=(entry,), root=tree))
    assert [(f.rule, f.severity) for f in result.findings] == [("V105", "error")]


def test_notes_do_not_fail_a_lint(tree):
    severities = {"V105": "info", "V106": "info"}
    assert not lint_paths([tree / "vspec"], LintOptions(severities=severities)).fails
    assert lint_paths([tree / "vspec"]).fails


# -- suppressions --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "cabin",
    [
        CABIN.replace("in the cabin\n", "in the cabin  # sigcat: ignore[V105, V106]\n"),
        CABIN.replace("Cabin.Noise:", "# sigcat: ignore[V105,V106]\nCabin.Noise:"),
        "# sigcat: ignore-file[V1]\n" + CABIN,
    ],
    ids=["line", "block", "file"],
)
def test_a_comment_suppresses_on_its_line_in_its_block_or_in_its_file(tree, cabin):
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    result = lint_paths([tree / "vspec"])
    assert (result.findings, result.suppressed) == ((), 2)


def test_a_block_ends_with_its_node(tree):
    cabin = CABIN.replace("Cabin:", "# sigcat: ignore[V105]\nCabin:", 1)
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    assert [f.rule for f in lint_paths([tree / "vspec"]).findings] == ["L001", "V105", "V106"]


def test_a_suppression_of_a_rule_that_does_not_run_is_not_called_unused(tree):
    (tree / "vspec" / "Cabin.vspec").write_text("# sigcat: ignore-file[V101]\n" + CABIN)
    assert "L001" not in [f.rule for f in lint_paths([tree / "vspec"], LintOptions(ignore=("V101",))).findings]


# -- baselines -----------------------------------------------------------------------------------------------------


def test_a_baseline_hides_what_stands_already_wherever_it_moves(tree):
    baseline = tree / "baseline.json"
    baseline.write_text(baseline_text(lint_paths([tree / "vspec"]).findings, tree))
    (tree / "vspec" / "Cabin.vspec").write_text("\n\n\n" + CABIN + "cabin2: {type: branch, description: Two.}\n")
    result = lint_paths([tree / "vspec"], LintOptions(baseline=baseline, root=tree))
    assert [f.rule for f in result.findings] == ["V101"]


def test_an_entry_without_a_finding_is_stale(tree):
    baseline = tree / "baseline.json"
    baseline.write_text(baseline_text(lint_paths([tree / "vspec"]).findings, tree))
    (tree / "vspec" / "Cabin.vspec").write_text(CABIN.replace("noise in", "Noise in"))
    result = lint_paths([tree / "vspec"], LintOptions(baseline=baseline, root=tree))
    assert [(f.rule, f.path) for f in result.findings] == [("L003", "Vehicle.Cabin.Noise")]


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"findings": 5}', '{"findings": [{"rule": 1}]}', "[" * 100_000])
def test_what_is_no_baseline_is_refused(tree, text):
    (tree / "baseline.json").write_text(text)
    with pytest.raises(InputRefused, match="baseline"):
        lint_paths([tree / "vspec"], LintOptions(baseline=tree / "baseline.json"))


# -- configuration -------------------------------------------------------------------------------------------------


def test_the_configuration_is_found_upwards_and_its_paths_are_relative_to_it(tree):
    (tree / "pyproject.toml").write_text('[tool.sigcat.lint]\nbase = "vspec/VehicleSignalSpecification.vspec"\n'
                                         'ignore = ["V105"]\n[tool.sigcat.lint.severity]\nV106 = "error"\n')  # fmt: skip
    options = read_configuration(find_configuration(tree / "vspec") or Path())
    assert options.base is not None
    assert options.base.resolve() == (tree / "vspec" / "VehicleSignalSpecification.vspec").resolve()
    assert [(f.rule, f.severity) for f in lint_paths([tree / "vspec"], options).findings] == [("V106", "error")]


def test_everything_wrong_with_a_configuration_is_told_at_once(tmp_path):
    path = tmp_path / "sigcat.toml"
    path.write_text('[lint]\nignroe = []\nbase = "no.vspec"\nselect = 5\n[lint.severity]\nV1 = "fatal"\n')
    with pytest.raises(InputRefused) as refused:
        read_configuration(path)
    assert len(refused.value.findings) == 4
    assert "Did you mean 'ignore'?" in refused.value.findings[0].message


# -- rules of a company --------------------------------------------------------------------------------------------

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
    ["5", "- a", "acme: {}", "ACME1: {}", "ACME001: 5", "ACME001: {name: X}", OWN.format(pattern="("),
     OWN.format(pattern=".").replace("check: name", "check: nmae"), OWN.format(pattern=".").replace("pattern", "pat"),
     OWN.format(pattern=".").replace("severity: warning", "severity: fatal"), "? [1]\n: {}\n", "A: &a [*a]\n"],
)  # fmt: skip
def test_a_rule_file_with_a_defect_is_told_and_not_used(tmp_path, text):
    path = tmp_path / "own.yaml"
    path.write_text(text)
    findings = lint_paths([path]).findings if parse_rules(text.encode(), "own.yaml", trusted=False).rules else ()
    assert parse_rules(text.encode(), "own.yaml", trusted=False).findings or "L010" in [f.rule for f in findings] or (
        text in ("5", "- a")
    )  # fmt: skip


def test_the_option_of_a_shipped_rule_can_be_changed(tree):
    cabin = CABIN + "Cabin.HasDoor: {type: attribute, datatype: boolean, description: Whether.}\n"
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    options = LintOptions(select=("V102",))
    assert len(lint_paths([tree / "vspec"], options).findings) == 1
    changed = options._replace(rule_options={"V102": {"prefixes": ["Is", "Has"]}})
    assert lint_paths([tree / "vspec"], changed).findings == ()


# -- repairs -------------------------------------------------------------------------------------------------------


def fixed(tree: Path, *, unsafe: bool = False) -> Any:
    result = lint_paths([tree / "vspec"])
    return fixed_files(result.findings, result.repairs, sources_of(result.findings), unsafe=unsafe)


def test_a_repair_changes_the_bytes_that_are_wrong_and_no_others(tree):
    cabin = CABIN.replace("description: noise in the cabin\n", "description:   noise in the\n     cabin   # so it is\n")
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    (result,) = fixed(tree)
    assert result.after == cabin.replace("noise in the", "Noise in the").replace("cabin   #", "cabin.   #")
    assert len(result.settled) == 2
    assert "+  description:   Noise in the\n" in result.diff


@pytest.mark.parametrize(("before", "after"), [('"noise"', '"Noise."'), ("'noise'", "'Noise.'"), ("noise", "Noise.")])
def test_quoted_texts_stay_quoted(tree, before, after):
    (tree / "vspec" / "Cabin.vspec").write_text(CABIN.replace("noise in the cabin", before))
    assert [result.after for result in fixed(tree)] == [CABIN.replace("noise in the cabin", after)]


def test_what_changes_the_meaning_is_repaired_on_demand_only(tree):
    cabin = CABIN.replace("noise in the cabin\n", "Noise.\n  maxx: 5\n")
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    assert fixed(tree) == ()
    assert [result.after for result in fixed(tree, unsafe=True)] == [cabin.replace("maxx", "max")]


# -- reports -------------------------------------------------------------------------------------------------------


def test_the_text_report_shows_the_line_with_a_caret_and_ends_with_a_count(tree):
    result = lint_paths([tree / "vspec"], LintOptions(select=("V105",)))
    lines = report(result.findings, "text", sources_of(result.findings)).splitlines()
    assert lines[0].endswith("Cabin.vspec:8:16: warning V105 The description starts with a small letter. Start it with "
                             "a capital letter.")  # fmt: skip
    assert lines[1:] == [
        "    8 |   description: noise in the cabin",
        "                       ^^^^^",
        "Found 1 warning in 1 file.",
    ]


def test_control_characters_of_a_file_do_not_reach_the_terminal(tmp_path):
    path = tmp_path / "x.vspec"
    path.write_text('"Vehicle.\\x1b[2J": {max: 1}\n', encoding="utf-8")
    result = lint_paths([path])
    assert "\x1b" not in report(result.findings, "text", sources_of(result.findings))


def test_fingerprints_do_not_depend_on_lines(tree):
    def fingerprints() -> Any:
        findings = lint_paths([tree / "vspec"]).findings
        sarif = json.loads(report(findings, "sarif", rules=load_rules(INTERFACE_RULES)))
        return [result["partialFingerprints"] for result in sarif["runs"][0]["results"]]

    before = fingerprints()
    (tree / "vspec" / "Cabin.vspec").write_text("\n\n" + CABIN)
    assert fingerprints() == before


def test_a_format_that_does_not_exist_is_refused():
    with pytest.raises(UsageError, match="junit"):
        report((), "junti")


# -- real trees ----------------------------------------------------------------------------------------------------


@official_releases
@pytest.mark.parametrize("release", RELEASES)
def test_official_releases_have_no_errors(release):
    assert [f.line_of_text for f in lint_paths([OFFICIAL / release / "spec"]).findings if f.severity == "error"] == []


def test_the_shipped_tree_has_no_errors():
    assert [f.line_of_text for f in lint_paths([VSPEC]).findings if f.severity == "error"] == []


@pytest.mark.parametrize("overlay", sorted(OVERLAYS.glob("*.vspec")), ids=lambda path: path.stem)
def test_a_shipped_overlay_is_clean_by_itself_though_it_shares_a_file_with_the_others(overlay):
    assert [f.line_of_text for f in lint_paths([overlay]).findings] == []


# -- input of any kind -----------------------------------------------------------------------------------


@given(st.binary(max_size=300) | st.text("VehicleABab:.- \n[]{}#&*!'\"0", max_size=300).map(str.encode))
@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_bytes_of_any_kind_never_end_a_lint(data):
    base = compose([])
    for is_tree in (True, False):
        for finding in lint_text(data, "posted", base, EVERY_RULE, is_tree=is_tree):
            assert finding.file == "posted"


ATTRIBUTES = st.sampled_from(
    ["type", "datatype", "unit", "description", "allowed", "enum", "min", "max", "default", "instances", "deprecation",
     "dependency", "errorList", "supervisionType", "aliveSupervision", "cycleTime", "previousRunnable", "ASILlevel"]
)  # fmt: skip
PATHS = st.sampled_from(
    ["Vehicle", "Vehicle.A", "Vehicle.a", "Vehicle.A.B", "Vehicle.Function", "Vehicle.Function.F",
     "Vehicle.Function.F.Error.E", "Vehicle.Function.F.Scheduling.Step", "Vehicle.Function.F.Scheduling",
     "Vehicle.Function.F.SafetyReaction.S", "Vehicle.Function.F.Mode.In", "Vehicle.*", "Vehicle..X", "Other"]
)  # fmt: skip
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.sampled_from(
        ["branch", "sensor", "uint8", "string", "F_E_ErrorSts", "F_Step", "Alive", "B", "Row[1,2]", "V1.0 moved to A.B", ""]
    ),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(ATTRIBUTES, inner, max_size=3),
    max_leaves=6,
)  # fmt: skip


@given(st.dictionaries(PATHS, st.dictionaries(ATTRIBUTES, VALUES, max_size=6), max_size=8))
@settings(max_examples=150, deadline=None)
def test_values_of_any_kind_at_any_place_never_end_a_lint(data):
    base = compose([])
    for is_tree in (True, False):
        lint_text(json.dumps(data).encode(), "posted", base, EVERY_RULE, is_tree=is_tree)


NODES = st.dictionaries(PATHS, st.dictionaries(ATTRIBUTES, VALUES, max_size=6), max_size=8)


def test_a_list_among_the_values_of_the_tree_does_not_end_the_lint_of_an_overlay():
    tree = "Vehicle: {type: branch}\nVehicle.A: {type: sensor, datatype: uint8, allowed: [[1], 2]}\n"
    base = compose([layer_from_text(tree.encode(), "tree", is_overlay=False)])
    findings = lint_text(b"Vehicle.A: {type: sensor, datatype: uint8, allowed: {2: Two}}\n", "posted", base, EVERY_RULE)
    assert "The overlay narrows `allowed`: `[1]` is no longer allowed." in {f.message for f in findings}


@given(NODES, NODES, NODES)
@settings(max_examples=150, deadline=None)
def test_an_overlay_has_the_findings_that_it_has_when_the_whole_tree_is_judged(tree, other, overlay):
    named = {"tree": {"Vehicle": {"type": "branch"}, **tree}, "other": other, "posted": overlay}
    layers = [
        layer_from_text(json.dumps(nodes).encode(), name, is_overlay=name != "tree") for name, nodes in named.items()
    ]
    base, whole = compose(layers[:2]), compose(layers, expanded=False)
    missing = base.nodes.keys() - base.definitions.keys()
    part = compose_part(base, layers[2])
    in_part, in_those_of_the_file, in_all = (
        {finding for finding, _ in found if finding.file == "posted" and finding.path not in missing}
        for found in (
            found_in(part, EVERY_RULE, part.changed.values()),
            found_in(whole, EVERY_RULE, whole.written_in({"posted"})),
            found_in(whole, EVERY_RULE),
        )
    )
    assert in_part == in_those_of_the_file == in_all


# -- overlays over what they change ----------------------------------------------------------------------------------

BELOW = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.A: {type: sensor, datatype: uint8, max: 200, default: 150, description: A thing.}
Vehicle.Mode: {type: actuator, datatype: string, allowed: [HIGH, LOW], default: HIGH, description: A mode.}
Vehicle.Row: {type: branch, instances: "Row[1,2]", description: Rows.}
Vehicle.Row.X: {type: sensor, datatype: uint8, unit: km/h, description: A thing.}
Vehicle.Row.Common: {type: sensor, datatype: uint8, instantiate: false, description: A thing.}
"""


@pytest.mark.parametrize(
    ("overlay", "told"),
    [
        ("Vehicle.A: {comment: Less., max: 100}\n", ("V010", 1, 34)),
        ("Vehicle.A: {min: 160}\n", ("V010", 1, 18)),
        ("Vehicle.A: {datatype: string}\n", ("V009", 1, 23)),
        ("Vehicle.Mode: {allowed: [LOW, HIGH]}\n", ("V121", 1, 25)),
        ("Vehicle.Row.Row1.X: {max: 100000}\n", ("V008", 1, 27)),
        ("Vehicle.Row.Row1.X: {unit: foo}\n", ("V006", 1, 28)),
        ("Vehicle.Row.Row1: {type: sensor, datatype: uint8, description: A row.}\n", ("V019", 1, 26)),
        ("Vehicle.Row.Row1.Common: {max: 3}\n", ("O101", 1, 1)),
        ("Vehicle.Row: {instances: ['Row[1,2]', [L, R]]}\nVehicle.Row.Row1.X: {max: 3}\n", ("O101", 2, 1)),
        ("Vehicle.Gone: {delete: true}\n", ("V001", 1, 1)),
        ("Vehicle.Row: {instances: ['A[1,1000]', 'B[1,1000]']}\n", ("V025", 1, 26)),
        ("Vehicle.B: {type: sensor, datatype: flaot, unit: foo, description: Two slips.}\n", ("V006", 1, 50)),
    ],
)
def test_what_an_overlay_makes_wrong_is_told_where_it_says_so(tmp_path, overlay, told):
    (tmp_path / "vspec").mkdir()
    (tmp_path / "overlays").mkdir()
    tree, file = tmp_path / "vspec" / "VehicleSignalSpecification.vspec", tmp_path / "overlays" / "own.vspec"
    tree.write_text(BELOW)
    file.write_text(overlay)
    (tree.parent / "units.yaml").write_bytes((VSPEC / "units.yaml").read_bytes())
    (tree.parent / "quantities.yaml").write_bytes((VSPEC / "quantities.yaml").read_bytes())
    alone = {(f.rule, f.line, f.column) for f in lint_paths([file]).findings}
    posted = lint_text(overlay.encode(), "posted", read_catalogue(tree), EVERY_RULE)
    assert told in alone
    assert told in {(f.rule, f.line, f.column) for f in posted}
    assert [f for f in lint_paths([tree]).findings if f.rule == told[0]] == []


def test_what_an_overlay_includes_is_a_part_of_it_wherever_it_stands(tmp_path):
    overlays = tmp_path / "overlays"
    (overlays / "inc").mkdir(parents=True)
    (overlays / "a.vspec").write_text(
        "Vehicle.Acme: {type: branch, description: Ours.}\n#include inc/shared.vspec Vehicle.Acme\n"
    )
    (overlays / "b.vspec").write_text("Vehicle.Other: {type: branch, description: Others.}\n")
    shared = overlays / "inc" / "shared.vspec"
    shared.write_text(
        "sig: {type: sensor, datatype: uint8, description: A signal.}\n*: {comment: Ours.}\n".replace("*", "'*'")
    )
    assert {f.rule for f in lint_paths([shared]).findings} == {"V101"}
    for path in (shared, overlays / "b.vspec", overlays / "inc" / ".." / "b.vspec"):
        assert [f.rule for f in lint_paths([path]).findings if f.severity == "error"] == []


def test_a_folder_above_the_repository_makes_no_overlay_of_a_tree(tmp_path):
    folder = tmp_path / "overlays" / "checkout"
    (folder / "vspec").mkdir(parents=True)
    (folder / ".git").mkdir()
    (folder / "vspec" / "VehicleSignalSpecification.vspec").write_text(
        "Vehicle: {type: branch, description: A vehicle.}\n#include Body.vspec Vehicle.Body\n"
    )
    body = folder / "vspec" / "Body.vspec"
    body.write_text("Is: {type: branch, description: A part.}\n")
    assert lint_paths([body]).findings == ()


def test_a_baseline_of_all_is_not_stale_where_a_part_is_linted(tree):
    baseline = tree / "baseline.json"
    overlay = tree / "overlays" / "own.vspec"
    overlay.parent.mkdir(exist_ok=True)
    overlay.write_text("Vehicle.own: {type: branch, description: Ours.}\n")
    baseline.write_text(baseline_text(lint_paths([tree]).findings, tree, [tree]))
    options = LintOptions(baseline=baseline, root=tree)
    assert lint_paths([tree / "vspec"], options).findings == lint_paths([tree], options).findings == ()
    overlay.write_text("Vehicle.Own: {type: branch, description: Ours.}\n")
    assert lint_paths([tree / "vspec"], options).findings == ()
    assert [f.rule for f in lint_paths([tree], options).findings] == ["L003"]


def test_an_empty_text_is_not_clean():
    assert [f.rule for f in lint_text(b" \n", "posted", compose([]), EVERY_RULE)] == ["Q003"]
