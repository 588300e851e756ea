"""A service that watches its files takes a changed project file over, and says which keys need a new start."""

import logging
from collections.abc import Sequence
from pathlib import Path

import pytest

from sigcat import codes
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding
from sigcat.project.changed_file import ProjectFile

FINDING = codes.NOT_TOML.finding("It is no TOML.", "sigcat.toml", 1)


class Service:
    """Notes what it is asked to take, and refuses it if it has an error."""

    def __init__(self) -> None:
        self.error: Exception | None = None
        self.taken = 0
        self.shown: list[Sequence[Finding]] = []

    def take(self, file: Path) -> None:
        self.taken += 1
        if self.error is not None:
            raise self.error

    def watched(self, file: Path | None) -> ProjectFile:
        return ProjectFile(file, self.take, self.shown.append)


def look_twice(watched: ProjectFile) -> None:
    """A file that has just changed may be half written: it is read at the next look."""
    watched.reload_settled()
    watched.reload_settled()


def test_each_change_is_taken_once(tmp_path: Path):
    file = tmp_path / "sigcat.toml"
    file.write_text("watch = true\n")
    service = Service()
    watched = service.watched(file)
    watched.reload_settled()
    assert service.taken == 0
    file.write_text("watch = true\nshipped = false\n")
    watched.reload_settled()
    assert service.taken == 0
    watched.reload_settled()
    watched.reload_settled()
    assert (service.taken, service.shown) == (1, [()])


def test_a_file_that_a_wildcard_matches_comes_and_goes(tmp_path: Path):
    file = tmp_path / "sigcat.toml"
    file.write_text('[[catalogue]]\nid = "own"\noverlays = ["overlays/*.vspec"]\n')
    service = Service()
    watched = service.watched(file)
    overlay = tmp_path / "overlays" / "seats.vspec"
    overlay.parent.mkdir()
    overlay.touch()
    look_twice(watched)
    assert service.taken == 1
    (overlay.parent / "notes.txt").touch()
    look_twice(watched)
    assert service.taken == 1
    overlay.unlink()
    look_twice(watched)
    assert service.taken == 2


@pytest.mark.parametrize(
    ("error", "shown"),
    [
        (InputRefused("it cannot be used", (FINDING,)), ("C001", "It is no TOML.")),
        (UsageError("no catalogue is left to host"), ("C003", "no catalogue is left to host")),
    ],
)
def test_the_findings_of_an_invalid_file_are_logged_and_shown_until_it_is_valid(error, shown, tmp_path, caplog):
    file = tmp_path / "sigcat.toml"
    file.write_text("")
    service = Service()
    watched = service.watched(file)
    service.error = error
    file.write_text("shipped = 1")
    look_twice(watched)
    ((finding,),) = service.shown
    assert (finding.rule, finding.message) == shown
    assert caplog.messages == [f"{file}: the file has errors; the last good state stays", finding.line_of_text]
    service.error = None
    file.write_text("shipped = true")
    look_twice(watched)
    assert service.shown[1:] == [()]


def test_a_file_that_is_emptied_is_reported_and_the_last_settings_stay(tmp_path):
    """An editor that is stopped between truncating and writing leaves such a file."""
    file = tmp_path / "sigcat.toml"
    file.write_text("shipped = true\n")
    service = Service()
    watched = service.watched(file)
    file.write_text("")
    look_twice(watched)
    assert service.taken == 0
    assert [(each.rule, each.message) for each in service.shown[0]] == [("C003", "The file is empty.")]
    file.write_text("# Nothing is set.\n")
    look_twice(watched)
    assert (service.taken, service.shown[1:]) == (1, [()])


def test_a_file_that_was_removed_is_reported(tmp_path):
    file = tmp_path / "sigcat.toml"
    file.write_text("")
    service = Service()
    watched = service.watched(file)
    service.error = UsageError(f"{file}: No such file or directory")
    file.unlink()
    look_twice(watched)
    assert [each.rule for each in service.shown[0]] == ["C005"]


@pytest.mark.parametrize(
    ("name", "before", "after", "keys"),
    [
        ("sigcat.toml", "functions = ['a']\n", "functions = ['b']\n[lint]\nignore = ['V']\n", ""),
        ("sigcat.toml", "[service]\nport = 1\n", "[registry]\ndatabase = 'a'\n[service]\nport = 2\n", "service, registry"),
        ("pyproject.toml", "[tool.sigcat]\nwatch = true\n", "[tool.sigcat]\ndbc = ['a']\n", "watch"),
        ("pyproject.toml", "[tool.sigcat]\n", "tool = 1\n[project]\n", ""),
    ],
)  # fmt: skip
def test_the_log_names_the_keys_that_need_a_new_start(name, before, after, keys, tmp_path, caplog):
    file = tmp_path / name
    file.write_text(before)
    watched = Service().watched(file)
    file.write_text(after)
    with caplog.at_level(logging.WARNING):
        look_twice(watched)
    assert caplog.messages == ([f"{file} has changed: start the service again to use {keys}"] if keys else [])


def test_a_service_without_a_project_watches_nothing():
    service = Service()
    look_twice(service.watched(None))
    assert service.taken == 0


def test_units_beside_the_file_come_and_go(tmp_path: Path):
    file, units = tmp_path / "sigcat.toml", tmp_path / "units.yaml"
    file.write_text('[[catalogue]]\nid = "own"\nrelease = "shipped"\n')
    service = Service()
    watched = service.watched(file)
    for change, taken in ((units.touch, 1), (units.unlink, 2)):
        change()
        look_twice(watched)
        assert service.taken == taken
