"""Several processes of one executable, each with separate instances of services."""

import pytest

from sigcat.integration.autosar_adaptive.processes import processes
from tests.integration.autosar_adaptive.sets import at, deployed, derive, function

SENDER = function("Wheel", [at("Vehicle.A.B", "Provider")])
RECEIVER = function("Brake", [at("Vehicle.A.B")])
OWN = {"identifiers": {"WheelService:instance": 2}}


def derived(**components):
    settings = {**OWN, "components": {name: {"processes": stated} for name, stated in components.items()}}
    return derive([SENDER, RECEIVER], deployed(autosarAdaptive=settings))


def test_a_process_offers_and_uses_the_instances_that_are_named_for_it():
    made = derived(Wheel={"RearWheel": {"WheelService": 3}}, Brake={"RearBrake": {"WheelService": 3}, "SpareBrake": {}})
    found = {each.name: [service.instance_id for service in each.services] for each in processes(made.model.components)}
    assert found == {
        "WheelProcess": [2], "BrakeProcess": [2], "RearWheel": [3], "RearBrake": [3], "SpareBrake": [2],
    }  # fmt: skip
    assert [finding for finding in made.findings if finding.rule == "A009"] == []


@pytest.mark.parametrize(
    ("stated", "word"),
    [
        ({"RearWheel": {}}, "its own instance of WheelService, not 2"),
        ({"RearWheel": {"WheelService": 2}}, "its own instance of WheelService, not 2"),
        ({"RearWheel": {"WheelService": 3}, "Spare": {"WheelService": 3}}, "its own instance of WheelService, not 3"),
        ({"RearWheel": {"WheelService": 0xFF00}}, "must be from 1 to 65279"),
        ({"RearWheel": {"WheelService": 3, "WhelService": 3}}, "offer or use WhelService"),
        ({"WheelProcess": {"WheelService": 3}}, "a unique name"),
        ({"brake": {"WheelService": 3}}, "a unique name"),
    ],
)
def test_a_process_that_cannot_be_is_refused(stated, word):
    (finding,) = [finding for finding in derived(Wheel=stated).findings if finding.rule == "A009"]
    assert word in finding.message
