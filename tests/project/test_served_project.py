"""The functions that a service hosts in a project: the shipped ones do not fit the catalogue of a company."""

from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library
from sigcat.findings import has_errors
from sigcat.function.hosting import FunctionLibrary
from sigcat.project.read_project import read_project
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
