"""One mistake in a function.yaml that is otherwise sound is one finding, at the line where it was made."""

from pathlib import Path

import pytest

from sigcat.function.document.expression import may_hold_value, root_of
from sigcat.function.function_file import check_function
from tests.function.shipped import interfaces

SOUND = (Path(__file__).parent / "demonstration.function.yaml").read_text()

OUT = "role: provided}"
SECOND_STEP = (
    "    Terminate:",
    "    BrakeStep: {description: Brakes., asil: B, cycleTime: 20, priority: 5, previousRunnable: Step}\n    Terminate:",
)


def changed(*changes: tuple[str, str]) -> str:
    text = SOUND
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    return text


def found(text: str) -> list[tuple[str, str]]:
    """The rule of each finding, and its line."""
    lines = text.splitlines()
    return [
        (finding.rule, lines[finding.line - 1].strip())
        for finding in check_function(text.encode(), "function.yaml", interfaces())
    ]


def test_the_function_that_they_change_is_sound():
    assert found(SOUND) == []


@pytest.mark.parametrize(
    ("changes", "rule", "line"),
    [
        ([("init: 0", "rangeErrorAction: Default, init: 0")], "F045", "- {path: Vehicle.Demo.In,"),
        ([("init: 0", "rangeErrorAction: Init")], "F045", "- {path: Vehicle.Demo.In,"),
        ([("debounceTime: 5", "debounceTime: 50")], "F046", "Step:"),
        ([("max: 100, asil: B, description: The input", "max: 100, default: true, asil: B, description: The input")],
         "F024", "Vehicle.Demo.In:"),
        ([("init: 0", "init: true")], "F024", "- {path: Vehicle.Demo.In,"),
        ([("default: 1", "default: false")], "F024", "Gain:"),
        ([(OUT, "role: provided, timeout: 100}")], "F044", "- {path: Vehicle.Demo.Out,"),
        ([(OUT, "role: provided, e2eError: Demo_Late_ErrorSts}")], "F228", "- {path: Vehicle.Demo.Out,"),
        ([("role: consumed,", "role: consumed, e2eError: Losst,")], "F013", "- {path: Vehicle.Demo.In,"),
        ([(OUT, OUT + "\n          - {path: Vehicle.Demo.In, role: consumed, asil: B}")], "F038", "- {path: Vehicle.Demo.In, role: consumed, asil: B}"),
        ([(OUT, OUT + "\n          - {path: Vehicle.Demo.In, role: provided}")], "F038", "- {path: Vehicle.Demo.In, role: provided}"),
        ([("name: A, asil: B", "name: A"), ("asil: B, description: The input", "description: The input")], "F090", "- {path: Vehicle.Demo.In,"),
        ([("Vehicle.Demo.Out, role", "Vehicle.Speed, role")], "F018", "Vehicle.Demo.Out:"),
        ([("{path: Vehicle.Function.Demo.Parameter.Gain}", "")], "F018", "Gain:"),
        ([("        safetyReactions: [Lost_SftyCondSts]\n", "")], "F018", "Lost:"),
        ([("      - Demo_Terminate\n", "")], "F018", "Terminate:"),
        ([("    - {mode: 'OFF', description: It is off., runnables: []}\n", "")], "F072", "active:"),
        ([("runnables: [Demo_Step]", "runnables: []")], "F073", "- interface: Demo_Step"),
        ([SECOND_STEP, ("      - Demo_Terminate", "      - Demo_BrakeStep\n      - Demo_Terminate"), ("runnables: []", "runnables: [BrakeStep]")],
         "F074", "- {mode: 'OFF',"),
        ([("cycleTime: 20", "cycleTime: 0")], "I505", "Step:"),
        ([("cycleTime: 20", "cycleTime: -20")], "F004", "Step:"),
        ([("cycleTime: 20", "cycleTime: 20ms")], "F004", "Step:"),
        ([("cycleTime: 20", "cycleTime: 20.0000001")], "F004", "Step:"),
        ([("cycleTime: 20, ", "")], "I507", "Step:"),
        ([("Works., asil: B", "Works., asil: QM")], "I522", "Step:"),
        ([("Works., asil: B", "Works., asil: QM"), ("severity: The output is 0., asil: B", "severity: The output is 0., asil: QM"),
          ("errorList: [Late], asil: B", "errorList: [Late], asil: QM"), ("default: 1, asil: B", "default: 1, asil: QM")], "F057", "Step:"),
        ([("debounceTime: 5", "previousRunnable: Terminate")], "F059", "Step:"),
        ([("function: Demo\n", "function: Demos\n")], "F015", "function: Demos"),
    ],
)  # fmt: skip
def test_a_mistake_is_one_finding_where_it_was_made(changes, rule, line):
    ((told, at),) = found(changed(*changes))
    assert told == rule
    assert at.startswith(line)


def test_a_function_that_is_renamed_beside_its_overlay_is_one_finding():
    text = "function: CoreAccs\ndescription: A.\nresponsible: A team\ncomponents: [{name: C, runnables: [CoreAcc_Init, CoreAcc_Step, CoreAcc_Terminate]}]\n"
    assert found(text) == [("F015", "function: CoreAccs")]


@pytest.mark.parametrize(
    "text",
    ["in.speed", "in->speed", "x[3]", "(*p).x", "*p", "&x", "f(x)", "f()", "x[i+1]", "((const Bus *)in)->values[3].speed",
     "(unsigned char)x", "x[0x1F]", "x[-1]", " a.b ", "f(1, x)->c", "x[i][j.k + 1]", "(struct Bus *)p"],
)  # fmt: skip
def test_expressions_that_hold_a_value_are_taken(text):
    assert may_hold_value(text)


@pytest.mark.parametrize(
    "text",
    ["a b", "a +", "1x", "3", "a..b", "a.", "->a", "a;b", "a = b", "x == 1", "'x'", '"abc"', "a,b", "a-b", "a * b", "int",
     "return", "struct s", "in.3x", "x[", "x]", "(x]", "x[a b]", "a@b", "x++", "a/*x*/b", "-", "ä", " ", "[" * 5000, "(" * 900, "(*f)(a, b)->c", "*(p + 3)", "f(g(x))", "f(a.b)", "f(x",
     "x[f]()", "a\n.b", "a ? b : c", "x[y = 1]", "sizeof(x)", "typeof(x)", "(x, y)", "x[1 << 2]", "a.f()"],
)  # fmt: skip
def test_what_names_no_value_in_c_is_refused(text):
    assert not may_hold_value(text)


@pytest.mark.parametrize(
    ("text", "root"),
    [("in.speed", "in"), ("x[i]", "x"), ("(*in).a[k].b", "in"), ("((const Bus *)in)->values[i + 1]", "in"), ("&x", "x"),
     ("(Bus)in.a", "in"), ("(unsigned char)x", "x"), ("(Bus **)&in", "in"), ("(in)->a", "in"), ("*p", "p"), ("f()", "f"),
     ("; x", None), ("", None)],
)  # fmt: skip
def test_an_expression_begins_with_a_name(text, root):
    assert root_of(text) == root


@pytest.mark.parametrize(("written", "fix"), [
    ("ASIL B", "Write B."), ("b", "Write B."), ("B(D)", "Write B."), ("qm", "Write QM."), ("E", ""),
])  # fmt: skip
def test_a_level_that_is_spelled_as_elsewhere_is_refused_with_what_to_write(written, fix):
    text = changed(("name: A, asil: B", f"name: A, asil: {written}"))
    (finding,) = check_function(text.encode(), "function.yaml", interfaces())
    assert (finding.rule, finding.fix) == ("F004", fix)


def test_a_mistyped_interface_is_found_at_its_name():
    text = (Path(__file__).parents[2] / "examples/wheel_speed_calculation/function.yaml").read_text()
    text = text.replace("interface: WheelSpeedCalculation_RangeError", "interface: WheelSpeedCalculation_RngeError")
    (finding,) = [each for each in check_function(text.encode(), "function.yaml", interfaces()) if each.rule == "F013"]
    assert text.splitlines()[finding.line - 1][finding.column - 1 :] == "WheelSpeedCalculation_RngeError_ErrorSts"
    assert finding.pointer.endswith("/interface")


@pytest.mark.parametrize("role", ["consumed, asil: B", "provided"])
def test_an_interface_that_is_given_twice_names_the_first_place(role):
    first = next(number for number, line in enumerate(SOUND.splitlines(), 1) if "- {path: Vehicle.Demo.In," in line)
    text = changed((OUT, OUT + f"\n          - {{path: Vehicle.Demo.In, role: {role}}}"))
    (finding,) = check_function(text.encode(), "function.yaml", interfaces())
    assert finding.message.endswith(f", first at function.yaml:{first}.")


def test_two_values_of_one_number_are_one_finding():
    text = changed(
        (
            "float, unit: m/s, min: 0, max: 100, asil: B, description: The output",
            "string, allowed: [LOW, HIGH], asil: B, description: The output",
        ),
        (OUT, f"{OUT[:-1]}, values: {{LOW: 1, HIGH: 1}}}}"),
    )
    found = [each for each in check_function(text.encode(), "function.yaml", interfaces()) if each.rule == "F026"]
    assert [each.message for each in found] == ["Two values have the same number."]


def test_a_key_that_is_given_twice_names_the_first_place():
    (finding,) = check_function(f"{SOUND}\nfunction: Demo\n".encode(), "function.yaml", interfaces())
    assert "first at function.yaml:" in finding.message
