"""A project with several catalogues: each overlay is linted in those that list it, and the first one is the default."""

from pathlib import Path

import pytest

from sigcat.cli import main

PROJECT = """\
[[catalogue]]
id = "car"
release = "shipped"
overlays = ["overlays/car.vspec"]

[[catalogue]]
id = "trailer"
spec = "trailer/Trailer.vspec"
overlays = ["overlays/trailer.vspec"]
units = ["trailer/load_units.yaml"]

[[catalogue]]
id = "van"
release = "shipped"
overlays = ["overlays/car.vspec", "overlays/van.vspec"]
"""
TREE = "Trailer:\n  type: branch\n  description: A trailer.\n"
SIGNAL = "{path}:\n  type: sensor\n  datatype: float\n  unit: {unit}\n  description: A value of {path}.\n"
FILES = {
    "sigcat.toml": PROJECT,
    "trailer/Trailer.vspec": TREE + SIGNAL.format(path="Trailer.Load", unit="kg"),
    "trailer/load_units.yaml": "pallets:\n  definition: Pallets of 800 by 1200 mm.\n  unit: pallet\n  quantity: relation\n"
    "  allowed-datatypes: ['numeric']\n",
    "overlays/car.vspec": SIGNAL.format(path="Vehicle.Mirror", unit="degrees"),
    "overlays/van.vspec": "Vehicle.Mirror:\n  max: 90\n",
    "overlays/trailer.vspec": SIGNAL.format(path="Trailer.Pallets", unit="pallets"),
}


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_each_overlay_is_linted_over_its_own_tree_with_its_units(capsys):
    main(["lint", "--select", "V"])
    assert capsys.readouterr().out == "No findings.\n"


def test_an_overlay_in_the_wrong_catalogue_is_found(capsys):
    Path("sigcat.toml").write_text(PROJECT.replace("overlays/car.vspec", "overlays/trailer.vspec"))
    assert main(["lint", "--select", "V"]) == 1
    assert "V022 'Trailer.Pallets' is" in capsys.readouterr().out


def test_the_first_is_the_default_and_each_is_named_by_its_id(capsys):
    assert main(["show", "Vehicle.Mirror"]) == 0
    assert main(["show", "Trailer.Pallets"]) == 2
    assert main(["show", "Trailer.Pallets", "-s", "trailer"]) == 0
    assert main(["export", "csv", "-s", "trailer"]) == 0
    assert main(["diff", "car", "trailer", "--format", "json"]) == 0


def test_one_that_is_named_is_linted_alone(capsys):
    Path("overlays/car.vspec").write_text(SIGNAL.format(path="Vehicle.Mirror", unit="mirrors"))
    assert main(["lint", "overlays/trailer.vspec", "-s", "trailer", "--select", "V"]) == 0
