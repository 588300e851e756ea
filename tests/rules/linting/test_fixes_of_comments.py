"""Repairs of comments: codes that suppress nothing are removed, and the text next to them stays."""

import pytest

from sigcat.rules.linting.fixes import fixed_files
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.report import sources_of

TREE = "Vehicle: {type: branch, description: A vehicle.}\n"
A = "Vehicle.a: {type: sensor, datatype: float, description: Yes.}"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (f"{A}  # sigcat: ignore[V101, V105]\n", f"{A}  # sigcat: ignore[V101]\n"),
        (f"{A}  # sigcat: ignore[V105,V106 , V101] for a reason\n", f"{A}  # sigcat: ignore[V101] for a reason\n"),
        (f"# why\n# sigcat: ignore[V101]\n{A}\n", None),
        (f"# sigcat: ignore-file[V105]\n{TREE}", TREE),
        (f"{TREE}  # sigcat: ignore[V105]\n\n# more\n", f"{TREE}\n# more\n"),
        (f"{TREE.strip()} # kept # sigcat: ignore[V105]\r\n", f"{TREE.strip()} # kept\r\n"),
        (f"{TREE.strip()} # sigcat: ignore[V105]", TREE.strip()),
        ('Vehicle: {type: branch, description: "See # sigcat: ignore[V105]."}\n', None),
    ],
)
def test_what_suppresses_nothing_is_removed(tmp_path, before, after):
    path = tmp_path / "tree.vspec"
    path.write_bytes(before.encode())
    result = lint_paths([path])
    sources = {name: path.read_bytes().decode() for name in sources_of(result.findings)}
    fixed = fixed_files([f for f in result.findings if f.rule == "L001"], result.repairs, sources)
    assert [file.after for file in fixed] == ([after] if after is not None else [])


def test_a_value_and_a_comment_of_one_line_are_repaired_together(tmp_path):
    path = tmp_path / "tree.vspec"
    path.write_text(TREE.replace("A vehicle.", "a vehicle") + "# the end\n")
    path.write_text(path.read_text().replace("}\n", "}  # sigcat: ignore[V118]\n", 1))
    result = lint_paths([path])
    (fixed,) = fixed_files(result.findings, result.repairs, sources_of(result.findings))
    assert fixed.after == TREE + "# the end\n"
    assert [finding.rule for finding in fixed.settled] == ["V105", "V106", "L001"]
