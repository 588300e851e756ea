"""Comments that suppress findings."""

import pytest

from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions
from sigcat.rules.linting.suppression import read_suppressions
from tests.rules.linting.conftest import CABIN


@pytest.mark.parametrize(
    "cabin",
    [
        CABIN.replace("in the cabin\n", "in the cabin  # sigcat: ignore[V105, V106]\n"),
        CABIN.replace("Cabin.Noise:", "# sigcat: ignore[V105,V106]\nCabin.Noise:"),
        "# sigcat: ignore-file[V1]\n" + CABIN,
    ],
    ids=["line", "block", "file"],
)
def test_a_comment_suppresses_on_its_line_in_its_block_or_in_its_file(tree, cabin):
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    result = lint_paths([tree / "vspec"])
    assert (result.findings, result.suppressed) == ((), 2)


def test_a_block_ends_with_its_node(tree):
    cabin = CABIN.replace("Cabin:", "# sigcat: ignore[V105]\nCabin:", 1)
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    assert [f.rule for f in lint_paths([tree / "vspec"]).findings] == ["L001", "V105", "V106"]


def test_a_suppression_of_a_rule_that_does_not_run_is_not_called_unused(tree):
    (tree / "vspec" / "Cabin.vspec").write_text("# sigcat: ignore-file[V101]\n" + CABIN)
    assert "L001" not in [f.rule for f in lint_paths([tree / "vspec"], LintOptions(ignore=("V101",))).findings]


BLOCKS = """\
# sigcat: ignore[V101]

# another comment
A:
  type: branch
  # sigcat: ignore[V102]
  # sigcat: ignore[V103]
  instances:
    - X

    - Y
  description: A.
A.B: {}  # sigcat: ignore[V104]
# sigcat: ignore[V105]
"""


def test_a_comment_of_its_own_reaches_to_the_end_of_what_stands_below_it():
    entries = read_suppressions(BLOCKS, "a.vspec", ["V101", "V102", "V103", "V104", "V105"]).entries
    assert {entry.codes[0]: (entry.first, entry.last) for entry in entries} == {
        "V101": (4, 12),
        "V102": (8, 11),
        "V103": (8, 11),
        "V104": (13, 13),
        "V105": (14, 14),
    }
