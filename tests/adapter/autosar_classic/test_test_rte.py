"""Components on the test RTE send the same values as the simulation, and call services as docs/reference/adapter.md specifies."""

import json
import re
import shutil
import subprocess

import pytest

from sigcat.adapter.autosar_classic.code.plan import RteType
from sigcat.adapter.autosar_classic.test_rte.shapes import initializer
from sigcat.adapter.toolchain import toolchain
from sigcat.comparison.faults.drives import read_texts, write_texts
from sigcat.comparison.faults.scenario import Slow
from sigcat.comparison.faults.spoiling import spoil
from sigcat.comparison.running.runner import Drive, Kill
from sigcat.comparison.running.simulation import SIMULATION
from tests.adapter.autosar_classic.generated import (
    APPLICATIONS,
    CASES,
    DRIVE,
    ECOCONTROL,
    EXAMPLES,
    RUNNERS,
    SECOND,
    built,
    document,
    files,
    files_of,
    play,
    subject,
    written,
)
from tests.adapter.autosar_classic.test_components import PARK
from tests.adapter.core.compilers import SANITIZERS, sanitizers

pytestmark = pytest.mark.skipif(shutil.which("cmake") is None, reason="CMake, which builds the test RTE")
ROWS = {
    "bursts_that_fill_queues": ("sender.yaml", "taker.yaml"),
    "events_that_are_debounced": ("function.yaml",),
    "every_datatype_with_all_its_digits": ("function.yaml",),
    "members_of_a_class": ("function.yaml",),
    "methods_of_another_function": ("server.yaml", "client.yaml"),
    "methods_that_the_trace_answers": ("function.yaml",),
    "one_function_feeds_another": ("filter.yaml", "counter.yaml"),
    "structs_and_queues": ("function.yaml",),
    "windows_that_begin_with_a_mode": ("function.yaml",),
}


def _both(paths, drive, folder):
    whole = subject(paths)
    found = []
    for runner in RUNNERS:
        made = runner.build(whole, folder / runner.name, toolchain())
        recording = runner.play(made, whole, drive)
        assert recording.last_words == ""
        found.append(recording.sent)
    return found


@pytest.mark.parametrize("name", ROWS)
def test_every_bit_is_that_of_the_simulation(name, tmp_path):
    paths = [CASES / name / each for each in ROWS[name]]
    simulated, sent = _both(paths, Drive(CASES / name / "trace.csv", _length(CASES / name / "trace.csv")), tmp_path)
    assert any(simulated.values())
    assert sent == simulated


def test_calls_take_as_long_as_the_drive_says(tmp_path):
    """Others run meanwhile; what is due at the end runs in the order of tasks."""
    slow = (
        Slow("EcoControlMpc_Step", 8 * SECOND, 9 * SECOND, 300_000_000),
        Slow("CoreAcc_Step", 11 * SECOND, 12 * SECOND, 70_000_000),  # longer than its cycle: releases are missed
        Slow("CoreAcc_Step", 13 * SECOND, 14 * SECOND, 13_100_001),  # ends between ticks
    )
    drive = Drive(tmp_path / "slow.csv", 16 * SECOND)
    write_texts(spoil(read_texts(DRIVE), (), slow), drive.trace)
    simulated, sent = _both(ECOCONTROL, drive, tmp_path)
    assert sent == simulated
    times = [time for time, _ in sent["Vehicle.ADAS.EcoControl.Status"]]
    assert [time for time in times if time % (10 * SECOND // 1000) == 3_100_001]


@pytest.mark.parametrize("takes", [20_000_000, 30_000_000])
def test_what_is_due_too_runs_when_a_call_begins_that_takes_time_and_before_that_call_comes_again(takes, tmp_path):
    """The first one ends when both are due once more."""
    folder = shutil.copytree(CASES / "one_function_feeds_another", tmp_path / "code")
    text = (folder / "counter.yaml").read_text().replace("function: Counter", "function: Sum")
    text = text.replace("        events: [Vehicle.Filter.Levels]\n", "").replace(
        "runType: EventTriggered", "cycleTime: 20"
    )
    (folder / "counter.yaml").write_text(text)
    drive = Drive(tmp_path / "slow.csv", _length(folder / "trace.csv"))
    slow = (Slow("Filter_Step", 50_000_000, 150_000_000, takes),)
    write_texts(spoil(read_texts(folder / "trace.csv"), (), slow), drive.trace)
    simulated, sent = _both([folder / "filter.yaml", folder / "counter.yaml"], drive, tmp_path)
    assert sent == simulated


def _parked():
    """A trace for the set that parks: up to four echoes at one time, which no queue of the RTE loses, and modes."""
    rows = ["time,Vehicle.Park.Echo,Vehicle.Park.Wheels,ParkPlanner_Mode_In"]
    modes = {3: "SEARCH", 20: "PARK", 80: "SEARCH", 95: "PARK"}
    for k in range(120):
        wheels = json.dumps({"Speeds": [k, 2 * k, 3 * k, k % 7], "IsSliding": k % 2 == 0}).replace('"', '""')
        for number in range(k % 4 + 1):
            echo = json.dumps({"Sensor": k + number, "Range": number + k / 8}).replace('"', '""')
            rows.append(f'{k * 0.007:.3f},"{echo}","{wheels}",{modes.get(k, "") if number == 0 else ""}')
    return "\n".join(rows) + "\n"


SLOW = {
    "nothing": (),
    "an event-triggered call": (Slow("EchoFusion_EchoStep", 0, SECOND, 5_000_137),),
    "a call of a function with methods": (Slow("ParkPlanner_PlanStep", 0, SECOND, 13_000_137),),
    "a call that uses a method": (Slow("ParkScreen_Step", 0, SECOND, 3_000_001),),
}


@pytest.mark.parametrize("name", SLOW)
def test_values_that_wait_are_taken_when_a_call_has_ended_and_methods_are_served_meanwhile(name, tmp_path):
    """More values are received at one time than a call takes, and others while it runs."""
    (tmp_path / "fast.csv").write_text(_parked())
    drive = Drive(tmp_path / "slow.csv", SECOND)
    write_texts(spoil(read_texts(tmp_path / "fast.csv"), (), SLOW[name]), drive.trace)
    simulated, sent = _both(PARK, drive, tmp_path)
    assert len(simulated["Vehicle.Park.Distance"]) > 100
    assert sent == simulated


def test_a_run_may_end_while_a_call_takes_time(tmp_path):
    """It is terminated, and the call does not come to its end."""
    drive = Drive(tmp_path / "slow.csv", 8 * SECOND)
    whole = (Slow("CoreAcc_Step", 7 * SECOND, 8 * SECOND, 5 * SECOND),)
    write_texts(spoil(read_texts(DRIVE), (), whole), drive.trace)
    simulated, sent = _both(ECOCONTROL, drive, tmp_path)
    assert sent == simulated
    assert max(time for time, _ in sent["Vehicle.ADAS.EcoControl.AccelerationRequest"]) < 7 * SECOND


def test_a_provider_sends_to_the_queue_that_a_receiver_declares(tmp_path):
    """Also if it has no queue itself: the element is queued for both."""
    folder = shutil.copytree(CASES / "bursts_that_fill_queues", tmp_path / "code")
    (folder / "sender.yaml").write_text(
        (folder / "sender.yaml").read_text()
        .replace("variable: items, queueLength: 8, valuesPerStep: 8, countVariable: item_count", "variable: 'items[0]'")
    )  # fmt: skip
    drive = Drive(folder / "trace.csv", _length(folder / "trace.csv"))
    simulated, sent = _both([folder / "sender.yaml", folder / "taker.yaml"], drive, tmp_path)
    assert len(set(simulated["Vehicle.Burst.Sum"])) > 2
    assert sent == simulated


LOOKS = """\
      - interface: LookStep
        symbol: event_step
        data: [{path: Vehicle.Bounce.Key, role: consumed, variable: key, provider: Outside}]
"""


def test_a_call_that_reads_what_triggers_another_one_triggers_nothing(tmp_path):
    folder = shutil.copytree(CASES / "events_that_are_debounced", tmp_path / "code")
    text = (folder / "function.yaml").read_text()
    text = text.replace("define:\n", f"{LOOKS}define:\n", 1)
    text += "    LookStep: {description: Looks., cycleTime: 10, scheduling: Preemptive, asil: QM}\n"
    (folder / "function.yaml").write_text(text)
    drive = Drive(folder / "trace.csv", _length(folder / "trace.csv") + SECOND // 2)
    simulated, sent = _both([folder / "function.yaml"], drive, tmp_path)
    assert len(simulated["Vehicle.Bounce.Sum"]) > 2
    assert sent == simulated


def test_functions_may_have_types_of_one_name(tmp_path):
    """As in models of Simulink, each in separate headers."""
    paths = []
    for original, members in zip(ECOCONTROL, ("int a;", "double a; int b;"), strict=True):
        folder = shutil.copytree(original.parent, tmp_path / original.parent.name)
        (header,) = folder.glob("*_types.h")
        header.write_text(header.read_text().replace("#endif", f"typedef struct {{ {members} }} Parts;\n#endif"))
        paths.append(folder / original.name)
    made = written(tmp_path / "made", tuple(paths))
    assert (made / "test_rte/rte_tables.c").read_text().count("&TestRte_Memory_") == len(paths)
    assert built(made, tuple(paths)).is_file()


def _length(trace):
    times = [float(line.split(",")[0]) for line in trace.read_text().splitlines()[1:]]
    return round((times[-1] - times[0]) * SECOND)


def test_what_is_lost_in_a_queue_of_the_rte_is_an_overflow_in_the_same_step(tmp_path):
    """Such as one that an integrator has made too short: which values are lost is then the RTE's choice, and no secret."""
    folder = CASES / "bursts_that_fill_queues"
    paths = tuple(folder / each for each in ROWS[folder.name])
    as_in_the_core = {"Item": 3, "Frame": 2}
    changed = json.loads(document(paths))
    for element in (
        each for component in changed["Components"] for port in component["Ports"] for each in port["Elements"]
    ):
        if "QueueLength" in element and element["Name"] in as_in_the_core:
            element["QueueLength"] = as_in_the_core[element["Name"]]
    short = files_of(json.dumps(changed).encode())
    trace = folder / "trace.csv"
    played = play(built(written(tmp_path / "short", paths, short), paths), trace, _length(trace))
    whole = subject(paths)
    simulated = SIMULATION.play(
        SIMULATION.build(whole, tmp_path / "simulate", toolchain()), whole, Drive(trace, _length(trace))
    )
    for name in ("Taker_Lost_ErrorSts", "Taker_LostFrame_ErrorSts"):
        assert len(simulated.sent[name]) > 3
        assert played.sent[name] == list(simulated.sent[name])


def test_init_of_every_component_comes_before_anything_else():
    """Otherwise, a value that one sends in its Init would start another one before its Init."""
    text = files(ECOCONTROL)["test_rte/rte_tables.c"]
    batch = text[text.index("void Rte_Init_InitComponents(void)") :]
    assert "TestRte_Run_CoreAcc_Init();" in batch
    assert "TestRte_Run_EcoControlMpc_Init();" in batch
    assert "OnInit" not in text
    start = text[text.index("void TestRte_StartUp(void)") :]
    assert start.index("Rte_Start()") < start.index("Rte_Init_InitComponents()") < start.index("Rte_StartTiming()")


def test_wheel_speeds_are_those_of_the_simulation(tmp_path):
    folder = EXAMPLES / "wheel_speed_calculation"
    simulated, sent = _both([folder / "function.yaml"], Drive(folder / "drive.csv", 10 * SECOND), tmp_path)
    assert sent == simulated


def test_a_function_that_is_gone_says_nothing_more_and_others_go_on(tmp_path):
    drive = Drive(DRIVE, 40 * SECOND, kills=(Kill("EcoControlMpc", 37 * SECOND),))
    simulated, sent = _both(ECOCONTROL, drive, tmp_path)
    assert sent == simulated
    proposals = sent["Vehicle.ADAS.EcoControl.AccelerationProposal"]
    assert max(time for time, _ in proposals) < 37 * SECOND
    assert max(time for time, _ in sent["Vehicle.ADAS.EcoControl.AccelerationRequest"]) > 39 * SECOND


def test_a_method_of_a_function_that_is_gone_is_not_answered(tmp_path):
    folder = CASES / "methods_of_another_function"
    drive = Drive(folder / "trace.csv", _length(folder / "trace.csv"), kills=(Kill("Server", SECOND // 50),))
    simulated, sent = _both([folder / each for each in ROWS[folder.name]], drive, tmp_path)
    assert sent == simulated
    assert "40" in [value for _, value in sent["Vehicle.Calls.State"]]  # timed out


@pytest.fixture(scope="module")
def ecocontrol(tmp_path_factory):
    """EcoControl, with sanitizers where there are some."""
    flags = SANITIZERS if sanitizers() else ()
    return built(written(tmp_path_factory.mktemp("ecocontrol"), ECOCONTROL), ECOCONTROL, *flags)


@pytest.fixture(scope="module")
def missing(ecocontrol):
    return play(ecocontrol, _missing_brake(), 10 * SECOND)


def _missing_brake():
    """The brake pressure comes until 6 s, and again from 8 s on."""
    rows = ["time,Vehicle.Chassis.Brake.CylP,Vehicle.Chassis.Steering.WhlAg,CoreAcc_Mode_In", "0,1,0,ACTIVE"]
    for k in range(1, 200):
        time = k * 0.05
        rows.append(f"{time:.3f},{'' if 6 <= time < 8 else 1},0,")
    return "\n".join(rows) + "\n"


def test_the_dem_is_told_the_verdicts_of_the_core(missing):
    """§6: the first verdict, then each change; PREFAILED and HEALING are not verdicts. The DEM gets the values that others receive."""
    told = [(time, value) for time, name, value in missing.of("DEM") if name == "CoreAcc_BrakePressureTimeout_ErrorSts"]
    assert [value for _, value in told] == ["PASSED", "FAILED", "PASSED"]
    assert told == missing.sent["CoreAcc_BrakePressureTimeout_ErrorSts"]
    failed, healed = told[1][0], told[2][0]
    assert 6.2 * SECOND < failed < 7 * SECOND
    assert healed > 8 * SECOND


def test_others_are_inhibited_while_an_error_is_failed(missing):
    dem = [(time, value) for time, name, value in missing.of("DEM") if name == "CoreAcc_BrakePressureTimeout_ErrorSts"]
    fim = [(time, value) for time, name, value in missing.of("FiM") if "AccReqInvalid" in name]
    assert fim == [(dem[1][0], "INHIBITED"), (dem[2][0], "PERMITTED")]


def test_the_watchdog_manager_is_told_of_each_call(missing):
    """§10: a checkpoint before and after each call, and none of a call that the mode excludes."""
    told = [value for _, name, value in missing.of("WdgM") if name.startswith("CoreAcc")]
    assert told == ["Step_Begin", "Step_End"] * (len(told) // 2)
    assert len(told) // 2 == len(missing.sent["Vehicle.ADAS.EcoControl.AccelerationRequest"])
    mpc = [value for _, name, value in missing.of("WdgM") if name.startswith("EcoControlMpc")]
    assert mpc == []  # OFF from its beginning to its end


def test_what_is_kept_is_there_in_the_next_ignition_cycle(ecocontrol, tmp_path):
    """§6: an error that failed in the cycle before is counted, and counts are kept."""
    trace = "time,CoreAcc_Mode_In\n0,ACTIVE\n3,\n"
    first = play(ecocontrol, trace, 3 * SECOND, "-n", str(tmp_path), "-i", "1")
    assert ("CoreAcc_Stored", "CHANGED") in [(name, value) for _, name, value in first.of("NvM")]
    kept = (tmp_path / "CoreAcc_Stored.nvm").read_bytes()
    play(ecocontrol, trace, 3 * SECOND, "-n", str(tmp_path), "-i", "2")
    again = (tmp_path / "CoreAcc_Stored.nvm").read_bytes()
    assert int.from_bytes(kept[:4], "little") == 1
    assert int.from_bytes(again[:4], "little") == 2
    occurrences, cycles = ([int.from_bytes(data[at : at + 2], "little") for data in (kept, again)] for at in (6, 8))
    assert occurrences == [1, 2]  # the brake pressure never came
    assert cycles == [0, 1]


REFUSING = {
    "a mode": ("Rte_Switch_CoreAcc_CoreAcc_Mode_Out_Mode", "RTE_E_LIMIT", "CoreAcc_Mode_Out"),
    "an error for others": (
        "Rte_Write_CoreAcc_CoreAcc_BrakePressureTimeout_ErrorSts_Status", "RTE_E_COM_STOPPED", "CoreAcc_BrakePressureTimeout_ErrorSts",
    ),
    "a verdict for the diagnosis": (
        "Rte_Call_CoreAcc_Event_CoreAcc_BrakePressureTimeout_ErrorSts_SetEventStatus", "E_NOT_OK", "DEM",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSING)
def test_what_is_not_taken_is_said_again_until_it_is(name, tmp_path, ecocontrol):
    """Otherwise, values that are only sent on change would be lost. Here, everything is refused in every other 100 ms."""
    api, answer, what = REFUSING[name]
    text = files(ECOCONTROL)["test_rte/Rte_CoreAcc.c"]
    refusing, count = re.subn(
        rf"(Std_ReturnType {api}\([^{{]*{{\n)",
        rf"\1    if (((Os_Now() / 100000000U) % 2U) == 0U) {{\n        return {answer};\n    }}\n",
        text,
    )
    assert count == 1
    program = built(written(tmp_path, ECOCONTROL, {"test_rte/Rte_CoreAcc.c": refusing}), ECOCONTROL)
    length = 10 * SECOND + SECOND // 8
    usual, late = (_said(play(each, _missing_brake(), length), what) for each in (ecocontrol, program))
    last = {due // (SECOND // 5): (due, value) for due, value in usual}
    assert [value for _, value in late] == [value for _, value in last.values()]
    assert all(0 <= told - due <= SECOND // 5 for (told, _), (due, _) in zip(late, last.values(), strict=True))
    assert late != usual


def _said(played, what):
    if what == "DEM":
        return [(time, value) for time, name, value in played.of("DEM") if "BrakePressureTimeout" in name]
    return played.sent[what]


HEADER = "time_ns\tVehicle.Speed\tCoreAcc_Mode_In"
TRACES = {
    "nothing": ("", "line 1: The trace must have a header"),
    "a trace that is not normalized": ("time,Vehicle.Speed\n0,1\n", "line 1: The trace must be normalized"),
    "a time that is none": (f"{HEADER}\nsoon\t1\t\n", "line 2: The time must be a whole number of ns"),
    "a time in seconds": (f"{HEADER}\n0.5\t1\t\n", "line 2: The time must be a whole number of ns"),
    "a time below 0": (f"{HEADER}\n-1\t1\t\n", "line 2: The time must be a whole number of ns"),
    "a time that goes back": (
        f"{HEADER}\n2\t1\t\n1\t1\t\n",
        "line 3: The time must be a whole number of ns, and not before",
    ),
    "a cell too few": (f"{HEADER}\n0\t1\n", "line 2: The row must have as many cells as the header"),
    "a cell too many": (f"{HEADER}\n0\t1\t\t7\n", "line 2: The row must have as many cells"),
    "an empty line": (f"{HEADER}\n\n", "line 2: The row must have as many cells"),
    "a row that was cut": (f"{HEADER}\n0\t1\t", "line 2: The row must end with a line break"),
    "a byte of 0": (f"{HEADER}\n0\t\0\t\n", "line 2: The row must end with a line break, and have no byte of 0"),
    "a word for a number": (
        f"{HEADER}\n0\t1\t\n1\tfast\t\n",
        "line 3: Vehicle.Speed must have a value of its datatype",
    ),
    "a number that no float holds": (f"{HEADER}\n0\t1e39\t\n", "Vehicle.Speed must have a value"),
    "a space before a number": (f"{HEADER}\n0\t 1\t\n", "Vehicle.Speed must have a value"),
    "two numbers for one": (f"{HEADER}\n0\t1;2\t\n", "Vehicle.Speed must have a value"),
    "a number without its end": (f"{HEADER}\n0\t1;\t\n", "Vehicle.Speed must have a value"),
    "an unknown mode": (f"{HEADER}\n0\t\tSTANDING\n", "CoreAcc_Mode_In must have a value"),
    "a number that does not fit": (f"{HEADER}\n0\t\t256\n", "CoreAcc_Mode_In must have a value"),
    "a number below 0 that does not fit": (f"{HEADER}\n0\t\t-1\n", "CoreAcc_Mode_In must have a value"),
}


def _second_of(program, folder):
    """Play a second of `trace.csv` of a folder in lock step."""
    files = [folder / name for name in ("trace.csv", "recorded.csv", "services.csv")]
    return _run(program, folder, "lock", *files, SECOND)


@pytest.mark.parametrize("name", TRACES)
def test_a_damaged_trace_is_refused_before_anything_is_written(name, ecocontrol, tmp_path):
    text, said = TRACES[name]
    (tmp_path / "trace.csv").write_bytes(text.encode())
    done = _second_of(ecocontrol, tmp_path)
    assert (done.returncode, len(done.stderr.splitlines())) == (2, 1)
    assert done.stderr.startswith("test_rte: ")
    assert said in done.stderr
    assert not (tmp_path / "recorded.csv").exists()


def test_a_column_that_no_component_receives_is_named(ecocontrol, tmp_path):
    (tmp_path / "trace.csv").write_text("time_ns\tVehicle.Spede\n0\t1\n")
    done = _second_of(ecocontrol, tmp_path)
    assert done.returncode == 0
    assert done.stderr.splitlines() == [
        f"test_rte: {tmp_path / 'trace.csv'}: Vehicle.Spede is left out: no component receives it"
    ]


STRUCTS = {
    "a member too few": "TRUCK;20;1",
    "a member too many": "TRUCK;20;1;2;3",
    "an empty member": "TRUCK;;1;2",
    "a name that no member has": "SHIP;20;1;2",
    "a number too large for a member": "TRUCK;65536;1;2",
    "a mapping of JSON": '{"Kind": 1, "Speed": 20, "Position": {"X": 1, "Y": 2}}',
}


def test_a_value_of_another_form_is_refused(tmp_path):
    paths = (CASES / "structs_and_queues/function.yaml",)
    program = built(written(tmp_path, paths), paths)
    for text in STRUCTS.values():
        (tmp_path / "trace.csv").write_text(f"time_ns\tVehicle.Objects.Ahead\n0\t{text}\n")
        done = _run(program, tmp_path, "lock", tmp_path / "trace.csv", tmp_path / "s", tmp_path / "t", SECOND)
        assert done.returncode == 2, text
        assert "line 2: Vehicle.Objects.Ahead must have a value of its datatype" in done.stderr


ARGUMENTS = {
    "none": ([], "usage: test_rte"),
    "an unknown mode": (["fast", "trace", "sent", "told", "1"], 'MODE must be lock or free, not "fast"'),
    "a length that is none": (["lock", "trace", "sent", "told", "1s"], "LENGTH_NS must be a whole number of ns"),
    "a length that is too long": (
        ["lock", "trace", "sent", "told", "1" * 30],
        "LENGTH_NS must be a whole number of ns",
    ),
    "one file twice": (["lock", "trace", "sent", "trace", "1"], "must be three files"),
    "a trace that is not there": (["lock", "other", "sent", "told", "1"], "other cannot be read: No such file"),
    "a folder that is not there": (
        ["lock", "trace", "sent", "told", "1", "-n", "other"],
        "What -n names must be a folder",
    ),
    "an option without a value": (["lock", "trace", "sent", "told", "1", "-i"], "A value must follow"),
    "a cycle that is none": (["lock", "trace", "sent", "told", "1", "-i", "-1"], "ignition cycle must be whole"),
    "an unknown function": (["lock", "trace", "sent", "told", "1", "Other@1"], "of CoreAcc, EcoControlMpc"),
    "an end without a time": (
        ["lock", "trace", "sent", "told", "1", "CoreAcc@soon"],
        "The time of an end must be in ns",
    ),
    "an unknown option": (["lock", "trace", "sent", "told", "1", "--fast"], "What follows LENGTH_NS must be"),
    "a record that cannot be written": (["lock", "trace", "sent", "no/told", "1"], "no/told cannot be written"),
}


@pytest.mark.parametrize("name", ARGUMENTS)
def test_a_command_line_that_is_wrong_is_refused_in_one_line(name, ecocontrol, tmp_path):
    arguments, said = ARGUMENTS[name]
    (tmp_path / "trace").write_text("time_ns\n0\n")
    done = _run(ecocontrol, tmp_path, *arguments)
    assert (done.returncode, len(done.stderr.splitlines())) == (2, 1)
    assert said in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["trace"]


def test_a_block_that_is_not_of_the_component_is_left_out(ecocontrol, tmp_path):
    (tmp_path / "CoreAcc_Stored.nvm").write_bytes(b"x" * 1000)
    (tmp_path / "trace").write_text("time_ns\n0\n")
    done = _run(ecocontrol, tmp_path, "lock", "trace", "sent", "told", SECOND, "-n", tmp_path)
    assert done.returncode == 0
    assert "CoreAcc_Stored.nvm is left out: it must have" in done.stderr


def _run(program, folder, *arguments):
    command = [str(word) for word in (program, *arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder)


@pytest.mark.skipif(not sanitizers(), reason="sanitizers of the compiler")
def test_sanitizers_find_nothing_in_a_component_with_everything(tmp_path):
    paths = (APPLICATIONS / "full/function.yaml",)
    program = built(written(tmp_path, paths), paths, *SANITIZERS)
    played = play(program, "time,Full_Mode_In\n0,ON\n1,\n", SECOND)
    assert played.of("WdgM")


MUTANTS = {
    "received values are taken again at each step": ("if (Rte_IsUpdated_Chassis_Brake_CylP_CylP() != FALSE) {", "{"),
    "nothing is taken": (
        "Rte_Read_Chassis_Brake_CylP_CylP(&value) == RTE_E_OK",
        "Rte_Read_Chassis_Brake_CylP_CylP(&value) != RTE_E_OK",
    ),
    "copies are taken that never came": ("Rte_IStatus_Step_Vehicle_Speed_Speed() == RTE_E_OK", "FALSE"),
    "the mode is not taken": ("if (mode != RTE_TRANSITION_", "if (mode == RTE_TRANSITION_"),
    "a call that is due is forgotten": ("is_due = CoreAcc_Swc_Due.Step;", "is_due = FALSE;"),
    "outputs are not sent": ("if (CoreAcc_Adapter_Instance.publish.AccReq) {", "if (FALSE) {"),
    "what is sent is sent again": ("    CoreAcc_Adapter_Published(&CoreAcc_Adapter_Instance);", ""),
    "supervision never looks": ("    CoreAcc_Adapter_Start(&CoreAcc_Adapter_Instance, t);", ""),
}


@pytest.mark.parametrize("name", MUTANTS)
def test_a_component_that_is_wrong_is_found(name, tmp_path, ecocontrol):
    """The drive sees what a fault in the component does: the tests above can fail."""
    old, new = MUTANTS[name]
    text = files(ECOCONTROL)["swc/CoreAcc.c"]
    assert old in text
    program = built(written(tmp_path, ECOCONTROL, {"swc/CoreAcc.c": text.replace(old, new)}), ECOCONTROL)
    spoilt = "\n".join(_without_brake(line) for line in DRIVE.read_text().splitlines()) + "\n"
    assert play(program, spoilt, 30 * SECOND).sent != play(ecocontrol, spoilt, 30 * SECOND).sent


def _without_brake(line):
    """From 20 s to 22 s, no brake pressure comes."""
    time, *cells = line.split(",", 4)
    if time != "time" and 20 <= float(time) < 22:
        cells[2] = ""
    return ",".join([time, *cells])


def test_one_number_of_a_document_is_that_of_every_element_and_member():
    number = RteType("uint8", "uint8")
    pair = RteType("Pair", members=(("A", number), ("B", number)))
    assert initializer(7, RteType("Pairs", element=pair, length=2)) == "{{7U, 7U}, {7U, 7U}}"
    assert initializer([{"A": 1, "B": 2}], RteType("Pairs", element=pair, length=1)) == "{{1U, 2U}}"
