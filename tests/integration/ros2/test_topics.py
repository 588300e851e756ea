"""Topics and their messages: what travels together, in which fields, converted by whom."""

import pytest

from sigcat.platforms.deployment_file import DEPLOYMENT_FILE
from tests.integration.ros2.derived import messages
from tests.integration.ros2.functions import (
    document,
    example,
    examples,
    function,
    rules,
    settings,
    signal,
    topics,
)


def conversion(end):
    (made,) = end["DataMappingList"][0]["ConversionAPI"] or [None]
    return made


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


def test_a_struct_leaves_its_name_to_the_message_of_a_topic():
    pose = {
        "typeRef": "DT_GuardPose", "category": "userdefined", "cDef": "struct Pose", "Kind": "struct",
        "Fields": [{"Name": "X", "Datatype": "DT_Float32"}],
    }  # fmt: skip
    place = signal("Pose", "Vehicle.GuardPose", Datatype="DT_GuardPose", VssDatatype="Types.GuardPose")
    made = messages([function(place, datatypes=[pose])])
    assert made["GuardPose"]["Fields"][1]["DataType"] == "GuardPoseStruct"
    assert "GuardPose2" not in made


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
    made = messages([function(place, datatypes=[side, lane])])["LaneStruct"]
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
