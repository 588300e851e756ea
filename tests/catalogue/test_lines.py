"""Positions count lines as editors do: a file may have other characters that YAML 1.1 takes for ends of lines."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.catalogue.reading.yaml_document import position, read_document
from sigcat.cli import main
from sigcat.text_lines import line_and_column, lines_of

ENDS = ["\u2028", "\u2029", "\x85"]


@given(st.text(alphabet="ab\r\n\u2028\x85\x0b\x0c"))
def test_lines_end_with_lf_and_cr_alone(text: str) -> None:
    assert lines_of(text, keepends=True) == [line.decode() for line in text.encode().splitlines(keepends=True)]
    assert lines_of(text) == [line.decode() for line in text.encode().splitlines()]
    for index, character in enumerate(text):
        if character not in "\r\n":
            line, column = line_and_column(text, index)
            assert lines_of(text)[line][column] == character


@pytest.mark.parametrize("end", ENDS)
@pytest.mark.parametrize("written", ['"x{}y"', "x{}        y", "x # z{}"])
def test_a_node_is_in_the_line_that_an_editor_shows(end: str, written: str) -> None:
    text = f"a:\n  b: {written.replace('{}', end)}\n  c: &d [1]\ne: *d\n"
    root = read_document(text.encode(), "a.yaml").root
    assert root is not None
    (_, inner), (key, alias) = root.value
    assert [position(each) for each in (inner.value[1][0], inner.value[1][1], key, alias)] == [
        (3, 3), (3, 6), (4, 1), (3, 6)
    ]  # fmt: skip


@pytest.mark.parametrize("end", ENDS)
@pytest.mark.parametrize("broken", ["c: [", " c: d", "c: {{" * 100 + "[" * 500])
def test_an_error_is_in_the_line_that_an_editor_shows(end: str, broken: str) -> None:
    (finding,) = read_document(f'a: "x{end}y"\n{broken}\n'.encode(), "a.yaml").findings
    assert finding.line in (2, 3)
    assert "line 1" not in finding.fix.replace("as line 1", "")


@pytest.mark.parametrize("end", ENDS)
def test_a_report_shows_the_line_of_the_finding(end: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "overlay.vspec"
    file.write_text(f'Vehicle.Speed:\n  description: "a{end}b"\n  unit: furlong\n', encoding="utf-8", newline="")
    assert main(["lint", str(file)]) == 1
    report = capsys.readouterr().out
    assert f"{file}:3:9: error V006" in report
    assert "    3 |   unit: furlong\n" in report
