"""The report of packages: where each field of an Integration JSON goes."""

import pytest
from pydantic import BaseModel

from sigcat.adapter.ros2.report import TABLES, report
from sigcat.integration.report import NOT_CARRIED
from sigcat.integration.ros2.model import (
    ConditionMonitor,
    Diagnostic,
    FieldMapping,
    RosParameter,
    RosService,
    RosTopic,
    Schedule,
    StatusTopic,
    Transition,
)
from sigcat.limits import DEFAULT_LIMITS
from tests.adapter.autosar_adaptive.application.generated import FULL
from tests.adapter.ros2.generated import ECOCONTROL, ecocontrol, files, integration

MODELS: dict[str, type[BaseModel]] = {
    "topic": RosTopic, "signal": FieldMapping, "status": StatusTopic, "service": RosService, "parameter": RosParameter,
    "call": Schedule, "error": Diagnostic, "safety reaction": ConditionMonitor, "transition": Transition,
}  # fmt: skip


@pytest.mark.parametrize("kind", MODELS)
def test_the_report_knows_every_field_and_no_other(kind):
    assert {field.alias for field in MODELS[kind].model_fields.values()} == set(TABLES[kind])


def test_every_field_goes_to_a_file_that_is_there():
    for document in (ECOCONTROL.read_bytes(), integration(FULL / "function.yaml")):
        made = files(document)
        entries = report(document, "ros2.json", DEFAULT_LIMITS)
        assert entries
        assert [entry for entry in entries if entry.target == NOT_CARRIED] == []
        places = {place.strip() for entry in entries for place in entry.target.split(";")}
        assert {place for place in places if place not in made} == set()


def test_a_field_of_a_message_is_found_by_its_signal():
    entries = report(ECOCONTROL.read_bytes(), "ros2.json", DEFAULT_LIMITS)
    (unit,) = (entry for entry in entries if (entry.interface, entry.field) == ("BrkCylP", "FieldUnits"))
    assert (unit.target, unit.note) == ("eco_control_interfaces/msg/ChassisBrakeCylP.msg", "in a comment of the field")
    assert unit.target in ecocontrol()
