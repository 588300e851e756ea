"""A resolved function knows where each of its fields stands; what only follows from a missing part is not reported."""

import json

import pytest

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.function.declaration.scaffold import scaffold
from sigcat.function.function_file import check_function, check_function_json, checked_file
from sigcat.function.function_json.model import to_json
from tests.function.shipped import interfaces

TEXT = scaffold("Parking")
STEP = ("ComponentList", 0, "functionList", 1, "funcContractList", 0)
SPEED = (*STEP, "SignalList", 0)


def checked(text=TEXT, catalogue=None):
    return checked_file(text.encode(), "f.yaml", catalogue or interfaces())


def read_back(data):
    return check_function_json(data, "f.json")


def found(*changes, text=TEXT):
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    return [(each.rule, each.pointer) for each in check_function(text.encode(), "f.yaml", interfaces())]


@pytest.mark.parametrize(
    ("pointer", "source"),
    [
        (("FunctionInfo", "FunctionName"), ("function",)),
        (("FunctionInfo", "FunctionResponsible"), ("responsible",)),
        (("ComponentList", 0, "Name"), ("components", 0, "name")),
        ((*SPEED, "InitValue"), ("components", 0, "runnables", 1, "data", 0, "init")),
        ((*SPEED, "AsilLevel"), ("components", 0, "runnables", 1, "data", 0, "asil")),
        ((*SPEED, "VssPath"), ("components", 0, "runnables", 1, "data", 0, "path")),
        ((*STEP, "ParameterList", 0, "Variable"), ("components", 0, "runnables", 1, "parameters", 0, "variable")),
        ((*STEP, "ErrorList", 1, "Name"), ("components", 0, "runnables", 1, "errors", 1)),
        (("ModesList", 1, "RunnablesList", 0), ("modes", "active", 1, "runnables", 0)),
        (("ModeInterfaceList", 1), ("modes", "interfaces", 1)),
    ],
)
def test_a_field_stands_where_its_author_wrote_it(pointer, source):
    resolved = checked().resolved
    assert resolved.source(pointer) == source
    assert resolved.position(pointer) == resolved.document.position(source)


def test_a_field_of_the_catalogue_stands_where_the_interface_is_named():
    resolved = checked().resolved
    assert resolved.source((*SPEED, "Units")) == ("components", 0, "runnables", 1, "data", 0)
    assert resolved.source(("Datatypes", 0)) == ()


def test_what_could_not_be_resolved_moves_no_position():
    text = TEXT.replace("[Parking_SpeedTimeout_ErrorSts, ", "[Parking_Unheard_ErrorSts, ")
    assert checked(text).resolved.source((*STEP, "ErrorList", 0)) == ("components", 0, "runnables", 1, "errors", 1)


def test_function_json_from_elsewhere_is_its_own_source():
    resolved = read_back(to_json(checked().function)).resolved
    assert resolved.source(SPEED) == SPEED
    assert resolved.position(SPEED) == resolved.document.position(SPEED) != (0, 0)


# -- what follows from what ---------------------------------------------------------------------------------------


def test_the_sound_scaffold_has_no_findings():
    assert found() == []


def test_a_mistyped_call_is_one_finding_wherever_else_it_is_named():
    """Its component lacks a step, a mode runs it, and with it go the errors that it declares."""
    assert found(("interface: Parking_Step", "interface: Parking_Stepp")) == [
        ("F013", "/components/0/runnables/1/interface")
    ]


def test_a_call_that_runs_after_a_mistyped_one_is_no_finding_of_its_own():
    assert found(("- Parking_Init", "- Parking_Inti")) == [("F013", "/components/0/runnables/0")]


def test_a_mistyped_error_is_one_finding_wherever_else_it_is_named():
    changes = ("errors: [Parking_SpeedTimeout_ErrorSts", "errors: [Parking_SpeedTimeot_ErrorSts")
    assert found(changes) == [("F013", "/components/0/runnables/1/errors/0")]


def test_the_value_that_stands_in_for_a_missing_default_is_not_checked():
    assert found(("      default: 0.5\n", ""), ("min: 0.0", "min: 0.2")) == [
        ("F027", "/components/0/runnables/1/parameters/0")
    ]


def test_a_circle_that_the_file_defines_is_reported_once():
    circle = ("      cycleTime: 20\n", "      cycleTime: 20\n      previousRunnable: Step\n")
    assert found(circle) == [("I510", "/define/scheduling/Step/previousRunnable")]


def test_init_and_terminate_may_be_left_out_and_a_step_may_not():
    text = TEXT.replace("      - Parking_Init\n", "").replace("      - Parking_Terminate\n", "")
    assert "F050" not in [finding.rule for finding in checked(text).findings]
    findings = checked(TEXT.replace("Parking_Step", "Parking_Init", 1)).findings
    assert [f.message for f in findings if f.rule == "F050"] == ["Component 'Parking' must have a Step call."]


# -- ASIL ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("spelling", "level", "rules"), [("B", "B", []), ("ASIL B", "B", []), ("Dangerous", None, ["F091"])]
)
def test_an_asil_of_the_catalogue_is_read_or_refused(spelling, level, rules):
    overlay = f"Vehicle.Speed: {{type: sensor, datatype: float, unit: km/h, ASILlevel: {spelling}, description: S.}}\n"
    base = interfaces()
    layers = [*base.tree_layers, layer_from_text(overlay.encode(), "o.vspec")]
    text = TEXT.replace("            asil: QM\n", "")
    made = checked(text, compose(layers, base.vocabulary, base.type_layers))
    assert made.function.components[0].runnables[1].contracts[0].signals[0].asil_level == level
    assert [finding.rule for finding in made.findings] == rules


def test_a_safety_reaction_of_an_unknown_asil_has_a_finding():
    value = json.loads(to_json(checked().function))
    value["ComponentList"][0]["functionList"][1]["funcContractList"][0]["SafetyReactionList"][0]["AsilLevel"] = "A or B"
    (finding,) = read_back(json.dumps(value).encode()).findings
    assert (finding.rule, finding.message) == ("F091", "`AsilLevel` must be QM, A, B, C or D, not 'A or B'.")
