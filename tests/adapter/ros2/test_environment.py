"""`make ros2` makes what is needed, once, and says in one line what it lacks."""

import subprocess
import sys
from pathlib import Path

import pytest

from scripts import ros2_environment
from tests.needs import ros2


@ros2
def test_a_second_run_does_nothing() -> None:
    """The list of today gives an unchanged list."""
    before = ros2_environment.PYTHON.lstat().st_mtime_ns
    assert ros2_environment.main() == 0
    assert ros2_environment.PYTHON.lstat().st_mtime_ns == before


@ros2
def test_no_folder_of_the_machine_that_built_the_wheels_is_left() -> None:
    """CMake would look for Python there."""
    files = (ros2_environment.ENVIRONMENT / "share").rglob("*.cmake")
    assert [file for file in files if "/opt/python" in file.read_text() or "/usr/lib64" in file.read_text()] == []


@ros2
def test_rclpy_starts() -> None:
    """Libraries are found, and a node is made."""
    script = "import rclpy; rclpy.init(); print(rclpy.create_node('probe').get_name())"
    command = [str(ros2_environment.PYTHON), "-c", script]
    done = subprocess.run(command, env=ros2_environment.variables(), capture_output=True, text=True, check=True)
    assert done.stdout == "probe\n"


def test_another_python_is_told_in_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The wheels are for 3.11 alone."""
    monkeypatch.setattr(ros2_environment, "ENVIRONMENT", tmp_path / ".venv-ros2")
    monkeypatch.setattr(ros2_environment, "_MADE", tmp_path / ".venv-ros2/made_of")
    monkeypatch.setattr(ros2_environment, "_VERSION", "raise SystemExit(1)")
    assert ros2_environment.main() == 1
    told = capsys.readouterr().err
    version = sys.version.split()[0]
    assert told == (
        ".venv-ros2 cannot be made: the wheels of ROS 2 are for Python 3.11, "
        f"and this is {version}: put python3.11 on the path\n"
    )


def test_what_the_machine_lacks_is_told_in_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As the command that installs it."""
    monkeypatch.setattr(ros2_environment, "ENVIRONMENT", tmp_path / ".venv-ros2")
    monkeypatch.setattr(ros2_environment, "_MADE", tmp_path / ".venv-ros2/made_of")
    monkeypatch.setattr(ros2_environment, "_VERSION", "")
    monkeypatch.setattr(ros2_environment, "_library_of", lambda _: None)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert ros2_environment.main() == 1
    told = ".venv-ros2 cannot be made: something is missing: apt-get install cmake ninja-build g++ libpython3.11-dev\n"
    assert capsys.readouterr().err == told
