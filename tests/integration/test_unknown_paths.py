"""A path that the deployment gives to an unknown signal is reported on every platform, at its line."""

import pytest

from sigcat.platforms.deployment_file import read_deployment
from tests.integration.autosar_adaptive.sets import at, function
from tests.integration.autosar_adaptive.sets import derive as adaptive
from tests.integration.autosar_classic.classic import derive as classic
from tests.integration.ros2.functions import derived as ros2


@pytest.mark.parametrize(("derive", "rule"), [(adaptive, "A014"), (classic, "K007"), (ros2, "N220")])
def test_a_misspelled_signal_is_told_with_what_was_meant(derive, rule):
    signal = at("Vehicle.Demo.Level")
    right, wrong = f"Demo.{signal['Name']}", f"Demo.{signal['Name']}x"
    text = f"name: Set\npaths:\n  {right}: Vehicle.Demo.Level\n  {wrong}: Vehicle.Demo.Level\n"
    findings = derive([function("Demo", [signal])], read_deployment(text.encode(), "deployment.yaml")).findings
    told = [(each.file, each.line, each.column, each.path, each.fix) for each in findings if each.rule == rule]
    assert told == [("deployment.yaml", 4, 3, wrong, f"Did you mean {right!r}?")]
