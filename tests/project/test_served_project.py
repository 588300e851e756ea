"""The functions that a service hosts in a project: the shipped ones do not fit the catalogue of a company."""

import json
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.cli import main
from sigcat.findings import has_errors
from sigcat.function.hosting import FunctionLibrary
from sigcat.project.read_project import read_project
from sigcat.web.site import create_site
from tests.project.company import PROJECT, write_company


@pytest.mark.parametrize(
    ("line", "catalogues", "functions"),
    [("", True, False), ("shipped = true\n", True, True), ("shipped = false\n", False, False)],
)
def test_shipped_examples_are_hidden_beside_an_own_catalogue(tmp_path, line, catalogues, functions):
    file = write_company(tmp_path) / "sigcat.toml"
    file.write_text(line + PROJECT)
    project = read_project(file)
    assert (project.has_shipped_catalogues, project.has_shipped_functions) == (catalogues, functions)


@pytest.mark.parametrize(
    ("text", "has_examples"), [("", True), ('[[catalogue]]\nid = "a"\nrelease = "shipped"\n', False)]
)
def test_examples_are_shown_where_no_catalogue_of_the_project_makes_them_errors(tmp_path, text, has_examples):
    file = tmp_path / "sigcat.toml"
    file.write_text(text)
    assert read_project(file).has_shipped_functions is has_examples


def test_the_service_has_the_units_and_functions_of_the_project(tmp_path, monkeypatch):
    monkeypatch.chdir(write_company(tmp_path))
    project = read_project(Path("sigcat.toml"))
    library = Library(project.catalogues)
    functions = FunctionLibrary(project.functions, has_shipped=project.has_shipped_functions, catalogues=library)
    assert library.default.source.id == "acme"
    assert library.default.catalogue.vocabulary.unit("ppm") is not None
    assert not has_errors(library.default.catalogue.findings)
    assert [file.id for file in functions.files] == ["cabin_air"]


OWN = "Vehicle.Cabin.Smoke: {type: sensor, datatype: float, description: Smoke.%s}\n"


def test_the_service_has_the_rules_of_the_project_as_lint_has(tmp_path, monkeypatch, capsys):
    assert main(["init", str(tmp_path / "proj")]) == 0
    monkeypatch.chdir(tmp_path / "proj")
    capsys.readouterr()
    project = read_project(Path("sigcat.toml"))
    library = Library((*project.catalogues, *shipped_sources()))
    site = TestClient(create_site(library, lint=project.lint))
    for owner, expected in (("", ["OWN001"]), (", owner: Cabin team", [])):
        text = OWN % owner
        found = site.post("/api/v1/lint?catalogue=proj", content=text).json()["findings"]
        assert [each["rule"] for each in found] == expected
        Path("posted.vspec").write_text(text)
        main(["lint", "--format", "json", "posted.vspec"])
        assert [each["rule"] for each in json.loads(capsys.readouterr().out)["findings"]] == expected


def test_rules_of_the_project_are_not_about_what_sigcat_ships(tmp_path, monkeypatch):
    assert main(["init", str(tmp_path / "proj")]) == 0
    monkeypatch.chdir(tmp_path / "proj")
    project = read_project(Path("sigcat.toml"))
    library = Library((*project.catalogues, *shipped_sources()))
    site = TestClient(create_site(library, lint=project.lint))
    for catalogue in ("proj", "interfaces", "vss"):
        found = site.get(f"/api/v1/catalogues/{catalogue}/findings").json()["findings"]
        assert [each["rule"] for each in found if each["rule"] in ("OWN001", "V117")] == []
