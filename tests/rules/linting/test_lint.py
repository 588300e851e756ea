"""Linting of files and folders: findings, their places, and the kind of each file."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from sigcat import codes
from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.data import OVERLAYS, ROOT_FILE, VSPEC
from sigcat.errors import NotFound
from sigcat.rules.linting.discovery import discover
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import CheckedFunctions, LintOptions
from sigcat.rules.linting.posted import lint_text
from sigcat.rules.linting.selection import rules_for
from sigcat.rules.report import FORMATS, report, sources_of
from sigcat.rules.rule_set import RuleSet
from tests.needs import OFFICIAL, RELEASES, official_releases
from tests.rules.linting.conftest import CABIN, TREE


def overlay(folder: Path, name: str, text: str) -> Path:
    path = folder / "overlays" / name
    path.write_text(text)
    return path


def told(result: Any) -> list[tuple[str, int, int, str]]:
    return [(Path(f.file).name, f.line, f.column, f.rule) for f in result.findings]


@pytest.mark.parametrize("leads_to", ["loop.vspec", "gone.vspec", "overlays"], ids=["itself", "nothing", "a folder"])
def test_links_that_lead_to_no_file_are_reported(leads_to, tree):
    before = told(lint_paths([tree]))
    for folder in (tree / "vspec", tree / "overlays"):
        (folder / "loop.vspec").symlink_to(leads_to)
    assert sorted(told(lint_paths([tree]))) == sorted([*before, *2 * [("loop.vspec", 0, 0, "R012")]])
    named = overlay(tree, "named.vspec", "Vehicle.Cabin.Fan:\n  type: branch\n  description: Fan.\n")
    assert told(lint_paths([named])) == []


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


def test_an_overlay_may_refer_to_what_another_of_its_stack_defines(tree):
    branches = "".join(
        f"{path}: {{type: branch, description: A branch.}}\n"
        for path in ("Vehicle.Function", "Vehicle.Function.F", "Vehicle.Function.F.Error")
    )
    error = "Vehicle.Function.F.Error.{}: {{type: sensor, datatype: boolean, description: E., maturationTime: 1, \
severity: S, resetTime: 1, resetCondition: R{}}}\n"
    first = overlay(tree, "a.vspec", branches + error.format("One", ""))
    second = overlay(tree, "b.vspec", error.format("Two", ", dependency: [F_One_ErrorSts]"))
    assert lint_paths([second], LintOptions(ignore=("V118", "V124"), overlays=(first,))).findings == ()
    alone = lint_paths([second], LintOptions(ignore=("V118", "V020", "V124")))
    assert {f.rule for f in alone.findings} == {"I204"}, alone.findings


def test_overlays_side_by_side_are_alternatives_unless_a_stack_is_declared(tree):
    noise = "Vehicle.Cabin.Noise: {{unit: {}}}\n"
    variants = [overlay(tree, f"{name}.vspec", noise.format(name)) for name in ("one", "two", "three")]
    alone = {(file.name, f.rule) for file in variants for f in lint_paths([file]).findings}
    together = lint_paths([tree / "overlays"])
    assert {(Path(f.file).name, f.rule) for f in together.findings} == alone
    assert {"O105", "O106"}.isdisjoint(f.rule for f in together.findings)
    stacked = lint_paths([tree / "overlays"], LintOptions(overlays=tuple(variants)))
    assert "O105" in {f.rule for f in stacked.findings}


def test_an_overlay_beside_the_declared_stack_is_on_top_of_it(tree):
    below = overlay(tree, "below.vspec", "Vehicle.New: {type: sensor, datatype: uint8, description: New.}\n")
    above = overlay(tree, "above.vspec", "Vehicle.New: {max: 5}\n")
    (finding,) = lint_paths([tree / "overlays"]).findings
    assert (finding.rule, "'below.vspec' has it" in finding.fix) == ("O101", True)
    assert lint_paths([above], LintOptions(overlays=(below,))).findings == ()


@pytest.mark.parametrize(
    ("rule", "above"),
    [
        ("V020", "Vehicle.New.Branch.Leaf: {type: sensor, datatype: uint8, description: Leaf.}\n"),
        ("O102", "Vehicle.New: {delete: true}\n"),
        ("V113", "Vehicle.Old: {type: sensor, datatype: uint8, description: O., deprecation: V6.0 moved to Vehicle.New.Branch}\n"),
        ("I204", "Vehicle.Function.F.Error.Two: {type: sensor, datatype: boolean, description: Two., dependency: [F_One_ErrorSts]}\n"),
    ],
)  # fmt: skip
def test_whatever_an_overlay_lacks_and_another_one_has_is_told_with_its_file(tree, rule, above):
    overlay(tree, "below.vspec", "Vehicle.New: {type: branch, description: New.}\n"
            "Vehicle.New.Branch: {type: branch, description: A branch.}\n"
            "Vehicle.Function.F.Error.One: {type: sensor, datatype: boolean, description: One.}\n")  # fmt: skip
    path = overlay(tree, "above.vspec", above)
    advice = {f.rule: f.fix for f in lint_paths([path]).findings}
    assert "'below.vspec' has it" in advice[rule]
    (tree / "overlays/below.vspec").unlink()
    assert "has it" not in " ".join(f.fix for f in lint_paths([path]).findings)


def test_a_tree_with_a_root_of_its_own_is_a_tree_with_or_without_units(tmp_path):
    path = tmp_path / "server.vspec"
    path.write_text(
        "Server: {type: branch, description: A server.}\nServer.Load: {type: sensor, datatype: float, description: L.}\n"
    )
    more = tmp_path / "more.vspec"
    more.write_text("Server.Load: {max: 100}\n")
    assert lint_paths([path]).findings == ()
    assert [f.rule for f in lint_paths([more]).findings] == ["O104"]
    assert lint_paths([tmp_path]).findings == lint_paths([more]).findings


def test_the_tree_that_is_named_is_no_overlay_of_itself(tmp_path):
    path = tmp_path / "own.vspec"
    path.write_text(
        "Vehicle: {type: branch, description: V.}\nVehicle.A: {type: sensor, datatype: float, description: A.}\n"
    )
    assert lint_paths([path], LintOptions(base=path)).findings == ()


def test_struct_types_are_known_through_their_includes(tmp_path):
    (tmp_path / "include").mkdir()
    (tmp_path / "include" / "Time.vspec").write_text(
        "Time: {type: struct, description: A time.}\nTime.Seconds: {type: property, datatype: uint8, description: S.}\n"
    )
    (tmp_path / "Types.vspec").write_text("Types: {type: branch, description: T.}\n#include include/Time.vspec Types\n")
    (tmp_path / "VehicleSignalSpecification.vspec").write_text(
        "Vehicle: {type: branch, description: A vehicle.}\n"
        "Vehicle.Start: {type: sensor, datatype: Types.Time, description: When it began.}\n"
    )
    for paths in ([tmp_path], [tmp_path / "Types.vspec"], [tmp_path / "VehicleSignalSpecification.vspec"]):
        assert [f.line_of_text for f in lint_paths(paths).findings] == []


def test_a_file_that_is_named_in_two_ways_is_linted_once(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("own.vspec").write_text("Vehicle.A: {type: sensor, datatype: float, unit: ell, description: A.}\n")
    units, quantities = Path("units.yaml"), Path("quantities.yaml")
    units.write_text("ell: {definition: Ell, unit: ell of cloth, quantity: cloth, allowed-datatypes: [numeric]}\n")
    quantities.write_text("cloth: {definition: How long.}\n")
    options = LintOptions(units=(units, units.absolute()), quantities=(quantities, quantities.absolute()))
    paths = [Path("own.vspec"), tmp_path / "own.vspec", Path()]
    assert [f.rule for f in lint_paths(paths, options).findings if f.rule[0] == "U"] == []
    assert len(lint_paths(paths, options).files) == 3


def test_an_overlay_may_write_below_an_instance(tree):
    cabin = CABIN + 'Cabin.Seat: {type: branch, instances: ["Row[1,2]", [Left, Right]], description: Seats.}\n'
    cabin += "Cabin.Seat.Heat: {type: sensor, datatype: float, description: Heat.}\n"
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    text = "Vehicle.Cabin.Seat.Row1.Left.Heat: {type: sensor, datatype: float, max: 5, description: Heat.}\n"
    assert [f.rule for f in lint_paths([overlay(tree, "more.vspec", text)]).findings] == ["O104"]


def test_a_path_that_does_not_exist_is_refused(tmp_path):
    with pytest.raises(NotFound, match="there is no such file or folder"):
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

    def check(files: Sequence[tuple[bytes, str]], is_whole: bool) -> CheckedFunctions:
        seen.append((files, is_whole))
        return CheckedFunctions((), ("tree.vspec",))

    assert lint_paths([path], LintOptions(check_functions=check)).beside == ("tree.vspec",)
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


@pytest.mark.parametrize(
    ("attributes", "rule"),
    [
        ("min: .inf", "V030"),
        ("max: -.inf", "V030"),
        ("max: .nan", "V030"),
        ("type: .nan", "V001"),
        ("unit: .inf", "V004"),
    ],
)
def test_a_number_that_is_none_is_told_once_and_nothing_is_held_against_it(attributes, rule):
    base = read_catalogue(ROOT_FILE)
    whole = {
        "type": "sensor",
        "datatype": "float",
        "unit": "km/h",
        "min": 0,
        "max": 9,
        "description": "How loud it is.",
    }
    whole.update([tuple(attributes.split(": "))])
    lines = "".join(f"  {name}: {value}\n" for name, value in whole.items())
    found = lint_text(f"Vehicle.Loudness:\n{lines}".encode(), "posted", base, RuleSet(rules_for(LintOptions())))
    assert [finding.rule for finding in found if finding.severity == "error"] == [rule]


# -- real trees ----------------------------------------------------------------------------------------------------


@official_releases
@pytest.mark.parametrize("release", RELEASES)
def test_official_releases_have_no_errors(release):
    result = lint_paths([OFFICIAL / release / "spec"])
    assert len(result.files) > 30
    assert [f.line_of_text for f in result.findings if f.severity == "error"] == []


def test_the_shipped_tree_has_no_errors():
    result = lint_paths([VSPEC])
    assert len(result.files) > 30
    assert [f.line_of_text for f in result.findings if f.severity == "error"] == []


@pytest.mark.parametrize("overlay", sorted(OVERLAYS.glob("*.vspec")), ids=lambda path: path.stem)
def test_a_shipped_overlay_is_clean_by_itself_though_it_shares_a_file_with_the_others(overlay):
    result = lint_paths([overlay], LintOptions(overlays=shipped_sources()[0].overlays))
    assert str(overlay) in result.files
    assert [f.line_of_text for f in result.findings] == []


def test_a_missing_include_makes_no_roots_of_what_it_would_have_brought(tree):
    (tree / "vspec" / "Body.vspec").write_text(
        "Lights: {type: branch, description: Lights.}\nDoors: {type: branch, description: doors.}\n"
    )
    (tree / "vspec" / "VehicleSignalSpecification.vspec").write_text(TREE + "#include Bdy.vspec Vehicle\n")
    assert {f.rule for f in lint_paths([tree / "vspec"]).findings} == {"R008", "V105", "V106"}


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "Vehicle.A: {type: branch, description: A., instances: 'Row[1, 2]'}\nVehicle.A.Row1: {type: branch, description: One.}\n",
            ["V029"],
        ),
        ("Vehicle.A: {type: branch, description: A., B: {type: branch, C: {type: sensor}}}\n", ["R019"]),
        ("- Vehicle.A:\n  type: branch\n", ["R007"]),
        ("Vehicle.Gone.Away.X: {comment: Gone.}\n", ["O101"]),
        ("Vehicle.Gone.Away.X: {delete: true}\n", ["O102"]),
    ],
)
def test_one_cause_has_one_finding(tree, text, told):
    assert [f.rule for f in lint_paths([overlay(tree, "own.vspec", text)]).findings] == told


def test_an_old_path_below_an_instance_proposes_the_new_one(tmp_path):
    path = tmp_path / "old.vspec"
    path.write_text("Vehicle.Cabin.Door.Row1.Left.IsOpen: {comment: Old.}\n")
    (finding,) = lint_paths([path]).findings
    assert "'Vehicle.Cabin.Door.Row1.DriverSide.IsOpen'" in finding.fix


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("Cabin.Door.Row1.Left.IsOpen", ["Cabin.Door.Row1.DriverSide.IsOpen", "Cabin.Door.Row1.PassengerSide.IsOpen"]),
        ("Body.Mirrors.Left.IsHeatingOn", ["Body.Mirrors.DriverSide.IsHeatingOn"]),
    ],
)
def test_an_old_path_that_an_overlay_defines_anew_proposes_the_new_one_too(tmp_path, old, new):
    path = tmp_path / "old.vspec"
    path.write_text(f"Vehicle.{old}: {{type: actuator, datatype: boolean, description: Old.}}\n")
    (finding,) = lint_paths([path]).findings
    assert finding.rule == codes.BRANCH_UNDEFINED.id
    assert all(f"'Vehicle.{each}'" in finding.fix for each in new)


def test_a_branch_beside_instances_is_no_instance(tmp_path):
    path = tmp_path / "other.vspec"
    path.write_text("Vehicle.Cabin.Door.Frame.Width: {type: attribute, datatype: float, description: Width.}\n")
    (finding,) = lint_paths([path]).findings
    assert (finding.rule, finding.path) == (codes.BRANCH_UNDEFINED.id, "Vehicle.Cabin.Door.Frame")


def test_what_is_below_a_node_of_unknown_type_is_not_misplaced(tmp_path):
    """Other languages have other types: each is reported once, without findings that follow from it."""
    path = tmp_path / "services.vspec"
    path.write_text(
        "Services: {type: branch, description: Services.}\n"
        "Services.Move: {type: procedure, description: Moves.}\n"
        "Services.Move.Input: {type: iostruct, description: What goes in.}\n"
        "Services.Move.Input.Way: {type: property, datatype: float, description: How far.}\n"
    )
    assert [(f.rule, f.line) for f in lint_paths([path]).findings] == [
        (codes.TYPE_MISSING_OR_UNKNOWN.id, 2), (codes.TYPE_MISSING_OR_UNKNOWN.id, 3),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "fix"),
    [
        ("- Vehicle:\n  type: branch\n", "Write `Vehicle.Speed:` in place of `- Vehicle.Speed:`"),
        ("- Vehicle:\n    type: branch\n", "Write `Vehicle.Speed:` in place of `- Vehicle.Speed:`"),
        ("- 1\n- 2\n", "Write paths such as `Vehicle.Speed:`"),
        (
            "Vehicle: {type: branch, description: A vehicle., children: {Speed: {type: sensor, description: Speed.}}}\n",
            "Write `Vehicle.Speed:` at the beginning of a line",
        ),
    ],
)
def test_other_forms_of_a_tree_are_recognised(tmp_path, text, fix):
    path = tmp_path / "tree.vspec"
    path.write_text(text)
    (finding,) = lint_paths([path]).findings
    assert finding.fix.startswith(fix)


@pytest.mark.parametrize(
    ("datatype", "fix"),
    [("Points1", "Did you mean 'Types.Point'?"), ("x", "Use one such as")],
)
def test_an_unknown_datatype_says_what_to_write(tmp_path, datatype, fix):
    path = tmp_path / "types.vspec"
    path.write_text(
        "Types: {type: branch, description: Types.}\n"
        "Types.Point: {type: struct, description: A point.}\n"
        "Types.Point.X: {type: property, datatype: float, description: Along.}\n"
        "Types.Deep: {type: branch, description: More.}\n"
        "Types.Deep.Line: {type: struct, description: A line.}\n"
        f"Types.Deep.Line.From: {{type: property, datatype: {datatype}, description: Where it begins.}}\n"
    )
    (finding,) = lint_paths([path]).findings
    assert finding.fix.startswith(fix)


def test_a_file_that_is_no_text_is_told_so(tmp_path):
    path = tmp_path / "picture.vspec"
    path.write_bytes(b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR\xff")
    (finding,) = lint_paths([path]).findings
    assert (finding.rule, finding.message) == ("R002", "The file is not a text.")


def test_files_of_struct_types_in_several_folders_have_nothing_to_do_with_each_other(tmp_path):
    for name in ("One", "Two"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "types.vspec").write_text(
            f"{name}: {{type: branch, description: Types.}}\n"
            f"{name}.Pair: {{type: struct, description: A pair.}}\n"
            f"{name}.Pair.First: {{type: property, datatype: uint8, description: The first.}}\n"
        )
    assert lint_paths([tmp_path]).findings == ()
