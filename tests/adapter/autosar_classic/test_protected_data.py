"""Data that end-to-end protection checks: each code of the transformer on the test RTE."""

import re
import shutil
import subprocess

import pytest

from sigcat.adapter.toolchain import toolchain
from sigcat.comparison.running.runner import Drive
from tests.adapter.autosar_classic.generated import RUNNERS, SECOND, built, files, play, subject, written
from tests.adapter.autosar_classic.test_components import LANES
from tests.adapter.core.compilers import SANITIZERS, sanitizers

pytestmark = pytest.mark.skipif(shutil.which("cmake") is None, reason="CMake, which builds the test RTE")
STEP = SECOND // 100
YAW, MARKING, OFFSET = (f"Vehicle.Lanes.{name}" for name in ("YawRate", "Marking", "Offset"))
VALID, NODATA, INIT, INVALID, NO_STATE_MACHINE = 0x00, 0x20, 0x30, 0x40, 0x60
OK, NO_NEW_DATA = 0, 5
SOFT_RUNTIME_ERROR, HARD_ERROR, HARD_RUNTIME_ERROR = 0x77, 0x80, 0xFF
STATES = (VALID, NODATA, INIT, INVALID, NO_STATE_MACHINE)
CODES = (*(state | check for state in STATES for check in range(6)), SOFT_RUNTIME_ERROR, HARD_ERROR, HARD_RUNTIME_ERROR)
RECEIVED = {VALID | OK, NO_STATE_MACHINE | OK}
IGNORED = {NODATA | OK, INIT | OK, *(state | NO_NEW_DATA for state in STATES)}


@pytest.fixture(scope="module")
def lanes(tmp_path_factory):
    flags = SANITIZERS if sanitizers() else ()
    return built(written(tmp_path_factory.mktemp("lanes"), LANES), LANES, *flags)


def trace(columns, rows):
    """A trace with a row each 30 ms."""
    lines = [",".join(("time", *columns))]
    lines += [",".join((f"{number * 0.03:.2f}", *map(str, cells))) for number, cells in enumerate(rows)]
    return "\n".join(lines) + "\n"


def after(row, sent):
    """The last value of a column before the next row."""
    return next((value for time, value in reversed(sent) if time < (row + 1) * 3 * STEP), None)


def with_codes(values=True):
    """A good message after each one with a code, so that each code is seen alone."""
    for number, code in enumerate(CODES):
        yield number + 1 if values else "", hex(code)
        yield 1000 + number, ""


def expected(code):
    """Whether it is received, and whether it is rejected."""
    return code in RECEIVED, code not in RECEIVED | IGNORED


def test_each_state_and_check_of_the_protection_is_received_rejected_or_ignored(lanes):
    played = play(lanes, trace((YAW, f"{YAW}:e2e"), with_codes()), 3 * SECOND)
    for number, code in enumerate(CODES):
        heading = after(2 * number, played.sent["Vehicle.Lanes.Heading"])
        status = after(2 * number, played.sent["LaneMonitor_YawRejected_ErrorSts"])
        is_received = float(heading) == number + 1
        assert (is_received, status == "FAILED") == expected(code), hex(code)


def test_a_queue_delivers_each_value_with_its_code(lanes):
    """All that waits is taken in one step, whatever the codes are."""
    columns = (MARKING, f"{MARKING}:e2e", YAW)
    played = play(lanes, trace(columns, ((*cells, 1) for cells in with_codes())), 3 * SECOND)
    digest = 0
    for number, code in enumerate(CODES):
        is_received, is_rejected = expected(code)
        digest = (digest * 31 + number + 1) % 2**32 if is_received else digest
        assert after(2 * number, played.sent["Vehicle.Lanes.Sum"]) == str(digest), hex(code)
        status = after(2 * number, played.sent["LaneMonitor_MarkingRejected_ErrorSts"])
        assert (status == "FAILED") == is_rejected, hex(code)
        digest = (digest * 31 + 1000 + number) % 2**32


def test_values_that_wait_beside_a_rejected_one_are_taken_in_the_same_step(lanes):
    rows = "".join(f"0.0{time},{value},{code}\n" for time, value, code in ((20, 1, ""), (21, 2, "0x03"), (22, 3, "")))
    played = play(lanes, f"time,{MARKING},{MARKING}:e2e\n0,,\n{rows}", SECOND // 10)
    times = [time for time, value in played.sent["Vehicle.Lanes.Sum"] if value == str(31 + 3)]
    assert times[0] == 3 * STEP
    assert "FAILED" in [
        value for time, value in played.sent["LaneMonitor_MarkingRejected_ErrorSts"] if time <= 3 * STEP
    ]


def test_an_error_without_a_message_is_rejected_though_the_update_flag_is_not_set(lanes):
    played = play(lanes, trace((YAW, f"{YAW}:e2e"), with_codes(values=False)), 3 * SECOND)
    for number, code in enumerate(CODES):
        heading = after(2 * number, played.sent["Vehicle.Lanes.Heading"])
        status = after(2 * number, played.sent["LaneMonitor_YawRejected_ErrorSts"])
        assert float(heading) == (1000 + number - 1 if number else 0), hex(code)
        assert (status == "FAILED") == expected(code)[1], hex(code)


@pytest.mark.parametrize("code", sorted(IGNORED))
def test_the_time_out_of_the_core_decides_while_there_are_too_few_messages(code, lanes):
    played = play(lanes, trace((YAW, f"{YAW}:e2e"), ((5, hex(code)) for _ in range(30))), SECOND // 2)
    late = played.sent["LaneMonitor_YawLate_ErrorSts"]
    assert [value for _, value in late][-1] == "FAILED"
    assert 10 * STEP <= late[-1][0] <= 12 * STEP
    assert "FAILED" not in [value for _, value in played.sent["LaneMonitor_YawRejected_ErrorSts"]]


def test_a_component_without_an_error_for_rejections_takes_only_what_passes(lanes):
    """As docs/reference/adapter.md has it: what does not pass is discarded."""
    rows = [(7, ""), (8, "0x03"), (9, "0x43"), (10, "0xff"), (11, "")]
    played = play(lanes, trace((MARKING, f"{MARKING}:e2e"), rows), SECOND // 4)
    assert played.sent["Vehicle.Lanes.Shown"][-1][1] == str(7 * 31 + 11)


def test_a_mode_decides_which_call_takes_protected_data(lanes):
    """The call of the mode finds what was received before it, and what was rejected meanwhile."""
    columns = (OFFSET, f"{OFFSET}:e2e", "LaneMonitor_Mode_In")
    rows = [
        (4, "", "STANDBY"),
        (5, "0x03", ""),
        ("", "", "ASSIST"),
        *[("", "", "")] * 3,
        (6, "", ""),
        *[("", "", "")] * 3,
    ]
    played = play(lanes, trace(columns, rows), 30 * STEP)
    assert {value for _, value in played.sent["Vehicle.Lanes.Plan"]} == {"4", "6"}
    assert played.sent["Vehicle.Lanes.Plan"][0][0] >= 6 * STEP
    assert [value for _, value in played.sent["LaneMonitor_OffsetRejected_ErrorSts"]] == ["FAILED", "PASSED"]


def test_every_bit_is_that_of_the_simulation_while_all_messages_pass(tmp_path):
    rows = ((k * 0.5, 3 * k, k - 20, "ASSIST" if k == 10 else "STANDBY" if k == 20 else "") for k in range(40))
    (tmp_path / "trace.csv").write_text(trace((YAW, MARKING, OFFSET, "LaneMonitor_Mode_In"), rows))
    whole, drive = subject(LANES), Drive(tmp_path / "trace.csv", SECOND)
    simulated, sent = (
        runner.play(runner.build(whole, tmp_path / runner.name, toolchain()), whole, drive).sent for runner in RUNNERS
    )
    assert len(simulated["Vehicle.Lanes.Plan"]) > 2
    assert sent == simulated


@pytest.mark.parametrize("code", ["bad", "256", "-1"])
def test_a_code_that_is_none_is_refused(code, lanes, tmp_path):
    (tmp_path / "trace").write_text(f"time_ns\t{YAW}:e2e\t{YAW}\n0\t{code}\t1.0\n")
    command = [lanes, "lock", tmp_path / "trace", tmp_path / "sent", tmp_path / "told", str(SECOND)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, (tmp_path / "sent").exists()) == (2, False)
    assert f"line 2: {YAW} must have a code from 0 to 255" in done.stderr


def test_a_verdict_that_never_rests_does_not_hold_the_runnable(tmp_path):
    """A runnable calls the DEM at most twice each time that it publishes, and the next one calls it again."""
    text = files(LANES)["test_rte/Rte_LaneMonitor.c"]
    flips = "    LaneMonitor_Adapter_Instance.out.YawRejected = (LaneMonitor_Adapter_Instance.out.YawRejected == 1U) ? 0U : 1U;\n"
    changing, count = re.subn(
        r"(Std_ReturnType Rte_Call_\w*YawRejected_ErrorSts_SetEventStatus\([^{]*\{\n)", rf"\1{flips}", text
    )
    assert count == 1
    program = built(written(tmp_path, LANES, {"test_rte/Rte_LaneMonitor.c": changing}), LANES)
    played = play(program, trace((YAW, f"{YAW}:e2e"), [(1, ""), (2, "0x03"), (3, "")]), SECOND // 10)
    told = [time for time, name, _ in played.of("DEM") if "YawRejected" in name]
    assert len(told) > 4
    publications = files(LANES)["swc/LaneMonitor.c"].count("_Swc_Publish();")
    assert max(told.count(time) for time in told) <= 2 * publications
