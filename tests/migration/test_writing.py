"""Files are written together: all of them, or none."""

import os

import pytest

from sigcat.errors import UsageError
from sigcat.migration.writing import write_all

OVERLAY = "Vehicle.Coolant: {comment: x}\n"


def test_nothing_is_written_if_one_file_cannot_be(tmp_path):
    good = tmp_path / "good"
    good.write_bytes(b"before")
    with pytest.raises(UsageError, match="No file was changed"):
        write_all({good: b"after", tmp_path / "missing/bad": b"after"})
    assert good.read_bytes() == b"before"
    assert [path.name for path in tmp_path.iterdir()] == ["good"]


def test_replaced_files_are_restored(tmp_path):
    good, blocked = tmp_path / "good", tmp_path / "blocked"
    good.write_bytes(b"before")
    (blocked / "in").mkdir(parents=True)
    with pytest.raises(UsageError):
        write_all({good: b"after", tmp_path / "new": b"x", blocked: b"after"})
    assert good.read_bytes() == b"before"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["blocked", "good"]


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such permissions")
def test_permissions_and_links_stay(sides):
    target = sides.write("ours.vspec", OVERLAY)
    target.chmod(0o600)
    (sides.folder / "link.vspec").symlink_to(target)
    assert sides.run("link.vspec").status == 0
    assert target.read_text().startswith("Vehicle.Engine.Coolant")
    assert target.stat().st_mode & 0o777 == 0o600
    assert (sides.folder / "link.vspec").is_symlink()


@pytest.mark.parametrize("option", ["--dry-run", "--check"])
def test_some_options_write_nothing(sides, option):
    sides.write("ours.vspec", OVERLAY)
    result = sides.run(option)
    assert (sides.text("ours.vspec"), len(list(sides.folder.iterdir()))) == (OVERLAY, 1)
    assert result.status == (1 if option == "--check" else 0)
    if option == "--dry-run":
        assert "-Vehicle.Coolant: {comment: x}\n+Vehicle.Engine.Coolant: {comment: x}\n" in result.output


def test_the_report_lists_changes_and_findings(sides):
    sides.write("ours.vspec", f"{OVERLAY}Vehicle.Gone: {{comment: x}}\n")
    sides.run("--report", "report.md")
    report = sides.text("report.md")
    assert "1 change in 1 file, 1 finding." in report
    assert "- line 1: `Vehicle.Coolant` → `Vehicle.Engine.Coolant`" in report
    assert "`ours.vspec:2` error D003" in report


def test_layers_of_the_sides_are_not_changed(sides):
    sides.write("ours.vspec", OVERLAY)
    assert sides.run("-l", "ours.vspec").status in (0, 1)
    assert sides.text("ours.vspec") == OVERLAY


@pytest.mark.parametrize("text", ["A", "=B", "A="])
def test_a_choice_has_two_paths(sides, text):
    result = sides.run("--choose", text)
    assert result.status == 2
    assert "write the old and the new path" in result.messages


def test_a_read_only_file_and_all_others_stay(sides):
    before = "time,Vehicle.Coolant\n0,20\n"
    recording, overlay = sides.write("drive.csv", before), sides.write("ours.vspec", OVERLAY)
    recording.chmod(0o444)
    result = sides.run()
    assert result.status == 2
    assert "drive.csv is read-only" in result.messages
    assert (recording.read_text(), overlay.read_text()) == (before, OVERLAY)
    assert not [path for path in sides.folder.iterdir() if path.name.startswith(".")]
