"""A run can be written in several forms at once, each by the ending of its file."""

import json
import xml.etree.ElementTree as ET

import pytest

from scripts.cases import ROOT, RUNS
from sigcat.cli import main

CASE = ROOT / RUNS.folder / "one_function_feeds_another"
RUN = ("simulate", "filter.yaml", "counter.yaml", "--trace", "trace.csv")


@pytest.fixture
def run(monkeypatch, tmp_path, capfd):
    """Run the functions of a case, with outputs in a separate folder."""
    monkeypatch.chdir(CASE)

    def running(*given):
        options = [str(tmp_path / option) if option.startswith("out") else option for option in given]
        status = main([*RUN, *options])
        return status, capfd.readouterr().err.replace("what a function prints is no result\n", "")

    return running


def test_all_forms_at_once(run, tmp_path):
    plotted = ("Vehicle.Speed", "Vehicle.Filter.Trend", "Filter_Mode_Out", "Hold_SftyCondSts", "Vehicle.Counter.Mean")
    assert run("-o", "out.csv", "-o", "out.mcap", "-o", "out.svg", "--plot", *plotted) == (0, "")
    assert (tmp_path / "out.csv").read_text() == RUNS.text(CASE.name)
    texts = [element.text for element in ET.parse(tmp_path / "out.svg").iter()]
    assert {"Vehicle.Speed [km/h]", "Vehicle.Counter.Mean [m/s]", "RISES", "ON", "ACTIVE"} <= set(texts)


def test_mcap_has_what_was_received_and_sent(run, tmp_path):
    reader = pytest.importorskip("mcap.reader", reason="MCAP: pip install mcap")
    assert run("-o", "out.mcap") == (0, "")
    with (tmp_path / "out.mcap").open("rb") as file:
        found = [(channel.topic, message.log_time, json.loads(message.data), json.loads(schema.data))
                 for schema, channel, message in reader.make_reader(file).iter_messages()]  # fmt: skip
    assert [time for _, time, _, _ in found] == sorted(time for _, time, _, _ in found)
    of = {topic: [(time, data) for name, time, data, _ in found if name == topic] for topic, *_ in found}
    assert of["/Vehicle/Speed"][:2] == [(10_000_000, {"value": 36.0}), (50_000_000, {"value": 72.5})]
    assert of["/Vehicle/Filter/Levels"][1] == (20_000_000, {"value": [18.0, 0.0, 0.0]})
    assert of["/Vehicle/Filter/Trend"][1] == (20_000_000, {"value": 2, "symbol": "RISES"})
    assert of["/Filter_Step"][1] == (20_000_000, {"time": 0.02})
    (speed,) = {json.dumps(schema) for topic, _, _, schema in found if topic == "/Vehicle/Speed"}
    assert json.loads(speed)["properties"] == {"value": {"type": "number", "description": "In km/h."}}


def test_mcap_is_a_trace_too_with_the_same_results(run, tmp_path, capfd):
    pytest.importorskip("mcap.reader", reason="MCAP: pip install mcap")
    run("-o", "out.mcap")
    again = [str(tmp_path / "out.mcap") if each == "trace.csv" else each for each in RUN]
    assert main([*again, "-o", str(tmp_path / "again.csv")]) == 0
    assert (tmp_path / "again.csv").read_text() == RUNS.text(CASE.name)
    assert "one of them provides it" in capfd.readouterr().err  # what the functions sent is in the file, too


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"time,Vehicle.Speed\n0,1\n", "The file must be in MCAP: it does not begin as such a file."),
        (b"", "The file must be in MCAP: it does not begin as such a file."),
    ],
)
def test_a_file_that_is_no_mcap_is_refused_at_its_name(tmp_path, monkeypatch, capfd, content, said):
    pytest.importorskip("mcap.reader", reason="MCAP: pip install mcap")
    monkeypatch.chdir(CASE)
    (tmp_path / "drive.mcap").write_bytes(content)
    arguments = [str(tmp_path / "drive.mcap") if each == "trace.csv" else each for each in RUN]
    assert main([*arguments]) == 1
    assert f"drive.mcap: error T001 {said}" in capfd.readouterr().err


def test_an_mcap_that_was_cut_is_refused(run, tmp_path, capfd):
    pytest.importorskip("mcap.reader", reason="MCAP: pip install mcap")
    run("-o", "out.mcap")
    whole = (tmp_path / "out.mcap").read_bytes()
    (tmp_path / "cut.mcap").write_bytes(whole[: len(whole) // 2])
    assert main([str(tmp_path / "cut.mcap") if each == "trace.csv" else each for each in RUN]) == 1
    assert "The file must be in MCAP: it ends in the middle, or is damaged." in capfd.readouterr().err


def test_two_runs_give_the_same_mcap(run, tmp_path):
    pytest.importorskip("mcap.reader", reason="MCAP: pip install mcap")
    run("-o", "out1.mcap", "-o", "out2.mcap")
    run("-o", "out3.mcap")
    assert (tmp_path / "out1.mcap").read_bytes() == (tmp_path / "out2.mcap").read_bytes()
    assert (tmp_path / "out1.mcap").read_bytes() == (tmp_path / "out3.mcap").read_bytes()


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("-o", "out.txt"), "must end in .csv, .mcap or .svg"),
        (("-o", "out.svg"), "pass `--plot NAME`, a signal for the picture"),
        (("--plot", "Vehicle.Speed"), "name a file for the picture: -o FILE.svg"),
        (("-o", "out.svg", "--plot", "Vehicle.Sped"), "the run has no 'Vehicle.Sped'. Did you mean 'Vehicle.Speed'?"),
        (("-o", "out.svg", "--plot", "Vehicle.Filter.Levels"), "Vehicle.Filter.Levels cannot be drawn: it is not one number"),
        (("-o", "out.csv", "-o", "out.csv"), "is named for two results"),
        (("-o", "trace.csv"), "trace.csv is read by this command and would be lost"),
    ],
)  # fmt: skip
def test_what_cannot_be_written_is_told_before_anything_runs(run, tmp_path, options, words):
    status, said = run(*options)
    assert (status, words in said) == (2, True), said
    assert list(tmp_path.iterdir()) == []
    assert (CASE / "trace.csv").read_text().startswith("time,")


def test_a_trace_of_another_function_is_not_written_over_and_a_run_is(run, tmp_path):
    other = tmp_path / "outer.csv"
    other.write_text("time,Vehicle.Speed\n0,1\n")
    status, said = run("-o", "outer.csv")
    assert (status, "outer.csv is a trace and would be lost" in said) == (2, True), said
    assert other.read_text() == "time,Vehicle.Speed\n0,1\n"
    assert [run("-o", "out.csv")[0] for _ in range(2)] == [0, 0]


def test_what_one_run_writes_can_be_the_trace_of_another(run, tmp_path, capfd):
    """Outputs of the functions are skipped, each with a note."""
    run("-o", "out.csv")
    again = [part if part != "trace.csv" else str(tmp_path / "out.csv") for part in RUN]
    assert main([*again, "-o", str(tmp_path / "again.csv")]) == 0
    notes = capfd.readouterr().err.splitlines()
    assert len(notes) == 8
    assert [note.split()[2] for note in notes] == [*["T003"] * 7, "T007"]
