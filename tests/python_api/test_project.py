"""Projects of the Python API: the nearest sigcat.toml, its catalogues, rules and functions."""

import pytest

import sigcat

CONFIGURATION = """\
functions = ["functions"]

[[catalogue]]
id = "acme"
title = "ACME"
release = "shipped"
overlays = ["acme.vspec"]

[lint]
severity = { V003 = "info" }
"""
OVERLAY = "Vehicle.Noise:\n  type: sensor\n  datatype: float\n  unit: dB\n  description: Sound level.\n"
FUNCTION = """\
function: Noise
description: Watches the noise.
responsible: A team
components:
  - name: Noise
    runnables:
      - {interface: Step, data: [{path: Vehicle.Noise, role: consumed, init: 0, asil: QM}]}
define:
  scheduling:
    Step: {description: Watches., cycleTime: 100, asil: QM}
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "functions").mkdir()
    (tmp_path / "sigcat.toml").write_text(CONFIGURATION)
    (tmp_path / "acme.vspec").write_text(OVERLAY)
    (tmp_path / "functions/noise.yaml").write_text(FUNCTION)
    return tmp_path


def test_the_project_is_found_upwards_and_its_paths_do_not_depend_on_the_current_folder(folder, monkeypatch):
    monkeypatch.chdir(folder / "functions")
    project = sigcat.open_project()
    monkeypatch.chdir("/")
    assert (project.root, project.catalogues) == (folder, ("acme",))
    assert (project.catalogue().title, "Vehicle.Noise" in project.catalogue("acme")) == ("ACME", True)
    assert [function.name for function in project.catalogue().resolve(*project.functions)] == ["Noise"]


def test_severities_of_the_project_hold_for_a_text(folder):
    text = "Vehicle.Noise:\n  datatype: flaot\n"
    (found,) = [each for each in sigcat.open_project(folder).catalogue().lint(text) if each.rule == "V003"]
    assert found.severity == "info"


def test_users_of_a_branch_are_those_of_the_nodes_below_it(folder):
    project = sigcat.open_project(folder)
    assert project.users("Vehicle.Noise") == tuple(u for u in project.users("Vehicle") if u.path == "Vehicle.Noise")
    assert project.users("Vehicle.Cabin") == ()
    with pytest.raises(sigcat.NotFound, match=r"Vehicle\.Noise"):
        project.users("Vehicle.Noize")


def test_a_function_file_with_errors_is_reported_and_the_others_are_used(folder):
    (folder / "functions/broken.yaml").write_text(FUNCTION.replace("Noise", "Other").replace("consumed", "eaten"))
    project = sigcat.open_project(folder)
    assert [use.function for use in project.users("Vehicle.Noise")] == ["Noise"]
    assert {finding.file.rpartition("/")[2] for finding in project.function_errors()} == {"broken.yaml"}


def test_reload_reads_changed_files_and_returned_catalogues_stay(folder):
    project = sigcat.open_project(folder)
    before = project.catalogue()
    (folder / "acme.vspec").write_text(OVERLAY.replace("Sound level.", "Sound level in the cabin."))
    project.reload()
    assert before["Vehicle.Noise"].description == "Sound level."
    assert project.catalogue()["Vehicle.Noise"].description == "Sound level in the cabin."
    (folder / "acme.vspec").write_text(OVERLAY.replace("sensor", "sensr"))
    project.reload()
    with pytest.raises(sigcat.InputRefused, match="V001"):
        project.catalogue()


def test_without_a_project_the_shipped_catalogue_and_functions_are_open(tmp_path):
    project = sigcat.open_project(tmp_path)
    assert (project.catalogues, project.functions, project.root) == (("interfaces",), (), tmp_path)
    assert "CoreAcc" in {use.function for use in project.users("Vehicle.Speed")}


def test_everything_wrong_with_the_project_file_is_raised(folder):
    (folder / "sigcat.toml").write_text(
        CONFIGURATION.replace("overlays", "overlay").replace("functions =", "function =")
    )
    with pytest.raises(sigcat.InputRefused) as refused:
        sigcat.open_project(folder)
    assert {finding.line for finding in refused.value.findings} == {1, 7}
    assert any("sigcat.toml:7" in note for note in refused.value.__notes__)


def test_an_unknown_catalogue_is_not_found(folder):
    project = sigcat.open_project(folder)
    with pytest.raises(sigcat.NotFound, match="Unknown catalogue 'acmee'") as raised:
        project.catalogue("acmee")
    assert raised.value.nearest == ("acme",)


def test_a_vehicle_is_a_catalogue(folder):
    (folder / "sigcat.toml").write_text(f'{CONFIGURATION}\n[[vehicle]]\nid = "coupe"\nwithout = ["Vehicle.ADAS"]\n')
    project = sigcat.open_project(folder)
    assert project.vehicles == ("vehicle:coupe",)
    assert "Vehicle.Noise" in project.catalogue("vehicle:coupe")
    assert "Vehicle.ADAS" not in project.catalogue("vehicle:coupe")
    assert {change.path for change in project.diff("vehicle:coupe", "acme")} >= {"Vehicle.ADAS"}
    with pytest.raises(sigcat.NotFound, match="vehicle:coupe"):
        project.catalogue("vehicle:coup")
