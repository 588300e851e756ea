"""Functions become the Integration JSON of AUTOSAR adaptive."""

import json

import jsonschema
import pytest

from sigcat.errors import InputRefused, UsageError
from sigcat.function.function_json.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.methods import MethodInterface
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.autosar_adaptive.document import identifiers_of, read_integration
from sigcat.integration.autosar_adaptive.field_targets import CALL_TARGETS, PARAMETER_TARGETS, TABLES
from sigcat.integration.autosar_adaptive.model import IntegrationModel, integration_schema, to_json
from sigcat.integration.report import NOT_CARRIED, to_markdown
from sigcat.platforms.deployment_file import read_deployment
from tests.growth import LINEAR, growth
from tests.integration.autosar_adaptive.sets import at, deployed, derive, example, examples, function, parameter, signal
from tests.judges import judged_by
from tests.published.schemas import schema


def services(model: IntegrationModel, component=None):
    """Service interfaces by name and role."""
    return {
        (interface.name, interface.role): interface
        for part in model.components
        if component in (None, part.name)
        for interface in part.services
    }


def events(model: IntegrationModel):
    """Events by service and name."""
    return {
        (interface.name, event.name): event
        for part in model.components
        for interface in part.services
        for event in interface.services[0].events
    }


def rules(derived):
    return [finding.rule for finding in derived.findings]


def test_each_function_is_carried_whole():
    read = read_integration(to_json(derive(examples()).model), "integration.json")
    assert read.functions == tuple(examples())


# -- the examples -------------------------------------------------------------------------------------------------


def test_the_examples_are_integrated_without_a_finding_but_for_their_asil():
    assert {finding.rule for finding in derive(examples()).findings} == {"A019"}


@judged_by("jsonschema", "What is written is valid under our schemas, and they are valid ones")
def test_the_document_validates_under_our_schema():
    document = json.loads(to_json(derive(examples()).model))
    jsonschema.Draft202012Validator(integration_schema()).validate(document)


@judged_by("published", "What is written is valid under their schemas")
@pytest.mark.parametrize("name", ["CoreAcc", "EcoControlMpc", "WheelSpeedCalculation", "all"])
def test_the_document_validates_under_the_published_schema(name):
    document = json.loads(to_json(derive(examples() if name == "all" else [example(name)]).model))
    jsonschema.Draft202012Validator(schema("autosar_adaptive")).validate(document)


def test_the_order_of_the_functions_does_not_matter():
    assert to_json(derive(examples()).model) == to_json(derive(examples()[::-1]).model)


def test_the_document_read_back_is_the_same():
    model = derive(examples()).model
    assert to_json(read_integration(to_json(model), "integration.json")) == to_json(model)


def test_a_function_given_twice_is_refused():
    with pytest.raises(UsageError, match="once, not twice: CoreAcc"):
        derive([example("CoreAcc"), example("CoreAcc")])


# -- services -----------------------------------------------------------------------------------------------------


def test_what_a_function_of_the_set_provides_is_a_service_of_its_own():
    model = derive([example("CoreAcc"), example("EcoControlMpc")]).model
    consumed = services(model, "CoreAcc")["EcoControlMpcService", "Consumer"]
    provided = services(model, "EcoControlMpc")["EcoControlMpcService", "Provider"]
    assert [event.name for event in consumed.services[0].events] == ["ADAS_EcoControl_AccelerationProposal"]
    assert consumed.providers is not None
    assert consumed.providers[0].name == "EcoControlMpc"
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


@judged_by("published", "What is written is valid under their schemas")
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
    jsonschema.Draft202012Validator(schema("autosar_adaptive")).validate(json.loads(to_json(model)))


# -- ids ----------------------------------------------------------------------------------------------------------


def ids(model: IntegrationModel):
    """Every id by what it belongs to."""
    found = {}
    for part in model.components:
        for interface in part.services:
            found[interface.name] = interface.service_id
            found[f"{interface.name}:instance"] = interface.instance_id
            for group in interface.event_groups or ():
                found[f"{interface.name}.{group.name} group"] = group.id
            for event in interface.services[0].events:
                found[f"{interface.name}.{event.name}"] = event.event_id
            for field in interface.services[0].fields:
                found[f"{interface.name}.{field.name}"] = field.notifier_id
                found[f"{interface.name}.Get{field.name}"] = field.getter_id
    return found


def test_ids_do_not_change_when_a_signal_is_added():
    paths = [f"Vehicle.Branch{i}.Signal{j}" for i in range(5) for j in range(8)]
    before = ids(derive([function(signals=[at(path) for path in paths])]).model)
    for more in ("Vehicle.Aaa.First", "Vehicle.Branch2.Between", "Vehicle.Zzz.Last"):
        after = ids(derive([function(signals=[at(path) for path in sorted([*paths, more])])]).model)
        assert before.items() <= after.items()


def test_ids_do_not_change_when_a_function_is_added():
    before = ids(derive([example("EcoControlMpc")]).model)
    after = ids(derive(examples()).model)
    assert before.items() <= after.items()


def test_ids_are_unique_and_in_range():
    paths = [f"Vehicle.Branch{i % 18}.Signal{i}" for i in range(3000)]
    model = derive([function(signals=[at(path) for path in paths])]).model
    found = list(services(model).values())
    assert len({service.service_id for service in found}) == len({service.instance_id for service in found}) == 18
    for service in found:
        numbers = [event.event_id for event in service.services[0].events]
        assert len(set(numbers)) == len(numbers)
        assert all(number is not None and 0x8001 <= number <= 0xFFFE for number in numbers)


def test_ids_that_depend_on_each_other_are_told_with_what_keeps_them():
    paths = [f"Vehicle.Branch.Signal{i}" for i in range(600)]
    derived = derive([function(signals=[at(path) for path in paths])])
    reported = [finding for finding in derived.findings if finding.rule == "A008"]
    assert reported
    assert reported[0].fix.startswith("To keep it, fix it in the deployment file: identifiers: {VehicleBranchService.")


def test_ids_that_a_deployment_keeps_stay_whatever_is_added():
    paths = [f"Vehicle.Branch.Signal{i}" for i in range(900)]
    before = derive([function(signals=[at(path) for path in paths[300:]])]).model
    kept = deployed(autosarAdaptive={"identifiers": identifiers_of(before)})
    after = derive([function(signals=[at(path) for path in paths])], kept).model
    assert ids(before).items() <= ids(after).items()


def test_the_deployment_may_fix_ids():
    given = {"VehicleBranchService": 4660, "VehicleBranchService:instance": 7, "VehicleBranchService.Branch_B": 32769}
    derived = derive([function(signals=[at("Vehicle.Branch.B")])], deployed(autosarAdaptive={"identifiers": given}))
    made = ids(derived.model)
    assert given.items() <= made.items()


def test_an_id_that_the_deployment_gives_twice_or_out_of_range_is_refused():
    given = {
        "VehicleBranchService.Branch_A": 5,
        "VehicleBranchService.Branch_B": 32769,
        "VehicleBranchService.Branch_C": 32769,
    }
    one = function(signals=[at(f"Vehicle.Branch.{name}") for name in "ABC"])
    derived = derive([one], deployed(autosarAdaptive={"identifiers": given}))
    assert [(finding.rule, finding.severity) for finding in derived.findings] == [("A009", "error")] * 2


# -- nothing is dropped -------------------------------------------------------------------------------------------


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


# -- input that cannot be used --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name", ["*/ #include <x>", '"><script>', "", "   ", "1st", "x" * 5000, "\u0000", "été", "class"]
)
def test_hostile_names_become_short_names(name):
    model = derive([function(name, signals=[signal(name), signal(f"{name}2", "Provider")])]).model
    read_integration(to_json(model), "integration.json")


def test_what_the_deployment_says_of_nothing_is_told_with_what_was_meant():
    settings = {
        "components": {"Dem": {"executable": "X"}},
        "identifiers": {"VehicleAServic": 7},
        "services": [{"name": "Map", "paths": ["Vehicle.AB"]}],
    }
    derived = derive(
        [function(signals=[at("Vehicle.A.B")])], deployed(paths={"Demo.C": "V.A"}, autosarAdaptive=settings)
    )
    assert rules(derived) == ["A014"] * 4
    assert "Did you mean 'Demo'?" in [finding.fix for finding in derived.findings]
    assert any(finding.fix.startswith("Did you mean 'VehicleAService'") for finding in derived.findings)


def test_a_word_that_the_published_schema_lacks_is_told_and_not_written():
    words = parameter(Interfacetype="calibration", Attribute="Odd", RangeErrorAction="Ignore")
    derived = derive([function(contract={"ParameterList": [words]})])
    assert rules(derived) == ["A013"] * 3
    assert derived.model.components[0].parameters is not None
    entry = derived.model.components[0].parameters[0]
    assert (entry.interface_type, entry.attribute, entry.range_error_action) == ("Calibration", "NA", None)


def test_a_parameter_has_its_storage_class_datatype_and_values():
    parameters = derive([example("CoreAcc")]).model.components[0].parameters
    assert parameters is not None
    one = parameters[0]
    assert (one.name, one.interface_type, one.variable) == ("ALatMax", "Calibration", "core_params.ALatMax")
    assert (one.datatype.datatype, one.datatype.min, one.datatype.max, one.datatype.unit) == ("float", 0.5, 8, "m/s^2")


def test_the_code_of_a_component_and_its_calls_goes_along():
    component = derive([example("EcoControlMpc")]).model.components[0]
    assert component.code is not None
    assert (component.code.signature, component.header_files) == ("Pointers", ("EcoControlMpc.h",))
    init = component.calls[0].code
    assert init is not None
    assert (init.symbol, init.arguments) == ("EcoControlMpc_initialize", ("EcoControlMpc_M",))


def test_a_call_may_leave_its_scheduling_open():
    derived = derive([function(call={"Scheduling": ""})])
    assert derived.model.components[0].calls[0].scheduling is None
    assert "A011" not in rules(derived)


def test_a_parameter_keeps_its_scale_its_key_and_its_elements():
    scaled = parameter(Factor="0.5", Offset="-1", Key="gain", Storage="Learned", RangeError="Demo_Range_ErrorSts")
    derived = derive([function(contract={"ParameterList": [scaled]})])
    assert derived.model.components[0].parameters is not None
    (entry,) = derived.model.components[0].parameters
    assert (entry.datatype.scaling, entry.datatype.offset) == (0.5, -1)
    assert entry.code is not None
    assert (entry.code.key, entry.code.storage, entry.code.range_error) == ("gain", "Learned", "Demo_Range_ErrorSts")


def test_each_side_of_a_method_keeps_its_code():
    method = {"Name": "Ask", "Description": "Asks.", "Role": "Provider", "InDataTypeList": [], "OutDataTypeList": []}
    user = function("User", contract={"MethodList": [method | {"Role": "Consumer", "RequestVariable": "out.ask"}]})
    model = derive([function(contract={"MethodList": [method | {"Symbol": "Demo_ask"}]}), user]).model
    offered = services(model)["DemoService", "Provider"].services[0].methods[0].uses
    used = services(model)["DemoService", "Consumer"].services[0].methods[0].uses
    assert offered is not None
    assert used is not None
    assert [use.method.symbol for use in offered] == ["Demo_ask"]
    assert [use.method.request_variable for use in used] == ["out.ask"]


def test_who_provides_from_outside_is_the_provider():
    one = function(signals=[at("Vehicle.A.B", ExternalProvider="Gateway")])
    provider = services(derive([one]).model)["VehicleAService", "Consumer"].providers
    assert provider is not None
    assert [item.name for item in provider] == ["Gateway"]


def test_a_queue_is_an_event_that_keeps_its_length():
    queue = {
        "Name": "Q", "Description": "Counts.", "Role": "Provider", "AsilInfo": "QM", "QueueLength": 8,
        "Datatype": "DT_Float32", "Factor": 1, "Offset": 0, "InitValue": 0, "Units": "m",
    }  # fmt: skip
    model = derive([function(contract={"DataQList": [queue]})]).model
    uses = events(model)["DemoService", "Q"].uses
    assert uses is not None
    assert uses[0].queue is not None
    assert uses[0].queue.queue_length == 8


def test_two_components_of_one_function_talk_over_a_service():
    base = function(signals=[at("Vehicle.A.B", "Provider")]).model_dump(mode="json")
    other = function(signals=[at("Vehicle.A.B")]).model_dump(mode="json")["ComponentList"][0]
    base["ComponentList"].append({**other, "Name": "Reader"})
    model = derive([FunctionJson.model_validate(base)]).model
    assert ("DemoService", "Consumer") in services(model, "Reader")
    assert [component.executable for component in model.components] == ["DemoExecutable", "ReaderExecutable"]


def test_a_deployment_with_an_unknown_key_is_refused_with_its_line():
    with pytest.raises(InputRefused) as refused:
        read_deployment(b"name: X\nautosarAdaptive:\n  prot: 3\n", "deployment.yaml")
    assert [(finding.rule, finding.line) for finding in refused.value.findings] == [("F003", 3)]


def test_no_function_is_refused():
    with pytest.raises(UsageError):
        derive([])


def test_ten_times_the_signals_take_about_ten_times_as_long():
    def deriving(count):
        one = function(signals=[at(f"Vehicle.Branch{i % 50}.Signal{i}") for i in range(count)])
        return lambda: derive([one])

    assert growth(deriving, 200) < LINEAR


def test_what_is_wrong_with_a_deployment_is_told_in_the_order_of_its_lines():
    with pytest.raises(InputRefused) as refused:
        read_deployment(b"pakage: X\nautosarAdaptive: {identifiers: {A: 99999999}}\nros2: {topics: x}\n", "d.yaml")
    assert [finding.line for finding in refused.value.findings] == [1, 2, 3]


def failing(name, *dependencies):
    """A function that reports an error, which errors of others set too."""
    error = {
        "Name": f"{name}_Bad_ErrorSts", "Description": "Is bad.", "Datatype": "DT_Bool", "Dependancy": dependencies,
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "Error",
    }  # fmt: skip
    return function(name, contract={"ErrorList": [error]})


def test_a_component_consumes_the_errors_that_set_its_own():
    one, other = failing("Sense"), failing("Act", "Sense_Bad_ErrorSts", "Base_Gone_ErrorSts")
    derived = derive([other, one])
    found = services(derived.model)["SenseService", "Consumer"]
    assert [field.name for field in found.services[0].fields] == ["Sense_Bad_ErrorSts"]
    assert [provider.name for provider in found.providers or ()] == ["Sense"]
    (act,) = [component for component in derived.model.components if component.name == "Act"]
    assert {service.name for service in act.services} == {"SenseService", "ActService"}
    told = [entry for entry in derived.report if entry.interface == "Sense_Bad_ErrorSts"]
    assert {entry.function for entry in told} == {"Sense"}


def test_a_component_consumes_the_errors_that_set_its_safety_reactions():
    reaction = {
        "Name": "Invalid_SftyCondSts", "Description": "Nothing is valid.", "Datatype": "DT_Bool",
        "ErrorList": ["Sense_Bad_ErrorSts"],
    }  # fmt: skip
    derived = derive([failing("Sense"), function("Act", contract={"SafetyReactionList": [reaction]})])
    found = services(derived.model)["SenseService", "Consumer"]
    assert [field.name for field in found.services[0].fields] == ["Sense_Bad_ErrorSts"]


def test_the_deployment_names_who_provides_safety_conditions_and_modes():
    derived = derive([example("CoreAcc")], deployed(safetyManager="SafetyCluster", modeManager="StateManagement"))
    found = services(derived.model)
    named = {service: [each.name for each in interface.providers or ()] for (service, _), interface in found.items()}
    assert named["SafetyManagementService"] == ["SafetyCluster"]
    assert named["ModeManagementService"] == ["StateManagement"]


def test_an_interface_above_qm_has_no_protection():
    assert rules(derive([function(signals=[at("Vehicle.A.B", AsilLevel="C")])])) == ["A019"]
