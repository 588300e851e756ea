"""From functions to packages, messages, topics and nodes of ROS 2."""

import json

import jsonschema
import pytest
from pydantic import BaseModel, ValidationError

from sigcat.errors import UsageError
from sigcat.function.function_json.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.datatype import Datatype
from sigcat.function.function_json.methods import MethodInterface
from sigcat.function.function_json.model import FunctionInfo, Mode
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.report import NOT_CARRIED
from sigcat.integration.ros2.field_targets import TABLES
from sigcat.integration.ros2.model import integration_schema, to_json
from sigcat.integration.ros2.names import CONSTANT, FIELD, MESSAGE
from sigcat.platforms.deployment_file import DEPLOYMENT_FILE
from tests.integration.ros2.functions import (
    derived,
    document,
    example,
    examples,
    function,
    rules,
    settings,
    signal,
    topics,
)
from tests.judges import judged_by


def node(functions, index=0):
    return document(functions)["NodePackageList"][0]["Nodes"][index]


def messages(functions, deployment=None):
    packages = document(functions, deployment)["InterfacePackageList"]
    return {message["Name"]: message for package in packages for message in package["Messages"]}


def conversion(end):
    (made,) = end["DataMappingList"][0]["ConversionAPI"] or [None]
    return made


# -- the document -------------------------------------------------------------------------------------------------


@judged_by("jsonschema", "What is written is valid under our schemas, and they are valid ones")
def test_the_examples_are_derived_valid_under_our_schema():
    jsonschema.Draft202012Validator(integration_schema()).validate(document(examples()))


def test_the_order_of_the_functions_does_not_matter():
    assert to_json(derived(examples()).model) == to_json(derived(examples()[::-1]).model)


def test_a_document_is_read_back_to_the_same_bytes():
    model = derived(examples()).model
    assert to_json(type(model).model_validate(json.loads(to_json(model)))) == to_json(model)


def test_every_name_is_one_of_rosidl():
    made = document(examples())
    packages = [*made["InterfacePackageList"], *made["NodePackageList"]]
    messages = [message for package in made["InterfacePackageList"] for message in package["Messages"]]
    fields = [field for message in messages for field in message["Fields"]]
    constants = [constant for message in messages for constant in message["Constants"]]
    for form, named in ((FIELD, packages), (MESSAGE, messages), (FIELD, fields), (CONSTANT, constants)):
        assert named
        assert [each["Name"] for each in named if not form.fullmatch(each["Name"])] == []


def test_a_set_has_each_function_once_and_one_at_least():
    with pytest.raises(UsageError, match="once, not twice: CoreAcc"):
        derived([example("core_acc"), example("core_acc")])
    with pytest.raises(UsageError, match="There is no function"):
        derived([])


# -- topics and messages ------------------------------------------------------------------------------------------


def test_a_signal_is_a_topic_named_after_its_path():
    end = topics([example("core_acc")])["Subscription", "vehicle/chassis/brake/cyl_p"]
    assert end["MessageType"] == "vehicle_msgs/msg/ChassisBrakeCylP"
    assert end["DataMappingList"][0]["GlobalVariableName"] == ["core_inputs.bus_ACCIn.Bus_Veh.BrkCylP"]


def test_topics_and_messages_of_a_signal_are_the_same_alone_and_in_a_set():
    alone, together = messages([example("core_acc")]), messages(examples())
    assert alone
    assert alone.items() <= together.items()
    names, of_all = (
        {key: end["MessageType"] for key, end in topics(those).items()} for those in ([example("core_acc")], examples())
    )
    assert names
    assert names.items() <= of_all.items()


def test_provider_and_consumer_of_a_set_meet():
    ends = topics(examples())
    name = "vehicle/adas/eco_control/acceleration_proposal"
    assert ends["Publisher", name]["NodeName"] == "eco_control_mpc"
    assert ends["Subscription", name]["NodeName"] == "core_acc"
    assert ends["Subscription", name]["Providers"] == ["EcoControlMpc"]


def test_signals_of_a_branch_can_travel_together():
    ends = topics(examples(), settings(topics="branch"))
    end = ends["Publisher", "core_acc/vehicle/adas/eco_control"]
    assert end["MessageType"] == "vehicle_msgs/msg/ADASEcoControlCoreAcc"
    assert end["DataMappingList"][0]["ROSTopicFieldName"] == ["status", "acceleration_request"]


def test_outputs_of_a_function_can_travel_together():
    ends = topics(examples(), settings(topics="function", namespace="/ego"))
    assert ends["Publisher", "core_acc/out"]["DataMappingList"][0]["ROSTopicFieldName"][0] == "status"
    assert ("Subscription", "eco_control_mpc/out") in ends


def test_a_keyword_is_avoided_and_the_change_is_told():
    switch = function(signal("Sw", "Vehicle.Body.Switch"))
    end = topics([switch])["Subscription", "vehicle/body/switch"]
    assert end["DataMappingList"][0]["ROSTopicFieldName"] == ["switch_value"]
    assert ("N210", "Vehicle.Body.Switch") in rules([switch])


def test_the_numbers_of_the_code_stand_in_the_conversion_and_those_of_the_catalogue_in_the_message():
    end = topics([example("core_acc")])["Subscription", "vehicle/adas/map/dfs/map_data_spd_unit_typ"]
    symbols = [(each["Text"], each["Value"], each["Number"]) for each in conversion(end)["Symbols"]]
    assert symbols == [("KM_PER_HOUR", 0, 0), ("MI_PER_HOUR", 1, 1), ("NOT_IN_MAP", 3, 2)]
    constants = messages([example("core_acc")])["ADASMapDFSMapDataSpdUnitTyp"]["Constants"]
    assert constants[2] == {"Name": "NOT_IN_MAP", "DataType": "uint8", "Value": "2"}


def enumeration(off, on):
    symbols = [{"Symbol": "OFF", "Value": off}, {"Symbol": "ON", "Value": on}]
    return {"typeRef": "DT_State", "category": "userdefined", "cDef": "uint8_t", "Kind": "enumeration", "VssDatatype": "uint8", "Symbols": symbols}  # fmt: skip


def state(vss, role, name, *numbers):
    one = signal("State", "Vehicle.State", role=role, Datatype="DT_State", VssDatatype=vss)
    return function(one, name=name, datatypes=[enumeration(*numbers)])


@pytest.mark.parametrize(
    ("vss", "enumerations", "fields", "constant", "given"),
    [
        ("string", "both", [("state", "string"), ("state_number", "uint8")], ("uint8", "7"), [("ON", 7, 7)]),
        ("string", "number", [("state", "uint8")], ("uint8", "7"), None),
        ("string", "text", [("state", "string")], ("string", "ON"), [("ON", 7, None)]),
        ("uint8", "both", [("state", "uint8")], ("uint8", "7"), None),
    ],
)
def test_a_consumer_with_other_numbers_than_the_provider_converts_them(vss, enumerations, fields, constant, given):
    numbers = settings(enumerations=enumerations)
    both = [state(vss, "Provider", "Give", 6, 7), state(vss, "Consumer", "Take", 1, 0)]
    assert [rule for rule, path in rules(both, numbers) if path == "Vehicle.State"] == []
    made = messages(both, numbers)["State"]
    assert [(field["Name"], field["DataType"]) for field in made["Fields"][1:]] == fields
    assert (made["Constants"][1]["DataType"], made["Constants"][1]["Value"]) == constant
    ends = topics(both, numbers)
    giving = ends["Publisher", "vehicle/state"]["DataMappingList"][0]["ConversionAPI"]
    assert giving is None if given is None else said(giving[0])[1:] == given
    taken = None if enumerations == "text" else 6
    assert said(conversion(ends["Subscription", "vehicle/state"])) == [("OFF", 1, taken), ("ON", 0, taken and 7)]


def said(made):
    return [(each["Text"], each["Value"], each.get("Number")) for each in made["Symbols"]]


def test_an_enumeration_with_other_values_is_another_one():
    other = state("uint8", "Consumer", "Take", 6, 7)
    names = other.model_dump_json().replace('"ON"', '"AUTO"')
    assert ("N214", "Vehicle.State") in rules(
        [state("uint8", "Provider", "Give", 6, 7), type(other).model_validate_json(names)]
    )


def test_a_unit_is_converted_in_the_direction_of_the_call():
    consumed = topics([example("core_acc")])["Subscription", "vehicle/adas/cruise_control/speed_set"]
    assert (conversion(consumed)["Factor"], conversion(consumed)["Offset"]) == ("0.2777777777777778", "0")
    provided = topics([example("wheel_speed_calculation")])["Publisher", "vehicle/chassis/axle/row1/wheel/left/speed"]
    assert (conversion(provided)["Factor"], conversion(provided)["Offset"]) == ("0.01", "-100")


def test_the_same_datatype_and_unit_need_no_conversion():
    end = topics([example("core_acc")])["Subscription", "vehicle/chassis/brake/cyl_p"]
    assert end["DataMappingList"][0]["ConversionAPI"] is None


def test_a_larger_datatype_is_rounded_and_bounded():
    byte = {"typeRef": "DT_UInt8", "category": "primitive", "cDef": "uint8_t"}
    end = topics([function(signal(Datatype="DT_UInt8"), datatypes=[byte])])["Subscription", "vehicle/speed"]
    assert conversion(end)["Kind"] == "Cast"
    assert (conversion(end)["Rounding"], conversion(end)["Saturates"]) == ("Nearest", True)


def test_arrays_keep_their_length():
    end = topics([example("eco_control_mpc")])["Subscription", "vehicle/adas/map/horizon/altitude"]
    assert end["DataMappingList"][0]["ROSTopicFieldDataType"] == ["float32[50]"]


def test_structs_become_messages_and_one_that_contains_itself_is_refused():
    point = {
        "typeRef": "DT_Point", "category": "userdefined", "cDef": "struct Point", "Kind": "struct",
        "Fields": [{"Name": "X", "Datatype": "DT_Float32"}],
    }  # fmt: skip
    place = signal("Place", "Vehicle.Place", Datatype="DT_Point", VssDatatype="Types.Point")
    made = messages([function(place, datatypes=[point])])
    assert made["Point"]["Fields"][0]["DataType"] == "float32"
    assert made["Place"]["Fields"][1]["DataType"] == "Point"
    endless = point | {"Fields": [{"Name": "Next", "Datatype": "DT_Point"}]}
    assert ("N200", "Vehicle.Place") in rules([function(place, datatypes=[endless])])


def test_an_enumeration_in_a_struct_has_constants():
    side = {
        "typeRef": "DT_Side", "category": "userdefined", "cDef": "uint8_t", "Kind": "enumeration",
        "Symbols": [{"Symbol": "LEFT", "Value": 0}, {"Symbol": "RIGHT", "Value": 2}],
    }  # fmt: skip
    lane = {
        "typeRef": "DT_Lane", "category": "userdefined", "cDef": "struct Lane", "Kind": "struct",
        "Fields": [{"Name": "Side", "Datatype": "DT_Side"}, {"Name": "Others", "Datatype": "DT_Side"}],
    }  # fmt: skip
    place = signal("Lane", "Vehicle.Lane", Datatype="DT_Lane", VssDatatype="Types.Lane")
    made = messages([function(place, datatypes=[side, lane])])["Lane"]
    assert [(each["Name"], each["DataType"], each["Value"]) for each in made["Constants"]] == [
        ("SIDE_LEFT", "uint8", "0"), ("SIDE_RIGHT", "uint8", "2"),
        ("OTHERS_LEFT", "uint8", "0"), ("OTHERS_RIGHT", "uint8", "2"),
    ]  # fmt: skip


def test_a_message_of_a_struct_has_the_words_of_the_catalogue():
    point = {
        "typeRef": "DT_Point", "category": "userdefined", "cDef": "struct Point", "Kind": "struct",
        "Description": "A place.", "Fields": [{"Name": "X", "Datatype": "DT_Float32", "Description": "Ahead."}],
    }  # fmt: skip
    place = signal("Place", "Vehicle.Place", Datatype="DT_Point", VssDatatype="Types.Point")
    made = messages([function(place, datatypes=[point])])["Point"]
    assert (made["Description"], made["Fields"][0]["Description"]) == ("A place.", "Ahead.")


def test_methods_become_services_that_provider_and_user_share():
    argument = {"Name": "Speed", "Datatype": "DT_Float32", "Units": "m/s"}
    method = {"Name": "SetLimit", "Description": "Sets it.", "InDataTypeList": [argument], "OutDataTypeList": []}
    both = [
        function(name=name, contract={"MethodList": [method | {"Role": role}]})
        for name, role in (("Acc", "Provider"), ("Hmi", "Consumer"))
    ]
    calls = document(both)["CommunicationList"]
    services = [(s["ServiceName"], s["Role"], s["ServiceType"]) for call in calls for s in call["ROSServiceList"]]
    assert services == [
        ("set_limit", "Server", "vehicle_msgs/srv/SetLimit"),
        ("set_limit", "Client", "vehicle_msgs/srv/SetLimit"),
    ]


@pytest.mark.parametrize(
    ("change", "differs"), [({}, False), ({"Units": "km/h"}, True), ({"Datatype": "DT_Bool"}, True)]
)
def test_provider_and_user_of_a_method_mean_the_same(change, differs):
    argument = {"Name": "Speed", "Datatype": "DT_Float32", "Units": "m/s"}
    both = []
    for name, role, given in (("Acc", "Provider", argument), ("Hmi", "Consumer", argument | change)):
        method = {
            "Name": "SetLimit",
            "Description": "Sets it.",
            "InDataTypeList": [given],
            "OutDataTypeList": [],
            "Role": role,
        }
        both.append(function(name=name, contract={"MethodList": [method]}))
    assert (("N214", "SetLimit") in rules(both)) is differs


def test_a_path_can_be_told_by_the_deployment():
    bare = function(signal("Speed", ""))
    assert ("N211", "Acc.Speed") in rules([bare])
    deployment = DEPLOYMENT_FILE.model_validate({"paths": {"Acc.Speed": "Vehicle.Speed"}})
    assert ("Subscription", "vehicle/speed") in topics([bare], deployment)


# -- quality of service -------------------------------------------------------------------------------------------


def quality(*functions, role="Subscription", deployment=None):
    return topics(functions, deployment)[role, "vehicle/speed"]["QualityOfService"]


def test_qm_values_that_come_again_are_best_effort():
    made = quality(function(signal(role="Provider")), function(signal(), name="Hmi"))
    assert (made["Reliability"], made["Durability"], made["Depth"]) == ("best_effort", "volatile", 1)


@pytest.mark.parametrize("asil", ["A", "B", "C", "D"])
def test_values_with_an_asil_are_reliable(asil):
    made = quality(function(signal(role="Provider")), function(signal(AsilLevel=asil), name="Hmi"))
    assert made["Reliability"] == "reliable"
    assert made["Liveliness"] == ("manual_by_topic" if asil in "CD" else "automatic")


def test_the_strictest_of_a_set_counts_on_both_ends():
    both = (function(signal(role="Provider")), function(signal(AsilLevel="D", Timeout="300"), name="Hmi"))
    assert quality(*both, role="Publisher")["Reliability"] == "reliable"
    assert quality(*both, role="Publisher")["Liveliness"] == "manual_by_topic"


@pytest.mark.parametrize(("length", "depth"), [(8, 100), (10, 100), (11, 110)])
def test_a_queue_is_reliable_and_loses_values_before_the_middleware_does(length, depth):
    queue = signal() | {"AsilInfo": "QM", "QueueLength": length, "Factor": 1, "Offset": 0, "InitValue": 0, "Units": ""}
    consumer = function(name="Hmi", contract={"DataQList": [queue]})
    both = (function(signal(role="Provider")), consumer)
    assert [quality(*both, role=role)["Depth"] for role in ("Publisher", "Subscription")] == [depth, depth]
    assert quality(*both)["Reliability"] == "reliable"


@pytest.mark.parametrize("publisher", [(), (function(signal(role="Provider"), call={"Runtype": "EventTriggered"}),)])
def test_a_deadline_is_requested_only_from_a_publisher_of_the_set_that_offers_one(publisher):
    made = topics([*publisher, function(signal(Timeout="200", AsilLevel="D"), name="Hmi")])
    end = made["Subscription", "vehicle/speed"]
    assert "Deadline" not in end["QualityOfService"]
    assert "LeaseDuration" not in end["QualityOfService"]
    assert end["DataMappingList"][0]["FieldList"][0]["Timeout"] == 200


def test_of_a_publisher_outside_of_the_set_nothing_is_requested_that_it_may_not_offer():
    made = quality(function(signal(Timeout="200", AsilLevel="D")))
    assert (made["Reliability"], made["Liveliness"]) == ("best_effort", "automatic")


def test_a_time_out_is_the_deadline_and_a_publisher_offers_twice_its_cycle_or_less():
    provider, consumer = function(signal(role="Provider")), function(signal(Timeout="200"), name="Hmi")
    assert quality(provider, consumer)["Deadline"] == 200
    assert quality(provider, consumer, role="Publisher")["Deadline"] == 100
    hasty = function(signal(Timeout="60"), name="Hmi")
    assert quality(provider, hasty, role="Publisher")["Deadline"] == 60
    assert ("N213", "Vehicle.Speed") in rules([provider, hasty])


def test_a_queue_of_which_nothing_may_be_sent_promises_no_deadline():
    queue = signal(role="Provider") | {
        "AsilInfo": "QM",
        "QueueLength": 8,
        "Factor": 1,
        "Offset": 0,
        "InitValue": 0,
        "Units": "",
    }
    for count, promised in (({}, 100), ({"CountVariable": "n"}, None)):
        provider = function(contract={"DataQList": [queue | count]})
        assert quality(provider, role="Publisher").get("Deadline") == promised


def test_attributes_are_kept_for_who_starts_late():
    assert quality(function(signal(Type="attribute")))["Durability"] == "transient_local"


def test_the_deployment_has_the_last_word():
    deployment = settings(quality={"Vehicle.Speed": {"depth": 5, "reliability": "reliable"}})
    made = quality(function(signal()), deployment=deployment)
    assert (made["Depth"], made["Reliability"]) == (5, "reliable")


def test_a_policy_is_that_of_the_deployment_where_a_call_has_a_priority():
    deployment, calls = settings(schedulingPolicy="rr"), ({"Priority": "10"}, {"Priority": ""})
    for call, policy, told in zip(calls, ("rr", None), (set(), {("N221", "Acc_Step")}), strict=True):
        functions = [function(signal(), call=call)]
        (made,) = document(functions, deployment)["NodePackageList"][0]["Nodes"]
        assert made.get("SchedulingPolicy") == policy
        assert {each for each in rules(functions, deployment) if each[0] == "N221"} == told


def test_a_policy_is_one_of_ros():
    with pytest.raises(ValueError, match="schedulingPolicy"):
        settings(schedulingPolicy="fifoo")


def test_a_quality_of_nothing_is_told_with_what_was_meant():
    deployment = settings(quality={"Vehicle.Sped": {"depth": 5}, "/vehicle/speed": {"depth": 5}})
    found = [finding for finding in derived([function(signal())], deployment).findings if finding.rule == "N220"]
    assert [(finding.severity, "Vehicle.Speed" in finding.fix) for finding in found] == [("warning", True)]


@pytest.mark.parametrize(
    ("name", "package"),
    [
        ("Rclcpp", "rclcpp_2"),
        ("Std", "std_2"),
        ("Launch", "launch_2"),
        ("Composition", "composition_2"),
        ("9lives", "function_9_lives"),
    ],
)
def test_a_package_does_not_hide_one_of_ros(name, package):
    made = derived([function(signal(), name=name)], DEPLOYMENT_FILE.model_validate({})).model
    assert made.node_packages[0].name == package
    assert made.interface_packages[0].name == f"{package}_interfaces"


@pytest.mark.parametrize("package", ["std_msgs", "builtin_interfaces"])
def test_messages_do_not_go_into_a_package_of_ros(package):
    with pytest.raises(ValidationError):
        settings(messagePackage=package)


@pytest.mark.parametrize("topics_by", ["signal", "branch", "function"])
def test_every_publisher_of_the_examples_offers_what_its_subscribers_ask_for(topics_by):
    ends = topics(examples(), settings(topics=topics_by))
    meetings = [
        (asked["QualityOfService"], ends["Publisher", name]["QualityOfService"])
        for (role, name), asked in ends.items()
        if role != "Publisher" and ("Publisher", name) in ends
    ]
    assert meetings
    for mine, other in meetings:
        assert mine["Reliability"] == "best_effort" or other["Reliability"] == "reliable"
        assert mine["Durability"] == "volatile" or other["Durability"] == "transient_local"
        assert mine.get("Deadline") is None or other.get("Deadline", 1e9) <= mine["Deadline"]


# -- nodes --------------------------------------------------------------------------------------------------------


def test_transitions_make_the_calls_of_the_life_cycle():
    made = {each["Transition"]: each for each in node([example("core_acc")])["Lifecycle"]}
    assert made["configure"]["Runnables"] == ["CoreAcc_Init"]
    assert made["activate"]["Starts"] == made["deactivate"]["Stops"] == ["CoreAcc_Step"]
    for name in ("cleanup", "shutdown", "error"):
        assert made[name]["Runnables"] == ["CoreAcc_Terminate"]


def test_a_cyclic_call_has_a_timer_and_runs_in_its_modes():
    (step,) = node([example("core_acc")])["Schedules"]
    assert (step["Trigger"], step["Period"], step["ThreadPriority"]) == ("Timer", 50, 10)
    assert step["ActiveModes"] == ["STANDBY", "ACTIVE"]


def test_an_event_triggered_call_runs_on_what_it_consumes():
    call = {"Runtype": "EventTriggered", "Cycletime": None, "DebounceDelay": "5"}
    (step,) = node([function(signal(), call=call)])["Schedules"]
    assert (step["Trigger"], step["Topics"], step["Debounce"]) == ("Topics", ["vehicle/speed"], 5)
    assert ("N215", "Acc_Step") in rules([function(call=call)])
    other = signal("Mass", "Vehicle.Mass")
    for event in ("Speed", "Vehicle.Speed"):
        (step,) = node([function(signal(), other, call=call | {"EventList": event})])["Schedules"]
        assert step["Topics"] == ["vehicle/speed"]


def test_queued_data_keeps_what_signals_have():
    queue = signal() | {"AsilInfo": "QM", "QueueLength": 8, "Factor": 1, "Offset": 0, "InitValue": 0, "Units": ""}
    queue |= {"Default": 5, "Access": "Buffered"}
    end = topics([function(contract={"DataQList": [queue]})])["Subscription", "vehicle/speed"]
    field = end["DataMappingList"][0]["FieldList"][0]
    assert (field["Default"], field["Access"]) == (5, "Buffered")


def test_modes_have_topics_with_a_constant_for_each_mode():
    topic = node([example("core_acc")])["ModeTopics"][0]
    assert (topic["TopicName"], topic["Role"]) == ("core_acc/mode_in", "Subscription")
    constants = messages([example("core_acc")])["CoreAccModeIn"]["Constants"]
    assert [(each["Name"], each["Value"]) for each in constants] == [("OFF", "0"), ("STANDBY", "1"), ("ACTIVE", "2")]


def test_every_node_of_a_function_is_told_its_mode_and_the_first_one_tells_it():
    core = example("core_acc")
    second = core.components[0].model_copy(update={"name": "Arbiter", "runnables": ()})
    both = core.model_copy(update={"components": (*core.components, second)})
    nodes = document([both])["NodePackageList"][0]["Nodes"]
    assert [[topic["TopicName"] for topic in each["ModeTopics"]] for each in nodes] == [
        ["core_acc/mode_in", "core_acc/mode_out"],
        ["core_acc/mode_in"],
    ]
    assert len([name for name in messages([both]) if "Mode" in name]) == 2


def test_parameters_have_the_catalogues_unit_and_range():
    made = {each["Name"]: each for each in node([example("wheel_speed_calculation")])["Parameters"]}
    tire = made["tire_dia_frnt"]
    assert (tire["Units"], tire["VariableUnits"]) == ("inch", "mm")
    assert tire["Default"] == pytest.approx(650 / 25.4)
    assert tire["Conversion"]["Factor"] == "25.4"


def parameter(**more):
    base = {
        "Name": "Limit", "Description": "A limit.", "Datatype": "DT_Float32", "Asillevel": "QM", "Min": 0, "Max": 9,
        "Default": 1, "InitValue": 2, "RangeErrorAction": "Default", "Interfacetype": "Calibration",
        "Attribute": "Normal", "Units": "m", "Variable": "par.Limit",
    }  # fmt: skip
    return base | more


@pytest.mark.parametrize(
    ("more", "kind", "default", "bounds"),
    [
        ({}, "double", 2.0, (0, 9)),
        ({"VssDatatype": "uint16", "Max": 65535}, "integer", 2, (0, 65535)),
        ({"VssDatatype": "int64", "Min": -(2**63), "Max": 2**63 - 1}, "integer", 2, (None, None)),
        ({"VssDatatype": "boolean", "Max": 1}, "bool", True, (None, None)),
        ({"VssDatatype": "string", "DefaultText": "left", "Max": 0}, "string", "left", (None, None)),
        ({"Datatype": "DT_Float32Array3", "VssDatatype": "float[]"}, "double_array", [2.0, 2.0, 2.0], (None, None)),
        ({"Datatype": "DT_Side", "VssDatatype": "string"}, "string", "RIGHT", (None, None)),
    ],
)
def test_a_parameter_has_a_type_of_nodes(more, kind, default, bounds):
    types = [
        {"typeRef": "DT_Float32Array3", "category": "userdefined", "cDef": "float[3]", "Kind": "array",
         "ElementType": "DT_Float32", "Length": 3},
        {"typeRef": "DT_Side", "category": "userdefined", "cDef": "uint8_t", "Kind": "enumeration",
         "Symbols": [{"Symbol": "LEFT", "Value": 0}, {"Symbol": "RIGHT", "Value": 2}]},
    ]  # fmt: skip
    (made,) = node([function(contract={"ParameterList": [parameter(**more)]}, datatypes=types)])["Parameters"]
    assert (made["Type"], made["Default"], (made.get("From"), made.get("To"))) == (kind, default, bounds)


def test_elements_of_an_array_have_a_range_in_words():
    pair = {"typeRef": "DT_Pair", "category": "userdefined", "cDef": "float[2]", "Kind": "array",
            "ElementType": "DT_Float32", "Length": 2}  # fmt: skip
    listed = parameter(Datatype="DT_Pair", VssDatatype="float[]", Min=-0.5)
    (made,) = node([function(contract={"ParameterList": [listed]}, datatypes=[pair])])["Parameters"]
    assert made["AdditionalConstraints"] == "each element from -0.5 to 9"


@pytest.mark.parametrize(
    ("rule", "more"),
    [
        ("N209", {"Interfacetype": "Measurement"}),
        ("N209", {"VssDatatype": "uint64", "Max": 2**64 - 1}),
        ("N209", {"Datatype": "DT_Point", "VssDatatype": "Types.Point"}),
    ],
)
def test_a_parameter_that_nodes_do_not_have_is_told(rule, more):
    point = {"typeRef": "DT_Point", "category": "userdefined", "cDef": "struct Point", "Kind": "struct", "Fields": []}
    made = function(contract={"ParameterList": [parameter(VssPath="Vehicle.Limit", **more)]}, datatypes=[point])
    assert (rule, "Vehicle.Limit") in rules([made])


def test_a_parameter_that_is_scaled_in_the_code_is_converted_from_there():
    scaled = parameter(Datatype="DT_UInt16", VssDatatype="float", Factor="0.5", Offset="-1", ConversionFactor="2")
    word = {"typeRef": "DT_UInt16", "category": "primitive", "cDef": "uint16_t"}
    (made,) = node([function(contract={"ParameterList": [scaled]}, datatypes=[word])])["Parameters"]
    assert (made["Default"], made["From"], made["To"]) == (4.0, 0, 18)
    assert (made["Conversion"]["Factor"], made["Conversion"]["Offset"]) == ("1", "2")


def test_a_parameter_starts_with_the_elements_that_its_author_gave():
    listed = parameter(Datatype="DT_Pair", VssDatatype="float[]", DefaultText="[1, 2]", InitElements="[3, 4.5]")
    pair = {"typeRef": "DT_Pair", "category": "userdefined", "cDef": "float[2]", "Kind": "array",
            "ElementType": "DT_Float32", "Length": 2}  # fmt: skip
    (made,) = node([function(contract={"ParameterList": [listed]}, datatypes=[pair])])["Parameters"]
    assert made["Default"] == [3.0, 4.5]


def test_a_parameter_does_not_take_the_name_of_one_that_every_node_has():
    made = function(contract={"ParameterList": [parameter(Name="LockStep", VssPath="Vehicle.LockStep")]})
    assert [each["Name"] for each in node([made])["Parameters"]] == ["lock_step_2"]
    assert ("N210", "Vehicle.LockStep") in rules([made])


def test_an_error_does_not_take_the_topic_of_transitions():
    error = {
        "Name": "Acc_TransitionEvent_ErrorSts", "Description": "It is.", "Datatype": "DT_Float32", "Dependancy": [],
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "None.", "ResetCondition": "",
    }  # fmt: skip
    made = node([function(contract={"ErrorList": [error]})])
    assert made["ErrorTopics"][0]["TopicName"] == "acc/transition_event_2"


def test_what_a_graph_and_a_signal_say_is_not_in_words():
    error = {
        "Name": "Acc_Order_ErrorSts", "Description": "The order is broken.", "Datatype": "DT_Float32", "Dependancy": [],
        "OccurenceCountLimit": 0, "IgnitionCountLimit": 0, "MaturationTime": 0, "Severity": "None.",
        "ResetCondition": "A restart.",
    }  # fmt: skip
    watchdog = {"AliveSupervision": None, "DeadlineSupervision": None, "LogicalSupervision": "After init."}
    told, graph = {"Watchdog": watchdog}, {"Checkpoint": {"BeginsSequence": True}}
    in_words = function(call=told, contract={"ErrorList": [error]})
    assert {("N205", "Acc_Step"), ("N206", "Acc_Order_ErrorSts")} <= set(rules([in_words]))
    drawn = function(call=told | graph, contract={"ErrorList": [error | {"Reset": "Restart"}]})
    assert not {"N205", "N206"} & {rule for rule, _ in rules([drawn])}
    (step,) = document([drawn])["ComponentList"][0]["functionList"]
    assert (step["Checkpoint"], step["funcContractList"][0]["ErrorList"][0]["Reset"]) == (
        {"BeginsSequence": True},
        "Restart",
    )


def test_a_document_has_each_function_whole_as_it_was_given():
    given = [example("core_acc"), example("eco_control_mpc")]
    made = document(given)["SourceFunctionList"]
    assert made == [json.loads(each.model_dump_json(by_alias=True)) for each in given]


def test_a_set_is_two_packages_named_after_it_one_of_nodes_and_one_of_messages():
    made = document(examples(), DEPLOYMENT_FILE.model_validate({"name": "EcoControl"}))
    (interfaces,), (package,) = made["InterfacePackageList"], made["NodePackageList"]
    assert (package["Name"], interfaces["Name"]) == ("eco_control", "eco_control_interfaces")
    assert [(each["NodeName"], each["Executable"], each["Plugin"]) for each in package["Nodes"]] == [
        ("core_acc", "core_acc_node", "eco_control::CoreAccNode"),
        ("eco_control_mpc", "eco_control_mpc_node", "eco_control::EcoControlMpcNode"),
        ("wheel_speed_calculation", "wheel_speed_calculation_node", "eco_control::WheelSpeedCalculationNode"),
    ]
    assert "eco_control_interfaces" in package["Dependencies"]


def test_a_package_of_messages_with_the_name_of_the_set_keeps_it():
    made = document(examples(), DEPLOYMENT_FILE.model_validate({"name": "Acc", "ros2": {"messagePackage": "acc"}}))
    assert [made[key][0]["Name"] for key in ("InterfacePackageList", "NodePackageList")] == ["acc", "acc_2"]


def test_a_call_follows_those_of_its_node_that_it_names_but_for_init():
    last = function(call={"PrevRunnable": "Acc_Init, Acc_Read, Acc_Filter, Hmi_Step"})
    (step,) = last.components[0].runnables
    first = [
        step.model_copy(update={"name": name, "run_type": kind, "previous_runnable": None})
        for name, kind in (("Acc_Init", "Init"), ("Acc_Read", "Cyclic"), ("Acc_Filter", "Cyclic"))
    ]
    component = last.components[0].model_copy(update={"runnables": (*first, step)})
    made = last.model_copy(update={"components": (component,)})
    after = {each["RunnableName"]: each.get("After") for each in node([made])["Schedules"]}
    assert after == {"Acc_Read": None, "Acc_Filter": None, "Acc_Step": "Acc_Read, Acc_Filter"}
    assert {("N204", "Acc_Step")} == {found for found in rules([made]) if found[0] == "N204"}


def test_errors_are_diagnostics_and_depend_on_those_of_other_nodes():
    statuses = {each["Error"]: each for each in node(examples())["Diagnostics"]}
    assert statuses["CoreAcc_ProposalTimeout_ErrorSts"]["Dependencies"] == [
        "eco_control_mpc: EcoControlMpc_NoSolutionError_ErrorSts",
        "eco_control_mpc: EcoControlMpc_DeadlineError_ErrorSts",
    ]
    assert ("N216", "CoreAcc_ProposalTimeout_ErrorSts") in rules([example("core_acc")])


def ends(made, key):
    return [(each["Role"], each["TopicName"], each.get("Provider")) for each in made[key]]


def test_errors_have_topics_on_which_other_nodes_hear_them():
    assert ends(node(examples()), "ErrorTopics") == [
        ("Publisher", "core_acc/brake_pressure_timeout", None),
        ("Publisher", "core_acc/steering_angle_timeout", None),
        ("Publisher", "core_acc/proposal_timeout", None),
        ("Publisher", "core_acc/alive_error", None),
        ("Subscription", "eco_control_mpc/no_solution_error", "eco_control_mpc"),
        ("Subscription", "eco_control_mpc/deadline_error", "eco_control_mpc"),
    ]
    published = [(role, topic) for role, topic, _ in ends(node(examples(), 1), "ErrorTopics")]
    assert {("Publisher", "eco_control_mpc/no_solution_error"), ("Publisher", "eco_control_mpc/deadline_error")} <= {
        *published
    }


def test_an_error_from_outside_is_heard_where_its_own_set_tells_it():
    alone, together = (ends(node(those), "ErrorTopics")[-1][:2] for those in ([example("core_acc")], examples()))
    assert alone == together


def test_what_is_told_of_errors_and_reactions_is_reliable_and_kept_for_who_starts_late():
    made = node(examples())
    told = [(each["QualityOfService"], each["MessageType"], each["Field"])
            for each in (*made["ErrorTopics"], *made["SafetyReactionTopics"])]  # fmt: skip
    assert {(quality["Reliability"], quality["Durability"], quality["Depth"]) for quality, _, _ in told} == {
        ("reliable", "transient_local", 1)
    }
    assert {(message, field) for _, message, field in told} == {
        ("vehicle_msgs/msg/ErrorStatus", "status"), ("vehicle_msgs/msg/SafetyReaction", "state"),
    }  # fmt: skip


def test_a_safety_condition_is_told_on_a_topic_of_the_node_and_heard_from_the_platform():
    made = node([example("core_acc")])
    (condition,) = made["SafetyReactions"]
    assert condition["Statuses"][0] == "core_acc: CoreAcc_BrakePressureTimeout_ErrorSts"
    assert condition["TopicName"] == "core_acc/acc_req_invalid"
    assert ends(made, "SafetyReactionTopics") == [
        ("Publisher", "core_acc/acc_req_invalid", None), ("Subscription", "safety_management/acc_req_invalid", None),
    ]  # fmt: skip


def test_an_error_and_a_reaction_of_one_name_have_two_topics():
    base = {"Description": "It is.", "Datatype": "DT_Float32"}
    error = base | {
        "Name": "Acc_Fault_ErrorSts", "Dependancy": [], "OccurenceCountLimit": 0, "IgnitionCountLimit": 0,
        "MaturationTime": 0, "Severity": "None.", "ResetCondition": "",
    }  # fmt: skip
    reaction = base | {"Name": "Fault_SftyCondSts", "ErrorList": ["Acc_Fault_ErrorSts"], "AsilLevel": "QM"}
    both = function(contract={"ErrorList": [error], "SafetyReactionList": [reaction]})
    made = node([both])
    assert ends(made, "ErrorTopics")[0][1] == "acc/fault"
    assert ends(made, "SafetyReactionTopics")[0][1] == "acc/fault_2"
    assert ("N210", "Fault_SftyCondSts") in rules([both])


def test_every_set_has_the_same_messages_for_errors_reactions_and_steps():
    package = document([function(signal("Status", "Vehicle.Error.Status"))])["InterfacePackageList"][0]
    made = {each["Name"]: each for each in package["Messages"]}
    numbers = {name: [(each["Name"], each["Value"]) for each in made[name]["Constants"]]
               for name in ("ErrorStatus", "SafetyReaction")}  # fmt: skip
    assert numbers == {
        "ErrorStatus": [("PASSED", "0"), ("FAILED", "1")],
        "SafetyReaction": [("INACTIVE", "0"), ("ACTIVE", "1")],
    }
    assert [each["Name"] for each in package["Services"]] == ["Step"]
    assert "ErrorStatus2" in made


# -- what ROS 2 cannot express, and where everything went ---------------------------------------------------------


@pytest.mark.parametrize(
    ("rule", "path", "made"),
    [
        ("N201", "Vehicle.Speed", function(signal(AsilLevel="B"))),
        ("N202", "Acc_Step", function(call={"StackSize": "2048"})),
        ("N203", "Acc_Step", function(call={"Priority": "higher than others"})),
        ("N204", "Acc_Step", function(call={"PrevRunnable": "Hmi_Step"})),
        ("N212", "Vehicle.Speed", function(signal(Variable=None))),
        ("N217", "Vehicle.Speed", function(signal(Factor="1e999999999"))),
        ("N217", "Vehicle.Speed", function(signal(Factor="0"))),
        ("N217", "Vehicle.Speed", function(signal(Offset="ten"))),
    ],
)
def test_what_cannot_be_expressed_is_a_finding_that_names_the_interface(rule, path, made):
    assert (rule, path) in rules([made])


def test_functions_that_disagree_about_a_signal_are_told():
    other = function(signal(VssDatatype="double"), name="Hmi")
    assert ("N214", "Vehicle.Speed") in rules([function(signal(role="Provider")), other])
    assert ("N218", "Vehicle.Speed") in rules(
        [function(signal(role="Provider")), function(signal(role="Provider"), name="Hmi")]
    )


def test_datatypes_of_one_name_and_two_meanings_stay_apart():
    wide = {"typeRef": "DT_Number", "category": "primitive", "cDef": "double"}
    one = function(signal(Datatype="DT_Number"), datatypes=[wide])
    two = function(signal(Datatype="DT_Number"), name="Hmi", datatypes=[wide | {"cDef": "float"}])
    made = document([one, two])
    assert {"DT_Number", "DT_NumberV2"} <= {each["typeRef"] for each in made["Datatypes"]}
    kinds = [
        t["DataMappingList"][0]["GlobalVariableDataType"] for c in made["CommunicationList"] for t in c["ROSTopicList"]
    ]
    assert kinds == [["double"], ["float"]]


MODELS: dict[str, type[BaseModel]] = {
    "signal": Signal, "queue": DataQueue, "parameter": ParameterInterface,
    "method": MethodInterface, "error": ErrorInterface, "safety reaction": SafetyReaction,
    "call": Runnable, "transition": Runnable, "mode": Mode,
    "mode interface": ModeInterface, "datatype": Datatype,
    "function": FunctionInfo,
}  # fmt: skip


@pytest.mark.parametrize("kind", MODELS)
def test_the_report_knows_every_field_of_every_interface(kind):
    fields = {field.alias for field in MODELS[kind].model_fields.values()}
    assert fields <= set(TABLES[kind])


def test_the_report_tells_where_each_field_went():
    entries = {(entry.interface, entry.field): entry for entry in derived(examples()).report}
    brake = entries["Vehicle.Chassis.Brake.CylP", "Variable"]
    assert brake.target == "topic vehicle/chassis/brake/cyl_p, field cyl_p: Variable"
    assert entries["CoreAcc_Step", "StackSize"].target == NOT_CARRIED
    assert not any("{" in entry.target for entry in entries.values())


def test_what_is_not_carried_has_a_reason():
    not_carried = [entry for entry in derived(examples()).report if entry.target == NOT_CARRIED]
    assert not_carried
    assert all(entry.note for entry in not_carried)


def test_the_deployment_names_who_provides_safety_conditions_and_modes():
    deployment = DEPLOYMENT_FILE.model_validate({"safetyManager": "SafetyCluster", "modeManager": "StateManager"})
    made = document([example("core_acc")], deployment)["NodePackageList"][0]["Nodes"][0]
    assert {each["Provider"] for each in made["SafetyReactions"]} == {"SafetyCluster"}
    assert ends(made, "SafetyReactionTopics")[1][2] == "SafetyCluster"
    assert {each.get("Provider") for each in made["ModeTopics"]} == {"StateManager", None}


def test_what_a_function_provides_in_one_cycle_travels_together_by_default():
    out = [signal(name, f"Vehicle.{name}", role="Provider") for name in ("Speed", "Mass")]
    give = function(*out, name="Give")
    take = function(signal(), signal("Outside", "Vehicle.Outside"), name="Take")
    ends = topics([give, take], DEPLOYMENT_FILE.model_validate({}))
    assert set(ends) == {
        ("Publisher", "give/cycle50_ms"), ("Subscription", "give/cycle50_ms"), ("Subscription", "vehicle/outside"),
    }  # fmt: skip
    written, read = (ends[role, "give/cycle50_ms"]["DataMappingList"][0] for role in ("Publisher", "Subscription"))
    assert (written["ROSTopicFieldName"], read["ROSTopicFieldName"]) == (["speed", "mass"], ["speed"])


def test_a_queue_and_what_comes_without_a_cycle_have_topics_of_their_own():
    queue = signal("Mass", "Vehicle.Mass") | {"AsilInfo": "QM", "QueueLength": 8, "Factor": 1, "Offset": 0, "InitValue": 0, "Units": ""}  # fmt: skip
    out = [signal(name, f"Vehicle.{name}", role="Provider") for name in ("Speed", "Mass")]
    events = {"Runtype": "EventTriggered", "Cycletime": None}
    late = function(signal("Late", "Vehicle.Late", role="Provider"), name="Late", call=events)
    take = function(name="Take", contract={"DataQList": [queue]})
    names = {name for _, name in topics([function(*out, name="Give"), late, take], DEPLOYMENT_FILE.model_validate({}))}
    assert names == {"give/cycle50_ms", "vehicle/mass", "vehicle/late"}


def test_names_are_relative_and_the_namespace_is_that_of_the_nodes():
    made = document([example("core_acc")], settings(namespace="/ego"))
    (package,) = made["NodePackageList"]
    assert package["Nodes"][0]["Namespace"] == "/ego"
    named = [topic["TopicName"] for call in made["CommunicationList"] for topic in call["ROSTopicList"]]
    named += [topic["TopicName"] for topic in package["Nodes"][0]["ModeTopics"]]
    assert [name for name in named if name.startswith("/")] == []


@pytest.mark.parametrize("topic", ["vehicle/speed", "/vehicle/speed", "/ego/vehicle/speed", "Vehicle.Speed"])
def test_quality_is_set_by_path_or_by_the_name_of_a_topic_in_any_form(topic):
    deployment = settings(namespace="/ego", quality={topic: {"depth": 5}})
    assert quality(function(signal()), deployment=deployment)["Depth"] == 5
