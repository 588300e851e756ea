"""Times are any number of whole nanoseconds, in every format."""

import json

import jsonschema_rs
import pytest

from sigcat.cli import main
from sigcat.function.function_json.duration import time_in_a_name
from tests.published.schemas import schema

FUNCTION = """\
function: Motor
description: Controls a motor.
responsible: Motor team
components:
  - name: Motor
    runnables:
      - Init
      - interface: Step
        errors: [Late]
        data: [{{path: Vehicle.Speed, role: consumed, variable: speed, timeout: {cycle}5, timeoutError: Late, asil: QM}}]
      - Terminate
define:
  errors:
    Late: {{description: The speed is late., maturationTime: {time}, resetTime: {time}, resetCondition: It is over., severity: Off., asil: QM}}
  scheduling:
    Init: {{description: Prepares., asil: QM, priority: 1, scheduling: Preemptive}}
    Terminate: {{description: Ends., asil: QM, priority: 1, scheduling: Preemptive}}
    Step: {{description: Works., asil: QM, cycleTime: {cycle}, executionOffset: {time}, priority: 1, scheduling: Preemptive}}
"""


@pytest.fixture
def file(tmp_path):
    def made(cycle, time):
        path = tmp_path / "function.yaml"
        path.write_text(FUNCTION.format(cycle=cycle, time=time))
        return path

    return made


@pytest.mark.parametrize(("cycle", "time"), [("0.0625", "0.125"), ("2.5", "0.000001"), ("10", "20.0")])
def test_whole_nanoseconds_pass_lint_and_go_through_function_json(cycle, time, file, tmp_path, capsys):
    path = file(cycle, time)
    main(["lint", str(path)])
    assert "error" not in capsys.readouterr().out
    built = tmp_path / "f.json"
    assert main(["function", "build", str(path), "-o", str(built)]) == 0
    document = json.loads(built.read_text())
    jsonschema_rs.validate(schema("function_json"), document)
    step = document["ComponentList"][0]["functionList"][1]
    error = step["funcContractList"][0]["ErrorList"][0]
    assert nanoseconds(step, "Cycletime") == round(float(cycle) * 10**6)
    assert nanoseconds(error, "MaturationTime") == round(float(time) * 10**6)
    assert main(["generate", "core", str(built), "-o", str(tmp_path)]) == 0
    assert f"UINT64_C({round(float(cycle) * 10**6)})" in (tmp_path / "Motor_adapter.c").read_text()


def nanoseconds(part, key):
    return part.get(f"{key}Nanoseconds", (part.get(key) or 0) * 10**6)


@pytest.mark.parametrize(("cycle", "time"), [("0.0000005", "1"), ("10", "0.0000001"), ("10", "1.0e+13")])
def test_other_times_are_found_where_they_are_written(cycle, time, file, capsys):
    assert main(["lint", str(file(cycle, time))]) == 1
    out = capsys.readouterr().out
    assert "whole nanoseconds" in out or "must be from 0 to 1,000,000,000,000 ms" in out
    assert "F004" in out


def test_nanoseconds_that_contradict_milliseconds_are_found(file, tmp_path, capsys):
    built = tmp_path / "f.json"
    main(["function", "build", str(file("0.0625", "1")), "-o", str(built)])
    built.write_text(
        built.read_text().replace('"CycletimeNanoseconds": 62500', '"Cycletime": 2, "CycletimeNanoseconds": 62500')
    )
    assert main(["function", "validate", str(built)]) == 1
    assert "`Cycletime` must be the time of `CycletimeNanoseconds`, 0.0625 ms" in capsys.readouterr().out


def test_a_cycle_of_milliseconds_is_written_as_given_by_hand(file, tmp_path):
    built = tmp_path / "f.json"
    main(["function", "build", str(file("0.0625", "1")), "-o", str(built)])
    edited = tmp_path / "edited.json"
    edited.write_text(built.read_text().replace('"CycletimeNanoseconds": 62500', '"Cycletime": 0.0625'))
    assert main(["generate", "core", str(edited), "-o", str(tmp_path)]) == 0
    assert "UINT64_C(62500)" in (tmp_path / "Motor_adapter.c").read_text()


@pytest.mark.parametrize("platform", ["autosar-adaptive", "ros2"])
def test_platforms_take_them(platform, file, tmp_path):
    document = tmp_path / "integration.json"
    assert main(["integrate", platform, str(file("0.0625", "0.125")), "-o", str(document)]) == 0
    assert main(["generate", platform, str(document), "-o", str(tmp_path / "out")]) == 0


@pytest.mark.parametrize(("cycle", "advice"), [("0.0625", "counts whole microseconds"), ("2.5", "set `tick`")])
def test_autosar_classic_says_where_its_ticks_are_too_long(cycle, advice, file, tmp_path, capsys):
    command = ["integrate", "autosar-classic", str(file(cycle, "1")), "-o", str(tmp_path / "integration.json")]
    assert main(command) == 1
    said = capsys.readouterr().err
    assert "K006" in said
    assert advice in said


@pytest.mark.parametrize(("time", "name"), [(10, "10ms"), (25, "25ms"), (2.5, "2500us"), (0.0625, "62500ns")])
def test_names_of_times_have_no_point_and_are_told_apart(time, name):
    assert time_in_a_name(time) == name


@pytest.mark.parametrize(
    ("time", "said"),
    [
        ("1e300", "must be a finite number, not '1e300'. Write 1.0e+300: YAML reads 1e300 as a text, "),
        ("'20'", "must be a finite number, not '20'. Write 20, without quotes."),
        ("1.0e+300", "must be from 0 to 1,000,000,000,000 ms, not 1e+300 ms."),
    ],
)
def test_what_is_no_time_says_what_to_write(time, said, file, capsys):
    assert main(["lint", str(file("10", time))]) == 1
    assert f"`executionOffset` {said}" in capsys.readouterr().out
