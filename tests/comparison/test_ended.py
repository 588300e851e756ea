"""Ending a comparison ends all of its processes, whatever it is doing: a clear last line, and no report."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from sigcat.data import EXAMPLES
from tests import needs
from tests.waiting import DEADLINE, wait_until

pytestmark = [needs.cmake, needs.own_network]
FAULTS = """
scenarios:
  - name: brake-missing
    title: Brake pressure is missing
    from: 2
    to: 30
    faults:
      - {fault: dropped, signal: Vehicle.Chassis.Brake.CylP, from: 2, to: 30}
"""
LAST = "Interrupted: all processes were ended, and no report was written."


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """Folder of all builds: existing builds are not built again."""
    return tmp_path_factory.mktemp("built")


def begun(arguments: list[str], phase: str) -> "subprocess.Popen[str]":
    """The command, which has told that it is in a phase."""
    command = [sys.executable, "-c", "import sys; from sigcat.cli import main; sys.exit(main(sys.argv[1:]))"]
    process = subprocess.Popen([*command, "compare", *arguments], stderr=subprocess.PIPE, text=True)
    assert process.stderr is not None
    told = []
    for line in process.stderr:
        told.append(line)
        if phase in line:
            return process
    raise AssertionError(f"it did not come to {phase!r}: {''.join(told)}")


def with_name(text: str) -> Iterator[int]:
    """Processes that have a text among their arguments."""
    for folder in Path("/proc").iterdir():
        if folder.name.isdecimal() and int(folder.name) != os.getpid():
            with suppress(OSError):
                if text in (folder / "cmdline").read_bytes().decode(errors="replace"):
                    yield int(folder.name)


@pytest.mark.parametrize(
    ("phase", "number"),
    [
        pytest.param("AUTOSAR adaptive: building", signal.SIGTERM, id="building"),
        pytest.param("AUTOSAR adaptive: 40 s in lock step", signal.SIGINT, id="lock-step", marks=needs.slow),
        pytest.param("AUTOSAR adaptive: 20 s in free run", signal.SIGTERM, id="free-run", marks=needs.slow),
        pytest.param("AUTOSAR adaptive: faults", signal.SIGINT, id="faults", marks=needs.slow),
    ],
)
def test_everything_ends_with_the_command(phase, number, built, tmp_path):
    (tmp_path / "faults.yaml").write_text(FAULTS)
    report = tmp_path / "report.json"
    arguments = [str(EXAMPLES / "ecocontrol"), "--platforms", "autosar-adaptive", "--duration", "40"]
    arguments += ["--faults", str(tmp_path / "faults.yaml"), "--keep", str(built), "-o", str(report)]
    process = begun(arguments, phase)
    below = lambda: [each for each in with_name(str(built)) if each != process.pid]  # noqa: E731
    wait_until(below, "processes have begun")
    process.send_signal(number)
    assert process.wait(DEADLINE) == 128 + number
    assert process.stderr is not None
    told = process.stderr.read()
    assert told.splitlines()[-1:] == [LAST]
    assert "cannot be built" not in told
    process.stderr.close()
    wait_until(lambda: not below(), "they are gone")
    assert not report.exists()
