"""Names as code has them mean signals, by the words that they shorten."""

import pytest

from sigcat.catalogue.near_signals import NearSignals, words_in_code
from tests.function.shipped import interfaces

NEAR = NearSignals(interfaces())


@pytest.mark.parametrize(
    ("name", "path"),
    [
        ("EngSpd", "Vehicle.Powertrain.CombustionEngine.Speed"),
        ("engine_speed", "Vehicle.Powertrain.CombustionEngine.Speed"),
        ("VehSpd", "Vehicle.Speed"),
        ("EgoSpd", "Vehicle.Speed"),
        ("BrkPedPos", "Vehicle.Chassis.Brake.PedalPosition"),
        ("AccrPdlPosn", "Vehicle.Chassis.Accelerator.PedalPosition"),
        ("WhlSpdFL", "Vehicle.Chassis.Axle.Row1.Wheel.Left.Speed"),
        ("wheelSpeedRearRight", "Vehicle.Chassis.Axle.Row2.Wheel.Right.Speed"),
        ("LatAcc", "Vehicle.Acceleration.Lateral"),
        ("ax", "Vehicle.Acceleration.Longitudinal"),
        ("rain_intensity", "Vehicle.Body.Raindetection.Intensity"),
        ("MotorTemp", "Vehicle.Powertrain.ElectricMotor.Temperature"),
        ("VehMass", "Vehicle.Mass"),
    ],
)
def test_a_name_means_a_signal(name, path):
    best = NEAR.near(name)[0]
    assert best.node.path == path
    assert best.has_all


def test_what_has_only_some_of_the_words_is_near_if_they_say_much():
    (found,) = NEAR.near("BrkPedPrsd")
    assert found.node.path == "Vehicle.Chassis.Brake.PedalPosition"
    assert not found.has_all


@pytest.mark.parametrize("name", ["a_ego", "v_lead", "rtU", "x1", "", "_", "42", "总线", "q" * 5_000, "a_" * 5_000])
def test_a_name_that_says_nothing_means_nothing(name):
    assert all(2 * one.matched >= one.wanted for one in NEAR.near(name))
    assert len(NEAR.near(name)) <= 3


def test_a_whole_word_comes_before_one_that_begins_so():
    assert [one.node.name for one in NEAR.near("mode")] == ["Mode"] * 3


def test_words_that_say_nothing_are_left_out():
    assert words_in_code("rtU_EngSpd_raw") == ("rt", "eng", "spd")
    assert words_in_code("u_in") == ("u", "in")
