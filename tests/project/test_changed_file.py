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
        assert caplog.messages == [f"{file} has changed: start the service again to use it"]
        file.unlink()
        watched.reload_changed()
    assert len(caplog.messages) == 2


def test_a_service_without_a_project_watches_nothing(caplog: pytest.LogCaptureFixture):
    ProjectFile(None).reload_changed()
    assert caplog.messages == []
