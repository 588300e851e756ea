"""Functions and drive of a comparison."""

from pathlib import Path

import pytest

from sigcat.comparison.compared_set import read_compared
from sigcat.data import EXAMPLES
from sigcat.errors import InputRefused, UsageError

FUNCTION = EXAMPLES / "core_acc/function.yaml"


def test_the_shipped_set_has_everything():
    found = read_compared([EXAMPLES / "ecocontrol"])
    assert found.name == "EcoControl"
    assert [path.parent.name for path in found.functions] == ["core_acc", "eco_control_mpc"]
    assert found.trace is not None
    assert [what for what, _ in found.written] == ["declaration", "declaration", "deployment"]


def test_files_of_functions_are_a_set_without_a_drive():
    found = read_compared([FUNCTION])
    assert (found.name, found.functions, found.trace) == ("core_acc", (FUNCTION,), None)


def test_a_folder_that_says_nothing_has_the_functions_below_it(tmp_path: Path):
    (tmp_path / "one").mkdir()
    (tmp_path / "one/function.yaml").write_text("function: One\n")
    (tmp_path / "deployment.yaml").write_text("name: Set\n")
    found = read_compared([tmp_path])
    assert (len(found.functions), found.deployment) == (1, tmp_path / "deployment.yaml")


def test_a_folder_without_functions_is_refused(tmp_path: Path):
    with pytest.raises(UsageError, match=r"no compare\.yaml"):
        read_compared([tmp_path])


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("function: [a.yaml]\n", 1),
        ("functions: []\n", 1),
        ("name: Set\nfunctions: a.yaml\n", 2),
        ("functions: [\n", 2),
        ("- a\n", 1),
    ],
)
def test_what_is_wrong_in_the_file_is_found_at_its_line(tmp_path: Path, text, line):
    (tmp_path / "compare.yaml").write_text(text)
    with pytest.raises(InputRefused) as refused:
        read_compared([tmp_path])
    assert refused.value.findings[0].line == line


@pytest.mark.parametrize(
    "text", ["functions: [gone.yaml]\n", "functions: [{}]\nbaseline: gone\n", "functions: [{}]\ntrace: .\n"]
)
def test_what_it_names_has_to_be_there(tmp_path: Path, text):
    (tmp_path / "compare.yaml").write_text(text.replace("{}", str(FUNCTION)))
    with pytest.raises(UsageError, match=r"there is no such|must be a file"):
        read_compared([tmp_path])
