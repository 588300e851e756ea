"""Try before you save: an overlay yields nodes, findings and changes, and nothing is stored."""

import io
import json
from types import SimpleNamespace

import pytest

from sigcat.catalogue.comparing.trial import try_overlay
from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.data import ROOT_FILE
from tests.catalogue.comparing.running import sigcat, signal
from tests.catalogue.trees import ROOT, catalogue_of

TREE = ROOT + signal("Vehicle.Speed", max=100) + signal("Vehicle.Heat")


def test_it_yields_the_nodes_that_change_and_the_changes():
    base = catalogue_of(TREE)
    overlay = "Vehicle.Speed:\n  max: 90\n" + signal("Vehicle.New")
    trial = try_overlay(base, overlay.encode(), "posted")
    assert [node.path for node in trial.nodes] == ["Vehicle.Speed", "Vehicle.New"]
    assert trial.nodes[0].values["max"] == 90
    assert trial.nodes[0].definition.origin("max").overlay == "posted"
    assert [(change.kind, change.compatibility) for change in trial.changes] == [
        ("added", "compatible"),
        ("changed", "compatible"),
    ]
    assert trial.findings == ()


def test_the_catalogue_itself_stays_as_it_is():
    base = catalogue_of(TREE)
    digest = base.digest
    trial = try_overlay(base, b"Vehicle.Speed:\n  max: 90\n", "posted")
    assert base.nodes["Vehicle.Speed"].values["max"] == 100
    assert catalogue_of(TREE).digest == digest != trial.catalogue.digest


def test_what_the_overlay_deletes_is_a_change_without_a_node():
    trial = try_overlay(catalogue_of(TREE), b"Vehicle.Heat:\n  type: sensor\n  datatype: float\n  delete: true\n", "x")
    assert trial.nodes == ()
    assert [(change.kind, change.path) for change in trial.changes] == [("removed", "Vehicle.Heat")]


def test_only_what_the_overlay_brings_is_found():
    base = catalogue_of(TREE, "Vehicle.Nothing.*:\n  max: 1\n")
    assert len(base.findings) == 1
    trial = try_overlay(base, b"Vehicle.Speed:\n  min: high\n", "posted")
    assert [(finding.rule, finding.file, finding.line) for finding in trial.findings] == [("V004", "posted", 2)]


def test_what_an_old_release_is_forgiven_stays_forgiven():
    base = catalogue_of(ROOT + signal("Vehicle.A", max=300, datatype="uint8"))
    (error,) = base.findings
    forgiven = base.with_findings((error._replace(severity="warning"),))
    assert try_overlay(forgiven, signal("Vehicle.B").encode(), "posted").findings == ()


@pytest.mark.parametrize(
    "hostile", [b"#include /etc/passwd\n", b"[" * 50_000, b"\xff", b"A: [1]\n", b"Vehicle.Speed:\n  type: [x]\n"]
)
def test_hostile_text_is_a_finding(hostile):
    assert try_overlay(catalogue_of(TREE), hostile, "posted").findings


def test_struct_types_stay_types():
    types = "T:\n  type: branch\nT.Place:\n  type: struct\nT.Place.X:\n  type: property\n  datatype: float\n"
    layers = [layer_from_text(text.encode(), "text", is_overlay=False) for text in (ROOT, types)]
    base = compose(layers[:1], types=layers[1:])
    trial = try_overlay(base, signal("Vehicle.Place", datatype="T.Place").encode(), "posted")
    assert trial.findings == ()
    assert [node.path for node in trial.nodes] == ["Vehicle.Place"]


# -- the command --------------------------------------------------------------------------------------------------


@pytest.fixture
def files(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tree.vspec").write_text(TREE)
    (tmp_path / "good.vspec").write_text("Vehicle.Speed:\n  max: 90\n#include more.vspec\n")
    (tmp_path / "more.vspec").write_text("Vehicle.Heat:\n  comment: More.\n")
    (tmp_path / "bad.vspec").write_text("Vehicle.Speed:\n  datatype: flaot\n")


def test_the_command_shows_changes_and_nodes(files, capsys):
    assert sigcat("try", "good.vspec", "-s", "tree.vspec") == 0
    assert capsys.readouterr().out == (
        "Vehicle\n"
        "  ~ Heat  [text only]\n"
        "      comment: (none) → More.\n"
        "  ~ Speed  [compatible]\n"
        "      max: 100 → 90\n"
        "\n"
        "2 changes: 1 compatible, 1 text only\n"
        "\n"
        "Vehicle.Speed\n"
        "  type           sensor\n"
        "  datatype       float\n"
        "  description    Value of Vehicle.Speed.\n"
        "  max            90\n"
        "\n"
        "Vehicle.Heat\n"
        "  type           sensor\n"
        "  datatype       float\n"
        "  description    Value of Vehicle.Heat.\n"
        "  comment        More.\n"
    )


def test_an_overlay_with_errors_is_told_in_full_and_fails(files, capsys):
    assert sigcat("try", "bad.vspec", "-s", "tree.vspec") == 1
    out = capsys.readouterr().out
    assert "bad.vspec:2:13: error V003 'flaot' is not a datatype." in out
    assert "datatype: float → flaot" in out


def test_json_has_nodes_findings_and_changes(files, capsys):
    assert sigcat("try", "bad.vspec", "-s", "tree.vspec", "--format", "json") == 1
    data = json.loads(capsys.readouterr().out)
    assert [node["path"] for node in data["nodes"]] == ["Vehicle.Speed"]
    assert data["findings"][0]["rule"] == "V003"
    assert data["summary"]["worst"] == "breaking"


def test_an_overlay_can_come_from_standard_input(files, capsys, monkeypatch):
    monkeypatch.setattr("sys.stdin", SimpleNamespace(buffer=io.BytesIO(b"Vehicle.Speed:\n  max: 90\n")))
    assert sigcat("try", "-", "-s", "tree.vspec") == 0
    assert "max: 100 → 90" in capsys.readouterr().out


def test_without_a_tree_the_shipped_one_is_meant(files, capsys):
    assert sigcat("try", "good.vspec") == 1
    assert ROOT_FILE.is_file()
    assert "~ Speed" in capsys.readouterr().out


def test_a_missing_overlay_is_one_line(files, capsys):
    assert sigcat("try", "missing.vspec", "-s", "tree.vspec") == 2
    assert capsys.readouterr().err == "sigcat: missing.vspec: there is no such file\n"


def test_findings_are_findings():
    trial = try_overlay(catalogue_of(TREE), b"Nonsense", "posted")
    assert [finding.rule for finding in trial.findings] == ["R007"]


def test_a_node_that_does_not_exist_is_taken_for_a_slip_of_the_pen():
    (finding,) = try_overlay(catalogue_of(TREE), b"Vehicle.Sped:\n  max: 90\n", "posted").findings
    assert finding.rule == "V001"
    assert finding.fix.startswith("Did you mean 'Vehicle.Speed'")
