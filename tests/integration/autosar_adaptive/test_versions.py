"""Versions of services: stated, or raised by what changed since a previous document."""

import json

import pytest

from sigcat.errors import InputRefused
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.autosar_adaptive.someip.versions import raised, version_of
from sigcat.platforms.deployment_file import read_deployment
from tests.integration.autosar_adaptive.sets import at, deployed, derive, function

SERVICE = "DemoService"


def made(*names, unit="km/h", deployment=None):
    """A function that provides signals."""
    signals = [at(f"Vehicle.{name}", "Provider") | {"VssUnit": unit, "Units": unit} for name in names]
    return derive([function(signals=signals)], deployment or deployed()).model


OVER_TCP = deployed(autosarAdaptive={"transport": {SERVICE: {"protocol": "TCP"}}})


def version(model):
    """The version of its one service."""
    (component,) = model.components
    (service,) = component.services
    return str(version_of(service))


def with_version(model, major, minor):
    """The document with another version of its service."""
    document = json.loads(written(model))
    document["ComponentList"][0]["ServiceInterfaceList"][0].update(MajorVersion=major, MinorVersion=minor)
    return read_integration(json.dumps(document).encode(), "integration.json")


def test_a_service_has_version_1_0_or_what_the_deployment_states():
    assert version(made("Speed")) == "1.0"
    name = made("Speed").components[0].services[0].name
    assert version(made("Speed", deployment=deployed(autosarAdaptive={"versions": {name: "3.7"}}))) == "3.7"


@pytest.mark.parametrize("text", ["3", "255.0", "1.-1", "one", "1.0.0"])
def test_a_version_that_is_none_is_refused(text):
    with pytest.raises(InputRefused) as refused:
        read_deployment(f"autosarAdaptive: {{versions: {{A: '{text}'}}}}\n".encode(), "deployment.yaml")
    (finding,) = refused.value.findings
    assert (finding.line, finding.pointer) == (1, "/autosarAdaptive/versions/A")


def test_a_version_of_a_service_that_is_not_there_is_reported():
    findings = derive([function(signals=[at("Vehicle.Speed")])], deployed(autosarAdaptive={"versions": {"No": "2.0"}}))
    assert [each.path for each in findings.findings if "'No'" in each.message] == ["No"]


@pytest.mark.parametrize(
    ("before", "now", "expected"),
    [
        (made("Speed"), made("Speed"), "2.4"),
        (made("Speed"), made("Speed", deployment=OVER_TCP), "3.0"),
        (made("Speed"), made("Speed", "Limit"), "2.5"),
        (made("Speed", "Limit"), made("Speed"), "3.0"),
        (made("Speed"), made("Speed", unit="m/s"), "3.0"),
    ],
    ids=["the same", "by TCP", "an event more", "an event less", "another unit"],
)
def test_a_version_rises_by_what_changed(before, now, expected):
    found = raised(now, with_version(before, 2, 4), {})
    assert version(found.model) == expected
    assert [each.rule for each in found.findings] == ([] if expected == "2.4" else ["A023"])


def test_a_stated_version_is_kept():
    now = made("Speed")
    name = now.components[0].services[0].name
    assert version(raised(now, with_version(made("Speed", "Limit"), 2, 4), {name: "1.0"}).model) == "1.0"


def test_components_with_two_versions_of_a_service_are_refused():
    one, two = (
        function("One", signals=[at("Vehicle.Speed", "Provider")]),
        function("Two", signals=[at("Vehicle.Speed")]),
    )
    document = json.loads(written(derive([one, two]).model))
    document["ComponentList"][1]["ServiceInterfaceList"][0]["MajorVersion"] = 2
    with pytest.raises(InputRefused) as refused:
        read_integration(json.dumps(document).encode(), "integration.json")
    (finding,) = refused.value.findings
    assert finding.pointer == "/ComponentList/1/ServiceInterfaceList/0/MajorVersion"
    assert "must have one version, not 1.0 in One and 2.0 in Two" in finding.message
