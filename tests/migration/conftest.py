"""The trees, and an empty folder that is the current one."""

import pytest

from tests.migration.sides import Sides


@pytest.fixture
def sides(tmp_path, monkeypatch, capsys):
    trees, folder = tmp_path / "trees", tmp_path / "project"
    trees.mkdir()
    folder.mkdir()
    monkeypatch.chdir(folder)
    return Sides(folder, trees, capsys)
