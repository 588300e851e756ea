"""A service that watches its files says that its project file has changed."""

import logging
from pathlib import Path

import pytest

from sigcat.project.changed_file import ProjectFile


def test_each_change_is_logged_once(tmp_path: Path, caplog: pytest.LogCaptureFixture):
    file = tmp_path / "sigcat.toml"
    file.write_text("watch = true\n")
    watched = ProjectFile(file)
    with caplog.at_level(logging.WARNING):
        watched.reload_changed()
        assert caplog.messages == []
        file.write_text("watch = true\nshipped = false\n")
        watched.reload_changed()
        watched.reload_changed()
        assert caplog.messages == [f"{file} has changed: start the service again to use shipped"]
        file.unlink()
        watched.reload_changed()
    assert len(caplog.messages) == 2


@pytest.mark.parametrize(
    ("name", "before", "after", "expected"),
    [
        ("sigcat.toml", "functions = ['a']\n[lint]\nignore = []\n", "functions = ['b']\n[lint]\nignore = ['V']\n", "use functions, lint"),
        ("pyproject.toml", "[tool.sigcat]\nwatch = true\n", "[tool.sigcat]\ndbc = ['a']\n", "use dbc, watch"),
        ("sigcat.toml", "watch = true\n", "watch = \n", "use it"),
        ("pyproject.toml", "[tool.sigcat]\n", "tool = 1\n[project]\n", ""),
        ("sigcat.toml", "watch = true\n", "watch = true  # now\n", ""),
    ],
)  # fmt: skip
def test_the_log_names_the_changed_keys(name, before, after, expected, tmp_path, caplog):
    file = tmp_path / name
    file.write_text(before)
    watched = ProjectFile(file)
    file.write_text(after)
    watched.reload_changed()
    assert caplog.messages == ([f"{file} has changed: start the service again to {expected}"] if expected else [])


def test_a_service_without_a_project_watches_nothing(caplog: pytest.LogCaptureFixture):
    ProjectFile(None).reload_changed()
    assert caplog.messages == []
