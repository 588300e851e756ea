"""Outputs are compared with a file of expected ones: a back-to-back test."""

import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from scripts.cases import ROOT, RUNS
from sigcat.cli import main

CASE = ROOT / RUNS.folder / "one_function_feeds_another"
EXPECTED = (CASE / RUNS.expected).read_text()
RUN = ("simulate", str(CASE / "filter.yaml"), str(CASE / "counter.yaml"), "--trace", str(CASE / "trace.csv"))
MEAN = "4.166666666666667"


@pytest.fixture
def run(tmp_path, monkeypatch, capfd):
    """Run the functions of a case, and compare them with a text."""
    monkeypatch.chdir(tmp_path)

    def running(text, *options):
        Path("expected.csv").write_text(text)
        status = main([*RUN, "-o", "out.csv", "--expect", "expected.csv", *options])
        said = capfd.readouterr().err.replace("what a function prints is no result\n", "")
        assert "Traceback" not in said
        return status, [line for line in said.splitlines() if not line.startswith("  ")]  # but for excerpts

    return running


def test_what_a_run_wrote_is_what_is_expected_of_it(run):
    assert run(EXPECTED) == (0, ["sigcat: All 8 outputs of expected.csv are as expected."])
    assert Path("out.csv").read_text() == EXPECTED


HEAD = EXPECTED.splitlines()[0]


@pytest.mark.parametrize(
    "text",
    ["time,call\n", f"{HEAD}\n", f"{HEAD}\n0.01{',' * HEAD.count(',')}\n", "time,Vehicle.Speed\n0,1\n"],
    ids=["no column", "no row", "empty cells", "inputs only"],
)
def test_a_file_without_values_of_outputs_is_no_pass(run, text):
    status, said = run(text)
    assert status == 2
    assert said[-1].startswith("sigcat: expected.csv has no value of an output: nothing was compared.")


def test_an_output_without_values_is_not_counted(run):
    lines = [line.split(",") for line in EXPECTED.splitlines()]
    for line in lines[1:]:
        line[-1] = ""
    status, said = run("".join(f"{','.join(line)}\n" for line in lines))
    assert status == 0
    assert said == [
        f"sigcat: All 7 outputs of expected.csv are as expected. Not compared, as they have no value: {lines[0][-1]}."
    ]


def test_what_differs_is_in_a_table_a_picture_and_a_report(run):
    changed = EXPECTED.replace(MEAN, "4.2").replace("RISES", "FALLS", 1)
    status, said = run(changed, "--differences", "first.svg", "--junit", "report.xml", "--report", "all.json")
    assert status == 1
    assert said[:2] == [
        "expected.csv:6:42: error T030 Vehicle.Filter.Trend must be FALLS at 0.020000000 s, not RISES.",
        "expected.csv:9:32: error T030 Vehicle.Counter.Mean must be 4.2 at 0.040000000 s, not 4.166666666666667.",
    ]
    assert said[2] == "sigcat: 2 of 8 outputs differ from expected.csv."
    head, trend, mean = said[3:]
    assert head.split() == [
        "output",
        "compared",
        "differ",
        "first",
        "at",
        "expected",
        "actual",
        "largest",
        "difference",
    ]
    assert trend.split()[2:6] == ["1", "0.020000000", "FALLS", "RISES"]
    assert mean.split()[3:] == ["0.040000000", "4.2", MEAN, "0.0333333333"]
    texts = [element.text for element in ET.parse("first.svg").iter()]
    assert {"Vehicle.Filter.Trend", "Vehicle.Counter.Mean [m/s]", "FALLS", "RISES"} <= set(texts)
    suites = ET.parse("report.xml").getroot()
    assert (suites.get("tests"), suites.get("failures")) == ("8", "2")
    failures = {case.get("name"): case.find("failure") for case in suites.iter("testcase")}
    assert failures["Vehicle.Filter.Levels"] is None
    mean_failure = failures["Vehicle.Counter.Mean"]
    assert mean_failure is not None
    assert "must be 4.2 at 0.040000000 s" in mean_failure.get("message", "")
    assert "T030" in Path("all.json").read_text()


@pytest.mark.parametrize(
    ("tolerance", "status"),
    [
        (("0.04",), 0),
        (("0.03",), 1),
        (("1%",), 0),
        (("0.1%",), 1),
        (("Vehicle.Counter.Mean=0.04",), 0),
        (("0.04", "Vehicle.Counter.Mean=0"), 1),
    ],
)
def test_numbers_may_be_near(run, tolerance, status):
    options = [word for each in tolerance for word in ("--tolerance", each)]
    assert run(EXPECTED.replace(MEAN, "4.2"), *options)[0] == status


@pytest.mark.parametrize("tolerance", ["", "-1", "nan", "x=1", "one", "inf"])
def test_a_tolerance_is_a_number(run, tolerance):
    status, (line,) = run(EXPECTED, f"--tolerance={tolerance}")
    assert status == 2
    assert line.startswith("sigcat: ")


def test_symbols_are_compared_whatever_the_tolerance(run):
    assert run(EXPECTED.replace("RISES", "FALLS", 1), "--tolerance", "100")[0] == 1


def test_a_value_holds_until_the_next_one(run):
    rows = "time,Vehicle.Counter.Count,Vehicle.Speed\n0.041,6,\n0.05,6,1\n"
    status, said = run(rows)
    assert status == 0
    assert said == [
        "expected.csv:1:28: info T003 Vehicle.Speed is left out: the functions do not send it.",
        "sigcat: All 1 outputs of expected.csv are as expected.",
    ]


def test_before_and_after_the_run_there_is_nothing(run):
    status, said = run("time,Filter_Standstill_ErrorSts\n0,PASSED\n")
    assert status == 1
    assert "must be PASSED at 0.000000000 s, not nothing yet." in said[0]
    status, said = run("time,Vehicle.Counter.Count\n1,18\n")
    assert "must be 18 at 1.000000000 s, not nothing: the run has ended." in said[0]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("time,Vehicle.Counter.Cuont\n", "expected.csv:1:6: error T002"),
        ("time,Vehicle.Counter.Count\n0,many\n", "expected.csv:2:3: error T005"),
        ("", "expected.csv:1:1: error T001"),
    ],
)
def test_a_file_that_cannot_be_used_is_refused(run, text, words):
    status, said = run(text)
    assert (status, said[0].startswith(words)) == (1, True), said
    assert not Path("out.csv").exists()


def test_options_that_need_it_say_so(monkeypatch, tmp_path, capfd):
    monkeypatch.chdir(tmp_path)
    assert main([*RUN, "--junit", "report.xml"]) == 2
    assert "need --expect" in capfd.readouterr().err
