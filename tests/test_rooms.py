"""Every room states its input and output, data flows one way through the rooms, and no file imports in a cycle."""

import ast
import tomllib
from pathlib import Path

import pytest

from sigcat.platforms.table import PLATFORMS

ROOT = Path(__file__).parents[1]
SHIPPED = {ROOT / "app/sigcat/adapter/ros2/python" / name for name in ("support", "support_of_humble")}
"""Parts of generated code, unchanged."""
PACKAGES = sorted({path.parent for path in (ROOT / "app/sigcat").rglob("__init__.py")} - SHIPPED)
CONTRACTS = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]


def module(package: Path) -> str:
    return ".".join(package.relative_to(ROOT / "app").parts)


def test_there_are_rooms():
    assert len(PACKAGES) > 20


def test_a_room_says_in_two_lines_what_comes_in_and_what_goes_out():
    for package in PACKAGES:
        text = ast.get_docstring(ast.parse((package / "__init__.py").read_text("utf-8"))) or ""
        assert len([line for line in text.splitlines() if line]) == 2, module(package)


def test_the_architecture_names_each_file_that_all_rooms_may_use():
    page = (ROOT / "docs/explanation/architecture.md").read_text("utf-8")
    files = [path.name for path in (ROOT / "app/sigcat").glob("*.py") if not path.name.startswith("__")]
    assert [name for name in sorted(files) if f"`{name}`" not in page] == []


def test_each_room_has_a_place_in_the_order():
    (order,) = [each["layers"] for each in CONTRACTS if each["type"] == "layers"]
    rooms = [package.name for package in PACKAGES if package.parent == ROOT / "app/sigcat"]
    assert sorted(room for layer in order for room in layer.split(" | ")) == sorted(rooms)


@pytest.mark.parametrize("container", ["sigcat.adapter", "sigcat.integration"])
def test_no_platform_imports_another(container):
    modules = {f"{container}.{name.replace('-', '_')}" for name in PLATFORMS}
    assert modules in [set(each["modules"]) for each in CONTRACTS if each["type"] == "independence"]


def test_no_room_has_a_cycle():
    assert [each["ancestors"] for each in CONTRACTS if each["type"] == "acyclic_siblings"] == [["sigcat"]]
