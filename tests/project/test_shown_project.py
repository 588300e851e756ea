"""`sigcat config --show`: every value, and where it comes from."""

from pathlib import Path

import pytest

from sigcat.cli import main
from tests.project.company import UNITS, write_company


@pytest.fixture(autouse=True)
def company(tmp_path, monkeypatch):
    monkeypatch.chdir(write_company(tmp_path))
    return tmp_path


def shown(capsys, *options):
    assert main(["config", "--show", *options]) == 0
    lines = (line.partition("#") for line in capsys.readouterr().out.splitlines())
    return {value.strip(): origin.strip() for value, _, origin in lines}


def test_values_of_the_project_have_their_line(capsys):
    lines = shown(capsys)
    assert lines["project = sigcat.toml"] == "found upwards"
    assert lines["units = units.yaml"] == "sigcat.toml:3"
    assert lines["rules = rules.yaml"] == "sigcat.toml:2"
    assert lines["deployment = deployment.yaml"] == "sigcat.toml:4"
    assert lines["lint.extended-attributes = owner"] == "sigcat.toml:8"
    assert lines["catalogue (default) = acme"] == "sigcat.toml:10"
    assert lines["overlays = overlays/acme.vspec"] == "sigcat.toml:14"
    assert lines["shipped functions = no"] == "default"
    assert lines["service.port = 8000"] == "default"


def test_options_and_the_environment_have_their_names(capsys, monkeypatch, company):
    (company / "more.yaml").write_text("")
    monkeypatch.setenv("SIGCAT_PORT", "8001")
    lines = shown(capsys, "-u", "more.yaml")
    assert lines["units = more.yaml"] == "-u"
    assert lines["service.port = 8001"] == "SIGCAT_PORT"
    monkeypatch.setenv("SIGCAT_CONFIG", "sigcat.toml")
    assert shown(capsys)["project = sigcat.toml"] == "SIGCAT_CONFIG"


def test_without_a_project_the_shipped_catalogue_is_shown(capsys):
    lines = shown(capsys, "--isolated")
    assert lines["project = none"] == "--isolated"
    assert lines["catalogue (default) = interfaces"] == "shipped"
    assert lines["shipped functions = yes"] == "default"


def test_units_that_are_found_have_no_line(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("sigcat.toml").write_text('[[catalogue]]\nid = "own"\nrelease = "shipped"\n')
    Path("units.yaml").write_text(UNITS)
    assert main(["config", "--show"]) == 0
    assert capsys.readouterr().out.count("beside the project file") == 2
