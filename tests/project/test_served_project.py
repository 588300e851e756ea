"""The functions that a service hosts in a project: the shipped ones do not fit the catalogue of a company."""

import pytest

from sigcat.project.read_project import read_project
from tests.project.company import PROJECT, write_company


@pytest.mark.parametrize(
    ("line", "catalogues", "functions"),
    [("", True, False), ("shipped = true\n", True, True), ("shipped = false\n", False, False)],
)
def test_shipped_examples_are_hidden_beside_own_functions(tmp_path, line, catalogues, functions):
    file = write_company(tmp_path) / "sigcat.toml"
    file.write_text(line + PROJECT)
    project = read_project(file)
    assert (project.has_shipped_catalogues, project.has_shipped_functions) == (catalogues, functions)


def test_a_project_without_its_own_catalogue_or_functions_shows_the_examples(tmp_path):
    file = tmp_path / "sigcat.toml"
    for text in ("", '[[catalogue]]\nid = "a"\nrelease = "shipped"\n'):
        file.write_text(text)
        assert read_project(file).has_shipped_functions
