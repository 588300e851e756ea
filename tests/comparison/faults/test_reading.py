"""A file of faults: its scenarios, and its errors with their lines."""

from pathlib import Path

import pytest

from sigcat.adapter.host.shapes import Number
from sigcat.comparison.faults.drives import read_texts
from sigcat.comparison.faults.reading import read_scenarios
from sigcat.comparison.faults.scenario import Killed, Slow, Spoilt
from sigcat.errors import InputRefused

EXAMPLE = Path("examples/ecocontrol/faults.yaml")
HEAD = "scenarios:\n  - name: one\n    title: One\n    from: 1\n    to: 2\n    faults:\n"


def read(text: str) -> list[object]:
    (scenario,) = read_scenarios(text.encode(), "faults.yaml", ["A"], ["F_Step"], ["F"])
    return [*scenario.spoilt, *scenario.slow, *scenario.killed]


@pytest.mark.parametrize(
    ("fault", "expected"),
    [
        ("{fault: value, signal: A, from: 1, to: 1.5, value: nan}", Spoilt("value", "A", 10**9, 1_500_000_000, "nan")),
        ("{fault: delayed, signal: A, from: 1, to: 1.5, by: 0.1}", Spoilt("delayed", "A", 10**9, 1_500_000_000, "", 10**8)),
        ("{fault: dropped, signal: A, from: 1, to: 1.5}", Spoilt("dropped", "A", 10**9, 1_500_000_000)),
        ("{fault: sent, signal: A, at: 1.5, value: '5'}", Spoilt("sent", "A", 1_500_000_000, 1_500_000_000, "5")),
        ("{fault: sent, signal: A, at: 1.5, value: -5}", Spoilt("sent", "A", 1_500_000_000, 1_500_000_000, "-5")),
        ("{fault: sent, signal: A, at: 1.5, value: 0.25}", Spoilt("sent", "A", 1_500_000_000, 1_500_000_000, "0.25")),
        ("{fault: sent, signal: A, at: 1.5, value: true}", Spoilt("sent", "A", 1_500_000_000, 1_500_000_000, "true")),
        ("{fault: slow, call: F_Step, from: 1, to: 1.5, takes: 0.07}", Slow("F_Step", 10**9, 1_500_000_000, 70_000_000)),
        ("{fault: killed, function: F, at: 1.2}", Killed("F", 1_200_000_000)),
    ],
)  # fmt: skip
def test_a_fault_is_read(fault, expected):
    assert read(f"{HEAD}      - {fault}\n") == [expected]


@pytest.mark.parametrize(
    ("fault", "line", "words"),
    [
        ("{fault: value, signal: A, from: 1, to: 1.5}", 7, "must say `value`"),
        ("{fault: dropped, signal: A, from: 1, to: 1.5, by: 1}", 7, "has no `by`"),
        ("{fault: dropped, signal: B, from: 1, to: 1.5}", 7, "B is no signal that the drive has"),
        ("{fault: slow, call: F_Stop, from: 1, to: 1.5, takes: 1}", 7, "F_Stop is no call"),
        ("{fault: killed, function: G, at: 1.5}", 7, "G is no function"),
        ("{fault: dropped, signal: A, from: 1.5, to: 1}", 7, "must end after it begins"),
        ("{fault: killed, function: F, at: 3}", 7, "must begin while its scenario is watched"),
        ("{fault: broken, signal: A}", 7, "`fault` must be value, dropped,"),
        ("{fault: [killed], function: F, at: 1.5}", 7, "`fault` must be value, dropped,"),
        ("{signal: A, from: 1, to: 1.5}", 7, "'fault' is missing."),
        ("{fault: sent, signal: A, at: 1.5, value: [1]}", 7, "value"),
        ("{fault: dropped, signal: A, from: -1, to: 1}", 7, "0"),
    ],
)
def test_what_is_wrong_is_a_finding_at_its_place(fault, line, words):
    with pytest.raises(InputRefused) as refused:
        read(f"{HEAD}      - {fault}\n")
    (finding,) = refused.value.findings
    assert (finding.line, words in finding.message) == (line, True), finding


def test_a_misspelled_fault_is_told_with_the_one_that_is_meant():
    with pytest.raises(InputRefused) as refused:
        read(f"{HEAD}      - {{fault: dropd, signal: A, from: 1, to: 1.5}}\n")
    (finding,) = refused.value.findings
    assert finding.message.endswith("not 'dropd'.")
    assert "'dropped'" in finding.fix
    assert (finding.line, finding.column) == (7, 17)


def test_two_scenarios_are_not_watched_at_one_time_unless_one_kills():
    other = HEAD.removeprefix("scenarios:\n").replace("one", "two")
    fault = "      - {fault: dropped, signal: A, from: 1, to: 1.5}\n"
    with pytest.raises(InputRefused) as refused:
        read_scenarios(f"{HEAD}{fault}{other}{fault}".encode(), "faults.yaml", ["A"], [], ["F"])
    assert "at one time" in refused.value.findings[0].message
    killed = "      - {fault: killed, function: F, at: 1}\n"
    assert len(read_scenarios(f"{HEAD}{fault}{other}{killed}".encode(), "faults.yaml", ["A"], [], ["F"])) == 2


def test_a_name_stands_for_one_scenario():
    fault = "      - {fault: dropped, signal: A, from: 1, to: 1.5}\n"
    other = HEAD.removeprefix("scenarios:\n").replace("from: 1\n", "from: 2\n").replace("to: 2\n", "to: 3\n")
    with pytest.raises(InputRefused) as refused:
        read_scenarios(f"{HEAD}{fault}{other}{fault.replace('1', '2')}".encode(), "faults.yaml", ["A"], [], [])
    assert any("one scenario" in finding.message for finding in refused.value.findings)


def test_the_example_has_at_least_twenty():
    columns = read_texts(Path("examples/ecocontrol/drive.csv")).columns
    found = read_scenarios(
        EXAMPLE.read_bytes(),
        str(EXAMPLE),
        columns,
        ["CoreAcc_Step", "EcoControlMpc_Step"],
        ["CoreAcc", "EcoControlMpc"],
    )
    assert len(found) >= 20


@pytest.mark.parametrize("value", ["fast", "[1]", "1e"])
@pytest.mark.parametrize("fault", ["fault: value, from: 1, to: 1.5", "fault: sent, at: 1.5"])
def test_a_value_that_the_signal_cannot_have_is_told_before_anything_is_played(value, fault):
    text = f"{HEAD}      - {{{fault}, signal: A, value: '{value}'}}\n"
    with pytest.raises(InputRefused) as refused:
        read_scenarios(text.encode(), "faults.yaml", ["A"], [], [], {"A": Number("float")})
    assert [(each.line, each.message.startswith("A must be ")) for each in refused.value.findings] == [(7, True)]


def test_a_name_that_is_near_none_is_told_with_those_there_are():
    text = f"{HEAD}      - {{fault: slow, call: X, from: 1, to: 1.5, takes: 1}}\n"
    with pytest.raises(InputRefused) as refused:
        read_scenarios(text.encode(), "faults.yaml", ["A"], ["Smooth_Step", "Smooth_Init"], [])
    assert [each.fix for each in refused.value.findings] == ["It has Smooth_Init, Smooth_Step."]
