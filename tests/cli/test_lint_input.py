"""`sigcat lint -`: a text that is in no file yet, as an editor or a pipe has it."""

import io
import sys
from pathlib import Path

import pytest

from sigcat.cli import main

FUNCTION = Path(__file__).parents[2] / "examples/core_acc/function.yaml"
GOOD = "Vehicle.X:\n  type: sensor\n  datatype: float\n  description: An x that is measured.\n"
BAD = GOOD.replace("sensor", "sensr")


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def lint(monkeypatch, capsys):
    def run(text: str, *options: str) -> tuple[int, str]:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
        status = main(["lint", "-", *options])
        return status, "".join(capsys.readouterr())

    return run


def test_an_overlay_is_checked_over_the_shipped_tree(lint):
    assert lint(GOOD) == (0, "No findings.\n")
    status, output = lint(BAD)
    assert status == 1
    assert "standard input:2:9: error V001" in output


def test_an_overlay_is_checked_over_the_tree_that_is_named(lint):
    Path("tree.vspec").write_text("Truck:\n  type: branch\n  description: A truck.\n", encoding="utf-8")
    assert "V022" in lint(GOOD, "-s", "tree.vspec")[1]
    assert lint(GOOD.replace("Vehicle", "Truck"), "-s", "tree.vspec")[0] == 0


def test_an_overlay_is_checked_over_the_tree_near_this_folder(lint):
    Path("vspec").mkdir()
    Path("vspec/units.yaml").write_text(
        "mm:\n  definition: A unit.\n  unit: millimetre\n  quantity: length\n  allowed-datatypes: [numeric]\n"
    )
    Path("vspec/quantities.yaml").write_text("length:\n  definition: How long.\n")
    tree = "Vehicle:\n  type: branch\n  description: A vehicle.\n" + GOOD.replace("float", "uint8")
    Path("vspec/tree.vspec").write_text(tree, encoding="utf-8")
    status, output = lint("Vehicle.X:\n  type: sensor\n  datatype: string\n")
    assert (status, "O103" in output) == (1, True)
    length = GOOD.replace("Vehicle.X", "Vehicle.Y").replace("An x", "A y") + "  unit: mm\n"
    assert lint(length) == (0, "No findings.\n")
    assert "'km'" in lint(length.replace("mm", "km"))[1]


def test_a_text_with_a_root_of_its_own_is_a_tree(lint):
    assert lint("Boat:\n  type: branch\n  description: A boat.\n" + GOOD.replace("Vehicle", "Boat"))[0] == 0
    assert "V021" in lint("Vehcle:\n  type: branch\n  description: A boat.\n")[1]


def test_the_configuration_counts_and_a_comment_suppresses(lint):
    Path("sigcat.toml").write_text('[lint]\nignore = ["V001"]\n', encoding="utf-8")
    assert lint(BAD)[0] == 0
    Path("sigcat.toml").write_text(
        '[lint]\nextended-attributes = ["owner"]\nseverity = {V001 = "info"}\n', encoding="utf-8"
    )
    status, output = lint(BAD + "  owner: us\n")
    assert status == 0
    assert "info V001" in output
    assert "owner" not in output
    Path("sigcat.toml").unlink()
    assert lint(BAD.replace("sensr", "sensr  # sigcat: ignore[V001]"))[0] == 0


def test_a_function_is_checked_as_one(lint):
    text = FUNCTION.read_text(encoding="utf-8")
    assert lint(text)[0] == 0
    status, output = lint(text.replace("function:", "functoin:", 1) + "nope: 1\n")
    assert status == 1
    assert "standard input:" in output


@pytest.mark.parametrize("options", [("--fix",), ("--diff",), ("--write-baseline", "known.json"), ("tree.vspec",)])
def test_what_needs_a_file_is_refused(lint, options):
    status, output = lint(GOOD, *options)
    assert status == 2
    assert "- is linted by itself" in output
