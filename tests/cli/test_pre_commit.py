"""The hooks of `.pre-commit-hooks.yaml`, installed and run by the real pre-commit in a real repository.

pre-commit builds and installs sigcat as it does for any user; only what sigcat depends on is taken from the environment
of the tests, so that nothing is downloaded.
"""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

from tests.reference_tools import checked_with

PROJECT = Path(__file__).parents[2]
SHIPPED = ("app", "vspec", "overlays", "interface_rules", "examples", "docs")
FILES = ("pyproject.toml", "README.md", "LICENSE", ".pre-commit-hooks.yaml")
TREE = """\
Vehicle:
  type: branch
  description: A vehicle.

Vehicle.Speed:
  type: sensor
  datatype: float
  description: How fast it is.
"""
CONFIGURATION = """\
repos:
  - repo: {hooks}
    rev: {revision}
    hooks:
      - id: sigcat-lint
      - id: sigcat-lint-tree
"""
GOOD = "Vehicle.Speed:\n  comment: Of the vehicle.\n"
BAD = "Vehicle.Sped:\n  comment: Of the vehicle.\n"


def run(folder: Path, *command: str, home: Path | None = None) -> "subprocess.CompletedProcess[str]":
    environment = {
        **os.environ,
        "GIT_CONFIG_GLOBAL": os.devnull,
        "GIT_AUTHOR_NAME": "A", "GIT_AUTHOR_EMAIL": "a@example.org",
        "GIT_COMMITTER_NAME": "A", "GIT_COMMITTER_EMAIL": "a@example.org",
        "PRE_COMMIT_HOME": str(home or folder),
        "PIP_NO_INDEX": "1", "PIP_NO_DEPS": "1",
        "PIP_NO_BUILD_ISOLATION": "0",  # pip reads this as: without isolation
        "PYTHONPATH": sysconfig.get_path("purelib"),
    }  # fmt: skip
    for name in [name for name in environment if name.startswith("GIT_DIR") or name == "GIT_INDEX_FILE"]:
        del environment[name]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)


def committed(folder: Path) -> str:
    for command in (("init", "-q"), ("add", "-A"), ("commit", "-q", "--no-verify", "-m", "All.")):
        done = run(folder, "git", *command)
        assert done.returncode == 0, done.stderr
    return run(folder, "git", "rev-parse", "HEAD").stdout.strip()


@pytest.fixture(scope="module")
def hooks(tmp_path_factory):
    """This project as a repository of hooks, and its revision."""
    folder = tmp_path_factory.mktemp("hooks")
    for name in SHIPPED:
        shutil.copytree(PROJECT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in FILES:
        shutil.copy(PROJECT / name, folder / name)
    return folder, committed(folder)


@pytest.fixture(scope="module")
def home(tmp_path_factory):
    """Folder in which pre-commit keeps the environments of hooks: installed once for all tests."""
    return tmp_path_factory.mktemp("home")


@pytest.fixture
def repository(tmp_path, hooks):
    folder, revision = hooks
    (tmp_path / "vspec").mkdir()
    (tmp_path / "overlays").mkdir()
    (tmp_path / "vspec" / "VehicleSignalSpecification.vspec").write_text(TREE)
    (tmp_path / "README.md").write_text("A tree.\n")
    (tmp_path / ".pre-commit-config.yaml").write_text(CONFIGURATION.format(hooks=folder, revision=revision))
    committed(tmp_path)
    return tmp_path


def staged(repository: Path, home: Path, **files: str) -> "subprocess.CompletedProcess[str]":
    """Return the output of pre-commit for a commit of these files."""
    for name, text in files.items():
        (repository / "overlays" / f"{name}.vspec").write_text(text)
    assert run(repository, "git", "add", "-A").returncode == 0
    return run(repository, sys.executable, "-m", "pre_commit", "run", "--color", "never", home=home)


@checked_with("pre-commit", "Hooks run, and refuse commits with errors")
def test_a_bad_overlay_is_not_committed(repository, home):
    done = staged(repository, home, bad=BAD)
    assert done.returncode == 1, done.stdout + done.stderr
    assert re.search(r"sigcat lint \(changed files\)\.+Failed", done.stdout)
    assert re.search(r"sigcat lint \(whole tree\)\.+Failed", done.stdout)
    assert "overlays/bad.vspec:1:1: error O101" in done.stdout
    assert "Did you mean 'Vehicle.Speed'?" in done.stdout


@checked_with("pre-commit", "Hooks run, and refuse commits with errors")
def test_a_good_overlay_is_committed(repository, home):
    done = staged(repository, home, good=GOOD)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.count("Passed") == 2


@checked_with("pre-commit", "Hooks run, and refuse commits with errors")
def test_the_whole_tree_is_linted_at_once_with_what_was_not_changed(repository, home):
    (repository / "overlays" / "one.vspec").write_text("Vehicle.Speed:\n  unit: m/s\n")
    (repository / "sigcat.toml").write_text('[lint]\noverlays = ["overlays/*.vspec"]\n')
    committed(repository)
    done = staged(repository, home, two="Vehicle.Speed:\n  unit: km/h\n")
    assert done.returncode == 1
    _, whole = done.stdout.split("sigcat lint (whole tree)")
    assert whole.count("Found ") == 1
    assert "overlays/two.vspec:2:9: warning O105 Overlays disagree on `unit`" in whole
    assert "one.vspec sets 'm/s', then two.vspec sets 'km/h'" in whole


@checked_with("pre-commit", "Hooks run, and refuse commits with errors")
def test_a_change_of_code_runs_the_hook_of_the_whole_tree(repository, home):
    (repository / "step.h").write_text("extern int speed;\n")
    done = staged(repository, home)
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"sigcat lint \(whole tree\)\.+Passed", done.stdout)


@checked_with("pre-commit", "Hooks run, and refuse commits with errors")
def test_a_change_of_other_files_runs_no_hook(repository, home):
    (repository / "README.md").write_text("The tree.\n")
    done = staged(repository, home)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.count("Skipped") == 2


@checked_with("pre-commit", "Hooks run, and refuse commits with errors")
def test_the_hook_of_a_new_project_runs_at_once(tmp_path, home):
    project = tmp_path / "signals"
    sigcat = run(tmp_path, sys.executable, "-m", "sigcat.cli", "init", str(project))
    assert sigcat.returncode == 0, sigcat.stderr
    committed(project)
    programs = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    command = ("env", f"PATH={programs}", sys.executable, "-m", "pre_commit", "run", "--all-files", "--color", "never")
    done = run(project, *command, home=home)
    assert (done.returncode, done.stdout.count("Passed")) == (0, 1), done.stdout + done.stderr
    (project / "overlays/cabin.vspec").write_text(BAD)
    done = run(project, *command, home=home)
    assert done.returncode == 1
    assert "overlays/cabin.vspec:1:1: error" in done.stdout
