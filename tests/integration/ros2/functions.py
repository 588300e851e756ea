"""Functions to integrate: the shipped examples, and small ones in which one thing differs."""

import json
from functools import cache

from sigcat.function.function_file import build_function
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.wire import written
from sigcat.integration.ros2.ros2_integration import derive
from sigcat.platforms.deployment_file import DEPLOYMENT_FILE
from tests.function.shipped import FUNCTIONS, interfaces, resolved


@cache
def example(name):
    path = next(path for path in FUNCTIONS if path.parent.name == name)
    return build_function(path.read_bytes(), str(path), interfaces())[0]


def examples():
    return [example(path.parent.name) for path in FUNCTIONS]


def settings(**ros2):
    """A deployment with a topic for each signal and a package of messages that sets share, unless it says otherwise."""
    return DEPLOYMENT_FILE.model_validate({"ros2": {"topics": "signal", "messagePackage": "vehicle_msgs", **ros2}})


def derived(functions, deployment=None):
    deployment = deployment or settings()
    return derive([resolved(each) for each in functions], deployment, deployment.ros2)


def document(functions, deployment=None):
    return json.loads(written(derived(functions, deployment).model))


def topics(functions, deployment=None):
    """Ends of topics by role and name of the topic."""
    made = document(functions, deployment)
    ends = [topic for call in made["CommunicationList"] for topic in call["ROSTopicList"]]
    return {(topic["Role"], topic["TopicName"]): topic for topic in ends}


def rules(functions, deployment=None):
    return {(finding.rule, finding.path) for finding in derived(functions, deployment).findings}


def signal(name="Speed", path="Vehicle.Speed", role="Consumer", **more):
    one = {"Name": name, "Description": f"What {name} says.", "Role": role, "Datatype": "DT_Float32", "AsilLevel": "QM"}
    return one | ({"VssPath": path, "VssDatatype": "float", "Variable": f"bus.{name}"} if path else {}) | more


def function(*signals, name="Acc", datatypes=(), call=None, contract=None, modes=None, **more):
    """A function of one cyclic call of 50 ms with these signals."""
    lists = dict.fromkeys(("DataQList", "MethodList", "ParameterList", "ErrorList", "SafetyReactionList"))
    step = {
        "Name": f"{name}_Step", "Description": "Steps.", "Runtype": "Cyclic", "Cycletime": 50, "AsilLevel": "QM",
        "Watchdog": None, "Scheduling": "Preemptive", "Priority": "10",
        "funcContractList": [{"SignalList": list(signals), **lists, **(contract or {})}],
    }  # fmt: skip
    base = {"typeRef": "DT_Float32", "category": "primitive", "cDef": "float"}
    return FunctionJson.model_validate(
        {
            "MetaInfo": {},
            "FunctionInfo": {"FunctionName": name, "FunctionResponsible": "Team", "Description": f"Function {name}."},
            "ComponentList": [{"Name": name, "functionList": [step | (call or {})]}],
            "ModesList": modes,
            "Datatypes": [base, *datatypes],
            **more,
        }
    )
