"""Signals in fields of messages that exist: where they travel, what the core converts, and what is refused."""

import json

import pytest

from sigcat.errors import InputRefused
from sigcat.integration.datatypes import BY_VSS
from sigcat.integration.ros2.document import read_integration
from sigcat.integration.ros2.messages.installed_messages import with_installed_messages
from sigcat.integration.ros2.messages.message_definitions import Definitions, Field, MessageError
from sigcat.integration.source_functions import SOURCE_FUNCTIONS
from sigcat.limits import DEFAULT_LIMITS
from tests.integration.ros2.functions import derived, document, function, rules, settings, signal, topics

TEXTS = {
    "demo_msgs/Motion": "std_msgs/Header header\nTwist twist\nfloat64[3] covariance # of it\nuint8 D=2\nuint8 gear 5",
    "demo_msgs/Twist": "Vector3 linear",
    "demo_msgs/Vector3": "float64 x\nfloat64 y\n",
    "std_msgs/Header": "builtin_interfaces/Time stamp\nstring frame_id",
    "demo_msgs/Plain": "float32 data\nfloat32[] many\nstring<=5 name",
}


def deployment(topic="/odom", kind="demo_msgs/Motion", **more):
    return settings(messages={topic: {"type": kind, **more}}, messageDefinitions=TEXTS)


def speed(role="Consumer", **more):
    return signal("Speed", "Vehicle.Speed", role, VssUnit="km/h", Units="km/h", **more)


def problems(made, *, rule="N222"):
    return [finding.message for finding in made.findings if finding.rule == rule]


def refused(fields, *signals, **more):
    return problems(derived([function(*(signals or (speed(),)))], deployment(fields=fields, **more)))


def test_a_topic_has_the_message_and_the_field_of_the_deployment():
    made = topics(
        [function(speed())], deployment(fields={"twist.linear.x": {"signal": "Vehicle.Speed", "unit": "m/s"}})
    )
    end = made["Subscription", "/odom"]
    (field,) = end["DataMappingList"][0]["FieldList"]
    assert (end["MessageType"], end["StampField"]) == ("demo_msgs/msg/Motion", "header.stamp")
    assert (field["Field"], field["FieldDataType"], field["FieldUnits"]) == ("twist.linear.x", "float64", "m/s")
    assert (field["CatalogueFactor"], field["CatalogueOffset"]) == ("3.6", "0")


def test_the_function_that_is_carried_has_the_datatype_and_unit_of_the_field_so_that_its_core_converts():
    made = document(
        [function(speed())], deployment(fields={"twist.linear.x": {"signal": "Vehicle.Speed", "unit": "m/s"}})
    )
    step = made[SOURCE_FUNCTIONS][0]["ComponentList"][0]["functionList"][0]
    (carried,) = step["funcContractList"][0]["SignalList"]
    assert (carried["VssDatatype"], carried["VssUnit"], carried["ConversionFactor"]) == ("double", "m/s", "5/18")


def test_what_is_sent_is_reliable_and_has_its_fixed_values():
    wanted = deployment(fields={"covariance[1]": "Vehicle.Speed"}, values={"header.frame_id": "base_link"})
    end = topics([function(speed("Provider"))], wanted)["Publisher", "/odom"]
    assert end["FixedFields"] == [{"Field": "header.frame_id", "FieldDataType": "string", "Value": "base_link"}]
    assert end["QualityOfService"]["Reliability"] == "reliable"


def test_packages_of_messages_are_dependencies():
    made = document([function(speed())], deployment(fields={"twist.linear.x": "Vehicle.Speed"}))
    assert "demo_msgs" in made["NodePackageList"][0]["Dependencies"]


def test_an_enumeration_has_the_numbers_of_the_message():
    gear = {
        "typeRef": "DT_Gear", "category": "userdefined", "cDef": "uint8_t", "Kind": "enumeration",
        "Symbols": [{"Symbol": "P", "Value": 0}, {"Symbol": "D", "Value": 1}],
    }  # fmt: skip
    one = signal("Gear", "Vehicle.Gear", Datatype="DT_Gear", VssDatatype="string")
    wanted = deployment(fields={"gear": {"signal": "Vehicle.Gear", "symbols": {"P": 22, "D": 2}}})
    end = topics([function(one, datatypes=[gear])], wanted)["Subscription", "/odom"]
    (conversion,) = end["DataMappingList"][0]["ConversionAPI"]
    assert [(each["Text"], each["Value"], each["Number"]) for each in conversion["Symbols"]] == [
        ("P", 0, 22),
        ("D", 1, 2),
    ]


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"twist.linear.z": "Vehicle.Speed"}, "demo_msgs/Motion.twist.linear has no field 'z': its fields are x, y"),
        ({"twist.linear.x.y": "Vehicle.Speed"}, "demo_msgs/Motion.twist.linear.x has no fields"),
        ({"covariance[3]": "Vehicle.Speed"}, "has no element 3"),
        ({"covariance": "Vehicle.Speed"}, "Vehicle.Speed is float, which covariance, float64[3], cannot have"),
        ({"twist": "Vehicle.Speed"}, "which twist, demo_msgs/Twist, cannot have"),
        ({"header.frame_id": "Vehicle.Speed"}, "header.frame_id is a text"),
        ({"header.stamp.sec": "Vehicle.Speed"}, "must have the time of the call"),
        ({"gear": {"signal": "Vehicle.Speed", "unit": "kg"}}, "cannot be converted from km/h to kg"),
        ({"gear": {"signal": "Vehicle.Speed", "symbols": {"P": 1}}}, "must be an enumeration"),
        ({"gear": "Vehicle.Speed", "twist.linear.x": "Vehicle.Speed"}, "must have one field"),
    ],
)
def test_what_does_not_fit_is_refused_with_its_reason(fields, message):
    (found,) = refused(fields)
    assert message in found


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"gear": 256}, "gear must have a value of uint8, not '256'"),
        ({"gear": 1.5}, "gear must have a value of uint8, not '1.5'"),
        ({"header.frame_id": 3}, "must have a value of string"),
        ({"twist.linear.x": 1.5}, "must have a signal or a value, not both"),
        ({"covariance": 1.5}, "must have a value of float64[3]"),
        ({"header.nothing": 1}, "has no field 'nothing'"),
    ],
)
def test_values_that_a_field_cannot_have_are_refused(values, message):
    (found,) = refused({"twist.linear.x": "Vehicle.Speed"}, speed("Provider"), values=values)
    assert message in found


def test_a_message_that_is_not_found_is_named_with_what_to_do():
    made = derived([function(speed())], deployment(kind="demo_msgs/Other", fields={"x": "Vehicle.Speed"}))
    (finding,) = (each for each in made.findings if each.rule == "N222")
    assert finding.message == "The message demo_msgs/Other is not found."
    assert "messageFolders" in finding.fix


def test_a_message_is_sent_by_one_node():
    fields = {"twist.linear.x": "Vehicle.Speed", "twist.linear.y": "Vehicle.Other"}
    others = (function(speed("Provider")), function(signal("Other", "Vehicle.Other", "Provider"), name="Second"))
    (found,) = problems(derived(others, deployment(fields=fields)))
    assert "must have one sender" in found
    mixed = function(speed("Provider"), signal("Other", "Vehicle.Other"))
    assert "the sender of Vehicle.Other" in problems(derived([mixed], deployment(fields=fields)))[0]


def test_values_of_a_message_that_is_only_received_are_refused():
    (found,) = refused({"gear": "Vehicle.Speed"}, values={"header.frame_id": "base_link"})
    assert "it is only received" in found


def test_a_signal_of_nothing_is_told():
    assert ("N220", "Vehicle.Sped") in rules([function(speed())], deployment(fields={"gear": "Vehicle.Sped"}))


@pytest.mark.parametrize("value", [3, True, None, ["base"], {"a": 1}])
def test_an_edited_document_cannot_give_a_field_a_value_of_another_kind(value):
    wanted = deployment(fields={"gear": "Vehicle.Speed"}, values={"header.frame_id": "base_link"})
    made = document([function(speed("Provider"))], wanted)
    (end,) = (topic for call in made["CommunicationList"] for topic in call["ROSTopicList"])
    end["FixedFields"][0]["Value"] = value
    with pytest.raises(InputRefused) as refused:
        read_integration(json.dumps(made).encode(), "ros2.json", DEFAULT_LIMITS)
    assert "The value of header.frame_id must be a string" in refused.value.findings[0].message


# -- definitions --------------------------------------------------------------------------------------------------


def test_definitions_are_read_as_rosidl_reads_them():
    texts = {
        "a_msgs/A": "byte b\nchar[4] c\nHeader header\nint32[<=3] some\nstring<=4 s 'a # b'\nstring NAME=x # y\n# text\n\nB[2] bs",
        "a_msgs/B": "float32 x",
        **TEXTS,
    }
    definitions = Definitions(texts)
    assert definitions.field("a_msgs/A", "bs[1].x") == Field("float32")
    assert definitions.field("a_msgs/A", "c[3]").element == BY_VSS["uint8"]
    assert definitions.message("a_msgs/A").constants == {"NAME": "x # y"}
    assert definitions.stamp("a_msgs/A") == "header.stamp"
    with pytest.raises(MessageError, match="Line 1 of a_msgs/C is not a field"):
        Definitions({"a_msgs/C": "float32"}).message("a_msgs/C")


def test_definitions_come_from_folders_and_from_what_is_installed(tmp_path):
    places = {
        "ws/demo/demo_msgs/msg/Motion.msg": TEXTS["demo_msgs/Motion"],
        "ws/demo/demo_msgs/msg/Twist.msg": "float64 x",
        "opt/share/std_msgs/msg/Header.msg": TEXTS["std_msgs/Header"],
    }
    for name, text in places.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    wanted = settings(messages={"/odom": {"type": "demo_msgs/msg/Motion", "fields": {"twist.x": "Vehicle.Speed"}}},
                      messageFolders=["ws"]).ros2  # fmt: skip
    read = with_installed_messages(wanted, tmp_path, {"AMENT_PREFIX_PATH": f"{tmp_path}/none:{tmp_path}/opt"})
    assert sorted(read.message_definitions) == ["demo_msgs/Motion", "demo_msgs/Twist", "std_msgs/Header"]
