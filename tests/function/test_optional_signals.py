"""Optional signals: in a vehicle without one, a function builds and runs, and its variable has the start value."""

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from sigcat.cli import main
from sigcat.findings import Finding
from sigcat.function.function_file import check_function, checked_file
from sigcat.function.function_json.model import FunctionJson, to_json
from sigcat.function.function_json.triggers import triggers
from sigcat.function.function_json.walk import calls_of
from sigcat.function.sets.check_set import check_functions
from tests.adapter.written import U8, absent, function, on_event, signal
from tests.function.shipped import interfaces
from tests.needs import c_compiler

CASE = Path(__file__).with_name("optional")
ROOF = "functions/roof/function.yaml"
POSITION, LOAD = "Vehicle.Cabin.Sunroof.Position", "Vehicle.Trailer.Load"
SEAT, SWITCH = "Vehicle.Cabin.Seat.Row2.DriverSide.Position", "Vehicle.Cabin.Sunroof.Switch"
SHADE = "Vehicle.Cabin.Sunroof.Shade.Position"


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    shutil.copytree(CASE, tmp_path / "project")
    monkeypatch.chdir(tmp_path / "project")
    return tmp_path / "project"


def built(vehicle: str, call: int = 1) -> dict[str, Any]:
    """The contract of a call in a vehicle."""
    assert main(["function", "build", ROOF, "-s", vehicle, "-o", "built.json"]) == 0
    document = json.loads(Path("built.json").read_bytes())
    contract: dict[str, Any] = document["ComponentList"][0]["functionList"][call]["funcContractList"][0]
    return contract


def paths(contract: dict[str, Any], key: str) -> list[str]:
    return [each["VssPath"] for each in contract.get(key, ())]


# -- vehicles -----------------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("project")
def test_a_note_names_the_vehicles_without_a_signal(capsys: pytest.CaptureFixture[str]):
    assert main(["function", "validate", ROOF, "--vehicles", "all", "--format", "json"]) == 0
    findings = json.loads(capsys.readouterr().out)["findings"]
    assert {each["severity"] for each in findings} == {"info"}
    told = {each["path"]: each["message"] for each in findings if each["message"].startswith("Vehicle")}
    assert set(told) == {POSITION, LOAD, SEAT, SWITCH, SHADE}
    assert told[SEAT] == f"Vehicle 'coupe' has no {SEAT!r}. It is optional: the function runs without it."


@pytest.mark.usefixtures("project")
def test_several_vehicles_are_one_note(project: Path, capsys: pytest.CaptureFixture[str]):
    more = '\n[[vehicle]]\nid = "van"\nwithout = ["Vehicle.Cabin.Sunroof"]\n'
    (project / "sigcat.toml").write_text((project / "sigcat.toml").read_text() + more)
    assert main(["function", "validate", ROOF, "--vehicles", "all"]) == 0
    assert f"Vehicles 'coupe' and 'van' have no {POSITION!r}." in capsys.readouterr().out


@pytest.mark.usefixtures("project")
def test_without_optional_a_missing_signal_is_an_error(project: Path, capsys: pytest.CaptureFixture[str]):
    text = (project / ROOF).read_text()
    (project / ROOF).write_text(text.replace("            optional: true\n            absentError: NoSunroof\n", ""))
    assert main(["function", "validate", ROOF, "--vehicles", "coupe"]) == 1
    assert f"error F010 Vehicle 'coupe' has no {POSITION!r}, which Roof_Step consumes." in capsys.readouterr().out


@pytest.mark.usefixtures("project")
def test_signals_that_a_vehicle_has_are_exchanged():
    contract = built("vehicle:truck")
    assert paths(contract, "AbsentSignalList") == []
    assert {POSITION, SEAT, LOAD, SWITCH} < set(paths(contract, "SignalList"))


@pytest.mark.usefixtures("project")
def test_signals_that_a_vehicle_lacks_keep_their_types():
    """That of the catalogue if the vehicle removes the signal, or has fewer instances; else the declared one."""
    contract = built("vehicle:coupe")
    assert paths(contract, "SignalList") == ["Vehicle.Speed", "Vehicle.Cabin.Infotainment.HMI.Brightness"]
    types = {each["VssPath"]: (each["Datatype"], each["VssDatatype"]) for each in contract["AbsentSignalList"]}
    assert types == {
        POSITION: ("DT_SInt8", "int8"), SEAT: ("DT_Float32", "uint16"), LOAD: ("DT_UInt16", "uint16"),
        SWITCH: ("DT_CabinSunroofSwitch", "string"),
    }  # fmt: skip


@pytest.mark.usefixtures("project")
def test_a_queue_is_absent_in_a_list_of_its_own():
    assert paths(built("vehicle:coupe", 2), "AbsentDataQList") == [SHADE]
    assert paths(built("vehicle:truck", 2), "DataQList") == [SHADE]


@pytest.mark.usefixtures("project")
@pytest.mark.parametrize("platform", ["autosar-adaptive", "autosar-classic", "ros2", "fmi"])
def test_every_platform_integrates_and_generates_it(platform: str, capsys: pytest.CaptureFixture[str]):
    """A call whose only trigger is absent is never due; no field is left out of the report."""
    output = ["-o", f"{platform}.json", "--report", "report.md"]
    assert main(["integrate", platform, ROOF, "-s", "vehicle:coupe", *output]) == 0
    assert "warning" not in capsys.readouterr().err
    assert main(["generate", platform, f"{platform}.json", "-o", platform]) == 0
    assert "| not carried |" not in Path("report.md").read_text()
    document = json.loads(Path(f"{platform}.json").read_text())
    document.pop("SourceFunctionList", None)
    document.pop("ComponentList" if platform == "ros2" else "", None)
    assert "Sunroof.Position" not in json.dumps(document)


@c_compiler
@pytest.mark.usefixtures("project")
@pytest.mark.parametrize(
    ("vehicle", "first", "status"),
    [("coupe", 20 + 2.5 + 0.007 + 40, "FAILED"), ("truck", 10 + 5 + 0.5, "PASSED")],
)
def test_a_simulated_function_has_the_start_value(vehicle, first, status, capsys: pytest.CaptureFixture[str]):
    assert main(["simulate", ROOF, "-s", f"vehicle:{vehicle}", "--trace", "drive.csv"]) == 0
    done = capsys.readouterr()
    header, _, row, *_ = (line.split(",") for line in done.out.splitlines())
    values = dict(zip(header, row, strict=True))
    assert float(values["Vehicle.Cabin.Infotainment.HMI.Brightness"]) == pytest.approx(first)
    assert values["Roof_NoSunroof_ErrorSts"] == status
    assert (SWITCH in header) == (vehicle == "truck")
    assert not any(rule in done.err for rule in ("T002", "T007"))


@c_compiler
@pytest.mark.usefixtures("project")
def test_a_trace_needs_no_column_for_an_absent_signal(project: Path, capsys: pytest.CaptureFixture[str]):
    (project / "speed.csv").write_text("time,Vehicle.Speed\n0,50\n0.2,120\n")
    assert main(["simulate", ROOF, "-s", "vehicle:coupe", "--trace", "speed.csv"]) == 0
    assert "T007" not in capsys.readouterr().err


# -- the file -----------------------------------------------------------------------------------------------------


def yaml(*data: str, errors: str = "", more: str = "") -> bytes:
    listed = "".join(f"          - {each}\n" for each in data)
    return f"""\
function: CoreAcc
description: Cruise control.
responsible: Cruise control team
components:
  - name: CoreAcc
    runnables:
      - interface: CoreAcc_Step
{more}        data:
{listed}        errors: [{errors}]
""".encode()


def found(*data: str, errors: str = "", more: str = "") -> list[tuple[str, str, int]]:
    findings = check_function(yaml(*data, errors=errors, more=more), "function.yaml", interfaces())
    return [(each.rule, each.severity, each.line) for each in findings if each.rule != "F056"]


SPEED = "{path: Vehicle.Speed, role: consumed, asil: QM}"


@pytest.mark.parametrize(
    ("item", "rule"),
    [
        ("path: Vehicle.No, role: consumed, optional: true, datatype: uint8, init: 1", "F114"),
        ("path: Vehicle.No, role: consumed, optional: true, values: {A: 1, B: 2}, init: B", "F114"),
        ("path: Vehicle.No, role: provided, optional: true, datatype: uint8", "F114"),
        ("path: Vehicle.No, role: consumed, optional: true, init: 1", "F115"),
        ("path: Vehicle.No, role: consumed, optional: true, datatype: uint9, init: 1", "F115"),
        ("path: Vehicle.No, role: consumed, optional: true, datatype: 'uint8[]', init: 1", "F115"),
        ("path: Vehicle.No, role: consumed, optional: false, datatype: uint8, init: 1", "F010"),
        ("path: Vehicle.Chassis.Axle.Wheel.Speed, role: consumed, optional: true, datatype: float, init: 1", "F010"),
        ("path: Vehicle.Chassis, role: consumed, optional: true, init: 1", "F011"),
        ("path: Vehicle.Cabin.Door.Row1.DriverSide.IsOpne, role: consumed, optional: true, init: 1", "F115"),
        ("path: Vehicle.Cabin.Door.Row9.DriverSide.IsOpen, role: consumed, optional: true, init: true", "F114"),
        ("path: Vehicle.Speed, role: consumed, optional: true", "F116"),
        ("path: Vehicle.Speed, role: consumed, optional: maybe", "F004"),
    ],
)
def test_a_wrong_entry_is_reported_at_its_line(item: str, rule: str):
    rules = found(SPEED if "Vehicle.Speed" not in item else "{path: Vehicle.IsMoving, role: consumed, asil: QM}",
                  f"{{{item}, asil: QM}}")  # fmt: skip
    assert [(each, line) for each, _, line in rules] == [(rule, 10)]


def test_the_error_of_an_absent_signal_must_be_declared():
    item = "{path: Vehicle.Speed, role: consumed, optional: true, init: 0, asil: QM, absentError: ProposalTimeout}"
    assert found(item) == [("F222", "error", 9)]
    assert found(item, errors="ProposalTimeout") == []
    gone = item.replace("Vehicle.Speed", "Vehicle.No").replace("init", "datatype: float, init")
    assert [rule for rule, *_ in found(gone)] == ["F114", "F222"]
    assert [rule for rule, *_ in found(gone, errors="ProposalTimeout")] == ["F114"]


@pytest.mark.parametrize("item", ["role: consumed, init: 0", "role: provided, optional: true"])
def test_an_error_for_the_absence_needs_an_optional_input(item: str):
    entry = f"{{path: Vehicle.Speed, {item}, asil: QM, absentError: ProposalTimeout}}"
    assert [rule for rule, *_ in found(entry, errors="ProposalTimeout") if rule.startswith("F11")] == ["F117"]


def test_a_misspelled_path_has_a_proposal():
    item = "{path: Vehicle.Sped, role: consumed, optional: true, datatype: float, init: 0, asil: QM}"
    (finding,) = notes(yaml(item))
    assert finding.fix == "Did you mean 'Vehicle.Speed'?"


def notes(data: bytes) -> list[Finding]:
    return [each for each in check_function(data, "function.yaml", interfaces()) if each.rule == "F114"]


@pytest.mark.parametrize(("more", "rules"), [("", ["F103"]), ("optional: true, ", [])])
def test_an_optional_signal_needs_no_provider(more: str, rules: list[str]):
    own = "Vehicle.ADAS.EcoControl.AccelerationProposal"
    data = yaml(f"{{path: {own}, role: consumed, {more}asil: QM, init: 0}}")
    said = check_functions([(data, "function.yaml")], interfaces())
    assert [each.rule for each in said if each.path == own and each.rule in ("F103", "F116")] == rules


# -- Function JSON ------------------------------------------------------------------------------------------------


def test_events_that_are_absent_trigger_nothing():
    items = (absent(signal("Gone", U8)), signal("There", U8))
    for more, names in (({"EventList": "Gone"}, []), ({"EventList": "There"}, ["There"]), ({}, ["There"])):
        (call,) = calls_of(function(on_event(*items, **more)))
        assert [each.name for each in triggers(call)] == names


def test_a_document_is_compared_with_the_catalogue():
    """One that was built for another vehicle is reported: what it exchanges may be absent, or what is absent be there."""
    gone = yaml("{path: Vehicle.No, role: consumed, optional: true, datatype: float, init: 0, asil: QM}")
    document = checked_file(gone, "function.yaml", interfaces()).function
    assert document is not None
    assert [each.rule for each in compared(document) if each.rule in ("F010", "F016", "F114")] == []
    for path, key, rule in (("Vehicle.Speed", "absent_signals", "F016"), ("Vehicle.No", "signals", "F114")):
        assert [
            each.rule for each in compared(moved(document, path, key)) if each.rule in ("F010", "F016", "F114")
        ] == [rule]


def moved(document: FunctionJson, path: str, key: str) -> FunctionJson:
    """The document with its absent signal at another path, in a list."""
    text = json.loads(to_json(document))
    contract = text["ComponentList"][0]["functionList"][0]["funcContractList"][0]
    (item,) = contract.pop("AbsentSignalList")
    wire = {"absent_signals": "AbsentSignalList", "signals": "SignalList"}[key]
    contract[wire] = [{**item, "VssPath": path}]
    return FunctionJson.model_validate_json(json.dumps(text))


def compared(document: FunctionJson) -> tuple[Finding, ...]:
    return check_function(to_json(document), "function.json", interfaces())
