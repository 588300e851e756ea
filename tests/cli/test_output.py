"""Where commands write: a regular file is replaced whole, links are followed, devices and pipes are written to."""

import ast
import errno
import json
import os
import stat
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.cli.output import opened, write_bytes, write_lines
from sigcat.errors import UsageError

PROJECT = Path(__file__).parents[2]
FUNCTION = str(PROJECT / "examples/core_acc/function.yaml")
TREE = "Vehicle:\n  type: branch\n  description: A vehicle.\n"
WRITING = {
    "export": ("export", "json", "-s", "tree.vspec", "-o"),
    "export with vss-tools": ("export", "csv", "-s", "tree.vspec", "-o"),
    "diff": ("diff", "tree.vspec", "tree.vspec", "--format", "json", "-o"),
    "lint": ("lint", "tree.vspec", "--format", "json", "-o"),
    "schema": ("schema", "function", "-o"),
    "function build": ("function", "build", FUNCTION, "-o"),
    "integrate": ("integrate", "ros2", FUNCTION, "-o"),
}


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("tree.vspec").write_text(TREE, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("command", WRITING.values(), ids=WRITING)
def test_a_pipe_is_written_to_and_stays_a_pipe(command):
    os.mkfifo("pipe")
    read: list[bytes] = []
    reader = threading.Thread(target=lambda: read.append(Path("pipe").read_bytes()), daemon=True)
    reader.start()
    assert main([*command, "pipe"]) == 0
    reader.join(30)
    assert read[0]
    assert stat.S_ISFIFO(Path("pipe").stat().st_mode)


@pytest.mark.parametrize("command", WRITING.values(), ids=WRITING)
def test_a_link_stays_a_link_and_what_it_leads_to_is_replaced(command):
    Path("elsewhere").mkdir()
    Path("elsewhere/result").write_text("old")
    Path("link").symlink_to("elsewhere/result")
    assert main([*command, "link"]) == 0
    assert Path("link").is_symlink()
    assert Path("elsewhere/result").read_text() not in ("old", "")
    assert [file.name for file in Path("elsewhere").iterdir()] == ["result"]


@pytest.mark.skipif(os.geteuid() != 0, reason="only root makes devices")
@pytest.mark.parametrize("command", WRITING.values(), ids=WRITING)
def test_a_device_stays_a_device(command):
    try:
        os.mknod("null", stat.S_IFCHR | 0o666, os.makedev(1, 3))
    except PermissionError:
        pytest.skip("this container makes no devices")
    assert main([*command, "null"]) == 0
    assert stat.S_ISCHR(Path("null").stat().st_mode)


def test_the_null_device_takes_what_nobody_wants_to_see():
    assert main(["export", "json", "-s", "tree.vspec", "-o", "/dev/null"]) == 0
    assert stat.S_ISCHR(Path("/dev/null").stat().st_mode)


def test_standard_output_may_be_named_as_a_file():
    command = [sys.executable, "-m", "sigcat.cli", "export", "json", "-s", "tree.vspec", "-o", "/dev/stdout"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)["Vehicle"]["type"] == "branch"


def test_a_link_to_nothing_yet_gets_its_file():
    Path("link").symlink_to("new.json")
    write_bytes(b"data", Path("link"))
    assert Path("link").is_symlink()
    assert Path("new.json").read_bytes() == b"data"


def test_a_link_into_a_folder_that_is_not_there_is_refused():
    Path("link").symlink_to("nowhere/new.json")
    with pytest.raises(UsageError, match="nowhere"):
        write_bytes(b"data", Path("link"))


def test_a_file_keeps_its_mode_and_leaves_nothing_beside_it(folder):
    Path("result").write_text("old")
    Path("result").chmod(0o640)
    write_bytes(b"new", Path("result"))
    assert Path("result").read_bytes() == b"new"
    assert stat.S_IMODE(Path("result").stat().st_mode) == 0o640
    assert sorted(file.name for file in folder.iterdir()) == ["result", "tree.vspec"]


def test_a_file_that_cannot_be_replaced_is_written(folder, monkeypatch):
    """A single file that is mounted into a container."""

    def busy(_self, _target):
        raise OSError(errno.EBUSY, "Device or resource busy")

    Path("result").write_text("old")
    monkeypatch.setattr(Path, "replace", busy)
    write_bytes(b"new", Path("result"))
    assert Path("result").read_bytes() == b"new"
    assert sorted(file.name for file in folder.iterdir()) == ["result", "tree.vspec"]


def test_what_fails_leaves_the_old_file(folder, monkeypatch):
    def full(_self, _target):
        raise OSError(errno.ENOSPC, "No space left on device")

    Path("result").write_text("old")
    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(OSError, match="No space"):
        write_bytes(b"new", Path("result"))
    assert Path("result").read_text() == "old"
    assert sorted(file.name for file in folder.iterdir()) == ["result", "tree.vspec"]


def test_folders_are_created_for_what_is_written_bit_by_bit():
    with opened(Path("runs/today/run.csv")) as file:
        file.write(b"time\n")
        assert not Path("runs/today/run.csv").exists()
    write_lines(["time\n"], Path("lines/today/run.csv"))
    assert Path("runs/today/run.csv").read_bytes() == Path("lines/today/run.csv").read_bytes() == b"time\n"
    assert [file.name for file in Path("runs/today").iterdir()] == ["run.csv"]


def test_an_error_while_writing_leaves_the_old_file(folder):
    def lines():
        yield "new\n"
        raise ValueError("wrong")

    Path("result").write_text("old")
    with pytest.raises(ValueError, match="wrong"):
        write_lines(lines(), Path("result"))
    assert Path("result").read_text() == "old"
    assert sorted(file.name for file in folder.iterdir()) == ["result", "tree.vspec"]


def test_all_commands_write_here_alone():
    files = [file for file in (PROJECT / "app/sigcat/cli").glob("*.py") if file.name != "output.py"]
    assert len(files) > 10
    for file in files:
        calls = (node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.Call))
        named = {call.func.attr for call in calls if isinstance(call.func, ast.Attribute)}
        assert not named & {"write_bytes", "write_text", "mkstemp", "NamedTemporaryFile"}, file.name
