"""What killed processes left is removed by the next one; what a living process or another program has is left alone."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from sigcat.cli.output import write_bytes
from sigcat.temporary_files import temporary_folder

PREFIX = "sigcat-test-of-folders-"
WAITING = f"""
import sys
from sigcat.temporary_files import temporary_folder
folder = temporary_folder({PREFIX!r})
print(folder.name, flush=True)
sys.stdin.read()
"""
LONG_AGO = (1_000_000_000, 1_000_000_000)


@pytest.fixture(autouse=True)
def _place(tmp_path, monkeypatch):
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.chdir(tmp_path)


def waiting():
    """A process that has a temporary folder, and the folder."""
    process = subprocess.Popen(
        [sys.executable, "-c", WAITING], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    return process, Path(process.stdout.readline().strip())


def ended(process, number):
    process.send_signal(number)
    process.communicate()


def test_a_folder_of_a_killed_process_is_removed():
    process, folder = waiting()
    ended(process, signal.SIGKILL)
    (folder / "kept" / "below").mkdir(parents=True)
    with temporary_folder(PREFIX) as mine:
        assert not folder.exists()
        assert Path(mine).is_dir()


def test_a_folder_of_a_living_process_stays():
    process, folder = waiting()
    os.utime(folder, LONG_AGO)
    with temporary_folder(PREFIX):
        assert folder.is_dir()
    ended(process, signal.SIGTERM)


@pytest.mark.parametrize("name", [f"{PREFIX}without-a-lock", "sigcat-other"])
def test_a_folder_that_may_be_of_others_stays(tmp_path, name):
    folder = tmp_path / name
    folder.mkdir()
    if name == "sigcat-other":
        (folder / ".sigcat-lock").touch()
    os.utime(folder, LONG_AGO)
    with temporary_folder(PREFIX):
        assert folder.is_dir()


def test_a_fragment_of_a_killed_process_is_removed_with_the_next_result(tmp_path):
    names = {
        ".result.0123456789ab": False,
        ".result.0123456789a": True,
        ".result.swp": True,
        ".other.0123456789ab": True,
    }
    for name in names:
        (tmp_path / name).touch()
        os.utime(tmp_path / name, LONG_AGO)
    (tmp_path / ".result.ba9876543210").touch()  # just made: it may not be locked yet
    write_bytes(b"new", tmp_path / "result")
    assert {name: (tmp_path / name).exists() for name in names} == names
    assert (tmp_path / ".result.ba9876543210").exists()
    assert (tmp_path / "result").read_bytes() == b"new"


def test_a_fragment_that_a_process_writes_stays(tmp_path):
    import fcntl

    fragment = tmp_path / ".result.0123456789ab"
    with fragment.open("wb") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        os.utime(fragment, LONG_AGO)
        write_bytes(b"new", tmp_path / "result")
        assert fragment.exists()
