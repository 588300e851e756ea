"""A drive that was logged on CAN goes through the gateway, and is then the drive that every platform is played."""

import pytest

from sigcat.cli import main
from sigcat.comparison.report.model import read_report
from sigcat.data import EXAMPLES

SET = EXAMPLES / "ecocontrol"
LOG, DATABASE, MAPPINGS = (str(SET / "can" / name) for name in ("drive.log.gz", "ecocontrol.dbc", "can.vspec"))
QUICK = ("--platforms", "simulate", "--duration", "8", "--no-faults")
FRAMES = 39_303


def compared(out, *arguments):
    assert main(["compare", str(SET), *QUICK, *arguments, "-o", str(out)]) == 0
    return read_report(out.read_bytes(), out.name)


def test_a_log_is_the_drive_that_it_was_recorded_from(tmp_path):
    logged = compared(tmp_path / "log.json", "--trace", LOG, "--dbc", DATABASE, "-l", MAPPINGS)
    drive = compared(tmp_path / "drive.json")
    assert {each.call: each.t_exec.total for each in logged.timing} == {
        each.call: each.t_exec.total for each in drive.timing
    }
    assert logged.traces == drive.traces


def test_each_frame_has_the_time_that_its_translation_took(tmp_path):
    logged = compared(tmp_path / "log.json", "--trace", LOG, "--dbc", DATABASE, "-l", MAPPINGS)
    (gateway,) = logged.measured
    assert gateway.durations.total == FRAMES
    assert 0 < gateway.durations.p50 <= gateway.durations.p99
    assert any("gateway" in each.ours for each in logged.paper)


@pytest.mark.parametrize(
    ("log", "arguments", "said"),
    [
        ("(0.0) can0 141#0000\n", (), "name its database with --dbc"),
        ("(0.0) can0 7FF#00\n(1.0) can0 7FF#00\n", ("--dbc", DATABASE, "-l", MAPPINGS), "no value of a signal that is mapped"),
        ("rubbish\n", ("--dbc", DATABASE, "-l", MAPPINGS), "no value of a signal that is mapped"),
        ("rubbish\n", ("--dbc", DATABASE, "-l", MAPPINGS), "bus.log:1:1: warning B002 The line is not a frame"),
    ],
    ids=["without-database", "of-another-bus", "no-log", "no-log-why"],
)  # fmt: skip
def test_a_log_that_gives_no_drive_is_refused(log, arguments, said, tmp_path, capsys):
    (tmp_path / "bus.log").write_text(log)
    assert main(["compare", str(SET), *QUICK, "--trace", str(tmp_path / "bus.log"), *arguments]) == 2
    assert said in capsys.readouterr().err


def test_what_is_written_for_comparison_is_written_for_no_platform(tmp_path):
    """The baseline is not played to here."""
    report = compared(tmp_path / "drive.json")
    assert next(each for each in report.targets if each.what.startswith("lines written by hand")).holds
