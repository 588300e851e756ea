"""Edits of an editor: ranges in UTF-16 code units, one after another, in files with any end of line."""

import json
from pathlib import Path

import pytest

from bench.editor import Editor
from tests.lsp.conftest import CABIN

Edit = tuple[str, str]
"""A text, and what replaces its first occurrence."""


def _position(text: str, index: int) -> dict[str, int]:
    lines = text[:index].split("\n")
    return {"line": len(lines) - 1, "character": len(lines[-1].encode("utf-16-le")) // 2}


def _changes(text: str, edits: tuple[Edit, ...]) -> tuple[list[dict[str, object]], str]:
    """Return the edits as an editor sends them, each in the text after those before, and the text after all."""
    changes: list[dict[str, object]] = []
    for old, new in edits:
        start = text.index(old)
        span = {"start": _position(text, start), "end": _position(text, start + len(old))}
        changes.append({"range": span, "text": new})
        text = text.replace(old, new, 1)
    return changes, text


EDITS: tuple[tuple[Edit, ...], ...] = (
    (("boolean", "flaot"),),
    (("Carbon", "🚗🚗 Carbon"), ("🚗 Carbon", "ü€ carbon")),
    (("Carbon", "🚗"), ("🚗 ", "🚗🚗 "), ("percent", "prozent")),
    (("percent", "pct"), ("pct", "percent"), ("boolean", "bool")),
    (("  unit: percent", ""), ("boolean", "é\u0301boolean")),
)


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
@pytest.mark.parametrize("edits", EDITS, ids=str)
def test_edits_give_the_findings_of_the_whole_text(
    client: Editor, project: Path, edits: tuple[Edit, ...], newline: str
) -> None:
    """Sent in one message, and each in a separate message."""
    path = project / "overlays/cabin.vspec"
    text = CABIN.replace("\n", newline)
    changes, after = _changes(text, edits)
    client.open(path, text)
    expected = client.change(path, after)
    client.change(path, text)
    assert client.edit(path, changes) == expected
    client.change(path, text)
    for change in changes:
        found = client.edit(path, [change])
    assert json.dumps(found) == json.dumps(expected)


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_lines_that_are_inserted_and_deleted_move_findings(client: Editor, project: Path, newline: str) -> None:
    """A finding stays at its word."""
    path = project / "overlays/cabin.vspec"
    text = CABIN.replace("boolean", "flaot").replace("\n", newline)
    (first,) = [each for each in client.open(path, text) if "flaot" in each["message"]]
    start = {"line": 0, "character": 0}
    inserted = client.edit(path, [{"range": {"start": start, "end": start}, "text": f"# 🚗{newline}{newline}"}])
    (moved,) = [each for each in inserted if "flaot" in each["message"]]
    assert moved["range"]["start"] == {**first["range"]["start"], "line": first["range"]["start"]["line"] + 2}
    deleted = client.edit(path, [{"range": {"start": start, "end": {"line": 2, "character": 0}}, "text": ""}])
    assert first in deleted
