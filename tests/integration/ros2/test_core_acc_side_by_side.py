"""The published CoreAcc: what its authors wrote by hand for ROS 2, and what is derived from their Function JSON.

Every place in which the two differ is listed with its reason; one that is not, or that is gone, fails the test.
"""

import json

import jsonschema
import pytest

from sigcat.function.function_file import check_function_json
from sigcat.integration.ros2.names import FIELD
from tests.integration.ros2.functions import document, example, settings
from tests.needs import published, published_files
from tests.published.schemas import schema
from tests.reference_tools import checked_with

_META = "who made the document, and when: their two files differ, ours takes it from the Function JSON"
_SIGNAL = "their integration file has lost what their Function JSON says of the signal; ours keeps it"
_TOPIC = "theirs follow the structures of the C code, which are not published; ours are in or out of the function"
_FIELD = "rosidl refuses capitals in the names of fields"
_TYPE = "messages have float32, float64 and bool, not float and boolean; the code has double, as its C definition says"
_VARIABLE = "their Function JSON names no variables; function.yaml and ours do, and here the signal's name replaces it"
_OWN = "what the published schema lacks: optional there"

EXPLAINED = {
    "/MetaInfo/Date": _META,
    "/MetaInfo/SchemaDescription": _META,
    "/FunctionInfo/FunctionName": _META,
    "/FunctionInfo/FunctionResponsible": _META,
    "/FunctionInfo/Description": _META,
    "/ComponentList/*/functionList/*/ParallelProcessing": _SIGNAL,
    "/ComponentList/*/functionList/*/funcContractList/*/SignalList/*/AsilLevel": _SIGNAL,
    "/ComponentList/*/functionList/*/funcContractList/*/SignalList/*/Min": _SIGNAL,
    "/ComponentList/*/functionList/*/funcContractList/*/SignalList/*/Max": _SIGNAL,
    "/ComponentList/*/functionList/*/funcContractList/*/SignalList/*/Default": _SIGNAL,
    "/ComponentList/*/functionList/*/funcContractList/*/SignalList/*/InitValue": _SIGNAL,
    "/ComponentList/*/functionList/*/funcContractList/*/SignalList/*/Units": _SIGNAL,
    "/CommunicationList/*/RunnableName": "CoreAcc_Runnable is not a call of their document; CoreAcc_Step is",
    "/CommunicationList/*/ROSTopicList": "bus_Measurement_PRE carries a signal that their Function JSON does not have",
    "/CommunicationList/*/ROSTopicList/*/TopicName": _TOPIC,
    "/CommunicationList/*/ROSTopicList/*/InterfaceName": _TOPIC,
    "/CommunicationList/*/ROSTopicList/*/DataMappingList/*/GlobalVariableName": _VARIABLE,
    "/CommunicationList/*/ROSTopicList/*/DataMappingList/*/GlobalVariableDataType": _TYPE,
    "/CommunicationList/*/ROSTopicList/*/DataMappingList/*/ROSTopicFieldName": _FIELD,
    "/CommunicationList/*/ROSTopicList/*/DataMappingList/*/ROSTopicFieldDataType": _TYPE,
    "/CommunicationList/*/ROSTopicList/*/DataMappingList/*/FieldList": _OWN,
    "/CommunicationList/*/ROSTopicList/*/MessageType": _OWN,
    "/CommunicationList/*/ROSTopicList/*/NodeName": _OWN,
    "/CommunicationList/*/ROSTopicList/*/Providers": _OWN,
    "/CommunicationList/*/ROSTopicList/*/QualityOfService": _OWN,
    "/CommunicationList/*/ROSTopicList/*/Role": _OWN,
    "/CommunicationList/*/ROSTopicList/*/StampField": _OWN,
    "/InterfacePackageList": _OWN,
    "/NodePackageList": _OWN,
    "/SourceFunctionList": _OWN,
}

SIDE_BY_SIDE = {
    # variable: (their topic, field, datatype), (our topic, field, datatype, datatype of the variable)
    "core_inputs.bus_ACCIn.Bus_Veh.EgoVehALgt": (
        ("bus_ACCIn", "EgoVehALgt", "float"),
        ("vehicle/acceleration/longitudinal", "longitudinal", "float32", "double"),
    ),
    "core_inputs.bus_ACCIn.Bus_Veh.SteerWhlAg": (
        ("bus_ACCIn", "SteerWhlAg", "float"),
        ("vehicle/chassis/steering/whl_ag", "whl_ag", "float64", "double"),
    ),
    "core_inputs.bus_ACCIn.Bus_Veh.BrkCylP": (
        ("bus_ACCIn", "BrkCylP", "float"),
        ("vehicle/chassis/brake/cyl_p", "cyl_p", "float64", "double"),
    ),
    "core_inputs.bus_ACCIn.Bus_Cust.EgoVehDshbSpdUnit": (
        ("bus_ACCIn", "EgoVehDshbSpdUnit", "uint8"),
        ("vehicle/adas/map/dfs/map_data_spd_unit_typ", "map_data_spd_unit_typ", "string", "uint8_t"),
    ),
    "core_inputs.bus_ACCIn.Bus_Cust.EgoVehMass": (
        ("bus_ACCIn", "EgoVehMass", "float"),
        ("vehicle/mass", "mass", "float32", "double"),
    ),
    "AsmAcc_AccIntSts": (
        ("bus_ACCOut", "ACCInt_Sts", "uint8"),
        ("vehicle/adas/eco_control/status", "status", "uint8", "uint8_t"),
    ),
    "core_outputs.bus_Measurement_PRE.PRE_GaccEnbFlg": (
        ("bus_Measurement_PRE", "GaccEnbFlg", "boolean"),
        None,  # not a signal of the function: no other list of either document contains it
    ),
    "core_inputs.bus_ACCIn.Bus_Cust.EnaGACC": (
        None,  # a signal of the function that their file maps to nothing
        ("vehicle/adas/eco_control/is_enabled", "is_enabled", "bool", "bool"),
    ),
}


def by_hand():
    return json.loads(published("integration_model_ros2_core_acc.json"))


def derived_from_theirs():
    data = published("function_model_core_acc.json")
    return document([check_function_json(data, "core_acc.json").function], settings(topics="function"))


def rows(made):
    """Topic, field, its datatype and the variable's datatype, by variable."""
    found = {}
    for call in made["CommunicationList"]:
        for topic in call["ROSTopicList"]:
            for each in topic["DataMappingList"]:
                names = ("ROSTopicFieldName", "ROSTopicFieldDataType", "GlobalVariableDataType", "GlobalVariableName")
                for field, kind, variable_kind, variable in zip(*(each[name] for name in names), strict=True):
                    found[variable] = (topic["TopicName"], field, kind, variable_kind)
    return found


def differences(theirs, ours, at=""):
    """Places in which two documents differ, with `*` for positions. An absent value and null are the same."""
    if isinstance(theirs, dict) and isinstance(ours, dict):
        keys = {*theirs, *ours}
        return {d for key in keys for d in differences(theirs.get(key), ours.get(key), f"{at}/{key}")}
    if isinstance(theirs, list) and isinstance(ours, list) and all(isinstance(i, dict) for i in (*theirs, *ours)):
        inner = {d for one, other in zip(theirs, ours, strict=False) for d in differences(one, other, f"{at}/*")}
        return inner | ({at} if len(theirs) != len(ours) else set())
    return set() if theirs == ours else {at}


@checked_with("published", "Their examples are read, and every difference is explained")
@published_files
def test_every_difference_from_their_file_is_explained():
    assert differences(by_hand(), derived_from_theirs()) == set(EXPLAINED)


@published_files
@pytest.mark.parametrize("variable", SIDE_BY_SIDE)
def test_their_mapping(variable):
    written = rows(by_hand()).get(variable)
    assert (written[:3] if written else None) == SIDE_BY_SIDE[variable][0]


@pytest.mark.parametrize("variable", SIDE_BY_SIDE)
def test_our_mapping(variable):
    assert rows(document([example("core_acc")])).get(variable) == SIDE_BY_SIDE[variable][1]


def test_none_of_their_field_names_would_pass_rosidl():
    names = [theirs[1] for theirs, _ in SIDE_BY_SIDE.values() if theirs]
    assert not any(FIELD.fullmatch(name) for name in names)


@checked_with("published", "Their examples are read, and every difference is explained")
@published_files
def test_their_own_file_is_read_by_our_model():
    from sigcat.integration.ros2.model import Ros2Integration

    assert Ros2Integration.model_validate(by_hand(), by_name=False)


@checked_with("published", "Documents that sigcat writes are valid under their schemas")
@pytest.mark.parametrize("name", ["core_acc", "eco_control_mpc", "wheel_speed_calculation"])
@pytest.mark.parametrize("topics", ["signal", "branch", "function"])
def test_what_is_derived_is_valid_under_their_schema(name, topics):
    jsonschema.Draft202012Validator(schema("ros2")).validate(document([example(name)], settings(topics=topics)))
