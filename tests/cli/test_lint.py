"""`sigcat lint` as programs run it: pipes, exit statuses, formats, repairs byte for byte."""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from app.cli import main
from app.rules.report import FORMATS
from tests.catalogue.trees import ROOT

PROJECT = Path(__file__).parents[2]
BAD = "".join(f"Vehicle.bad{n}: {{type: sensor, datatype: float, description: no}}\n" for n in range(400))
COMMAND = [sys.executable, "-m", "app.cli", "lint"]


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONPATH", str(PROJECT))
    return tmp_path


def started(*arguments, **options):
    return subprocess.Popen([*COMMAND, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)


def status_of(arguments):
    try:
        return main(arguments)
    except SystemExit as end:  # argparse ends the process itself
        return end.code


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


def test_a_reader_that_is_slow_gets_everything_even_from_a_pipe_that_does_not_block():
    Path("tree.vspec").write_text(ROOT + BAD)
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    process = subprocess.Popen([*COMMAND, "tree.vspec"], stdout=writing, stderr=subprocess.PIPE)
    os.close(writing)
    time.sleep(0.5)
    received = b""
    while chunk := os.read(reading, 4096):
        received += chunk
        time.sleep(0.001)
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
        (2, ["good.vspec", "-o", "no/such/folder/x"]),
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


def test_a_note_alone_is_no_failure(capsys):
    Path("tree.vspec").write_text(ROOT + BAD)
    Path("sigcat.toml").write_text('[lint.severity]\nV = "info"\n')
    assert main(["lint", "tree.vspec"]) == 0
    assert capsys.readouterr().out.endswith("Found 800 notes in 1 file.\n")


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


def test_the_report_of_a_format_goes_to_a_file_as_utf8():
    Path("ü.vspec").write_text(ROOT + BAD)
    assert main(["lint", "ü.vspec", "--format", "sarif", "-o", "report.sarif"]) == 1
    assert len(json.loads(Path("report.sarif").read_bytes())["runs"][0]["results"]) == 800
