"""Shells complete commands, options, and what the project has."""

import os
import shlex
import shutil
import subprocess
import sys

import pytest

from sigcat.cli import main
from tests.documentation.pages import ROOT
from tests.project.company import write_company

SEPARATOR = "\013"


@pytest.fixture
def company(tmp_path, monkeypatch):
    monkeypatch.chdir(write_company(tmp_path))


def completed(line):
    """Return what the shell receives, on descriptor 8, for a line."""
    asked = {
        **os.environ, "PYTHONPATH": str(ROOT / "app"), "COMP_LINE": line, "COMP_POINT": str(len(line)), "COMP_TYPE": "9",
        "_ARGCOMPLETE": "1", "_ARGCOMPLETE_SHELL": "bash", "_ARGCOMPLETE_IFS": SEPARATOR, "IFS": SEPARATOR,
        "_ARGCOMPLETE_SUPPRESS_SPACE": "1",
    }  # fmt: skip
    command = f"{shlex.quote(sys.executable)} -c 'from sigcat.cli import main; main()' 8>&1 9>/dev/null"
    done = subprocess.run(["bash", "-c", command], env=asked, capture_output=True, text=True, check=False, timeout=300)
    assert done.stderr == ""
    return done.stdout.split(SEPARATOR)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("sigcat ver", ["version-bump"]),
        ("sigcat function val", ["validate"]),
        ("sigcat diff --merge", ["--merge-base"]),
        ("sigcat lint --format git", ["github", "gitlab"]),
        ("sigcat show Vehicle.Cabin.Acm", ["Vehicle.Cabin.AcmeGas"]),
        ("sigcat show Vehicle.VehicleId", None),
        ("sigcat show Vehicle.Speed -s a", ["acme"]),
        ("sigcat diff acm", ["acme"]),
        ("sigcat rule ACME", ["ACME001"]),
        ("sigcat units pp", ["ppm"]),
        ("sigcat export csv -s missing.vspec -l x", [""]),
        ("sigcat show -s missing Vehicle.S", [""]),
    ],
)
def test_a_line_is_completed(company, line, expected):
    found = completed(line)
    if expected is None:  # one branch alone: what is below it
        assert len(found) > 5
        assert all(path.startswith("Vehicle.VehicleIdentification.") for path in found)
    else:
        assert found == expected


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_of_a_shell_is_one(capsys, shell):
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    assert "sigcat" in script
    if not shutil.which(shell):
        pytest.skip(f"{shell}: install it")
    setup = "autoload -Uz compinit; compinit -u; " if shell == "zsh" else ""
    subprocess.run([shell, "-c", setup + script], check=True, capture_output=True, timeout=300)
