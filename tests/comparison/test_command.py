"""`sigcat compare`: its inputs, outputs and statuses. Platforms other than the simulation have separate tests."""

import json
import shutil
from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.comparison.report.model import read_report
from sigcat.comparison.running.table import RUNNERS
from sigcat.data import EXAMPLES
from tests import needs
from tests.adapter.autosar_classic.generated import CASES

SET = str(EXAMPLES / "ecocontrol")
QUICK = ("--platforms", "simulate", "--duration", "8", "--no-faults")


def test_a_folder_has_the_report_in_every_form(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["compare", SET, *QUICK, "-o", str(tmp_path / "report")]) == 0
    assert "\nlines written by hand for a platform: pass. 0\n" in capsys.readouterr().err
    assert {each.name for each in (tmp_path / "report").iterdir()} == {
        f"comparison.{form}" for form in ("md", "json", "html")
    }
    report = read_report((tmp_path / "report/comparison.json").read_bytes(), "comparison.json")
    assert report.functions == ("CoreAcc", "EcoControlMpc")
    floor = {each.call: each.t_adapter.total for each in report.timing}
    assert floor == {"CoreAcc_Step": 61, "EcoControlMpc_Step": 6}  # from 5 s on: until then their mode is OFF


def test_without_a_place_the_report_is_markdown_on_standard_output(capsys: pytest.CaptureFixture[str]):
    assert main(["compare", SET, *QUICK]) == 0
    assert capsys.readouterr().out.startswith("# EcoControl on Simulation\n")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--platforms", ""], "--platforms must name some of simulate"),
        (["--platforms", "simulate", "--dbc", "gone.dbc"], "--dbc is for a log of CAN"),
        (["--platforms", "ros2-cp"], "Did you mean 'ros2-cpp'"),
        (["-o", "report.pdf"], "must be a folder, or end in .md, .json or .html"),
        (["--trace", "gone.csv"], "there is no such file"),
        (["--free-run", "-1"], "--free-run must be from 0 to 3600"),
        (["--free-run", "nan"], "--free-run must be from 0 to 3600"),
        (["--faults", "gone.yaml"], "there is no such file"),
        (["--deployment", "gone.yaml"], "there is no such file"),
    ],
)
def test_what_cannot_be_is_said_before_anything_is_built(arguments, said, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["compare", SET, *arguments]) == 2
    assert said in capsys.readouterr().err


def test_faults_beyond_the_end_of_the_drive_are_left_out_and_told(capsys):
    assert main(["compare", SET, "--platforms", "simulate", "--duration", "8"]) == 0
    told = capsys.readouterr()
    said = "Faults that are left out, as they end after 8 s, where the drive does: brake-missing, "
    assert said in told.err
    assert said.partition(":")[0] in told.out


def test_faults_and_none_contradict_each_other(capsys):
    with pytest.raises(SystemExit) as ended:
        main(["compare", SET, "--faults", "faults.yaml", "--no-faults"])
    assert ended.value.code == 2
    assert "not allowed with" in capsys.readouterr().err


def test_with_the_simulation_alone_of_those_that_are_wanted_nothing_was_compared(monkeypatch, capsys):
    for name, runner in RUNNERS.items():
        if name != "simulate":
            monkeypatch.setitem(RUNNERS, name, runner._replace(missing=lambda _: "get it"))
    assert main(["compare", SET, "--duration", "8", "--no-faults"]) == 2
    assert "Nothing was compared" in capsys.readouterr().err


@needs.cmake
def test_functions_take_turns_by_their_names_on_every_platform(tmp_path: Path):
    """Whatever their order in the set: one that is after the other sees what that one sends in the same step."""
    folder = shutil.copytree(CASES / "one_function_feeds_another", tmp_path / "set")
    text = (folder / "counter.yaml").read_text().replace("        events: [Vehicle.Filter.Levels]\n", "")
    (folder / "counter.yaml").write_text(text.replace("runType: EventTriggered", "cycleTime: 20"))
    (folder / "compare.yaml").write_text("functions: [filter.yaml, counter.yaml]\ntrace: trace.csv\n")
    platforms = ("--platforms", "simulate,autosar-classic", "--free-run", "0")
    assert main(["compare", str(folder), *platforms, "-o", str(tmp_path / "report.json")]) == 0


def test_without_a_drive_nothing_can_be_played(capsys: pytest.CaptureFixture[str]):
    assert main(["compare", str(EXAMPLES / "core_acc/function.yaml")]) == 2
    assert "--trace" in capsys.readouterr().err


def test_a_trace_without_rows_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    (tmp_path / "empty.csv").write_text("time,Vehicle.Speed\n")
    assert main(["compare", SET, "--trace", str(tmp_path / "empty.csv")]) == 2
    assert "nothing to play" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ("time,Vehicle.Speed\n0,1\n1,fast\n", "must be a number, not 'fast'"),
        ("time,Vehicle.Body.Horn.IsActive\n0,true\n1,false\n", "no column that one of the functions receives"),
    ],
    ids=["broken", "of another set"],
)
def test_a_trace_that_cannot_be_played_says_nothing_of_a_difference(rows, said, tmp_path: Path, capsys):
    (tmp_path / "trace.csv").write_text(rows)
    assert main(["compare", SET, *QUICK, "--trace", str(tmp_path / "trace.csv")]) == 2
    assert said in capsys.readouterr().err


def test_the_machine_is_told(tmp_path: Path):
    out = tmp_path / "comparison.json"
    assert main(["compare", SET, *QUICK, "-o", str(out)]) == 0
    told = json.loads(out.read_bytes())
    assert dict(told["machine"]).keys() >= {"processor", "cores", "system", "compiler", "Python"}


@needs.cmake
@pytest.mark.parametrize("begin", [2, 1_700_000_000])
def test_a_drive_that_begins_later_ends_with_its_last_row(begin: int, tmp_path: Path, capsys):
    """Times of a log are those of its clock. In a free run nothing would be played before their time."""
    trace, out = tmp_path / "trace.csv", tmp_path / "comparison.json"
    speeds = "".join(f"{begin + row / 4},{20 + row}\n" for row in range(5))
    trace.write_text(f"time,Vehicle.Speed\n{speeds}")
    options = ("--platforms", "simulate,autosar-classic", "--free-run", "1", "--no-faults", "--trace", str(trace))
    assert main(["compare", SET, *options, "-o", str(out)]) == 0
    (played,) = json.loads(out.read_bytes())["behaviour"]
    assert (played["seconds"], played["platform"]) == (1, "autosar-classic")
    assert f"No free run: the drive begins at {begin} s." in capsys.readouterr().err
