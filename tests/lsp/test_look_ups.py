"""Hover, completion, definition and references, over a tree of 1,000 signals."""

from pathlib import Path
from typing import Any

import pytest

from bench.editor import Editor
from tests.lsp.conftest import CABIN, FUNCTION


@pytest.fixture
def overlay(client: Editor, project: Path) -> Path:
    """An overlay that is open."""
    path = project / "overlays/cabin.vspec"
    client.open(path)
    return path


@pytest.fixture
def function(client: Editor, project: Path) -> Path:
    """A function file that is open."""
    path = project / "functions/cabin_air/function.yaml"
    client.open(path)
    return path


def test_hover_shows_datatype_unit_range_description_origin_and_users(client: Editor, overlay: Path) -> None:
    """Result of all layers together, and the functions that use it."""
    text = _hover(client, client.at(overlay, "Vehicle.Cabin.Gas", 10))
    for part in ("Vehicle.Cabin.Gas", "sensor", "`float`", "percent", "0 … 50", "Carbon dioxide in the air."):
        assert part in text
    assert "overlays/cabin.vspec:6 (overlay)" in text
    assert "overlays/limits.vspec:1 (overlay)" in text
    assert "functions/cabin_air/function.yaml:25 (consumed)" in text


def test_hover_knows_instances_units_rules_and_unsaved_texts(client: Editor, overlay: Path, function: Path) -> None:
    """A path with the name of an instance; the unit of a signal; a code in a comment; what was just typed."""
    assert "Whether the door is open." in _hover(client, client.at(function, "Vehicle.Cabin.Door.Left.IsOpen", 15))
    assert "Defined in: " in _hover(client, client.at(overlay, "percent", 2))
    client.change(overlay, CABIN.replace("in the air", "behind the seat") + "# sigcat: ignore-file[V006]\n")
    assert "# V006 " in _hover(client, client.at(overlay, "V006", 1))
    assert "behind the seat" in _hover(client, client.at(function, "Vehicle.Cabin.Gas", 3))
    assert client.ask("textDocument/hover", client.at(overlay, "behind", 1)) is None


def test_a_file_that_is_neither_open_nor_on_the_disk_has_no_hover(client: Editor, project: Path, overlay: Path) -> None:
    at = client.at(overlay, "Vehicle.Cabin.Gas", 10)
    missing = {**at, "textDocument": {"uri": (project / "overlays/gone.vspec").as_uri()}}
    for method in ("hover", "definition", "references"):
        context = {"context": {"includeDeclaration": True}} if method == "references" else {}
        assert not client.ask(f"textDocument/{method}", {**missing, **context})
    assert client.ask("textDocument/completion", missing)["items"]  # of an empty line
    beyond = {**at, "position": {"line": 10**6, "character": 0}}
    assert client.ask("textDocument/hover", beyond) is None


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Vehicle.Cab", {"Vehicle.Cabin"}),
        ("Vehicle.Cabin.Door.", {"Vehicle.Cabin.Door.Left", "Vehicle.Cabin.Door.Right"}),
        ("Vehicle.New:\n  ty", {"type: ", "datatype: ", "instances: "}),
        ("Vehicle.New:\n  type: sensor\n  ", {"datatype: ", "unit: "}),
        ("Vehicle.New:\n  type: ", {"sensor", "branch"}),
        ("Vehicle.New:\n  datatype: ", {"float", "uint8[]"}),
        ("Vehicle.New:\n  unit: ", {"km/h", "percent"}),
        ("Vehicle.New:  # sigcat: ignore[V", {"V006"}),
    ],
)
def test_completion_in_an_overlay(client: Editor, overlay: Path, text: str, expected: set[str]) -> None:
    """Paths, attributes, datatypes, units and codes, while the text is not yet valid."""
    client.change(overlay, f"{CABIN}\n{text}")
    assert expected <= _proposed(client, overlay, len(f"{CABIN}\n{text}"))


def test_completion_replaces_what_was_typed(client: Editor, overlay: Path) -> None:
    """The edit begins where the path begins: editors take dots for the end of a word."""
    client.change(overlay, f"{CABIN}\nVehicle.Cabin.Ga")
    line = CABIN.count("\n") + 1
    found = client.ask("textDocument/completion", _at_end(client, overlay))["items"]
    (gas,) = [each["textEdit"] for each in found if each["label"] == "Gas"]
    assert gas["newText"] == "Vehicle.Cabin.Gas"
    assert gas["range"] == {"start": {"line": line, "character": 0}, "end": {"line": line, "character": 16}}


def test_completion_in_a_function(client: Editor, function: Path) -> None:
    """Paths with instances, and variables of the C code."""
    client.change(function, FUNCTION + "        data:\n          - path: Vehicle.Cabin.Door.Left.")
    assert "Vehicle.Cabin.Door.Left.IsOpen" in _proposed(client, function, len(client.texts[function]))
    client.change(function, FUNCTION + "        data:\n          - path: Gas")
    assert "Vehicle.Cabin.Gas" in _proposed(client, function, len(client.texts[function]))
    client.change(function, FUNCTION + "        data:\n          - variable: ")
    assert _proposed(client, function, len(client.texts[function])) == {"input_gas", "input_door"}


def test_completion_of_rules_in_the_project_file(client: Editor, project: Path) -> None:
    """Codes within quotation marks."""
    path = project / "sigcat.toml"
    text = path.read_text() + '\n[lint]\nignore = ["V'
    client.open(path, text)
    assert "V006" in _proposed(client, path, len(text))


def test_definition_leads_to_tree_overlays_units_and_code(client: Editor, overlay: Path, function: Path) -> None:
    """Every layer that writes a node; the header before the source."""
    assert _places(client, "definition", client.at(function, "Cabin.Gas", 3)) == [
        ("cabin.vspec", 5), ("limits.vspec", 0),
    ]  # fmt: skip
    assert _places(client, "definition", client.at(function, "Vehicle.Cabin.Door.Left.IsOpen", 3)) == [
        ("cabin.vspec", 0)
    ]
    assert _places(client, "definition", client.at(overlay, "percent", 3))[0][0] == "units.yaml"
    assert _places(client, "definition", client.at(function, "input_gas", 3)) == [("CabinAir.h", 2), ("CabinAir.c", 2)]
    assert _places(client, "definition", client.at(function, "CabinAir_step", 3)) == [
        ("CabinAir.h", 5), ("CabinAir.c", 5),
    ]  # fmt: skip
    assert _places(client, "definition", client.at(function, "CabinAir.h", 3)) == [("CabinAir.h", 0)]


def test_references_are_layers_and_functions(client: Editor, overlay: Path) -> None:
    """An instance counts for its definition."""
    assert _places(client, "references", client.at(overlay, "Vehicle.Cabin.Door.IsOpen", 3)) == [
        ("cabin.vspec", 0), ("function.yaml", 28),
    ]  # fmt: skip


def test_nothing_is_known_of_what_is_no_name(client: Editor, overlay: Path) -> None:
    """Positions on an empty line, and beyond the end of the text."""
    end = {"textDocument": {"uri": overlay.as_uri()}, "position": {"line": 5_000, "character": 9}}
    for place in ({**end, "position": {"line": 4, "character": 0}}, end):
        assert client.ask("textDocument/hover", place) is None
        assert client.ask("textDocument/definition", place) == []


def _hover(client: Editor, place: Any) -> str:
    text: str = client.ask("textDocument/hover", place)["contents"]["value"]
    return text


def _at_end(client: Editor, path: Path) -> Any:
    lines = client.texts[path].split("\n")
    at = {"line": len(lines) - 1, "character": len(lines[-1])}
    return {"textDocument": {"uri": path.as_uri()}, "position": at}


def _proposed(client: Editor, path: Path, offset: int) -> set[str]:
    assert offset == len(client.texts[path])
    found = client.ask("textDocument/completion", _at_end(client, path))["items"]
    return {each["textEdit"]["newText"] for each in found}


def _places(client: Editor, what: str, place: Any) -> list[tuple[str, int]]:
    context = {"context": {"includeDeclaration": True}} if what == "references" else {}
    found = client.ask(f"textDocument/{what}", {**place, **context})
    return [(each["uri"].rsplit("/", 1)[1], each["range"]["start"]["line"]) for each in found]
