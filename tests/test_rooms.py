"""Every room says what comes in and what goes out, and which of its files may use which."""

import ast
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
SHIPPED = {ROOT / "app/sigcat/adapter/ros2/python" / name for name in ("support", "support_of_humble")}
"""Parts of what is generated, as they are."""
PACKAGES = sorted({path.parent for path in (ROOT / "app/sigcat").rglob("__init__.py")} - SHIPPED)
CONTRACTS = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]


def module(package: Path) -> str:
    return ".".join(package.relative_to(ROOT / "app").parts)


def parts(package: Path) -> list[Path]:
    return [each for each in package.iterdir() if (each / "__init__.py").exists() or each.match("[!_]*.py")]


ROOMS = [package for package in PACKAGES if len(parts(package)) > 1]


def test_there_are_rooms():
    assert len(ROOMS) > 20


@pytest.mark.parametrize("package", PACKAGES, ids=module)
def test_a_room_says_in_two_lines_what_comes_in_and_what_goes_out(package):
    text = ast.get_docstring(ast.parse((package / "__init__.py").read_text("utf-8"))) or ""
    assert len([line for line in text.splitlines() if line]) == 2


@pytest.mark.parametrize("package", ROOMS, ids=module)
def test_a_room_has_layers(package):
    (contract,) = [each for each in CONTRACTS if module(package) in each.get("containers", ())]
    assert contract["type"] == "layers"
    assert contract["exhaustive"]


def test_no_room_has_a_cycle():
    assert [each["ancestors"] for each in CONTRACTS if each["type"] == "acyclic_siblings"] == [["sigcat"]]
