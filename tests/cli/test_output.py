"""Outputs of commands: a regular file is replaced as a whole, links are followed, devices and pipes are written to."""

import ast
import errno
import json
import os
import resource
import shlex
import signal
import stat
import subprocess
import sys
import threading
from contextlib import suppress
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


@pytest.fixture
def closed_folder(folder, monkeypatch):
    """A folder that may not be written, with a file of 1,000 bytes that may, on a disk that is full at 1,500."""
    monkeypatch.setattr(os, "access", lambda path, mode: mode != os.W_OK or Path(path).is_file())
    Path("result").write_bytes(b"old " * 250)
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1_500, before[1]))
    yield folder
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


def test_a_file_in_a_folder_that_may_not_be_written_is_written_over(closed_folder):
    write_bytes(b"new", Path("result"))
    assert Path("result").read_bytes() == b"new"


def test_a_file_that_does_not_fit_in_place_keeps_its_content(closed_folder):
    with pytest.raises(OSError, match=r"'.*result'$"):
        write_bytes(b"new " * 1_000, Path("result"))
    assert Path("result").read_bytes() == b"old " * 250


@pytest.fixture(params=[signal.SIGTERM, signal.SIGHUP, signal.SIGINT])
def number(request):
    """A signal that is not ignored, as that of a terminal that closes is under `nohup`."""
    usual = signal.default_int_handler if request.param == signal.SIGINT else signal.SIG_DFL
    before = signal.signal(request.param, usual)
    yield request.param
    signal.signal(request.param, before)


def test_a_signal_while_writing_leaves_the_old_file_and_nothing_beside_it(folder, number):
    def lines():
        yield "new\n"
        os.kill(os.getpid(), number)
        yield "more\n"

    Path("result").write_text("old")
    with pytest.raises((SystemExit, KeyboardInterrupt)):
        write_lines(lines(), Path("result"))
    assert Path("result").read_text() == "old"
    assert sorted(file.name for file in folder.iterdir()) == ["result", "tree.vspec"]


def test_an_interrupt_that_a_library_swallows_ends_the_command(monkeypatch, capsys):
    def swallow(_path):
        with suppress(KeyboardInterrupt):
            os.kill(os.getpid(), signal.SIGINT)
        raise ValueError("Error building a validator")

    monkeypatch.setattr("sigcat.cli.show.read_tree", swallow)
    assert main(["show", "Vehicle"]) == 130
    assert capsys.readouterr().err == ""


def test_a_terminal_of_another_encoding_shows_escapes():
    Path("tree.vspec").write_text(TREE.replace("A vehicle", "Load — 負荷"), encoding="utf-8")
    environment = {**os.environ, "PYTHONIOENCODING": "latin-1", "PYTHONPATH": str(PROJECT / "app")}
    command = [sys.executable, "-m", "sigcat", "show", "Vehicle", "-s", "tree.vspec"]
    shown = subprocess.run(command, env=environment, capture_output=True, check=True).stdout
    assert rb"Load \u2014 \u8ca0\u8377." in shown


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


def test_an_error_names_the_file_of_the_user(monkeypatch):
    def refuse(self, *_arguments):
        raise OSError(errno.ENOSPC, "No space left on device", str(self))

    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(OSError, match=r"/result\.json'$"):
        write_bytes(b"new", Path("result.json"))


def test_all_commands_write_here_alone():
    files = [file for file in (PROJECT / "app/sigcat/cli").glob("*.py") if file.name != "output.py"]
    assert len(files) > 10
    for file in files:
        calls = (node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.Call))
        named = {call.func.attr for call in calls if isinstance(call.func, ast.Attribute)}
        assert not named & {"write_bytes", "write_text", "mkstemp", "NamedTemporaryFile"}, file.name


@pytest.mark.parametrize(
    "arguments", ["--help", "--version", "lint --help", "generate core --help", "rule V001", "schema function"]
)
def test_output_that_cannot_be_written_is_an_error(arguments):
    command = f"{shlex.quote(sys.executable)} -m sigcat.cli {arguments} >/dev/full"
    done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (2, "sigcat: No space left on device\n")


def test_help_whose_reader_has_gone_is_no_error():
    command = f"set -o pipefail; {shlex.quote(sys.executable)} -m sigcat.cli --help | true"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


def run_in_shell(command):
    environment = {**os.environ, "PYTHONPATH": str(PROJECT / "app")}
    return subprocess.run(
        command.replace("sigcat", f"{shlex.quote(sys.executable)} -m sigcat"),
        shell=True,
        env=environment,
        capture_output=True,
        check=False,
    )


@pytest.mark.parametrize(
    "command", ["export json -s tree.vspec", "show Vehicle -s tree.vspec", "lint tree.vspec", "--help"]
)
def test_a_result_for_a_closed_standard_output_is_an_error(command):
    done = run_in_shell(f"sigcat {command} >&-")
    assert done.returncode == 2
    assert done.stderr.startswith(b"sigcat: standard output is closed: the result was not written.")


def test_a_file_is_written_where_standard_output_is_closed(folder):
    assert run_in_shell("sigcat export json -s tree.vspec -o tree.json >&- <&-").returncode == 0
    assert json.loads(Path("tree.json").read_text())["Vehicle"]["type"] == "branch"


def test_messages_do_not_get_into_a_result_where_standard_error_is_closed():
    Path("tree.vspec").write_text(TREE + "Vehicle.A.B: {type: branch, description: B.}\n")
    assert "Vehicle" in json.loads(run_in_shell("sigcat export json -s tree.vspec 2>&-").stdout)


def test_a_read_only_file_is_refused(capsys):
    Path("result").write_text("old")
    Path("result").chmod(0o444)
    assert main(["schema", "function", "-o", "result"]) == 2
    assert "result is read-only: run `chmod u+w` on it, or name another file" in capsys.readouterr().err
    assert Path("result").read_text() == "old"


def test_a_read_only_file_is_not_repaired(capsys):
    Path("tree.vspec").write_text(TREE + "Vehicle.A: {type: branch, description: a}\n")
    Path("tree.vspec").chmod(0o444)
    before = Path("tree.vspec").read_text()
    assert main(["lint", "--fix", "tree.vspec"]) == 2
    assert "read-only" in capsys.readouterr().err
    assert Path("tree.vspec").read_text() == before


def test_all_names_of_a_file_have_the_new_content():
    Path("result").write_text("old and longer")
    Path("other").hardlink_to("result")
    write_bytes(b"new", Path("result"))
    assert Path("other").read_bytes() == b"new"
    assert Path("result").samefile("other")


def test_a_closed_standard_input_is_named():
    done = run_in_shell("sigcat lint - <&-")
    assert (done.returncode, done.stderr) == (2, b"sigcat: standard input is closed: open it, or name a file\n")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
def test_a_project_is_written_whole_though_its_list_cannot_be_printed(tmp_path):
    done = run_in_shell(f"sigcat init {tmp_path}/p >/dev/full")
    assert done.returncode == 2
    assert main(["lint", f"{tmp_path}/p"]) == 0
