"""Documents that tried to get code into generated files: each is a finding at its field, wherever it is given."""

import json
from collections.abc import Iterator

import pytest

from sigcat.api.application import create_app
from sigcat.api.settings import DEFAULT_SETTINGS
from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.cli import main
from sigcat.function.document.document import Pointer, pointer_text
from sigcat.platforms.table import PLATFORMS
from tests.adapter.hostile.everything import FUNCTION, FUNCTION_JSON, changed, document
from tests.api.conftest import asker

STEP: Pointer = ("ComponentList", 0, "functionList", 1)
CONTRACT: Pointer = (*STEP, "funcContractList", 0)
OF_FUNCTION: dict[Pointer, str] = {
    ("FunctionInfo", "Version"): '1.0"; */ static int evil = system("id"); /*',
    ("Code", "Sources", 0): "x.c)\nexecute_process(COMMAND id)\n#.c",
    ("Code", "Headers", 0): 'x.h"\nint evil;\n"',
    ("Code", "IncludeFolders", 0): "../../etc",
    ("Code", "Macros", 0, "Replacement"): "2)\nexecute_process(COMMAND id",
    (*STEP, "Symbol"): "Demo_step(); evil",
    (*STEP, "PreProcessing", 0): "evil(); f",
    (*CONTRACT, "SignalList", 0, "TimeoutValue"): "Last; evil()",
    (*CONTRACT, "SignalList", 0, "Variable"): "x = system(0)",
    (*CONTRACT, "SignalList", 0, "Units"): "m/s */ evil(); /*",
    (*CONTRACT, "SignalList", 1, "Name"): 'a" evil',
    (*CONTRACT, "ErrorList", 0, "Name"): 'Demo_"evil"_ErrorSts',
    (*CONTRACT, "MethodList", 0, "Symbol"): "f(evil())",
    ("Datatypes", 0, "cDef"): "int; int evil",
}
"""Payloads of Function JSON, and of the functions that an Integration JSON carries."""
OF_PLATFORM: dict[str, dict[Pointer, str]] = {
    "autosar-adaptive": {
        ("FunctionInformation", "FunctionName"): "A\n#include <evil>",
        ("ComponentList", 0, "ExecutableName"): "A)\nexecute_process(",
        ("ComponentList", 0, "ServiceInterfaceList", 0, "Name"): 'A"><evil/>',
    },
    "autosar-classic": {
        ("ApplicationInformation", "Name"): "A */ int evil; /*",
        ("ImplementationTypes", 0, "Name"): "int; int evil",
        ("Components", 0, "Runnables", 0, "Symbol"): "f(void) {} void evil",
    },
    "ros2": {
        ("CommunicationList", 0, "ROSTopicList", 0, "DataMappingList", 0, "FieldList", 0, "Field"): "a; evil(); b",
        ("NodePackageList", 0, "Name"): "a)\nexecute_process(",
        ("InterfacePackageList", 0, "Messages", 0, "Fields", 0, "Name"): "a\nuint8 evil",
    },
}


def cases() -> Iterator[tuple[str, Pointer, str]]:
    yield from ((FUNCTION_JSON, pointer, payload) for pointer, payload in OF_FUNCTION.items())
    for platform, payloads in OF_PLATFORM.items():
        yield from ((platform, pointer, payload) for pointer, payload in payloads.items())
        for pointer, payload in OF_FUNCTION.items():
            yield platform, ("SourceFunctionList", 0, *pointer), payload


CASES = list(cases())
NAMES = [f"{kind}{pointer_text(pointer)}" for kind, pointer, _ in CASES]


def generators(kind: str) -> tuple[str, ...]:
    return ("core",) if kind == FUNCTION_JSON else tuple(each.name for each in PLATFORMS[kind].generators)


@pytest.fixture(scope="module")
def ask():
    return asker(create_app(Library([each for each in shipped_sources() if each.id == "interfaces"]), DEFAULT_SETTINGS))


def place_of(data: bytes, payload: str) -> tuple[int, int]:
    """Line and column of a value in a document that was written with one value a line."""
    lines = data.decode().split("\n")
    number, line = next((index, each) for index, each in enumerate(lines, 1) if json.dumps(payload) in each)
    return number, line.index(json.dumps(payload)) + 1


@pytest.mark.parametrize(("kind", "pointer", "payload"), CASES, ids=NAMES)
def test_a_payload_is_a_finding_at_its_field(kind, pointer, payload, tmp_path, capsys, monkeypatch, ask):
    monkeypatch.chdir(tmp_path)
    data = changed(kind, pointer, payload)
    (tmp_path / "document.json").write_bytes(data)
    line, column = place_of(data, payload)
    for generator in generators(kind):
        assert main(["generate", generator, "document.json", "-o", "out"]) == 1
        assert f"document.json:{line}:{column}: error" in capsys.readouterr().err
        assert not (tmp_path / "out").exists()
        answer = ask(f"/api/v1/generate/{generator}", "POST", content=data)
        assert answer.status_code == 422
        assert pointer_text(pointer) in {each["pointer"] for each in answer.json()["findings"]}
    if kind == FUNCTION_JSON:
        assert main(["function", "validate", "document.json"]) == 1
        assert f"document.json:{line}:{column}: error" in "".join(capsys.readouterr())
        answer = ask("/api/v1/functions/validate", "POST", content=data).json()
        errors = {each["pointer"] for each in answer["findings"] if each["severity"] == "error"}
        assert not answer["ok"]
        assert pointer_text(pointer) in errors


def test_a_payload_of_a_function_yaml_is_a_finding_at_its_line(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = FUNCTION.read_text().replace("symbol: Demo_step", 'symbol: "Demo_step(); evil"')
    (tmp_path / "function.yaml").write_text(text)
    line = next(index for index, each in enumerate(text.split("\n"), 1) if "evil" in each)
    assert main(["generate", "core", "function.yaml", "-o", "out"]) == 1
    assert f"function.yaml:{line}:" in capsys.readouterr().err
    assert main(["lint", "function.yaml"]) == 1
    assert f"function.yaml:{line}:" in "".join(capsys.readouterr())


@pytest.mark.parametrize("kind", [FUNCTION_JSON, *PLATFORMS])
def test_without_a_payload_it_is_generated(kind, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "document.json").write_bytes(document(kind))
    for generator in generators(kind):
        assert main(["generate", generator, "document.json", "-o", generator]) == 0
