"""Facts that ROS 2 cannot express, and the targets of all fields."""

import pytest
from pydantic import BaseModel

from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.model import FunctionInfo, Mode
from sigcat.function.function_json.runnable import Runnable
from sigcat.integration.report import NOT_CARRIED
from sigcat.integration.ros2.field_targets import TABLES
from sigcat.platforms.deployment_file import DEPLOYMENT_FILE
from tests.integration.ros2.derived import ends, quality
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
