"""No input ends a lint: bytes of any kind, values of any kind at any place."""

import json
import os
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.composing.compose_part import compose_part
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.cli import main
from sigcat.data import INTERFACE_RULES
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.engine import found_in
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.posted import lint_text
from sigcat.rules.rule_set import RuleSet
from tests.properties import examples

EVERY_RULE = RuleSet(compiled_rules(INTERFACE_RULES))


@given(st.binary(max_size=300) | st.text("VehicleABab:.- \n[]{}#&*!'\"0", max_size=300).map(str.encode))
@examples(150)
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
     "Vehicle.Function.F.SafetyReaction.S", "Vehicle.Function.F.Mode.In", "Vehicle.*", "Vehicle..X", "Vehicle.A..X", "Vehicle.B.C",
     "Vehicle.Row1.B", "Other", "Nowhere.A", "Nowhere.B.C", "Nowhere.B..X"]
)  # fmt: skip
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.sampled_from(
        ["branch", "sensor", "uint8", "string", "F_E_ErrorSts", "F_Step", "Alive", "B", "Row[1,2]", "V1.0 moved to A.B", ""]
    ),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(ATTRIBUTES, inner, max_size=3),
    max_leaves=6,
)  # fmt: skip


@given(st.dictionaries(PATHS, st.dictionaries(ATTRIBUTES, VALUES, max_size=6), max_size=8))
@examples(150)
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
@examples(30)
def test_an_overlay_has_the_findings_that_it_has_when_the_whole_tree_is_checked(tree, other, overlay):
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


def test_an_empty_text_is_not_clean():
    assert [f.rule for f in lint_text(b" \n", "posted", compose([]), EVERY_RULE)] == ["Q003"]


def test_what_is_called_like_a_file_and_is_none_is_reported(tmp_path):
    (tmp_path / "a.vspec").write_text("Vehicle.Cabin: {type: branch, description: The cabin.}\n")
    (tmp_path / "link.vspec").symlink_to("nothing")
    (tmp_path / "folder.vspec").mkdir()
    os.mkfifo(tmp_path / "pipe.vspec")
    for name in ("units.yaml", "air.function.yaml", "package.json"):
        (tmp_path / name).symlink_to("nothing")
    found = lint_paths([tmp_path]).findings
    unreadable = {
        Path(finding.file).name: finding.message.removeprefix(repr(finding.file))
        for finding in found
        if finding.rule == "R012"
    }
    assert unreadable == {
        "link.vspec": " is a link to nothing.",
        "folder.vspec": " must be a file, not a folder.",
        "pipe.vspec": " must be a regular file.",
        "units.yaml": " is a link to nothing.",
        "air.function.yaml": " is a link to nothing.",
    }


def test_a_pipe_is_not_waited_for_by_a_repair(tmp_path, capsys):
    os.mkfifo(tmp_path / "pipe.vspec")
    assert main(["lint", "--isolated", "--fix", str(tmp_path)]) == 1
