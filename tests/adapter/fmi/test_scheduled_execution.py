"""In scheduled execution, an importer activates calls at the times of their clocks: outputs are those of a simulation, bit for bit."""

import json
import zipfile
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree as ET

import pytest

from sigcat.adapter.fmi.fmu_files import generate
from sigcat.cli import main
from sigcat.data import EXAMPLES
from sigcat.limits import DEFAULT_LIMITS
from tests.adapter.fmi.fmus import built, simulated, write_trace
from tests.adapter.fmi.test_event_mode import GRID, differences, outputs_of, points_of, set_inputs
from tests.adapter.fmi.test_fmus import AVERAGING, MILLISECOND, files_of
from tests.adapter.hostile.payloads import EVIL, PAYLOADS
from tests.adapter.test_hostile_text import words_of_xml
from tests.needs import cmake

fmpy = pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
from fmpy.fmi1 import FMICallException  # noqa: E402 -- where it is there
from fmpy.fmi3 import FMU3ScheduledExecution, FMU3Slave, fmi3LogMessageCallback  # noqa: E402
from fmpy.validation import validate_fmu  # noqa: E402

pytestmark = cmake
HERE = Path(__file__).parent
END = 350 * MILLISECOND


class Clock(NamedTuple):
    name: str
    reference: int
    priority: int
    interval: int | None
    """In ns; None if it is triggered."""
    shift: int


def clocks_of(made):
    """The clocks by priority, as modelDescription.xml has them. FMPy 0.3.32 does not read their attributes."""
    with zipfile.ZipFile(made.file) as archive:
        root = ET.fromstring(archive.read("modelDescription.xml"))
    return sorted((clock_of(each.attrib) for each in root.iter("Clock")), key=lambda each: each.priority)


def clock_of(attributes):
    assert (attributes["causality"], attributes["variability"]) == ("input", "discrete")
    interval, shift = None, 0
    if attributes["intervalVariability"] == "constant":
        assert (attributes["supportsFraction"], attributes["resolution"]) == ("true", str(10**9))
        interval, shift = int(attributes["intervalCounter"]), int(attributes["shiftCounter"])
        assert (float(attributes["intervalDecimal"]), float(attributes["shiftDecimal"])) == (
            interval / 1e9,
            shift / 1e9,
        )
    else:
        assert attributes["intervalVariability"] == "triggered"
    return Clock(attributes["name"], int(attributes["valueReference"]), int(attributes["priority"]), interval, shift)


def instance_of(made, said=None, kind=FMU3ScheduledExecution):
    """An instance whose messages are added to a list."""
    description = fmpy.read_model_description(str(made.file))
    fmu = kind(
        guid=description.instantiationToken, modelIdentifier=description.scheduledExecution.modelIdentifier,
        unzipDirectory=fmpy.extract(str(made.file)), instanceName="tested",
    )  # fmt: skip
    messages = [] if said is None else said
    fmu.instantiate(logMessage=fmi3LogMessageCallback(lambda *each: messages.append(each[-1].decode())))
    return fmu


def started(made):
    fmu = instance_of(made)
    fmu.enterInitializationMode(startTime=0.0)
    fmu.exitInitializationMode()
    return fmu


def activations(clocks, events, end):
    """The clocks to activate at each time: periodic ones by their intervals, others at events."""
    found: dict[int, list[Clock]] = {}
    for each in clocks:
        times = range(each.shift, end, each.interval) if each.interval else events
        for time in times:
            found.setdefault(time, []).append(each)
    return {time: sorted(listed, key=lambda each: each.priority) for time, listed in sorted(found.items())}


def played(made, points, events, end):
    fmu, clocks = started(made), clocks_of(made)
    schedule = activations(clocks, events, end)
    for time in sorted({*points, *schedule}):
        set_inputs(fmu, made, points.get(time, {}))
        for each in schedule.get(time, ()):
            fmu.activateModelPartition(each.reference, time / 1e9)
        if time in schedule:
            yield time, outputs_of(fmu, made)
    fmu.terminate()
    fmu.freeInstance()


def on_schedule(points, clocks):
    """Points of a trace at times of a schedule that has no triggered calls: values are received when a call is activated."""
    interval, shift = min((each.interval, each.shift) for each in clocks)
    found: dict[int, dict[str, object]] = {0: {}}
    for time, values in points.items():
        found.setdefault(shift + -(-(time - shift) // interval) * interval, {}).update(values)
    return found


def compare(made, trace, end, folder, *, is_debounced=False):
    clocks, points = clocks_of(made), points_of(trace, made, end)
    if all(each.interval for each in clocks):
        points = on_schedule(points, clocks)
    points = {time: values for time, values in points.items() if time < end}
    write_trace(list(points.items()), made, folder / "trace.csv")
    sent = simulated(made, folder / "trace.csv", folder / "sent.csv", end)
    events = {*points, *(time for time, _, _ in sent if is_debounced and time < end)}
    compared, wrong = differences(sent, played(made, points, events, end))
    assert not wrong, wrong[:5]
    assert compared > 10
    return points, sent


@pytest.mark.parametrize("name", ["core_acc", "eco_control_mpc"])
def test_periodic_calls_send_what_a_simulation_sends(name, tmp_path):
    made = built([EXAMPLES / name / "function.yaml"], tmp_path, is_scheduled=True)
    assert not validate_fmu(str(made.file))
    compare(made, EXAMPLES / "ecocontrol/drive.csv", 20 * 10**9, tmp_path)


@pytest.mark.parametrize("name", ["events_in_bursts", "events_that_are_debounced", "windows_that_begin_with_a_mode"])
def test_triggered_calls_run_when_their_clocks_are_activated(name, tmp_path):
    """A debounced call is due later than its signal: its clock is activated again."""
    files, trace = files_of(name)
    made = built(files, tmp_path, is_scheduled=True)
    assert not validate_fmu(str(made.file))
    compare(made, trace, END, tmp_path, is_debounced="debounced" in name)


@pytest.fixture(scope="module")
def averaging(tmp_path_factory):
    return built([AVERAGING], tmp_path_factory.mktemp("fmu"), is_scheduled=True)


def test_the_model_description_has_the_clocks_of_the_schedule(averaging):
    description = fmpy.read_model_description(str(averaging.file))
    assert description.coSimulation is None
    assert clocks_of(averaging) == [Clock("Averaging_Step", len(averaging.variables), 0, GRID, 0)]


def test_each_clock_runs_its_own_call_alone(tmp_path):
    """Both calls are due at once: the activation of one does not run the other one, whatever their order."""
    files, _ = files_of("events_that_are_debounced")
    made = built(files, tmp_path, is_scheduled=True)
    fmu = started(made)
    set_inputs(fmu, made, {"Vehicle.Bounce.Key": 3, "Vehicle.Bounce.Item": 5})
    last, ran = outputs_of(fmu, made), []
    for each in reversed(clocks_of(made)):
        fmu.activateModelPartition(each.reference, 0.0)
        now = outputs_of(fmu, made)
        ran.append((each.name, [name for name, value in now.items() if value != last[name]]))
        last = now
    fmu.terminate()
    fmu.freeInstance()
    assert ran == [("Bounce_QueueStep", ["Vehicle.Bounce.Total"]), ("Bounce_EventStep", ["Vehicle.Bounce.Sum"])]


def test_a_call_that_the_function_triggers_runs_in_the_activation_that_sends_the_signal(tmp_path):
    made = built([HERE / "chain/function.yaml"], tmp_path, is_scheduled=True)
    fmu = started(made)
    step = next(each for each in clocks_of(made) if each.interval)
    found = []
    for time in range(3):
        set_inputs(fmu, made, {"Vehicle.Chain.Input": time})
        fmu.activateModelPartition(step.reference, time * step.interval / 1e9)
        found.append([int.from_bytes(each, "little") for each in outputs_of(fmu, made).values()])
    fmu.terminate()
    fmu.freeInstance()
    assert found == [[1, 2], [3, 6], [6, 12]]


def test_misuse_is_refused_with_a_message(averaging):
    (clock,) = clocks_of(averaging)
    said: list[str] = []
    fmu = instance_of(averaging, said)
    refused = [(clock.reference, 0.0, "is called in clock activation mode")]
    refuse(fmu, said, refused)
    fmu.enterInitializationMode(startTime=0.0)
    refuse(fmu, said, refused)
    fmu.exitInitializationMode()
    fmu.activateModelPartition(clock.reference, 0.02)
    wrong = "A clock reference is not a clock"
    before = "must not be before the one before it"
    refuse(fmu, said, [(0, 0.02, wrong), (clock.reference + 1, 0.02, wrong), (2**32 - 1, 0.02, wrong)])
    refuse(
        fmu,
        said,
        [(clock.reference, 0.01, before), (clock.reference, float("nan"), before), (clock.reference, 1e300, before)],
    )
    with pytest.raises(FMICallException):
        fmu.enterEventMode()
    fmu.activateModelPartition(clock.reference, 0.02)
    fmu.terminate()
    refuse(fmu, said, refused)
    fmu.freeInstance()


def refuse(fmu, said, activations):
    for reference, time, message in activations:
        with pytest.raises(FMICallException):
            fmu.activateModelPartition(reference, time)
        assert message in said[-1]


def test_an_fmu_for_scheduled_execution_is_not_one_for_co_simulation(averaging):
    with pytest.raises(Exception, match="Failed to instantiate"):
        instance_of(averaging, kind=FMU3Slave)


def test_a_saved_state_remembers_the_calls_that_wait(averaging):
    (clock,) = clocks_of(averaging)
    fmu = started(averaging)
    state = fmu.getFMUState()
    fmu.activateModelPartition(clock.reference, 0.0)
    first = outputs_of(fmu, averaging)
    fmu.setFMUState(state)
    fmu.activateModelPartition(clock.reference, 0.0)
    assert outputs_of(fmu, averaging) == first
    fmu.freeFMUState(state)
    fmu.terminate()
    fmu.freeInstance()


@pytest.mark.parametrize(
    ("more", "message"), [("version: '2.0'", "needs FMI 3.0"), ("fmus: set", "needs one FMU for each function")]
)
def test_settings_that_exclude_each_other_are_a_finding(more, message, tmp_path, capsys):
    (tmp_path / "deployment.yaml").write_text(f"name: Set\nfmi: {{interface: scheduledExecution, {more}}}\n")
    deployment = ["--deployment", str(tmp_path / "deployment.yaml")]
    assert main(["integrate", "fmi", str(AVERAGING), *deployment, "-o", str(tmp_path / "fmi.json")]) == 1
    assert f"Scheduled execution {message}" in capsys.readouterr().err
    assert not (tmp_path / "fmi.json").exists()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda whole: whole["FmuList"][0]["ClockList"][0].update(Interval=5), "must have the clocks of its calls"),
        (lambda whole: whole["FmuList"][0]["ClockList"].clear(), "must have the clocks of its calls"),
        (lambda whole: whole.pop("InterfaceType"), "must have clocks if and only if"),
        (lambda whole: whole["FmuList"][0].pop("ClockList"), "must have clocks if and only if"),
        (lambda whole: whole.update(FmiVersion="2.0"), "must be an FMU of FMI 3.0 with one function"),
    ],
)
def test_a_document_with_other_clocks_is_refused(averaging, change, message, tmp_path, capsys):
    document = averaging.file.parent.parent / "fmi.json"
    whole = json.loads(document.read_text())
    change(whole)
    (tmp_path / "fmi.json").write_text(json.dumps(whole, indent=1))
    assert main(["generate", "fmi", str(tmp_path / "fmi.json"), "-o", str(tmp_path / "made")]) == 1
    found = capsys.readouterr().err
    assert "error J002" in found
    assert message in found
    assert not (tmp_path / "made").exists()


@pytest.mark.parametrize("payload", PAYLOADS, ids=ascii)
def test_no_text_of_a_clock_becomes_markup(averaging, payload):
    document = json.loads((averaging.file.parent.parent / "fmi.json").read_text())
    (clock,) = document["FmuList"][0]["ClockList"]
    clock["Description"] = payload
    files = generate(json.dumps(document).encode(), "fmi.json", DEFAULT_LIMITS)
    for name, tag in (("/modelDescription.xml", "Clock"), ("/index.html", "td")):
        words = words_of_xml(next(each for each in files if each.name.endswith(name)))
        assert tag in words
        assert not [word for word in words if EVIL in word]
