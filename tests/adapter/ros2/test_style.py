"""Packages are clean for the linters that ROS 2 has for its own."""

import subprocess

import pytest

from scripts import ros2_environment
from tests.adapter.ros2.generated import bonded, ecocontrol, full, small, storing, write
from tests.needs import ros2, sampled
from tests.reference_tools import checked_with

pytestmark = ros2

UNCRUSTIFY = ros2_environment.ENVIRONMENT / "opt/uncrustify_vendor/bin"
LINTERS = {
    "ament_cpplint": "*.hpp *.cpp",
    "ament_uncrustify": "*.hpp *.cpp",
    "ament_flake8": "*.py",
    "ament_pep257": "*.py",
}
"""Commands, and what they are for. Cores are C of every platform, with its own rules."""


@checked_with("ament", "Packages have no findings of the linters of ROS 2")
@pytest.mark.parametrize("linter", LINTERS)
@pytest.mark.parametrize("workspace", sampled([ecocontrol, full, small, storing, bonded], usual=[ecocontrol, bonded]))
def test_a_linter_has_nothing_to_say(linter, workspace, tmp_path):
    write(workspace(), tmp_path)
    patterns = LINTERS[linter].split()
    files = [str(file) for pattern in patterns for file in tmp_path.rglob(pattern) if file.parent.name != "core"]
    assert files
    done = subprocess.run([linter, *files], env=_variables(), capture_output=True, text=True, check=False, cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_linters_notice_what_is_wrong(tmp_path):
    (tmp_path / "wrong.cpp").write_text("int  main( ) { return 0 ; }\n")
    (tmp_path / "wrong.py").write_text("def f():\n  '''does'''\n  return \"x\"\n")
    for linter, patterns in LINTERS.items():
        file = "wrong.py" if patterns == "*.py" else "wrong.cpp"
        done = subprocess.run([linter, file], env=_variables(), capture_output=True, check=False, cwd=tmp_path)
        assert done.returncode != 0, linter


def _variables():
    variables = ros2_environment.variables()
    return {**variables, "PATH": f"{UNCRUSTIFY}:{variables['PATH']}"}
