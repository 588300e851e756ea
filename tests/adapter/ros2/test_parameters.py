"""Parameters of a node: with unit and range, and what the function would not take is refused as a whole."""

import pytest

from tests.adapter.ros2.built import USUAL, ended, running
from tests.adapter.ros2.other_end import ACTIVATE, CONFIGURE
from tests.needs import ros2

pytestmark = [ros2, pytest.mark.parametrize("language", USUAL)]

NODE = "eco_control_mpc"
NAMES = ["veh_m", "horizon_step", "energy_weight"]


def test_what_is_out_of_range_is_refused_with_all_that_comes_with_it(language, tmp_path):
    with running(language, tmp_path, NODE) as peer:
        peer.bring(NODE, CONFIGURE, ACTIVATE)
        before = peer.parameters(NODE, NAMES)
        for value in (0.5, 200.5, 1e300, float("inf"), float("nan")):
            assert not peer.set_all_parameters(NODE, {"energy_weight": 0.25, "horizon_step": value})[0], value
            assert peer.parameters(NODE, NAMES) == before
        assert not peer.set_parameters(NODE, {"horizon_step": "wide"})[0][0]
        assert not peer.set_parameters(NODE, {"no_such_parameter": 1.0})[0][0]
        assert not peer.set_parameters(NODE, {"lock_step": True})[0][0]
        assert peer.set_all_parameters(NODE, {"energy_weight": 0.25, "horizon_step": 200.0}) == [True, ""]
        assert peer.parameters(NODE, NAMES) == [before[0], 200.0, 0.25]


def test_a_parameter_says_its_unit_and_its_range(language, tmp_path):
    with running(language, tmp_path, NODE) as peer:
        found = peer.described(NODE, "horizon_step")
        assert found["ranges"] == [[1.0, 200.0]]
        assert "Unit: m" in found["description"]
        assert peer.described(NODE, "lock_step")["read_only"]


@pytest.mark.parametrize(
    ("name", "value"), [("horizon_step", "0.5"), ("horizon_step", "wide"), ("scheduling_policy", "fifoo")]
)
def test_a_node_does_not_start_with_a_parameter_that_it_would_refuse(language, name, value, tmp_path):
    status, told = ended(language, tmp_path, NODE, "-p", f"{name}:={value}")
    assert status == 1
    assert name in told
    assert not has_trace(told)


def test_a_node_says_in_a_line_that_its_arguments_cannot_be_read(language, tmp_path):
    status, told = ended(language, tmp_path, NODE, "--params-file", "/nowhere.yaml")
    assert status == 1
    assert "/nowhere.yaml" in told
    assert not has_trace(told)


def has_trace(told):
    """Whether a node tells more than a reason: where it is in its code, or that it was aborted."""
    return "Traceback" in told or "terminate called" in told
