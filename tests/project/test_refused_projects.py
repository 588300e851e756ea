"""A project that cannot work is an error with exit status 2, and says what to do."""

import errno
import os
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
    assert "sigcat.toml:14:14: error C005 There is no file 'overlays/acne.vspec'." in capsys.readouterr().err


def test_an_overlay_of_an_option_that_is_missing(company, capsys):
    assert main(["lint", "-l", "acne.vspec"]) == 2
    assert "acne.vspec: there is no such file" in capsys.readouterr().err


def test_wildcards_that_match_nothing(company, capsys):
    Path("sigcat.toml").write_text(PROJECT.replace("overlays/*.vspec", "overlay/*.vspec"))
    assert main(["lint"]) == 2
    assert "There is no folder 'overlay'. Did you mean 'overlays'?" in capsys.readouterr().err


def test_a_misspelled_release_is_proposed(company, capsys):
    Path("sigcat.toml").write_text(PROJECT.replace('release = "shipped"', 'release = "shiped"'))
    assert main(["lint"]) == 2
    assert "No file, folder or release is named 'shiped'. Did you mean shipped?" in capsys.readouterr().err


def test_a_wildcard_for_folders_that_is_a_part_of_a_name(company, capsys):
    Path("sigcat.toml").write_text(PROJECT.replace("overlays/*.vspec", "**overlays.vspec"))
    assert main(["lint"]) == 2
    assert "`**` in '**overlays.vspec' must be the whole name of a folder" in capsys.readouterr().err


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


def _refuse_to_list(monkeypatch, folder):
    """Refuse to list a folder, as a system does for users who may not read it: the tests may run as root."""
    scan = os.scandir

    def scandir(path="."):
        if Path(path).name == folder:
            raise PermissionError(errno.EACCES, "Permission denied", str(path))
        return scan(path)

    monkeypatch.setattr(os, "scandir", scandir)


@pytest.mark.parametrize("command", [["lint"], ["show", "Vehicle.Speed"]], ids=" ".join)
def test_a_folder_of_overlays_that_cannot_be_read(company, capsys, monkeypatch, command):
    _refuse_to_list(monkeypatch, "overlays")
    assert main(command) == 2
    said = capsys.readouterr().err
    assert "sigcat.toml:14:14: error C005 'overlays' cannot be read: Permission denied." in said
    assert "There is no file" not in said


def test_a_folder_of_functions_that_cannot_be_read(company, capsys, monkeypatch):
    _refuse_to_list(monkeypatch, "functions")
    assert main(["config"]) == 2
    assert "sigcat.toml:1:15: error C005 'functions' cannot be read: Permission denied." in capsys.readouterr().err


def test_a_file_below_a_folder_that_cannot_be_read(company, capsys, monkeypatch):
    stat = Path.stat

    def refuse(path, **options):
        if path.name == "can.dbc":
            raise PermissionError(errno.EACCES, "Permission denied")
        return stat(path, **options)

    monkeypatch.setattr(Path, "stat", refuse)
    assert main(["config"]) == 2
    assert "sigcat.toml:5:9: error C005 'can.dbc' cannot be read: Permission denied." in capsys.readouterr().err


def test_what_matches_and_is_no_file_is_reported(company, capsys):
    Path("overlays/link.vspec").symlink_to("nothing")
    Path("overlays/folder.vspec").mkdir()
    os.mkfifo("overlays/pipe.vspec")
    assert main(["lint"]) == 2
    said = capsys.readouterr().err
    assert "sigcat.toml:14:14: error C005 'overlays/link.vspec' is a link to nothing." in said
    assert "sigcat.toml:14:14: error C005 'overlays/folder.vspec' must be a file, not a folder." in said
    assert "sigcat.toml:14:14: error C005 'overlays/pipe.vspec' must be a regular file." in said


def test_folders_that_a_wildcard_for_anything_matches_are_not_meant(company):
    Path("overlays/include").mkdir()
    Path("sigcat.toml").write_text(PROJECT.replace("overlays/*.vspec", "overlays/*"))
    assert main(["config"]) == 0


@pytest.mark.parametrize(
    ("before", "after", "place"),
    [
        ("overlays = ", "overlas = ", "14:1: error C002"),
        ('release = "shipped"', '  spec = "tree.vspec"', "13:11: error C005"),
        ('release = "shipped"', 'release = "v9.9"', "13:12: error "),
        ('["overlays/*.vspec"]', '[\n  "overlays/acme.vspec",\n  "overlays/acne.vspec",\n]', "16:4: error C005"),
        ('["functions"]', "['functions', 'function']", "1:28: error C005"),
        ('deployment = "deployment.yaml"', 'deployment = "deploy.yaml"', "4:15: error C005"),
        ("extended-attributes", "  extnded-attributes", "8:3: error L012"),
        ('id = "acme"', 'id = "a b"', "11:1: error C003"),
        ('id = "acme"\n', "", "10:1: error C004"),
        ('functions = ["functions"]', 'functions = "functions"', "1:1: error C003"),
    ],
)
def test_a_finding_has_the_column_of_its_key_or_value(company, capsys, before, after, place):
    assert before in PROJECT
    Path("sigcat.toml").write_text(PROJECT.replace(before, after))
    assert main(["lint"]) == 2
    assert f"sigcat.toml:{place}" in capsys.readouterr().err


def test_a_folder_that_is_called_like_the_project_file_is_not_passed_over(tmp_path, monkeypatch, capsys):
    (tmp_path / "sigcat.toml").mkdir()
    monkeypatch.chdir(tmp_path)
    assert main(["show", "Vehicle.Speed"]) == 2
    assert "sigcat.toml: Is a directory" in capsys.readouterr().err
