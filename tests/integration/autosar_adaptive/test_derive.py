"""Functions become the Integration JSON of AUTOSAR adaptive."""

import json

import jsonschema
import pytest

from sigcat.errors import UsageError
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import document_schema, written
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from tests.integration.autosar_adaptive.derived import events, rules, services
from tests.integration.autosar_adaptive.sets import (
    at,
    deployed,
    derive,
    example,
    examples,
    function,
    scaled_array,
    signal,
)
from tests.published.schemas import schema
from tests.reference_tools import checked_with


def test_each_function_is_carried_whole():
    read = read_integration(written(derive(examples()).model), "integration.json")
    assert read.functions == tuple(examples())


# -- the examples --------------------------------------------------------------------------------------------------------


def test_the_examples_are_integrated_without_a_finding_but_for_their_asil():
    assert {finding.rule for finding in derive(examples()).findings} == {"A019"}


@checked_with("jsonschema", "Documents are valid under our schemas, and the schemas are valid")
def test_the_document_validates_under_our_schema():
    document = json.loads(written(derive(examples()).model))
    jsonschema.Draft202012Validator(document_schema(IntegrationModel)).validate(document)


@checked_with("published", "Documents that sigcat writes are valid under their schemas")
@pytest.mark.parametrize("name", ["CoreAcc", "EcoControlMpc", "WheelSpeedCalculation", "all"])
def test_the_document_validates_under_the_published_schema(name):
    document = json.loads(written(derive(examples() if name == "all" else [example(name)]).model))
    jsonschema.Draft202012Validator(schema("autosar_adaptive")).validate(document)


def test_the_order_of_the_functions_does_not_matter():
    assert written(derive(examples()).model) == written(derive(examples()[::-1]).model)


def test_the_document_read_back_is_the_same():
    model = derive(examples()).model
    assert written(read_integration(written(model), "integration.json")) == written(model)


def test_a_function_given_twice_is_refused():
    with pytest.raises(UsageError, match="CoreAcc is "):
        derive([example("CoreAcc"), example("CoreAcc")])


# -- services ------------------------------------------------------------------------------------------------------------


def test_what_a_function_of_the_set_provides_is_a_service_of_its_own():
    model = derive([example("CoreAcc"), example("EcoControlMpc")]).model
    consumed = services(model, "CoreAcc")["EcoControlMpcService", "Consumer"]
    provided = services(model, "EcoControlMpc")["EcoControlMpcService", "Provider"]
    assert [event.name for event in consumed.services[0].events] == ["ADAS_EcoControl_AccelerationProposal"]
    assert consumed.providers is not None
    assert consumed.providers[0].name == Text("EcoControlMpc")
    assert consumed.service_id == provided.service_id
    assert consumed.services[0].events[0].event_id == provided.services[0].events[0].event_id


def test_what_nobody_of_the_set_provides_is_gathered_by_its_first_branch():
    names = services(derive([example("CoreAcc")]).model)
    assert ("VehicleChassisService", "Consumer") in names
    assert ("VehicleADASService", "Consumer") in names
    assert names["VehicleService", "Consumer"].services[0].events[0].name == "Vehicle_Mass"


def test_the_deployment_may_gather_them_otherwise():
    services_wanted = [{"name": "Map", "paths": ["Vehicle.ADAS.Map"]}]
    derived = derive([example("CoreAcc")], deployed(autosarAdaptive={"services": services_wanted}))
    names = services(derived.model)
    gathered = names["Map", "Consumer"].services[0].events
    assert [event.name for event in gathered] == ["ADAS_Map_DFS_MapDataSpdUnitTyp"]


def test_an_event_travels_in_the_datatype_and_unit_of_the_catalogue():
    event = events(derive([example("CoreAcc")]).model)["VehicleADASService", "ADAS_CruiseControl_SpeedSet"]
    assert (event.datatype, event.unit) == ("float", "km/h")
    assert event.uses is not None
    use = event.uses[0].signal
    assert use is not None
    assert (use.units, use.max, use.conversion_factor) == ("m/s", 70, "3.6")
    assert event.data_mapping == ("core_inputs.bus_ACCIn.Bus_Cust.SetSpd",)


@pytest.mark.parametrize(
    ("give", "take", "expected"),
    [
        ({"VssMin": -5, "VssMax": 300}, {"VssMin": -5, "VssMax": 300}, (-5, 300)),
        ({"VssMax": 300}, {"VssMax": 300}, (None, 300)),
        ({"Min": 0, "Max": 60}, {"Min": 10, "Max": 50}, (0, 60)),
        (None, {"Min": 10, "Max": 50, "VssMin": -5, "VssMax": 300}, (-5, 300)),
        (None, {"Min": 10, "Max": 50}, (None, None)),
    ],
)
def test_the_range_that_is_sent_is_that_of_the_catalogue_or_the_provider(give, take, expected):
    providing = [] if give is None else [function("Give", [at("Vehicle.Speed", "Provider", **give)])]
    made = events(derive([*providing, function("Take", [at("Vehicle.Speed", **take)])]).model)
    (event,) = [event for event in made.values() if event.name == "Vehicle_Speed"]
    assert (event.min, event.max) == expected
    taken = [use.interface for use in event.uses or () if use.function == "Take"]
    assert [(each.min, each.max) for each in taken] in ([], [(take.get("Min", 0), take.get("Max", 10))])


def test_an_enumeration_is_sent_with_the_numbers_of_the_catalogue():
    model = derive([example("CoreAcc")]).model
    sent = {item.name: item for item in model.datatypes or ()}["DT_ADASMapDFSMapDataSpdUnitTyp"]
    assert [(item.symbol, item.value) for item in sent.symbols or ()][2] == ("NOT_IN_MAP", 2)
    event = events(model)["VehicleADASService", "ADAS_Map_DFS_MapDataSpdUnitTyp"]
    assert (event.min, event.max) == (0, 2)
    assert event.uses is not None
    assert [(item.symbol, item.value) for item in event.uses[0].code_symbols or ()][2] == ("NOT_IN_MAP", 3)


def test_a_signal_without_a_path_is_told_and_the_deployment_can_help():
    one = function(signals=[signal("Speed")])
    derived = derive([one])
    assert rules(derived) == ["A002"]
    assert ("DemoRequiredService", "Consumer") in services(derived.model)
    helped = derive([one], deployed(paths={"Demo.Speed": "Vehicle.Speed"}))
    assert rules(helped) == []
    assert ("VehicleService", "Vehicle_Speed") in events(helped.model)


def test_two_providers_of_one_signal_are_told():
    derived = derive([function(name, [at("Vehicle.A.B", "Provider")]) for name in ("One", "Two")])
    assert rules(derived) == ["A003"]
    assert {("OneService", "Provider"), ("TwoService", "Provider")} <= set(services(derived.model))


def test_sides_that_disagree_are_told():
    other = at("Vehicle.A.B") | {"VssDatatype": "double"}
    derived = derive([function("One", [at("Vehicle.A.B", "Provider")]), function("Two", [other])])
    assert rules(derived) == ["A004"]
    assert "double in km/h" in derived.findings[0].message


def test_names_that_are_the_same_to_autosar_are_kept_apart():
    derived = derive([function(signals=[at("Vehicle.A.B_C"), at("Vehicle.A.B.C"), at("Vehicle.A.b.c")])])
    names = [name for _, name in events(derived.model)]
    assert len({name.lower() for name in names}) == 3
    assert rules(derived) == ["A007", "A007"]


def test_errors_safety_reactions_and_modes_are_fields():
    names = services(derive([example("WheelSpeedCalculation")]).model)
    own = [field.name for field in names["WheelSpeedCalculationService", "Provider"].services[0].fields]
    assert "WheelSpeedCalculation_RangeError_ErrorSts" in own
    assert "WheelSpeedCalculation_Mode_Out" in own
    safety = names["SafetyManagementService", "Consumer"].services[0].fields
    assert [field.name for field in safety] == ["WhlSpdRLInvalid_SftyCondSts"]
    modes = names["ModeManagementService", "Consumer"].services[0].fields
    assert [field.name for field in modes] == ["WheelSpeedCalculation_Mode_In"]


def test_calls_keep_every_field_of_the_paper():
    component = derive([example("WheelSpeedCalculation")]).model.components[0]
    step = next(call for call in component.calls if call.name.endswith("_Step"))
    assert (step.modes, step.run_type, step.cycle_time, step.scheduling) == (("Run",), "Cyclic", 10, "Preemptive")
    assert step.function_modes == ("NORMAL", "SERVICE")
    assert step.watchdog is not None
    assert step.watchdog.deadline is not None
    assert (step.stack_size, step.execution_offset, step.priority) == ("2048", "2", "10")


def test_a_call_on_events_is_told():
    derived = derive([function(signals=[at("Vehicle.A.B")], call={"Runtype": "EventTriggered", "Cycletime": None})])
    assert rules(derived) == ["A010"]
    call = derived.model.components[0].calls[0]
    assert (call.trigger, call.triggers) == ("Event", ("VehicleAService/A_B",))


def test_a_run_type_that_does_not_exist_is_told_by_another_code():
    derived = derive([function(signals=[at("Vehicle.A.B")], call={"Runtype": "Sometimes"})])
    assert rules(derived) == ["A015"]
    assert derived.model.components[0].calls[0].run_type == "Cyclic"


def test_methods_have_arguments_and_an_id():
    method = {
        "Name": "SetSpeed", "Description": "Sets it.", "Role": "Provider",
        "InDataTypeList": [{"Name": "v", "Datatype": "DT_Float32", "Units": "km/h"}], "OutDataTypeList": [],
    }  # fmt: skip
    user = function("User", contract={"MethodList": [method | {"Role": "Consumer"}]})
    model = derive([function(contract={"MethodList": [method]}), user]).model
    made = services(model)["DemoService", "Provider"].services[0].methods[0]
    assert made.inputs is not None
    assert (made.inputs[0].name, made.inputs[0].datatype, made.inputs[0].unit) == ("v", "float", "km/h")
    assert services(model)["DemoService", "Consumer"].services[0].methods[0].method_id == made.method_id


def test_a_datatype_without_content_is_told():
    opaque = {"typeRef": "DT_Thing", "category": "userdefined", "cDef": "struct Thing"}
    derived = derive([function(signals=[signal("T", Datatype="DT_Thing", VssPath="Vehicle.A.T")], datatypes=[opaque])])
    assert rules(derived) == ["A005"]


def test_a_datatype_that_contains_itself_is_refused():
    loop = {
        "typeRef": "DT_Loop", "category": "userdefined", "cDef": "struct Loop", "Kind": "struct",
        "Fields": [{"Name": "Next", "Datatype": "DT_Loop"}],
    }  # fmt: skip
    derived = derive([function(signals=[signal("T", Datatype="DT_Loop", VssPath="Vehicle.A.T")], datatypes=[loop])])
    assert [(finding.rule, finding.severity) for finding in derived.findings] == [("A006", "error")]


@checked_with("published", "Documents that sigcat writes are valid under their schemas")
def test_arrays_of_texts_and_structs_validate_under_the_published_schema():
    texts = {
        "typeRef": "DT_StringArray",
        "category": "userdefined",
        "cDef": "char **",
        "Kind": "array",
        "ElementType": "DT_String",
    }
    model = derive(
        [function(signals=[signal("T", Datatype="DT_StringArray", VssPath="Vehicle.A.T")], datatypes=[texts])]
    ).model
    assert model.datatypes is not None
    entry = model.datatypes[0]
    assert (entry.kind, entry.dimension, entry.element) == ("array", "dynamic", "string")
    jsonschema.Draft202012Validator(schema("autosar_adaptive")).validate(json.loads(written(model)))


def test_an_array_is_sent_with_the_elements_of_the_catalogue():
    model = derive([scaled_array()]).model
    (event,) = events(model).values()
    assert event.datatype == "DT_Float32Array4"
    assert model.datatypes is not None
    (entry,) = (each for each in model.datatypes if each.name == event.datatype)
    assert (entry.kind, entry.dimension, entry.element, entry.vss_datatype) == ("array", 4, "float", "float[]")
