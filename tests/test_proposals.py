"""Proposals of near names have one bound: so many names are compared in a piece of work, and then no more."""

import pytest

from sigcat.function.function_file import check_function
from sigcat.names import bounded_proposals, may_compare, nearest
from sigcat.rules.linting.lint import lint_paths
from tests.function.shipped import FUNCTIONS, interfaces

KNOWN = ("Speed", "Load", "Gear")


def test_without_a_bound_every_name_has_its_proposal():
    assert {nearest("Sped", KNOWN) for _ in range(10_000)} == {("Speed",)}


def test_what_is_wrong_after_the_bound_has_no_proposal():
    with bounded_proposals(2 * len(KNOWN)):
        assert [nearest("Sped", KNOWN) for _ in range(3)] == [("Speed",), ("Speed",), ()]


def test_a_part_of_the_work_has_what_is_left_of_the_whole():
    with bounded_proposals(2 * len(KNOWN)):
        with bounded_proposals(len(KNOWN)):
            assert [nearest("Sped", KNOWN) for _ in range(2)] == [("Speed",), ()]
        with bounded_proposals():
            assert [nearest("Sped", KNOWN) for _ in range(2)] == [("Speed",), ()]
        assert nearest("Sped", KNOWN) == ()


def test_who_looks_words_up_counts_too():
    with bounded_proposals(5):
        assert may_compare(5)
        assert not may_compare(5)


COUNT = 1_000
"""Unknown names, each of which is compared with more than a thousand nodes."""


def test_the_first_unknown_signals_of_a_function_have_proposals():
    lines = (f"          - {{path: Vehicle.AverageSped{number}, role: consumed}}\n" for number in range(COUNT))
    text = FUNCTIONS[0].read_text(encoding="utf-8").replace("        data:\n", f"        data:\n{''.join(lines)}", 1)
    found = [each for each in check_function(text.encode(), "f.yaml", interfaces()) if each.rule == "F010"]
    assert len(found) == COUNT
    assert "Did you mean" in found[0].fix
    assert "Did you mean" not in found[-1].fix


def test_the_first_unknown_nodes_of_an_overlay_have_proposals(tmp_path):
    overlay = tmp_path / "overlay.vspec"
    overlay.write_text("".join(f"Vehicle.AverageSped{number}:\n  max: 1\n" for number in range(COUNT)))
    with bounded_proposals(COUNT):
        found = [each for each in lint_paths([overlay]).findings if each.rule == "O101"]
    assert len(found) == COUNT
    assert "Did you mean" in found[0].fix
    assert "Did you mean" not in found[-1].fix


@pytest.mark.parametrize(
    ("name", "candidate", "is_near"),
    [
        ("init", "lint", False),
        ("Vehicle.Cabin.CO2", "Vehicle.Cabin.Door.Row2", False),
        ("Vehicle.Cabin.Door.Row3.IsOpen", "Vehicle.Cabin.Door.Row1.IsOpen", True),
        ("Vehicle.Cabin.Dor.Row1.IsOpen", "Vehicle.Cabin.Door.Row1.IsOpen", True),
        ("Vehicle.Cabin.Row1.IsOpen", "Vehicle.Cabin.Door.Row1.IsOpen", True),
        ("lnit", "lint", True),
        ("lnt", "lint", True),
        ("ilnt", "lint", True),
        ("v5", "v5.0", True),
    ],
)
def test_a_name_is_proposed_only_if_it_is_near(name, candidate, is_near):
    assert nearest(name, [candidate]) == ((candidate,) if is_near else ())
