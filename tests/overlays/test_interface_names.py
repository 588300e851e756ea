"""Names of interfaces are derived from paths, as the paper's glossary has them."""

import pytest

from sigcat.catalogue.model.interfaces import by_interface_name, category_of, function_of, interface_name

WHEEL = "Vehicle.Function.WheelSpeedCalculation"
GLOSSARY = [
    (f"{WHEEL}.Error.RangeError", "error", "WheelSpeedCalculation_RangeError_ErrorSts"),
    (f"{WHEEL}.SafetyReaction.WhlSpdRLInvalid", "safety_reaction", "WhlSpdRLInvalid_SftyCondSts"),
    (f"{WHEEL}.Mode.In", "mode", "WheelSpeedCalculation_Mode_In"),
    (f"{WHEEL}.Mode.Out", "mode", "WheelSpeedCalculation_Mode_Out"),
    (f"{WHEEL}.Scheduling.Init", "scheduling", "WheelSpeedCalculation_Init"),
    (f"{WHEEL}.Scheduling.Step", "scheduling", "WheelSpeedCalculation_Step"),
    (f"{WHEEL}.Scheduling.FastStep", "scheduling", "WheelSpeedCalculation_FastStep"),
    (f"{WHEEL}.Scheduling.Terminate", "scheduling", "WheelSpeedCalculation_Terminate"),
]


@pytest.mark.parametrize(("path", "category", "name"), GLOSSARY)
def test_category_and_name_follow_from_the_path(path, category, name):
    assert category_of(path) == category
    assert interface_name(path) == name
    assert function_of(path) == "WheelSpeedCalculation"


@pytest.mark.parametrize("path", ["Vehicle.Speed", f"{WHEEL}.Parameter.LargestSpeed", "Vehicle", "A.B.C.D.E.F"])
def test_data_is_named_by_its_path(path):
    assert category_of(path) == "data"
    assert interface_name(path) == path


@pytest.mark.parametrize("path", ["Vehicle.Function", WHEEL, f"{WHEEL}.Error", f"{WHEEL}.Mode"])
def test_branches_that_group_interfaces_are_none(path):
    assert category_of(path) is None


def test_only_paths_below_a_function_belong_to_it():
    assert function_of("Vehicle.Chassis.Axle") == ""
    assert function_of("Vehicle.Function") == ""


def test_interfaces_are_found_by_name():
    assert by_interface_name([path for path, _, _ in GLOSSARY]) == {name: path for path, _, name in GLOSSARY}
    assert by_interface_name(["Vehicle.Speed", WHEEL]) == {}
