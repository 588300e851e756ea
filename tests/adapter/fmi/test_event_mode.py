"""With event mode, inputs are received at their own times, between communication points: outputs are there at the same instant."""

import csv
import random

import pytest

from sigcat.adapter.host.shapes import numbers, packing
from sigcat.data import EXAMPLES
from sigcat.runs.recording.cells import value_of
from sigcat.runs.recording.times import nanoseconds
from tests.adapter.fmi.fmus import built, leaves_of, simulated, write_trace
from tests.adapter.fmi.test_fmus import AVERAGING, MILLISECOND, files_of
from tests.needs import cmake

fmpy = pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
from fmpy.fmi1 import FMICallException  # noqa: E402 -- where it is there
from fmpy.fmi3 import FMU3Slave  # noqa: E402

pytestmark = cmake
GRID = 10 * MILLISECOND
END = 350 * MILLISECOND
KINDS = {"Enumeration": "Int64"}


def points_of(trace, made, end):
    """The rows of a trace, each at a time of its own that is not on the grid of communication points; the first ones at 0."""
    chance, shapes = random.Random(1), made.connections.received
    found: dict[int, dict[str, object]] = {0: {}}
    for row in csv.DictReader(trace.open(newline="", encoding="utf-8")):
        at = nanoseconds(row["time"]) or 0
        point = 0 if at == 0 else at + chance.randrange(1, GRID)
        if point < end:
            cells = {name: cell for name, cell in row.items() if cell and name in shapes}
            found.setdefault(point, {}).update({name: value_of(cell, shapes[name]) for name, cell in cells.items()})
    return dict(sorted(found.items()))


def instance_of(made, *, has_events=True):
    description = fmpy.read_model_description(str(made.file))
    fmu = FMU3Slave(
        guid=description.instantiationToken, modelIdentifier=description.coSimulation.modelIdentifier,
        unzipDirectory=fmpy.extract(str(made.file)), instanceName="tested",
    )  # fmt: skip
    fmu.instantiate(eventModeUsed=has_events)
    fmu.enterInitializationMode(startTime=0.0)
    fmu.exitInitializationMode()
    return fmu


def set_inputs(fmu, made, values):
    for name, value in values.items():
        flat = list(numbers(value, made.connections.received[name]))
        for leaf in leaves_of(made, name):
            count = leaf.length or 1
            taken, flat = flat[:count], flat[count:]
            getattr(fmu, f"set{KINDS.get(leaf.type, leaf.type)}")([made.variables.index(leaf)], taken)


def outputs_of(fmu, made):
    """The bytes of each output, by its name in recordings."""
    found = {}
    for index, each in enumerate(made.connections.exits):
        leaves = [leaf for leaf in made.variables if leaf.causality == "output" and leaf.owner == index]
        found[each.name] = b"".join(bytes_of(fmu, made.variables.index(leaf), leaf) for leaf in leaves)
    return found


def bytes_of(fmu, reference, leaf):
    many = {"nValues": leaf.length} if leaf.length else {}
    values = getattr(fmu, f"get{KINDS.get(leaf.type, leaf.type)}")([reference], **many)
    return b"".join(packing(leaf.number).pack(each) for each in values)


def handle_event(fmu, made, values):
    set_inputs(fmu, made, values)
    fmu.updateDiscreteStates()
    fmu.enterStepMode()


def played(fmu, made, points, end):
    """Outputs at each communication point and at each event, after it."""
    handle_event(fmu, made, points[0])
    yield 0, outputs_of(fmu, made)
    now = 0
    for point in sorted({*points, *range(GRID, end, GRID)} - {0}):
        needs_event, *_ = fmu.doStep(currentCommunicationPoint=now / 1e9, communicationStepSize=(point - now) / 1e9)
        now = point
        if needs_event or point in points:
            fmu.enterEventMode()
            handle_event(fmu, made, points.get(point, {}))
        yield point, outputs_of(fmu, made)


def differences(sent, found):
    """The number of compared values, and what differs: at each instant all that the simulation has sent until then."""
    last, compared, wrong = {}, 0, []
    remaining = iter([*sent, (2**63, "", b"")])
    time, name, value = next(remaining)
    for point, outputs in found:
        while time <= point:
            last[name] = value
            time, name, value = next(remaining)
        compared += len(last)
        wrong += [(point, each, outputs[each], last[each]) for each in last if outputs[each] != last[each]]
    return compared, wrong


def compare(made, trace, end, folder):
    points = points_of(trace, made, end)
    assert any(each % GRID for each in points)
    write_trace(list(points.items()), made, folder / "trace.csv")
    sent = simulated(made, folder / "trace.csv", folder / "sent.csv", end)
    fmu = instance_of(made)
    compared, wrong = differences(sent, played(fmu, made, points, end))
    fmu.terminate()
    fmu.freeInstance()
    assert not wrong, wrong[:5]
    return compared, points, sent


@pytest.mark.parametrize("name", ["events_in_bursts", "events_that_are_debounced"])
def test_a_call_that_a_signal_triggers_runs_when_the_signal_is_received(name, tmp_path):
    files, trace = files_of(name)
    compared, points, sent = compare(built(files, tmp_path), trace, END, tmp_path)
    assert compared > 10
    assert any(time in points and time % GRID for time, _, _ in sent)


@pytest.mark.parametrize("name", ["one_function_feeds_another", "structs_and_queues"])
def test_outputs_of_other_functions_are_those_of_a_simulation(name, tmp_path):
    files, trace = files_of(name)
    compared, _, _ = compare(built(files, tmp_path), trace, END, tmp_path)
    assert compared > 10


def test_ecocontrol_with_events_between_communication_points(tmp_path):
    files = [EXAMPLES / name / "function.yaml" for name in ("core_acc", "eco_control_mpc")]
    made = built(files, tmp_path)
    compared, _, _ = compare(made, EXAMPLES / "ecocontrol/drive.csv", 10 * 10**9, tmp_path)
    assert compared > 1000


@pytest.fixture(scope="module")
def averaging(tmp_path_factory):
    return built([AVERAGING], tmp_path_factory.mktemp("fmu"))


def test_the_master_of_fmpy_uses_the_event_mode(averaging):
    description = fmpy.read_model_description(str(averaging.file))
    assert description.coSimulation.hasEventMode
    result = fmpy.simulate_fmu(str(averaging.file), stop_time=0.1, output_interval=0.01, use_event_mode=True)
    assert result["time"][-1] == pytest.approx(0.1)


def test_each_mode_refuses_what_belongs_to_the_other(averaging):
    fmu = instance_of(averaging)
    with pytest.raises(FMICallException):
        fmu.doStep(currentCommunicationPoint=0.0, communicationStepSize=0.01)
    with pytest.raises(FMICallException):
        fmu.enterEventMode()
    fmu.enterStepMode()
    with pytest.raises(FMICallException):
        fmu.enterStepMode()
    with pytest.raises(FMICallException):
        fmu.updateDiscreteStates()
    fmu.terminate()
    fmu.freeInstance()


def test_a_state_goes_back_to_an_instance_that_is_used_alike(averaging):
    with_events, without = instance_of(averaging), instance_of(averaging, has_events=False)
    state = with_events.getFMUState()
    again = without.deserializeFMUState(with_events.serializeFMUState(state))
    with pytest.raises(FMICallException):
        without.setFMUState(again)
    with_events.setFMUState(state)
    with_events.freeFMUState(state)
    without.freeFMUState(again)
    for each in (with_events, without):
        each.terminate()
        each.freeInstance()
