"""Exported JSON of releases before VSS 5.0: a `uuid` at each node, instances that repeat little, words of the time."""

import json
import uuid
from typing import Any

import pytest

from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.exported_json import UNKNOWN, catalogue_from_export
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused
from tests.catalogue.comparing.running import sigcat, signal
from tests.catalogue.trees import ROOT, catalogue_of

MIRRORS = "Vehicle.Mirrors:\n  type: branch\n  instances: [Left, Right]\n  description: M.\n"
DOORS = 'Vehicle.Doors:\n  type: branch\n  instances: ["Row[1,2]", [Left, Right]]\n  description: D.\n'
TREE = ROOT + MIRRORS + signal("Vehicle.Mirrors.Pan") + DOORS + signal("Vehicle.Doors.Gap") + signal("Vehicle.Speed")


def older_export(nodes: dict[str, dict[str, Any]]) -> bytes:
    """The nodes by path, nested, each with a `uuid` of its path, as tools of that time wrote them."""
    tree: dict[str, Any] = {"children": {}}
    for path, values in nodes.items():
        place = tree
        *above, name = path.split(".")
        for branch in above:
            place = place["children"][branch]
        children: dict[str, Any] = {"children": {}} if values["type"] == "branch" else {}
        place["children"][name] = {**children, **values, "uuid": uuid.uuid5(uuid.NAMESPACE_OID, path).hex}
    return json.dumps(tree["children"], sort_keys=True).encode()


def exported(tree: Catalogue) -> dict[str, dict[str, Any]]:
    return {path: dict(node.values) for path, node in tree.nodes.items()}


def read(nodes: dict[str, dict[str, Any]]) -> Catalogue:
    return catalogue_from_export(older_export(nodes), "older.json")


def vehicle(**values: Any) -> dict[str, dict[str, Any]]:
    """A vehicle with one signal, `Vehicle.X`."""
    return {"Vehicle": {"type": "branch", "description": "V."}, "Vehicle.X": {"description": "X.", **values}}


def test_a_uuid_is_no_difference():
    tree, export = catalogue_of(TREE), read(exported(catalogue_of(TREE)))
    assert compare(tree, export, UNKNOWN) == compare(export, tree, UNKNOWN) == ()


def test_instances_are_found_though_each_has_a_uuid_of_its_own():
    tree = catalogue_of(TREE)
    export = read(exported(tree))
    assert {path: node.template for path, node in export.nodes.items()} == {
        path: node.template for path, node in tree.nodes.items()
    }


def test_instances_are_found_though_they_repeat_only_the_texts_of_their_branch():
    nodes = exported(catalogue_of(TREE))
    nodes["Vehicle.Mirrors"]["deprecation"] = "v3.1 gone"
    assert read(nodes).nodes["Vehicle.Mirrors.Left.Pan"].template == "Vehicle.Mirrors.Pan"


def test_a_branch_with_another_text_is_no_instance():
    nodes = exported(catalogue_of(TREE))
    nodes["Vehicle.Mirrors.Left"]["description"] = "Another."
    assert read(nodes).nodes["Vehicle.Mirrors.Left.Pan"].template == "Vehicle.Mirrors.Left.Pan"


def test_changes_since_an_older_export_are_told_once_for_all_instances(tmp_path, capsys):
    (tmp_path / "old.json").write_bytes(older_export(exported(catalogue_of(TREE))))
    (tmp_path / "new.vspec").write_text(TREE.replace("Value of Vehicle.Mirrors.Pan.", "Turned aside."))
    assert sigcat("diff", str(tmp_path / "old.json"), str(tmp_path / "new.vspec")) == 0
    out = capsys.readouterr().out
    assert "~ Pan  2 instances" in out
    assert out.endswith("1 change: 1 text only\n")


def test_words_of_before_are_read_as_the_present_ones():
    export = read(vehicle(type="attribute", datatype="string", enum=["OFF", "ON"], value="OFF"))
    values = export.nodes["Vehicle.X"].values
    assert (values["allowed"], values["default"]) == (["OFF", "ON"], "OFF")
    assert [(finding.rule, finding.severity) for finding in export.findings] == [("V026", "warning")] * 2


def test_what_was_not_checked_then_is_a_warning():
    findings = read(vehicle(type="sensor", datatype="uint8", max=300)).findings
    assert [(finding.rule, finding.severity) for finding in findings] == [("V008", "warning")]


def test_an_export_without_uuid_is_checked_as_today():
    nodes = json.loads(older_export(vehicle(type="sensor", datatype="uint8", max=300)))
    del nodes["Vehicle"]["uuid"], nodes["Vehicle"]["children"]["X"]["uuid"]
    findings = catalogue_from_export(json.dumps(nodes).encode(), "export.json").findings
    assert [(finding.rule, finding.severity) for finding in findings] == [("V008", "error")]


def test_what_is_no_tree_is_refused_at_any_age(tmp_path):
    (tmp_path / "old.json").write_text('{"Vehicle": {"type": "branch", "uuid": "1", "children": [1]}}')
    (tmp_path / "new.vspec").write_text(TREE)
    with pytest.raises(InputRefused):
        _ = catalogue_from_export(b"[1]", "old.json")
    assert sigcat("diff", str(tmp_path / "old.json"), str(tmp_path / "new.vspec")) == 1
