"""Rename a node in the tree, in overlays and in functions."""

from pathlib import Path
from typing import Any

import pytest

from bench.editor import Editor
from tests.lsp.conftest import CABIN, FUNCTION, LIMITS


def test_a_signal_is_renamed_in_every_file(client: Editor, project: Path) -> None:
    """Overlays and functions; open texts, as they are."""
    overlay = project / "overlays/cabin.vspec"
    client.open(overlay)
    text = f"# A comment.\n{CABIN}"
    client.change(overlay, text)
    edits = _renamed(client, client.at(overlay, "Vehicle.Cabin.Gas", 4), "Air")
    assert edits == {
        "cabin.vspec": text.replace("Cabin.Gas", "Cabin.Air"),
        "limits.vspec": LIMITS.replace("Cabin.Gas", "Cabin.Air"),
        "function.yaml": FUNCTION.replace("Cabin.Gas", "Cabin.Air"),
    }
    client.change(overlay, CABIN)


def test_a_branch_is_renamed_above_its_instances(client: Editor, project: Path) -> None:
    """The name of the branch alone, in all paths below it."""
    overlay = project / "overlays/cabin.vspec"
    client.open(overlay)
    client.open(project / "tree/Acme.vspec")
    edits = _renamed(client, client.at(project / "tree/Acme.vspec", "Vehicle.Cabin.Door"), "Gate")
    assert edits["cabin.vspec"] == CABIN.replace("Door", "Gate")
    assert edits["function.yaml"] == FUNCTION.replace("Door", "Gate")
    assert "\nVehicle.Cabin.Gate:\n" in edits["Acme.vspec"]


@pytest.mark.parametrize(
    ("text", "name", "message"),
    [
        ("Cabin.Gas", "Vehicle.Other.Gas", "changes only the name 'Gas' at the end"),
        ("Cabin.Gas", "two words", "is not a name"),
        ("Cabin.Gas", "Door", "exists"),
        ("Carbon", "Oxygen", "Nothing to rename"),
    ],
)
def test_what_cannot_be_renamed_is_an_error(client: Editor, project: Path, text: str, name: str, message: str) -> None:
    """With a message that says why."""
    client.open(project / "overlays/cabin.vspec")
    with pytest.raises(ValueError, match=message):
        _renamed(client, client.at(project / "overlays/cabin.vspec", text, 2), name)


def test_a_node_of_another_folder_is_not_renamed(tmp_path: Path) -> None:
    """The shipped tree stays as it is."""
    from bench.editor import editor

    path = tmp_path / "speed.vspec"
    path.write_text("Vehicle.Speed:\n  type: sensor\n  datatype: float\n  description: Speed.\n")
    with editor(tmp_path) as client:
        client.open(path)
        with pytest.raises(ValueError, match="defined outside of this folder"):
            _renamed(client, client.at(path, "Speed"), "Velocity")


def _renamed(client: Editor, place: Any, name: str) -> dict[str, str]:
    """The texts of files after a rename."""
    changes = client.ask("textDocument/rename", {**place, "newName": name})["changes"]
    return {uri.rsplit("/", 1)[1]: _edited(_text(client, uri), edits) for uri, edits in changes.items()}


def _text(client: Editor, uri: str) -> str:
    path = Path(uri.removeprefix("file://"))
    return client.texts.get(path) or path.read_text()


def _edited(text: str, edits: list[Any]) -> str:
    lines = text.split("\n")
    for edit in sorted(edits, key=lambda each: each["range"]["start"]["character"], reverse=True):
        start, end = edit["range"]["start"], edit["range"]["end"]
        assert start["line"] == end["line"]
        line = lines[start["line"]]
        lines[start["line"]] = line[: start["character"]] + edit["newText"] + line[end["character"] :]
    return "\n".join(lines)
