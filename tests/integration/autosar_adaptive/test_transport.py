"""Transport of services: protocol, event groups, multicast."""

import pytest

from sigcat.errors import InputRefused
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.platforms.deployment_file import read_deployment
from tests.integration.autosar_adaptive.sets import at, deployed, derive, function

SERVICE = "DemoService"
SPEED, ANGLE = "Branch_Speed", "Branch_Angle"


def derived(chosen, service=SERVICE):
    """A service with two events, and what the deployment says of its transport."""
    one = function(signals=[at("Vehicle.Branch.Speed", "Provider"), at("Vehicle.Branch.Angle", "Provider")])
    return derive([one], deployed(autosarAdaptive={"transport": {service: chosen}}))


def groups(found):
    """Event groups of each event."""
    (service,) = found.model.components[0].services
    assert {group.name for group in service.event_groups} == {event.event_group for event in service.services[0].events}
    return {event.name: event.event_group for event in service.services[0].events}


@pytest.mark.parametrize(
    ("chosen", "expected"),
    [
        ({}, {SPEED: "Cycle50ms", ANGLE: "Cycle50ms"}),
        ({"eventGroups": "one"}, {SPEED: "Events", ANGLE: "Events"}),
        ({"eventGroups": {"Fast": [SPEED]}}, {SPEED: "Fast", ANGLE: "Cycle50ms"}),
    ],
    ids=["by cycle", "one", "by name"],
)
def test_event_groups_are(chosen, expected):
    found = derived(chosen)
    assert groups(found) == expected
    assert [finding.rule for finding in found.findings] == []


def test_a_service_and_a_member_of_a_group_that_do_not_exist_are_reported():
    unknown = derived({"protocol": "TCP"}, "DemoServise")
    assert [(each.rule, SERVICE in each.fix) for each in unknown.findings] == [("A014", True)]
    member = derived({"eventGroups": {"Fast": ["Branch_Sped"]}})
    assert [(each.rule, SPEED in each.fix) for each in member.findings] == [("A014", True)]


def test_the_document_read_back_has_it():
    model = derived({"protocol": "TCP", "multicast": {"threshold": 2, "address": "239.1.2.3", "port": 30500}}).model
    assert read_integration(written(model), "integration.json") == model


@pytest.mark.parametrize(
    ("chosen", "message"),
    [
        ({"protocol": "SCTP"}, "UDP"),
        ({"multicast": {"threshold": 2, "address": "10.0.0.1", "port": 30500}}, "multicast"),
        ({"multicast": {"threshold": 2, "address": "everywhere", "port": 30500}}, "multicast"),
        ({"multicast": {"threshold": 0, "address": "239.1.2.3", "port": 30500}}, "1"),
        ({"multicast": {"threshold": 2}}, "address"),
    ],
    ids=["protocol", "unicast", "no address", "threshold", "without address"],
)
def test_what_cannot_be_sent_so_is_refused(chosen, message):
    data = str({"autosarAdaptive": {"transport": {SERVICE: chosen}}}).replace("'", '"').encode()
    with pytest.raises(InputRefused) as refused:
        read_deployment(data, "deployment.yaml")
    assert any(message in finding.message for finding in refused.value.findings), refused.value.findings
