"""Every platform, built as it is compared, with real transports: what it sends in lock step is what the simulation sends."""

import shutil

import pytest

from sigcat.adapter.toolchain import toolchain
from sigcat.comparison.behaviour import in_lock_step
from sigcat.comparison.faults.drives import read_texts, write_texts
from sigcat.comparison.faults.scenario import Slow
from sigcat.comparison.faults.spoiling import spoil
from sigcat.comparison.recording import Recording, Sent
from sigcat.comparison.running.runner import Drive, Kill
from sigcat.comparison.running.table import RUNNERS
from tests import needs
from tests.comparison.ecocontrol import DRIVE, EXAMPLES, subject

SECOND = 10**9
STATUS = ("PASSED", "OFF")
REAL = {
    "autosar-adaptive": [needs.cmake, needs.own_network],
    "ros2-cpp": [needs.ros2, needs.slow],
    "ros2-py": [needs.ros2, needs.slow],
}
REAL_PARTS = {**REAL, "fmi": [needs.cmake, needs.fmpy]}
PLATFORMS = [pytest.param(name, marks=REAL_PARTS.get(name, [])) for name in RUNNERS]
OTHERS = [pytest.param(name, marks=marks) for name, marks in REAL.items()]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("platforms")


@pytest.fixture(scope="module")
def play(folder):
    """Run a platform; a build is made once."""

    def played(name: str, drive: Drive) -> Recording:
        runner = RUNNERS[name]
        built = runner.build(subject(), folder / name.split("-", maxsplit=1)[0], toolchain())
        return runner.play(built, subject(), drive)

    return played


def expected_and_found(
    play, name: str, drive: Drive
) -> tuple[dict[str, tuple[Sent, ...]], dict[str, tuple[Sent, ...]]]:
    """A field of AUTOSAR has a value from the beginning: only later values count."""
    both = [dict(play(each, drive).sent) for each in ("simulate", name)]
    if name == "autosar-adaptive":
        both = [{key: changes(key, values) for key, values in sent.items()} for sent in both]
    return both[0], both[1]


def changes(name: str, values):
    if name.startswith("Vehicle."):
        return values
    found = [each for at, each in enumerate(values) if at == 0 or each[1] != values[at - 1][1]]
    return tuple(found[1:] if found and found[0][1] in STATUS else found)


@pytest.mark.parametrize("name", OTHERS)
def test_every_bit_of_every_step_is_that_of_the_simulation(play, name):
    behaviour = in_lock_step(*expected_and_found(play, name, Drive(DRIVE, 35 * SECOND)))
    assert behaviour.is_equal
    assert behaviour.values > 1000


@pytest.mark.parametrize("name", OTHERS)
def test_a_drive_begins_with_its_first_row(play, name, tmp_path):
    """The first calls are due then, and at no other time."""
    later = tmp_path / "later.csv"
    later.write_text(begun_at(11 * SECOND + SECOND // 1000))
    behaviour = in_lock_step(*expected_and_found(play, name, Drive(later, 31 * SECOND)))
    assert behaviour.is_equal
    assert behaviour.values > 500


def begun_at(begin: int) -> str:
    """EcoControl's drive, which begins at a time in ns."""
    header, *rows = DRIVE.read_text().splitlines()
    cells = [row.split(",", maxsplit=1) for row in rows[:4000]]
    times = [round(float(time) * SECOND) + begin for time, _ in cells]
    shifted = [f"{time // SECOND}.{time % SECOND:09d},{rest}" for time, (_, rest) in zip(times, cells, strict=True)]
    return "\n".join([header, *shifted, ""])


@needs.ros2
@needs.slow
def test_functions_that_are_due_at_one_time_run_in_the_order_of_the_set(folder):
    """A value that one function sends is received by the next: the providing function is first here."""
    turned = subject(("eco_control_mpc", "core_acc"))
    drive = Drive(DRIVE, 35 * SECOND)
    sent = []
    for name in ("simulate", "ros2-cpp"):
        runner = RUNNERS[name]
        built = runner.build(turned, folder / f"turned-{name}", toolchain())
        sent.append(dict(runner.play(built, turned, drive).sent))
    assert in_lock_step(*sent).is_equal


@pytest.mark.parametrize("name", OTHERS)
def test_others_go_on_as_in_the_simulation_when_a_function_is_killed(play, name):
    drive = Drive(DRIVE, 34 * SECOND, kills=(Kill("EcoControlMpc", 31 * SECOND),))
    expected, found = expected_and_found(play, name, drive)
    assert in_lock_step(expected, found).is_equal
    assert any(text == "FAILED" for _, text in found["CoreAcc_ProposalTimeout_ErrorSts"])


SLOW = (
    Slow("EcoControlMpc_Step", 8 * SECOND, 9 * SECOND, 700_000_000),
    Slow("CoreAcc_Step", 11 * SECOND, 12 * SECOND, 70_000_000),  # longer than its cycle: releases are missed
    Slow("CoreAcc_Step", 13 * SECOND, 14 * SECOND, 13_100_001),  # ends between releases
    Slow("CoreAcc_Step", 16 * SECOND, 18 * SECOND, 333_000_000),
    Slow("EcoControlMpc_Step", 16 * SECOND, 19 * SECOND, 1_050_000_000),  # longer than its deadline
)


@pytest.mark.parametrize("name", OTHERS)
def test_calls_take_as_long_as_the_drive_says(play, name, tmp_path):
    """They begin, end, miss releases and exceed deadlines in the same step as in the simulation."""
    drive = Drive(tmp_path / "slow.csv", 22 * SECOND)
    write_texts(spoil(read_texts(DRIVE), (), SLOW), drive.trace)
    expected, found = expected_and_found(play, name, drive)
    assert in_lock_step(expected, found).is_equal
    assert any(text == "FAILED" for _, text in found["EcoControlMpc_DeadlineError_ErrorSts"])
    begun = [call.time_ns for call in play("simulate", drive).calls if call.call == "CoreAcc_Step"]
    assert len([time for time in begun if 11 * SECOND <= time < 12 * SECOND]) < 20


@pytest.mark.parametrize("name", OTHERS)
def test_calls_and_processes_are_measured(play, name):
    recording = play(name, Drive(DRIVE, 10 * SECOND))
    assert {each.call for each in recording.calls} == {"CoreAcc_Step", "EcoControlMpc_Step"}
    own = [each for each in recording.processes if not each.is_player]
    assert len(own) == 2
    assert all(each.cpu_s > 0 and each.peak_rss_bytes > 2**20 and each.executable_bytes > 2**12 for each in own)


@pytest.mark.parametrize("name", OTHERS)
def test_in_free_run_calls_come_at_their_cycle_and_with_the_time_of_a_clock(play, name):
    recording = play(name, Drive(DRIVE, 8 * SECOND, "free run"))
    assert recording.last_words == ""
    times = [time for time, _ in recording.sent["Vehicle.ADAS.EcoControl.Status"]]
    assert 40 <= len(times) <= 65  # from 5 s on, when the mode is STANDBY, every 50 ms
    assert all(4.5 * SECOND < each < 9 * SECOND for each in times)
    for each in recording.supervised:  # whether all are in time depends on the machine: `compare` reports it
        assert each.call or len(each.gaps_ns) >= 7 * SECOND // each.period_ns


@pytest.mark.parametrize("name", PLATFORMS)
def test_what_is_missing_is_told_in_one_line(name, tmp_path, monkeypatch):
    """An empty machine: no compiler, no CMake, no ROS 2."""
    monkeypatch.setattr("sigcat.players.ros2_environment.WHEELS", tmp_path / "none")
    monkeypatch.setattr("sigcat.adapter.toolchain.packaged", lambda: None)
    told = RUNNERS[name].missing({"PATH": str(tmp_path)})
    assert told
    assert "\n" not in told
    assert "install" in told.lower()


def dying(folder, how):
    """EcoControl whose CoreAcc dies in its 20th step."""
    for name in ("core_acc", "eco_control_mpc"):
        shutil.copytree(EXAMPLES / name, folder / name)
    source = folder / "core_acc/CoreAcc.c"
    text = source.read_text()
    begin = text.index("{", text.index("void CoreAcc_step(void)\n")) + 1
    dies = f"static int steps = 0; if (++steps == 20) {{ {how} }}"
    source.write_text(f"#include <stdio.h>\n#include <stdlib.h>\n{text[:begin]}{dies}{text[begin:]}")
    members = [member._replace(folder=folder / member.folder.name) for member in subject().prepared.connections.members]
    prepared = subject().prepared
    return subject()._replace(
        prepared=prepared._replace(connections=prepared.connections._replace(members=tuple(members)))
    )


@pytest.mark.parametrize("name", PLATFORMS)
def test_a_function_that_dies_ends_the_run_with_its_last_words(name, tmp_path, capfd):
    says = 'for (int i = 0; i < 1000; i++) { (void)fprintf(stderr, "brakes?\\n"); } (void)fprintf(stderr, "the brakes are gone\\n");'
    runner, changed = RUNNERS[name], dying(tmp_path / "code", f"{says} abort();")
    recording = runner.play(runner.build(changed, tmp_path / "built", toolchain()), changed, Drive(DRIVE, 60 * SECOND))
    assert "SIGABRT" in recording.last_words or "the brakes are gone" in recording.last_words
    assert len(recording.sent["Vehicle.ADAS.EcoControl.Status"]) == (2 if runner.is_sampled else 19)
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize(
    ("name", "call"),
    [("simulate", "CoreAcc_Step"), ("autosar-classic", "CoreAcc.Step_50ms did not return, at 5950000000 ns")],
)
def test_where_all_run_in_one_process_it_is_told_which_call_died(name, call, tmp_path):
    runner, changed = RUNNERS[name], dying(tmp_path / "code", "*(volatile int *)0 = 1;")
    recording = runner.play(runner.build(changed, tmp_path / "built", toolchain()), changed, Drive(DRIVE, 60 * SECOND))
    assert "SIGSEGV" in recording.last_words
    assert call in recording.last_words
