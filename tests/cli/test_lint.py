"""`sigcat lint` as programs run it: pipes, exit statuses, formats, repairs byte for byte."""

import fcntl
import json
import os
import shlex
import struct
import subprocess
import sys
import termios
from pathlib import Path
from typing import Any

import pytest

from sigcat.cli import main
from sigcat.patterns import compile_bounded
from sigcat.rules import patterns
from sigcat.rules.report import FORMATS
from tests.catalogue.trees import ROOT
from tests.unreadable import unreadable
from tests.waiting import wait_until

PROJECT = Path(__file__).parents[2]
BAD = "".join(f"Vehicle.bad{n}: {{type: sensor, datatype: float, description: no}}\n" for n in range(400))
OWN = """\
ACME001:
  name: without-prefix
  title: Names start with Acme.
  severity: warning
  why: Others can distinguish them.
  check: name
  nodes: {types: [signals]}
  options: {pattern: 'Acme.*'}
  source: Naming guide
"""
COMMAND = [sys.executable, "-m", "sigcat.cli", "lint"]


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONPATH", str(PROJECT / "app"))
    return tmp_path


def started(*arguments, **options):
    return subprocess.Popen([*COMMAND, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)


def status_of(arguments):
    try:
        return main(arguments)
    except SystemExit as end:  # argparse ends the process itself
        return end.code


def test_a_folder_that_cannot_be_read_is_an_error(folder, monkeypatch, capsys):
    Path("names/closed").mkdir(parents=True)
    Path("names/tree.vspec").write_text(ROOT)
    unreadable(Path("names/closed"), monkeypatch)
    assert status_of(["lint", "names"]) == 2
    output, errors = capsys.readouterr()
    assert "No findings" not in output
    assert "names/closed: Permission denied" in errors


# -- pipes ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("form", FORMATS)
def test_a_reader_that_leaves_ends_the_output_quietly_and_the_verdict_stands(form):
    Path("tree.vspec").write_text(ROOT + BAD)
    process = started("tree.vspec", "--format", form)
    assert process.stdout is not None
    process.stdout.read(10)
    process.stdout.close()
    assert process.stderr is not None
    assert process.stderr.read() == b""
    assert process.wait() == 1


def waiting_in(pipe: int) -> int:
    """Bytes that were written into a pipe and not yet read."""
    (count,) = struct.unpack("i", fcntl.ioctl(pipe, termios.FIONREAD, b"\0" * 4))
    return int(count)


def test_a_reader_that_is_slow_gets_everything_even_from_a_pipe_that_does_not_block():
    Path("tree.vspec").write_text(ROOT + BAD)
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    process = subprocess.Popen([*COMMAND, "tree.vspec"], stdout=writing, stderr=subprocess.PIPE)
    os.close(writing)
    wait_until(lambda: waiting_in(reading) > 60_000 or process.poll() is not None, "the pipe is full")
    received = b""
    while chunk := os.read(reading, 4096):
        received += chunk
    assert process.wait() == 1
    assert received.endswith(b"in 1 file.\n")
    assert received.count(b" V101 ") == 400


def test_a_terminal_of_few_characters_gets_escapes():
    Path("ü.vspec").write_text(
        ROOT + "Vehicle.ä: {type: sensor, datatype: float, description: Yes.}\n", encoding="utf-8"
    )
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    done = subprocess.run([*COMMAND, "ü.vspec"], env=environment, capture_output=True, check=False)
    assert done.returncode == 1
    assert b"Vehicle.\\xe4" in done.stdout


# -- exit statuses -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("folder", ["empty", "other"])
def test_a_folder_without_a_file_to_check_is_not_green(tmp_path, monkeypatch, capsys, folder):
    monkeypatch.chdir(tmp_path)
    Path("empty").mkdir()
    Path("other").mkdir()
    Path("other/notes.yaml").write_text("a: b\n")
    assert main(["lint", folder]) == 2
    assert f"Nothing to check: {folder} has no .vspec" in capsys.readouterr().err


def test_a_folder_beside_this_one_is_checked(tmp_path, monkeypatch, capsys):
    (tmp_path / "here").mkdir()
    (tmp_path / "beside").mkdir()
    (tmp_path / "beside" / "tree.vspec").write_text("A:\n  type: branch\n  description: A tree of the test.\n")
    monkeypatch.chdir(tmp_path / "here")
    assert main(["lint", "../beside"]) == 0
    assert "No findings." in capsys.readouterr().out


@pytest.mark.parametrize(
    ("status", "arguments"),
    [
        (0, ["good.vspec"]),
        (0, ["bad.vspec", "--ignore", "V"]),
        (1, ["bad.vspec"]),
        (1, ["."]),
        (1, ["broken.vspec"]),
        (2, ["missing.vspec"]),
        (2, ["good.vspec", "--select", "Z9"]),
        (2, ["good.vspec", "--format", "xml"]),
        (2, ["good.vspec", "--nonsense"]),
        (2, ["good.vspec", "-o", "good.vspec/x"]),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else str(value),
)
def test_the_status_is_0_when_clean_1_with_findings_and_2_when_it_could_not_run(status, arguments, capsys):
    Path("good.vspec").write_text(ROOT + "Vehicle.New: {type: sensor, datatype: float, description: Yes.}\n")
    Path("bad.vspec").write_text(ROOT + BAD)
    Path("broken.vspec").write_bytes(b"\xff[")
    assert status_of(["lint", *arguments]) == status
    output = capsys.readouterr()
    assert "Traceback" not in output.err
    assert bool(output.err) == (status == 2)


@pytest.mark.parametrize(
    ("file", "text", "reason"),
    [
        ("sigcat.toml", "[lint", "Not valid TOML"),
        ("sigcat.toml", "[lint]\nselct = []\n", "Did you mean 'select'?"),
        ("sigcat.toml", "[lint.severity]\nV101 = 'eror'\n", "Did you mean 'error'?"),
        ("sigcat.toml", "[lint.per-file.here]\nX1 = 'off'\n", "No rule has the code 'X1'."),
        (
            "sigcat.toml",
            "[lint]\n[lint.severity]\nV199 = 'off'\n",
            "sigcat.toml:3:1: error L012 No rule has the code 'V199'.",
        ),
        ("pyproject.toml", "[tool.sigcat.lint]\nseverity = {V199 = 'off'}\n", "pyproject.toml:2:1: error L012"),
        ("sigcat.toml", "[lint.options.V102]\nprefxes = ['Is']\n", "Did you mean 'prefixes'?"),
        ("sigcat.toml", "[lint.options.V102]\nprefixes = 3\n", "must be a list of names, not 3"),
        ("sigcat.toml", "[lint.options.R001]\nmost = 3\n", "Rule R001 has no options."),
        ("pyproject.toml", "[tool.sigcat.lint]\nrules = ['own.yaml']\n", "ACME1"),
        ("own.toml", "[lint]\nbaseline = 'own.yaml'\n", "is not a baseline"),
    ],
)
def test_a_configuration_that_cannot_be_used_is_status_2_and_the_reason_is_told(file, text, reason, capsys):
    Path("own.yaml").write_text("ACME1: {}\n")
    Path("good.vspec").write_text(ROOT)
    Path(file).write_text(text)
    given = ["--config", file] if file == "own.toml" else []
    assert status_of(["lint", "good.vspec", *given]) == 2
    assert reason in capsys.readouterr().err


def test_what_is_wrong_with_a_rule_is_told_when_an_overlay_alone_is_linted(capsys):
    Path("own.yaml").write_text(OWN.replace("check: name", "check: nmae"))
    Path("sigcat.toml").write_text("[lint]\nrules = ['own.yaml']\n")
    Path("more.vspec").write_text("Vehicle.Speed: {max: 5}\n")
    assert main(["lint", "more.vspec"]) == 1
    assert "own.yaml:1:1: error L010 Unknown check 'nmae' of rule ACME001." in capsys.readouterr().out


class Counting:
    """A pattern that keeps what it is matched with."""

    def __init__(self, pattern: Any, matched: list[str]) -> None:
        self.pattern = pattern
        self.matched = matched

    def fullmatch(self, text: str, timeout: float) -> object:
        self.matched.append(text)
        return self.pattern.fullmatch(text, timeout=timeout)

    search = fullmatch


def test_a_rule_that_is_too_slow_is_tried_on_one_node_only(capsys, monkeypatch):
    Path("own.yaml").write_text(OWN.replace("Acme.*", "(a|a)+b"))
    Path("sigcat.toml").write_text("[lint]\nrules = ['own.yaml']\n")
    names = [f"{'a' * 60}{n}" for n in range(100)]
    Path("tree.vspec").write_text(ROOT + "".join(BAD.splitlines()[0].replace("bad0", n) + "\n" for n in names))
    matched: list[str] = []
    monkeypatch.setattr(patterns, "compile_bounded", lambda text: Counting(compile_bounded(text), matched))
    assert main(["lint", "tree.vspec", "--select", "ACME", "--extend-select", "L"]) == 1
    assert matched == [names[0]]
    assert [line.split()[2] for line in capsys.readouterr().out.splitlines() if ": error" in line] == ["L011"]


@pytest.mark.parametrize(
    ("arguments", "name"),
    [
        (["lint", "--selct", "V1"], "--select"),
        (["lint", "--colr=always"], "--color"),
        (["lint", "--format", "jsn"], "json"),
        (["lnt"], "lint"),
        (["lint", ".", "--select", "V10l"], "V101"),
        (["rule", "V1O1"], "V101"),
    ],
    ids=" ".join,
)
def test_a_mistyped_option_or_code_is_told_with_the_one_that_was_meant(arguments, name, capsys):
    assert status_of(arguments) == 2
    error = capsys.readouterr().err
    assert "Did you mean" in error
    assert name in error.rpartition("Did you mean")[2]


@pytest.mark.parametrize("name", ["pipe.vspec", "gone.vspec"])
def test_what_is_no_file_is_refused_by_name_and_reported_beside_others(name, capsys):
    os.mkfifo("pipe.vspec")
    Path("gone.vspec").symlink_to("nowhere")
    Path("more.vspec").write_text("Vehicle.Speed: {max: 5}\n")
    assert main(["lint", "more.vspec"]) == 0
    assert main(["lint", "."]) == 1
    assert f"{name}: error R012" in capsys.readouterr().out
    assert main(["lint", name]) == 2
    assert f"sigcat: {name}" in capsys.readouterr().err


def test_an_included_pipe_is_not_waited_for(capsys):
    os.mkfifo("pipe.vspec")
    Path("more.vspec").write_text("#include pipe.vspec\nVehicle.Speed: {max: 5}\n")
    assert main(["lint", "more.vspec"]) == 1
    assert "R012" in capsys.readouterr().out


def test_output_that_is_closed_leaves_the_verdict():
    Path("tree.vspec").write_text(ROOT + BAD)
    done = subprocess.run(f"{shlex.join(COMMAND)} tree.vspec >&-", shell=True, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (1, b"")


def test_a_full_disk_is_told():
    Path("tree.vspec").write_text(ROOT + BAD)
    done = subprocess.run(f"{shlex.join(COMMAND)} tree.vspec >/dev/full", shell=True, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (2, b"sigcat: No space left on device\n")


# -- colour --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "environment", "is_coloured"),
    [
        ([], {}, True),
        ([], {"NO_COLOR": "1"}, False),
        ([], {"TERM": "dumb"}, False),
        (["--color", "never"], {}, False),
        (["--color", "always"], {"NO_COLOR": "1"}, True),
        (["--colour", "never"], {}, False),
        (["--format", "json"], {}, False),
    ],
)
def test_a_terminal_gets_colours_unless_somebody_objects(arguments, environment, is_coloured, capsys, monkeypatch):
    Path("tree.vspec").write_text(ROOT + BAD)
    for name in ("NO_COLOR", "TERM"):
        monkeypatch.delenv(name, raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    assert main(["lint", "tree.vspec", *arguments]) == 1
    assert ("\x1b[" in capsys.readouterr().out) == is_coloured


def test_a_note_alone_is_no_failure(capsys):
    Path("tree.vspec").write_text(ROOT + BAD)
    Path("sigcat.toml").write_text('[lint.severity]\nV = "info"\n')
    assert main(["lint", "tree.vspec"]) == 0
    assert capsys.readouterr().out.endswith("Found 1,199 notes in 1 file.\n")


# -- repairs -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("mark", ["", "\ufeff"], ids=["plain", "byte order mark"])
@pytest.mark.parametrize("end", ["\n", "\r\n"], ids=["LF", "CRLF"])
def test_repairs_leave_every_other_byte(mark, end):
    before = mark + end.join((
        "# A comment — with a dash.",
        "Vehicle: {type: branch,   description: A vehicle.}   # behind",
        "",
        "Vehicle.A:   # sigcat: ignore[V104]",
        "    description: 'under the höod'",
        "    type:     sensor # and here",
        "    datatype: float",
        "",
        "# the end",
    ))  # fmt: skip
    after = before.replace("   # sigcat: ignore[V104]", "").replace("'under the höod'", "'Under the höod.'")
    Path("tree.vspec").write_bytes(before.encode())
    assert main(["lint", "tree.vspec", "--fix"]) == 0
    assert Path("tree.vspec").read_bytes() == after.encode()


def test_a_file_that_is_no_utf8_is_left_as_it_is():
    data = b"Vehicle: {type: branch, description: caf\xe9}\n"
    Path("tree.vspec").write_bytes(data)
    assert main(["lint", "tree.vspec", "--fix"]) == 1
    assert Path("tree.vspec").read_bytes() == data


def test_unsafe_repairs_are_made_when_they_are_asked_for():
    text = ROOT + "Vehicle.A: {type: sensor, datatype: float, description: Yes., maxx: 5}\n"
    Path("tree.vspec").write_text(text)
    assert main(["lint", "tree.vspec", "--fix"]) == 1
    assert Path("tree.vspec").read_text() == text
    assert main(["lint", "tree.vspec", "--fix", "--unsafe-fixes"]) == 0
    assert Path("tree.vspec").read_text() == text.replace("maxx", "max")


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("description: >-  # folded\n    lower text\n    continues\n", "description: >-  # folded\n    Lower text\n    continues.\n"),
        ("description: |+\n    lower text\n\n# the end\n", "description: |+\n    Lower text.\n\n# the end\n"),
        ("description: 'it''s'", "description: 'It''s.'"),
        ("description: über alles.", "description: über alles."),
        ("unit: KM/H\t\n  description: a", "unit: km/h\t\n  description: A."),
        ("description: plain\n    on two lines  # why\n", "description: Plain\n    on two lines.  # why\n"),
        ("description: A.\n  deprecation: v6.0 removed\n", "description: A.\n  deprecation: V6.0 removed\n"),
    ],
)  # fmt: skip
def test_a_text_is_repaired_in_whatever_style_it_is_written_and_once(before, after, capsys):
    node = "Vehicle.A:\n  type: sensor\n  datatype: float\n  "
    Path("tree.vspec").write_text(ROOT + node + before, encoding="utf-8", newline="")
    main(["lint", "tree.vspec", "--fix"])
    assert Path("tree.vspec").read_bytes() == (ROOT + node + after).encode()
    capsys.readouterr()
    main(["lint", "tree.vspec", "--fix", "--unsafe-fixes"])
    assert "sigcat: 0 of " in capsys.readouterr().err
    assert Path("tree.vspec").read_bytes() == (ROOT + node + after).encode()


def test_an_attribute_is_not_renamed_to_one_that_is_there(capsys):
    text = ROOT + "Vehicle.A: {type: sensor, datatype: float, descripton: Yes., description: Yes.}\n"
    Path("tree.vspec").write_text(text)
    assert main(["lint", "tree.vspec", "--fix", "--unsafe-fixes"]) == 1
    assert Path("tree.vspec").read_text() == text
    assert "V117" in capsys.readouterr().out


def test_the_report_of_a_format_goes_to_a_file_as_utf8():
    Path("ü.vspec").write_text(ROOT + BAD)
    assert main(["lint", "ü.vspec", "--format", "sarif", "-o", "report.sarif"]) == 1
    assert len(json.loads(Path("report.sarif").read_bytes())["runs"][0]["results"]) == 1199


def test_settings_of_the_service_are_checked_with_the_project(capsys):
    Path("sigcat.toml").write_text(
        '[[catalogue]]\nid = "own"\nrelease = "shipped"\n\n[service]\nprot = 80\nport = "x"\n'
    )
    assert main(["lint"]) == 1
    out = capsys.readouterr().out
    assert "sigcat.toml:6:1: error C002 Unknown setting 'prot' in [service]. Did you mean 'port'?" in out
    assert "sigcat.toml:7:1: error C003 [service] port: " in out
