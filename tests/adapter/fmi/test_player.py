"""`sigcat simulate --fmu` lives through an FMU that crashes, hangs or takes all memory, and says what happened."""

import json
import shutil
import zipfile
from pathlib import Path
from types import SimpleNamespace

import pytest

from sigcat.adapter.host.shapes import Array, Number
from sigcat.cli import main
from sigcat.players.fmu import read_fmu
from tests.adapter.fmi.fmus import built
from tests.needs import cmake

pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
pytestmark = cmake
HERE = Path(__file__).parent
MISBEHAVING = """
    if (self->acceleration > 90.0f) {
        for (;;) {
        }
    }
    if (self->acceleration > 80.0f) {
        __builtin_trap();
    }
    if (self->acceleration > 70.0f) {
        volatile char *taken = malloc((size_t)1 << 34);
        taken[0] = 1;
    }
    self->count++;"""


@pytest.fixture(scope="module")
def fmu(tmp_path_factory):
    """An FMU that loops, traps or takes 16 GiB at an acceleration."""
    folder = tmp_path_factory.mktemp("fmu")
    shutil.copytree(HERE / "averaging", folder / "averaging")
    code = folder / "averaging/averaging.c"
    text = code.read_text()
    assert "    self->count++;" in text
    code.write_text("#include <stdlib.h>\n" + text.replace("    self->count++;", MISBEHAVING))
    return built([folder / "averaging/function.yaml"], folder).file


def play(fmu, folder, value, *options):
    trace = folder / "trace.csv"
    trace.write_text(f"time,Vehicle.Acceleration.Longitudinal\n0.05,{value}\n0.1,0\n")
    return main(["simulate", "--fmu", str(fmu), "--trace", str(trace), "-o", str(folder / "out.csv"), *options])


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (95, "did not return from the step at 0.05 s within 1 s."),
        (85, "ended with signal 4 at 0.05 s."),
        (75, "ended with signal 11 at 0.05 s."),
    ],
)
def test_what_an_fmu_does_is_an_error_with_the_time_of_the_step(fmu, tmp_path, capfd, value, message):
    limit = "1" if "return" in message else "60"
    assert play(fmu, tmp_path, value, "--step-limit", limit) == 2
    assert message in capfd.readouterr().err
    assert not (tmp_path / "out.csv").exists()


def test_one_that_behaves_comes_to_its_end(fmu, tmp_path):
    assert play(fmu, tmp_path, 5) == 0
    assert len((tmp_path / "out.csv").read_text().splitlines()) > 1


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--expect", "other.csv"], "--fmu runs an FMU alone, without --expect."),
        (["-o", "again.csv"], "--fmu writes one CSV file"),
    ],
)
def test_options_that_an_fmu_does_not_have_are_refused(fmu, tmp_path, capsys, options, message):
    assert play(fmu, tmp_path, 5, *options) == 2
    assert message in capsys.readouterr().err


def test_a_step_is_that_of_an_fmu(capsys):
    assert main(["simulate", "--step", "10"]) == 2
    assert "it needs --fmu FILE" in capsys.readouterr().err


def test_a_file_that_is_none_is_an_error(tmp_path, capsys):
    (tmp_path / "a.fmu").write_bytes(b"PK\x03\x04 not a zip")
    (tmp_path / "trace.csv").write_text("time,a\n0,1\n")
    assert main(["simulate", "--fmu", str(tmp_path / "a.fmu"), "--trace", str(tmp_path / "trace.csv")]) == 2
    assert "is not an FMU" in capsys.readouterr().err


def test_a_document_with_another_start_value_is_refused(tmp_path, capsys):
    document = tmp_path / "fmi.json"
    assert main(["integrate", "fmi", str(HERE / "averaging/function.yaml"), "-o", str(document)]) == 0
    whole = json.loads(document.read_text())
    (weight,) = (each for each in whole["FmuList"][0]["VariableList"] if each["Name"].endswith("Weight"))
    assert weight["Start"] == [0.25]
    weight["Start"] = [0.5]
    document.write_text(json.dumps(whole, indent=1))
    assert main(["generate", "fmi", str(document), "-o", str(tmp_path / "made")]) == 1
    assert (
        "error J002 Vehicle.Function.Averaging.Parameter.Weight must have the type, dimension, causality and start value"
        in capsys.readouterr().err
    )
    assert not (tmp_path / "made").exists()


def test_a_trace_of_simulate_names_interfaces_as_it_does_there(monkeypatch):
    mode, speed = "Vehicle.Function.Spray.Mode.In", "h"
    variables = [
        SimpleNamespace(
            name=name, valueReference=number, type="Int32", causality="input", variability="discrete", shape=()
        )
        for number, name in enumerate((mode, speed))
    ]
    description = SimpleNamespace(coSimulation=True, defaultExperiment=None, modelVariables=variables)
    monkeypatch.setattr("fmpy.read_model_description", lambda _: description)
    inputs = read_fmu(Path("spray.fmu")).inputs
    assert {name: port.name for name, port in inputs.items()} == {mode: mode, "Spray_Mode_In": mode, speed: speed}


ARRAYS = """<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="3.0" modelName="Arrays" instantiationToken="{0}">
  <CoSimulation modelIdentifier="Arrays"/>
  <ModelVariables>
    <Float64 name="time" valueReference="0" causality="independent" variability="continuous"/>
    <UInt64 name="n" valueReference="1" causality="structuralParameter" variability="tunable" start="3"/>
    <Float64 name="gain" valueReference="2" causality="parameter" variability="tunable" start="1"/>
    <Float64 name="matrix" valueReference="3" causality="input" start="0 0 0 0 0 0">
      <Dimension start="2"/><Dimension valueReference="1"/>
    </Float64>
    <String name="text" valueReference="4" causality="output"/>
    <Binary name="bytes" valueReference="5" causality="output"/>
    <Float64 name="rows" valueReference="6" causality="output"><Dimension valueReference="1"/></Float64>
  </ModelVariables>
  <ModelStructure><Output valueReference="4"/><Output valueReference="5"/><Output valueReference="6"/></ModelStructure>
</fmiModelDescription>
"""


def test_a_structural_parameter_is_a_length_and_texts_are_not_read(tmp_path):
    file = tmp_path / "arrays.fmu"
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("modelDescription.xml", ARRAYS)
    read = read_fmu(file)
    number = Number("double")
    assert {name: (port.shape, port.size) for name, port in read.inputs.items()} == {
        "gain": (number, 1),
        "matrix": (Array(Array(number, 3), 2), 6),
    }
    assert [(port.name, port.shape, port.size) for port in read.outputs] == [("rows", Array(number, 3), 3)]


def test_an_unknown_column_is_not_an_input_of_the_fmu(fmu, tmp_path, capsys):
    (tmp_path / "trace.csv").write_text("time,Vehicle.Sped\n0,1\n")
    assert main(["simulate", "--fmu", str(fmu), "--trace", str(tmp_path / "trace.csv")]) == 1
    assert (
        "The column 'Vehicle.Sped' is not an input of the FMU. Did you mean 'Vehicle.Speed'?" in capsys.readouterr().err
    )
