"""Two FMUs that are connected by their buses exchange the values that they exchange by connected signals."""

import json
import shutil
import struct
from contextlib import contextmanager
from functools import cache

import pytest

from tests.adapter.fmi.bus.made import HERE, made
from tests.adapter.fmi.bus.operations import Instance, operations, settle_together
from tests.adapter.fmi.fmus import run
from tests.needs import cmake

pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
pytest.importorskip("cantools", reason="cantools: pip install 'sigcat[can]'")
pytestmark = cmake
STEP = 0.01
PAIR = HERE / "pair"


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """The FMUs of two functions that exchange a speed and an answer, for each choice of `signals`."""

    @cache
    def files_with(signals):
        options = {"tree": PAIR / "tree.vspec", "dbc": PAIR / "pair.dbc", "signals": signals}
        return [made(tmp_path_factory.mktemp(name), PAIR / f"{name}.yaml", **options) for name in ("wheel", "display")]

    return files_with


@contextmanager
def pair(files):
    """An instance of each."""
    found = [Instance(file) for file in files]
    yield found
    for each in found:
        each.close()


@pytest.fixture
def beside(files):
    with pair(files("beside")) as found:
        yield found


def values_of(wheel, display):
    return wheel.get("Vehicle.Speed"), display.get("Vehicle.Answer")


def over_signals(instances, times):
    """Outputs at each communication point, if the importer hands outputs over to inputs in its events."""
    wheel, display = instances
    for time in times:
        for each in (wheel, display):
            if time > 0:
                each.step(time)
                each.fmu.enterEventMode()
        for _ in range(3):
            display.set("Vehicle.Speed", wheel.get("Vehicle.Speed"))
            wheel.set("Vehicle.Answer", display.get("Vehicle.Answer"))
            for each in (wheel, display):
                each.update()
        for each in (wheel, display):
            each.fmu.enterStepMode()
        yield values_of(wheel, display)


def over_the_bus(instances, times):
    wheel, display = instances
    for time in times:
        for each in (wheel, display):
            if time > 0:
                each.step(time)
                each.fmu.enterEventMode()
        settle_together((wheel, display))
        yield values_of(wheel, display)


@pytest.mark.parametrize("step", [0.005, 0.01, 0.035])
def test_two_fmus_exchange_the_values_of_connected_signals(beside, files, step):
    times = [index * step for index in range(200)]
    values = list(over_the_bus(beside, times))
    with pair(files("beside")) as connected:
        assert values == list(over_signals(connected, times))
    assert values[-1][0] > 100


@pytest.mark.skipif(
    not shutil.which("fmucontainer"), reason="the FMU Manipulation Toolbox: pip install fmu-manipulation-toolbox"
)
def test_a_container_of_the_toolbox_connects_two_fmus_by_their_buses(beside, files, tmp_path):
    import fmpy

    for file in files("beside"):
        shutil.copy(file, tmp_path)
    ends = (("Wheel.fmu", "Display.fmu"), ("Display.fmu", "Wheel.fmu"))
    links = [[*(one, f"Powertrain.Tx_{part}"), *(other, f"Powertrain.Rx_{part}")]
             for one, other in ends for part in ("Data", "Clock")]  # fmt: skip
    container = {"name": "both.fmu", "fmu": ["Wheel.fmu", "Display.fmu"], "step_size": STEP, "link": links}
    (tmp_path / "both.json").write_text(json.dumps({**container, "auto_link": False}))
    run("fmucontainer", "-fmu-directory", tmp_path, "-container", "both.json", "-fmi", "3")
    outputs = ["Vehicle.Speed", "Vehicle.Answer"]
    played = fmpy.simulate_fmu(str(tmp_path / "both.fmu"), stop_time=2.0, output_interval=STEP, output=outputs)
    expected = list(over_the_bus(beside, [index * STEP for index in range(201)]))
    assert [tuple(row[name].item() for name in outputs) for row in played] == expected


def test_a_frame_is_received_at_the_end_of_the_step_in_which_it_is_sent(beside):
    wheel, display = beside
    settle_together(beside)
    for each in beside:
        each.step(0.035)
    assert wheel.get("Vehicle.Speed") == 2.0
    assert display.get("Vehicle.Speed") == 0.25
    for each in beside:
        each.fmu.enterEventMode()
    sent = [struct.unpack("<d", each.frame[2])[0] for each in operations(wheel.take())]
    assert sent == [1.5, 1.75, 2.0]


def test_signals_are_on_the_bus_only(files):
    with pair(files("replaced")) as found:
        wheel, display = found
        assert {name for name in wheel.variables if name.startswith("Vehicle.")} == set()
        speeds = []
        for index in range(20):
            for each in found:
                if index > 0:
                    each.step(index * STEP)
                    each.fmu.enterEventMode()
            sent = display.take()
            speeds += [struct.unpack("<d", each.frame[2])[0] for each in operations(wheel.settle(sent))]
            display.fmu.updateDiscreteStates()
            display.fmu.enterStepMode()
        assert speeds[-1] > 1
