"""The command that writes ARXML, and its report."""

import json

import pytest

from sigcat.adapter.autosar_adaptive.arxml.adaptive_arxml import generate
from sigcat.adapter.autosar_adaptive.arxml.field_targets import TABLES
from sigcat.cli import main
from sigcat.function.function_json.wire import written as to_json
from tests.adapter.arxml_made import lost, made
from tests.integration.autosar_adaptive.sets import at, derive, examples, function

# -- the command ---------------------------------------------------------------------------------------------------------


def test_the_command_writes_the_files(tmp_path):
    source = tmp_path / "integration.json"
    source.write_bytes(to_json(derive(examples()).model))
    assert main(["generate", "arxml", str(source), "-o", str(tmp_path / "out")]) == 0
    written = {path.name: path.read_bytes() for path in (tmp_path / "out").glob("*.arxml")}
    assert written == {file.name: file.data for file in made("examples")}


def test_the_command_refuses_what_is_no_integration(tmp_path, capsys):
    source = tmp_path / "integration.json"
    source.write_text("{}", encoding="utf-8")
    assert main(["generate", "arxml", str(source), "-o", str(tmp_path / "out")]) == 1
    assert "F002" in capsys.readouterr().err
    assert main(["generate", "arxml", str(tmp_path / "none.json"), "-o", str(tmp_path / "out")]) == 2


def test_the_command_writes_a_release_that_is_asked_for(tmp_path, capsys):
    source = tmp_path / "integration.json"
    source.write_bytes(to_json(derive(examples()).model))
    assert main(["generate", "arxml", str(source), "-o", str(tmp_path / "out"), "--release", "R22-11"]) == 0
    written = {path.name: path.read_bytes() for path in (tmp_path / "out").glob("*.arxml")}
    assert written == {file.name: file.data for file in made("examples", "R22-11")}
    with pytest.raises(SystemExit, match="2"):
        main(["generate", "arxml", str(source), "-o", str(tmp_path / "out"), "--release", "R19-11"])
    assert "R20-11" in capsys.readouterr().err


# -- the report ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("part", TABLES)
def test_each_field_of_the_document_has_a_place_in_the_arxml(part):
    parts = [f".{each.__name__}" for each in TABLES]
    inner = {
        name
        for name, info in part.model_fields.items()
        if any(f"{each}, ...]" in str(info.annotation) or f"{each} |" in str(info.annotation) for each in parts)
        or info.annotation in TABLES
    }
    wanted = {info.alias for name, info in part.model_fields.items()}
    held = {part.model_fields[name].alias for name in inner}
    assert wanted - held <= TABLES[part][1].keys() <= wanted


def test_no_value_of_the_document_is_lost():
    model = derive(examples()).model.model_copy(update={"functions": None})
    assert lost(to_json(model), generate(model), ELSEWHERE) == []


ELSEWHERE = {"Class", "HeaderFolders", "Release", "Transformation"}
"""Fields whose words are other ones in ARXML: categories, the schema, byte orders; or that it has no place for."""


def test_what_a_call_makes_of_a_value_stands_in_admin_data():
    value = at(
        "Vehicle.A.B", Timeout="150", TimeoutError="Demo_Late_ErrorSts", RangeErrorAction="Init", Variable="bus.b"
    )
    value |= {"ConversionFactor": "5/18", "ConversionOffset": "0"}
    written = {file.name: file.data.decode() for file in generate(derive([function(signals=[value])]).model)}
    for key, text in (("Timeout", "150"), ("RangeErrorAction", "Init"), ("Variable", "bus.b"), ("ConversionFactor", "5/18")):  # fmt: skip
        assert f'<SD GID="A_B.Demo_Step.{key}">{text}</SD>' in written["components.arxml"]


def test_the_command_reports_where_each_field_went(tmp_path):
    (tmp_path / "integration.json").write_bytes(to_json(derive(examples()).model))
    report = tmp_path / "report.json"
    arguments = ["generate", "arxml", str(tmp_path / "integration.json"), "-o", str(tmp_path / "out")]
    assert main([*arguments, "--report", str(report)]) == 0
    rows = json.loads(report.read_text(encoding="utf-8"))
    assert {"event", "call", "parameter", "service"} <= {row["kind"] for row in rows}
    assert [row for row in rows if row["target"] == "not carried"] == []
