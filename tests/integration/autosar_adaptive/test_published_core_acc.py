"""The published CoreAcc example: what its authors wrote by hand beside what is derived from their Function JSON.

Each line below is one difference, with its reason. Everything else is the same.
"""

import json
from pathlib import Path

from sigcat.function.function_file import check_function_json
from sigcat.function.function_json.wire import written
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT, read_deployment
from tests.integration.autosar_adaptive.sets import derive
from tests.needs import published, published_files

FUNCTION = "function_model_core_acc.json"
BY_HAND = "integration_model_AA_core_acc.json"
DEPLOYMENT = Path(__file__).parent / "published_core_acc" / "deployment.yaml"

pytestmark = published_files

ABSENT = "-"
CARRIED = "The published schema has no field for it; the Function JSON says it, and it is carried on."
CONSUMED = (
    "The Function JSON says Consumer, and so does the code, which reads it as an input. The example offers it as the "
    "provider: a slip, or a set of functions in which another one provides it."
)
PROVIDER = "Follows from the role: each consumer of a service has its provider."
RULE = "The authors left the instance open; here it is a number by rule, so that provider and consumer agree."

DIFFERENCES = (
    # place, by hand, derived, why
    ("CoreAcc_Init/Description", ABSENT, "Core ACC initialisation function", CARRIED),
    ("CoreAcc_Init/Function", ABSENT, "CoreAcc", CARRIED),
    ("CoreAcc_Init/ParallelProcessing", ABSENT, False, CARRIED),
    ("CoreAcc_Init/Priority", ABSENT, "higher than CoreAcc_Step function", CARRIED),
    (
        "CoreAcc_Init/Scheduling", "Preemptive", "Non-preemptive",
        "The authors' own Function JSON says Non-Preemptive; copied by hand, it became its opposite.",
    ),
    ("CoreAcc_Step/ContractTypes", ABSENT, ["Global Variable Interfaces"], CARRIED),
    ("CoreAcc_Step/Description", ABSENT, "Core ACC Step function/Main Runnable", CARRIED),
    ("CoreAcc_Step/Function", ABSENT, "CoreAcc", CARRIED),
    ("CoreAcc_Step/PrevRunnable", ABSENT, "CoreAcc_Init", CARRIED),
    ("CoreAcc_Step/Priority", ABSENT, "higher than Gacc  Component", CARRIED),
    ("CoreAcc_Terminate/Description", ABSENT, "Core ACC terminate function during shutdown", CARRIED),
    ("CoreAcc_Terminate/Function", ABSENT, "CoreAcc", CARRIED),
    ("CoreAcc_Terminate/Priority", ABSENT, "higher than CoreAcc_Step, and CoreACC_Init function", CARRIED),
    ("FunctionInformation/Functions", ABSENT, ["CoreAcc"], CARRIED),
    ("event ADAS_EcoControl_IsEnabled/role", "Provider", "Consumer", CONSUMED),
    ("event Vehicle_Mass/role", "Provider", "Consumer", CONSUMED),
    (
        "event ADAS_EcoControl_Status/service", "CoreAccOutput", "CoreAccService",
        "What a component provides is one service, named after the component by rule.",
    ),
    ("service ChassisToCoreAcc/ServiceInstanceID", None, 140, RULE),
    ("service MapToCoreAcc/ServiceInstanceID", None, 130, RULE),
    ("service CoreAccToEcoControl/ServiceInstanceID", ABSENT, 206, RULE),
    ("service CoreAccToEcoControl/Name", ABSENT, "SOME/IP", PROVIDER),
    ("service CoreAccToEcoControl/ServiceDeploymentType", ABSENT, "SOME/IP", PROVIDER),
    ("service CoreAccToEcoControl/ContractName", ABSENT, "AdaptiveAUTOSAR", PROVIDER),
)  # fmt: skip


def document(deployment=None):
    function = check_function_json(published(FUNCTION), FUNCTION).function
    assert function is not None
    return json.loads(written(derive([function], deployment or read_deployment(DEPLOYMENT.read_bytes(), "d")).model))


def lines(integration):
    """The document as lines of place and value; lists by name, as their order says nothing."""
    component = integration["ComponentList"][0]
    found = {
        f"{part}/{key}": value
        for part in ("MetaInformation", "FunctionInformation")
        for key, value in integration[part].items()
    }
    found |= {
        key: component[key] for key in ("Name", "ExecutableName", "HeaderFiles", "FunctionGroupModes", "ParameterList")
    }
    found["DataTypes"] = integration["DataTypes"]
    for call in component["FunctionList"]:
        found |= {f"{call['Name']}/{key}": value for key, value in call.items() if key != "Name"}
    for service in component["ServiceInterfaceList"]:
        for content in service["ServiceList"]:
            for event in content["Events"]:
                place = f"event {event['Name']}"
                found |= {f"{place}/service": service["Name"], f"{place}/role": service["Role"]}
                found |= {f"{place}/DataType": event["DataType"], f"{place}/DataMappingList": event["DataMappingList"]}
            for kind in ("Methods", "Fields"):
                found |= {f"{kind} {item['Name']}": service["Name"] for item in content[kind]}
        for provider in service["Provider"] or ():
            found |= {f"service {service['Name']}/{key}": value for key, value in provider.items()}
    return found


def test_side_by_side():
    by_hand, derived = lines(json.loads(published(BY_HAND))), lines(document())
    different = {
        place: (by_hand.get(place, ABSENT), derived.get(place, ABSENT))
        for place in {*by_hand, *derived}
        if by_hand.get(place, ABSENT) != derived.get(place, ABSENT)
    }
    assert different == {place: (theirs, ours) for place, theirs, ours, _ in DIFFERENCES}


def test_nothing_that_the_authors_wrote_is_missing():
    by_hand, derived = lines(json.loads(published(BY_HAND))), lines(document())
    assert set(by_hand) <= set(derived)


def test_what_the_authors_typed_by_hand_is_derived_but_for_what_the_deployment_says():
    by_hand, derived = lines(json.loads(published(BY_HAND))), lines(document())
    same = [place for place in by_hand if place in derived and by_hand[place] == derived[place]]
    assert len(same) == len(by_hand) - 6


def test_without_a_deployment_each_signal_without_a_path_is_told():
    function = check_function_json(published(FUNCTION), FUNCTION).function
    assert function is not None
    findings = derive([function], DEFAULT_DEPLOYMENT).findings
    without_path = [finding for finding in findings if finding.rule == "A002"]
    assert len(without_path) == 6
    assert all("Set its path in the deployment file" in finding.fix for finding in without_path)
    others = {(finding.rule, finding.path) for finding in findings if finding.rule != "A002"}
    assert others == {("A017", "CoreAcc_Step"), ("A018", "enum"), ("A018", "rad")}, "a priority as text, separate units"
