"""Diagnostics are the findings of `sigcat lint`, of the text in the editor."""

import json
from pathlib import Path
from typing import Any

import pytest

from bench.editor import Editor
from tests.lsp.conftest import CABIN, FUNCTION, LIMITS, tree_text


def test_findings_are_those_of_the_command(
    client: Editor, project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The same rules at the same places, for each file of the project."""
    monkeypatch.chdir(project)
    for name in ("overlays/cabin.vspec", "overlays/limits.vspec", "functions/cabin_air/function.yaml", "sigcat.toml"):
        assert _found(client.open(project / name)) == _of_command(name, capsys), name


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("overlays/cabin.vspec", CABIN.replace("boolean", "flaot")),
        ("overlays/cabin.vspec", CABIN.replace("percent", "°C").replace("Carbon", "🚗 Carbon")),
        ("overlays/limits.vspec", LIMITS.replace("max: 50", "max: slow")),
        ("overlays/limits.vspec", LIMITS.replace("Cabin.Gas", "Cabni.Gas")),
        ("overlays/limits.vspec", f"{LIMITS}  max: 3\n  ]"),
        ("tree/Acme.vspec", tree_text().replace("unit: km/h", "unit: kmh", 1)),
        ("functions/cabin_air/function.yaml", FUNCTION.replace("Cabin.Gas", "Cabin.Gsa")),
        ("sigcat.toml", "[[catalogues]]\n"),
        ("sigcat.toml", '[[vehicle]]\nid = "v"\nwithout = ["Vehicle.Sped"]\n'),
    ],
)
def test_unsaved_texts_have_the_findings_of_a_saved_file(
    client: Editor,
    project: Path,
    name: str,
    text: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The file on the disk stays as it is; a copy of the project with the text saved is linted by the command."""
    copy = _copied(project, tmp_path)
    (copy / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(copy)
    client.open(project / name)
    found = client.change(project / name, text)
    client.close(project / name)
    assert _found(found) == _of_command(name, capsys)
    assert found


def test_an_unsaved_overlay_is_below_those_that_stack_on_it(client: Editor, project: Path) -> None:
    """A signal that an open overlay renames is missing in the next one."""
    cabin, limits = project / "overlays/cabin.vspec", project / "overlays/limits.vspec"
    client.open(cabin, CABIN.replace("Cabin.Gas", "Cabin.Air"))
    assert [each["code"] for each in client.open(limits, LIMITS.replace("  type: sensor\n  datatype: float\n", ""))]
    client.open(cabin)
    assert client.change(limits, LIMITS) == []


def test_ranges_count_utf_16_code_units(client: Editor, project: Path) -> None:
    """A character beyond the basic plane counts twice."""
    path = project / "overlays/cabin.vspec"
    text = "Vehicle.Cabin.Door.IsOpen: {description: 🚗., type: sensor, datatype: flaot}\n"
    client.open(path)
    found = client.change(path, text)
    (wrong,) = [each for each in found if "flaot" in each["message"]]
    start = len(text[: text.index("flaot")].encode("utf-16-le")) // 2
    assert wrong["range"]["start"] == {"line": 0, "character": start}
    assert wrong["range"]["end"] == {"line": 0, "character": start + 5}


def test_quick_fixes_are_the_repairs_of_fix(client: Editor, project: Path) -> None:
    """An edit of the wrong part alone, and one for all that is safe."""
    path = project / "overlays/cabin.vspec"
    client.open(path)
    text = CABIN.replace("Carbon dioxide in the air.", "carbon dioxide in the air")
    found = client.change(path, text)
    assert found
    actions = client.ask("textDocument/codeAction", {
        **client.at(path, "carbon"), "range": found[0]["range"], "context": {"diagnostics": found},
    })  # fmt: skip
    kinds = {each["kind"] for each in actions}
    assert kinds == {"quickfix", "source.fixAll.sigcat"}
    (all_fixes,) = [each for each in actions if each["kind"] != "quickfix"]
    assert _edited(text, all_fixes["edit"]["changes"][path.as_uri()]) == CABIN


def test_what_stops_the_command_is_a_diagnostic(client: Editor, project: Path) -> None:
    """A tree without signals."""
    (found,) = client.open(project / "tree/Acme.vspec", "Vehicle:\n  type: branch\n  description: A car.\n")
    assert "no signals" in found["message"]
    client.close(project / "tree/Acme.vspec")


def test_a_project_file_that_cannot_be_read_does_not_end_the_server(client: Editor, project: Path) -> None:
    """Findings are at the project file; other files are checked again after it is right."""
    path = project / "sigcat.toml"
    client.open(path, "catalogue = [")
    assert client.open(project / "overlays/limits.vspec") == []
    client.close(path)
    assert client.open(project / "overlays/limits.vspec", LIMITS.replace("50", "slow"))


def _edited(text: str, edits: list[Any]) -> str:
    lines = text.splitlines(keepends=True)
    for edit in edits:
        ends = edit["range"]["start"], edit["range"]["end"]
        start, end = (sum(map(len, lines[: at["line"]])) + at["character"] for at in ends)
        text = text[:start] + edit["newText"] + text[end:]
    return text


def _copied(project: Path, folder: Path) -> Path:
    for path in project.rglob("*"):
        if path.is_file():
            target = folder / path.relative_to(project)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(path.read_bytes())
    return folder


def _found(diagnostics: list[Any]) -> list[tuple[str, int, str]]:
    return [(each["code"], each["range"]["start"]["line"], each["message"]) for each in diagnostics]


def _of_command(name: str, capsys: pytest.CaptureFixture[str]) -> list[tuple[str, int, str]]:
    if name == "sigcat.toml":
        return _of_project(name)
    from sigcat.cli import main

    main(["lint", "--format", "json", name])
    found = json.loads(capsys.readouterr().out)["findings"]
    return [
        (each["rule"], max(each["line"] - 1, 0), f"{each['message']} {each['fix']}".rstrip())
        for each in found
        if each["file"] == name
    ]


def _of_project(name: str) -> list[tuple[str, int, str]]:
    from sigcat.errors import InputRefused
    from sigcat.project.read_project import read_project
    from sigcat.project.vehicles import vehicle_findings

    try:
        found = tuple(vehicle_findings(read_project(Path(name))))
    except InputRefused as error:
        found = tuple(error.findings)
    return [(f.rule, max(f.line - 1, 0), f"{f.message} {f.fix}".rstrip()) for f in found]
