"""The report: every field that has a value has a place, or a reason."""

import json

import pytest

from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.wire import written as to_json
from sigcat.integration.autosar_adaptive.field_targets import CALL_TARGETS, PARAMETER_TARGETS, TABLES
from sigcat.integration.report import NOT_CARRIED, to_markdown
from tests.integration.autosar_adaptive.derived import rules
from tests.integration.autosar_adaptive.sets import derive, example, examples, function, signal


@pytest.mark.parametrize("kind", [Signal, DataQueue, MethodInterface, ErrorInterface, SafetyReaction, ModeInterface])
def test_every_field_of_an_interface_has_a_place(kind):
    assert {str(field.alias) for field in kind.model_fields.values()} <= set(TABLES[kind][1])


def test_every_field_of_a_call_and_of_a_parameter_has_a_place():
    assert {str(field.alias) for field in Runnable.model_fields.values()} <= set(CALL_TARGETS)
    assert {str(field.alias) for field in ParameterInterface.model_fields.values()} <= set(PARAMETER_TARGETS)


def test_the_report_has_every_field_that_has_a_value():
    derived = derive(examples())
    assert NOT_CARRIED not in {entry.target for entry in derived.report}
    targets = {(entry.interface, entry.field): entry.target for entry in derived.report}
    assert targets["BrkCylP", "Timeout"] == "CoreAcc/VehicleChassisService/Chassis_Brake_CylP/Uses/Signal/Timeout"
    assert targets["WheelSpeedCalculation_Step", "StackSize"].endswith(
        "/FunctionList/WheelSpeedCalculation_Step/StackSize"
    )


def test_a_value_that_the_report_tells_of_stands_there():
    """Every number and text of a signal is in the document, wherever it went."""
    derived = derive([example("CoreAcc")])
    written = to_json(derived.model).decode()
    contracts = [one for call in example("CoreAcc").components[0].runnables for one in call.contracts or ()]
    lists = [(one.signals, one.errors, one.safety_reactions, one.parameters) for one in contracts]
    interfaces = [interface for four in lists for listed in four for interface in listed or ()]
    values = [value for interface in interfaces for value in interface.model_dump(mode="json").values()]
    texts = [
        json.dumps(value, ensure_ascii=False).strip("[]{").split(",")[0]
        for value in values
        if value not in (None, [], {})
    ]
    assert len(texts) > 100
    assert [text for text in texts if text not in written] == []


def test_a_field_that_no_one_knows_is_told():
    method = {
        "Name": "M", "Description": "Does.", "Role": "Provider", "InDataTypeList": [], "OutDataTypeList": [], "Colour": "red",
    }  # fmt: skip
    derived = derive([function(contract={"MethodList": [method]})])
    assert rules(derived) == ["A012"]
    assert derived.findings[0].message.startswith("Colour of M (Demo) has no place in the Integration JSON")


def test_the_report_escapes_what_documents_contain():
    derived = derive([function(signals=[signal('a|b"><script>', VssPath="Vehicle.A.B")])])
    text = to_markdown(derived.report)
    assert "<script>" not in text
    assert "a\\|b" in text
