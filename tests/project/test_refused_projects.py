"""A project that cannot work is an error with exit status 2, and says what to do."""

from pathlib import Path

import pytest

from sigcat.cli import main
from tests.project.company import PROJECT, write_company

BRANCHES = "Vehicle:\n  type: branch\n  description: A vehicle.\n"


@pytest.fixture
def company(tmp_path, monkeypatch):
    monkeypatch.chdir(write_company(tmp_path))
    return tmp_path


@pytest.mark.parametrize(
    "command", [["lint"], ["show", "Vehicle.Speed"], ["function", "validate"], ["config"]], ids=" ".join
)
def test_an_overlay_that_is_listed_and_missing(company, capsys, command):
    Path("sigcat.toml").write_text(PROJECT.replace("overlays/*.vspec", "overlays/acne.vspec"))
    assert main(command) == 2
    assert "sigcat.toml:14: error C005 There is no file 'overlays/acne.vspec'." in capsys.readouterr().err


def test_an_overlay_of_an_option_that_is_missing(company, capsys):
    assert main(["lint", "-l", "acne.vspec"]) == 2
    assert "acne.vspec: there is no such file" in capsys.readouterr().err


def test_wildcards_that_match_nothing(company, capsys):
    Path("sigcat.toml").write_text(PROJECT.replace("overlays/*.vspec", "overlay/*.vspec"))
    assert main(["lint"]) == 2
    assert "There is no file 'overlay/*.vspec'." in capsys.readouterr().err


@pytest.mark.parametrize("command", [["lint"], ["search", "speed"], ["function", "validate"]], ids=" ".join)
def test_a_catalogue_without_signals(company, capsys, command):
    Path("branches.vspec").write_text(BRANCHES)
    text = PROJECT.replace('release = "shipped"', 'spec = "branches.vspec"').replace(
        'overlays = ["overlays/*.vspec"]', ""
    )
    Path("sigcat.toml").write_text(text)
    assert main(command) == 2
    assert "branches.vspec: the catalogue has no signals" in capsys.readouterr().err


def test_a_path_of_a_lint_without_a_file_to_check(company, capsys):
    Path("empty").mkdir()
    assert main(["lint", "overlays", "empty"]) == 2
    assert "Nothing to check: empty has no .vspec" in capsys.readouterr().err


def test_a_catalogue_that_is_misspelled_is_proposed(company, capsys):
    assert main(["show", "Vehicle.Speed", "-s", "acne"]) == 2
    assert "Did you mean acme" in capsys.readouterr().err
