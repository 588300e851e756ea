"""What a bus of an FMU cannot be is a finding, with the place and what to do."""

import json

import pytest

from sigcat.cli import main
from tests.adapter.fmi.bus.made import HERE

pytest.importorskip("cantools", reason="cantools: pip install 'sigcat[can]'")
PAIR = HERE / "pair"
NODE = "Vehicle:\n  type: branch\n  description: A vehicle.\n"
SIGNAL = "  datatype: double\n  type: sensor\n  unit: km/h\n  description: A speed.\n"
ANSWER = "\nVehicle.Answer:\n  datatype: int32\n  type: sensor\n  description: An answer.\n"
FORMULA = "network_serialization: {signal: Speed, message: Wheel, transform: {math: 'sqrt(x)'}}"


def tried(folder, capsys, mapping, deployment, dbc=None):
    """Status and messages of an integration of the display over a tree with one mapping."""
    (folder / "tree.vspec").write_text(f"{NODE}\nVehicle.Speed:\n{SIGNAL}  {mapping}\n{ANSWER}")
    (folder / "bus.dbc").write_text(dbc or (PAIR / "pair.dbc").read_text())
    (folder / "deployment.yaml").write_text(f"fmi: {deployment}\n")
    options = [
        "-s",
        str(folder / "tree.vspec"),
        "--deployment",
        str(folder / "deployment.yaml"),
        "-o",
        str(folder / "fmi.json"),
    ]
    status = main(["integrate", "fmi", str(PAIR / "display.yaml"), *options])
    (folder / "tree.vspec").unlink()
    return status, capsys.readouterr().err


BUS = "{bus: {name: Can, dbc: [bus.dbc]}}"
SPEED = "network_serialization: {signal: Speed, message: Wheel}"


@pytest.mark.parametrize(
    ("mapping", "deployment", "told"),
    [
        (FORMULA, BUS, "J003 The formula of Wheel.Speed, sqrt(x), must have only +, -, *, / by a constant, abs, floor, ceil and round."),
        ("network_serialization: {signal: Sped}", BUS, "M101"),
        ("network_serialization: {signal: Speed, message: Wheels}", BUS, "M101"),
        (SPEED, "{bus: {name: Can, dbc: [other.dbc]}}", "other.dbc must be a file. Correct the path."),
        (FORMULA.replace("sqrt(x)", "x*1e400"), BUS, "J003 The formula of Wheel.Speed, x*1e400, must have only +, -, *, / by a constant, abs, floor, ceil and round."),
        ("comment: Nothing.", BUS, "J003 No signal of the functions is mapped to the CAN database."),
        (SPEED, "{bus: {name: Can, dbc: [bus.dbc]}, version: '2.0'}", "A bus needs FMI 3.0."),
        (SPEED, "{bus: {name: Can, dbc: [bus.dbc]}, interface: scheduledExecution}", "A bus needs `coSimulation`."),
        (SPEED, "{bus: {name: 1 a, dbc: [bus.dbc]}}", "`name`"),
        (SPEED, "{bus: {name: Can, dbc: []}}", "`dbc`"),
        (SPEED, "{bus: {name: Can, dbc: [bus.dbc], signals: none}}", "`signals`"),
    ],
)  # fmt: skip
def test_what_a_bus_cannot_be_is_a_finding(tmp_path, capsys, mapping, deployment, told):
    status, err = tried(tmp_path, capsys, mapping, deployment)
    assert status == 1
    assert told in err
    assert "Traceback" not in err


def test_a_signal_of_two_messages_is_a_warning_and_in_both(tmp_path, capsys):
    second = 'BO_ 101 Second: 8 Wheel\n SG_ Speed : 0|16@1+ (1,0) [0|0] "km/h" Display\n\nBO_ 200'
    dbc = (PAIR / "pair.dbc").read_text().replace("BO_ 200", second)
    _, err = tried(tmp_path, capsys, "network_serialization: {signal: Speed}", BUS, dbc)
    assert "M102" in err
    (fmu,) = json.loads((tmp_path / "fmi.json").read_text())["FmuList"]
    assert [each["Name"] for each in fmu["CanBus"]["BusMessages"]] == ["Wheel", "Second"]


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ('SG_ Speed : 0|60@1+ (1,0) [0|0] "km/h"', "must be a whole number of at most 52 bits"),
        ('SG_ Speed : 0|16@1- (1,0) [0|0] "km/h"', "must be a whole number of at most 52 bits"),
    ],
)
def test_a_number_that_a_double_does_not_hold_is_refused(tmp_path, capsys, line, told):
    dbc = (PAIR / "pair.dbc").read_text().replace('SG_ Speed : 0|64@1- (1,0) [0|0] "km/h"', line)
    dbc = dbc if "16" in line else dbc.replace("SIG_VALTYPE_ 100 Speed : 2;", "")
    status, err = tried(tmp_path, capsys, SPEED, BUS, dbc)
    assert status == 1
    assert told in err


BOTH = "network_serialization: {signal: Speed, message: Wheel}"


def test_a_signal_that_is_received_and_sent_is_refused(tmp_path, capsys):
    answer = ANSWER.replace("type: sensor", "type: actuator") + f"  {BOTH}\n"
    (tmp_path / "tree.vspec").write_text(f"{NODE}\nVehicle.Speed:\n{SIGNAL}  {BOTH}\n{answer}")
    status, err = integrated(tmp_path, capsys)
    assert status == 1
    assert (
        "J003 Wheel.Speed must be an input or an output of the FMU, not both: Vehicle.Answer and Vehicle.Speed." in err
    )


def integrated(folder, capsys, bus="{name: Can, dbc: [bus.dbc]}", *options):
    (folder / "bus.dbc").write_text((PAIR / "pair.dbc").read_text())
    (folder / "deployment.yaml").write_text(f"fmi: {{bus: {bus}}}\n")
    tree = ["-s", str(folder / "tree.vspec"), "--deployment", str(folder / "deployment.yaml")]
    status = main(["integrate", "fmi", str(PAIR / "display.yaml"), *tree, "-o", str(folder / "fmi.json"), *options])
    (folder / "tree.vspec").unlink()
    return status, capsys.readouterr().err


@pytest.mark.parametrize("is_in_project", [True, False])
def test_the_can_database_of_the_project_is_the_default(is_in_project, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tree.vspec").write_text(f"{NODE}\nVehicle.Speed:\n{SIGNAL}  {SPEED}\n{ANSWER}")
    (tmp_path / "sigcat.toml").write_text("dbc = ['bus.dbc']\n" if is_in_project else "")
    status, err = integrated(tmp_path, capsys, "{name: Can}")
    assert status == (not is_in_project), err
    assert ("J003 The bus must have a CAN database." in err) is not is_in_project
