"""Quality of service: which follows from ASIL, cycle, queue and the other end."""

import pytest
from pydantic import ValidationError

from sigcat.platforms.deployment_file import DEPLOYMENT_FILE
from tests.integration.ros2.derived import quality
from tests.integration.ros2.functions import (
    derived,
    document,
    examples,
    function,
    rules,
    settings,
    signal,
    topics,
)


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
