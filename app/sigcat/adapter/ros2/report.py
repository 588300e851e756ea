"""The report: each field of an Integration JSON with its place in the packages."""

from collections.abc import Iterator, Mapping

from pydantic import BaseModel

from sigcat.adapter.core.plan import CLASS
from sigcat.integration.report import Entry, FieldTarget, Targets, entries
from sigcat.integration.ros2.document import read_integration
from sigcat.integration.ros2.model import Communication, Ros2Integration, RosNode, RosTopic
from sigcat.integration.ros2.topics import PUBLISHER
from sigcat.limits import Limits

_CORE = FieldTarget("{core}", "decided there, as on every platform")
_DOCUMENT = FieldTarget("{interfaces}", "in a comment of the field")
_CODE = "{node}"
_TOPIC: Targets = {
    **dict.fromkeys(
        ("TopicName", "InterfaceName", "Role", "NodeName", "DataMappingList", "StampField", "FixedFields"), _CODE
    ),
    "MessageType": "{interfaces}",
    "Providers": FieldTarget("README.md", "in the picture"),
    "QualityOfService": FieldTarget(_CODE, "its events are counted and reported in the diagnostics"),
}
_FIELD: Targets = {
    **dict.fromkeys(("Signal", "Variable", "VariableDataType", "VariableUnits", "Conversion", "Min", "Max", "Default",
                     "InitValue", "RangeErrorAction", "Timeout", "TimeoutError", "Access", "QueueLength", "AsilLevel"),
                    _CORE),
    **dict.fromkeys(("Field", "NumberField"), "{interfaces}; {node}"),
    "FieldDataType": "{interfaces}",
    **dict.fromkeys(("CatalogueFactor", "CatalogueOffset"), FieldTarget(_CODE, "in the core, which converts")),
    **dict.fromkeys(("FieldUnits", "VssPath"), _DOCUMENT),
    "ExternalProvider": FieldTarget("README.md", "in the picture"),
}  # fmt: skip
_STATUS: Targets = {
    **dict.fromkeys(("InterfaceName", "TopicName", "Role", "Field", "QualityOfService"), _CODE),
    "MessageType": "{interfaces}",
    "Provider": FieldTarget("README.md", "in the picture"),
    "VssPath": _DOCUMENT,
}
_SERVICE: Targets = {
    **dict.fromkeys(("ServiceName", "MethodName", "Role", "NodeName", "Success"), _CODE),
    **dict.fromkeys(("ServiceType", "Request", "Response"), "{interfaces}; {node}"),
}
_PARAMETER: Targets = {
    **dict.fromkeys(("Name", "Type", "Description", "Default", "From", "To", "AdditionalConstraints", "Units"),
                    FieldTarget("{node}; {config}", "value, descriptor and comment")),
    "ReadOnly": _CODE,
    "Attribute": FieldTarget("{core}; {node}", "what is learned is kept in the storage folder"),
    **dict.fromkeys(("Parameter", "Variable", "VariableDataType", "VariableUnits", "Conversion", "Interfacetype",
                     "RangeErrorAction"), _CORE),
    "VssPath": FieldTarget("{config}", "in a comment"),
}  # fmt: skip
_SCHEDULE: Targets = {
    "RunnableName": "{core}; {node}",
    **dict.fromkeys(("Trigger", "Period", "Offset", "Debounce", "Topics", "After", "ActiveModes", "AliveMin", "AliveMax",
                     "AliveReference", "AliveError", "DeadlineMin", "DeadlineMax", "DeadlineError", "LogicalSupervision",
                     "LogicalError"), _CORE),
    "ThreadPriority": FieldTarget(_CODE, "of the thread that makes the calls, under SCHED_FIFO"),
}  # fmt: skip
_DIAGNOSTIC: Targets = {
    **dict.fromkeys(("Name", "Error", "Message"), FieldTarget(_CODE, "a status on /diagnostics")),
    "Severity": FieldTarget("README.md", "in the table of errors"),
    **dict.fromkeys(("MaturationTime", "OccurenceCountLimit", "IgnitionCountLimit", "ResetTime", "ResetCondition",
                     "Dependencies", "Level"), _CORE),
    "VssPath": _CORE,
}  # fmt: skip
_CONDITION: Targets = {
    **dict.fromkeys(("SafetyReaction", "TopicName"), _CODE),
    **dict.fromkeys(("Statuses", "VariableDataType", "VssPath"), _CORE),
    **dict.fromkeys(("Description", "Provider"), "README.md"),
}
_TRANSITION: Targets = dict.fromkeys(
    ("Transition", "Callback", "From", "To", "Runnables", "Starts", "Stops"), FieldTarget(_CODE, "a callback")
)
TABLES: Mapping[str, Targets] = {
    "topic": _TOPIC, "signal": _FIELD, "status": _STATUS, "service": _SERVICE, "parameter": _PARAMETER,
    "call": _SCHEDULE, "error": _DIAGNOSTIC, "safety reaction": _CONDITION, "transition": _TRANSITION,
}  # fmt: skip


def report(data: bytes, name: str, limits: Limits) -> tuple[Entry, ...]:
    """An entry for each field that has a value. Raises InputRefused if the document cannot be used."""
    model = read_integration(data, name, limits)
    return tuple(entry for package in model.node_packages or () for node in package.nodes
                 for entry in _of_node(node, package.name, model))  # fmt: skip


def _of_node(node: RosNode, package: str, model: Ros2Integration) -> Iterator[Entry]:
    places = {
        "core": f"{package}/core/{node.function}_adapter.{_ending(node, model)}",
        "node": f"{package}/src/{node.name}_node.cpp",
        "config": f"{package}/config/{node.name}.yaml",
        "interfaces": "",
    }
    for communication in model.communications:
        yield from _of_communication(communication, node, places)
    for kind, listed in (
        ("transition", node.transitions), ("call", node.schedules), ("parameter", node.parameters),
        ("status", (*node.modes, *node.error_topics, *node.reaction_topics)), ("error", node.diagnostics),
        ("safety reaction", node.conditions),
    ):  # fmt: skip
        for each in listed:
            message = getattr(each, "message", "") if kind == "status" else ""
            yield from _entries(node, kind, each, {**places, "interfaces": f"{message}.msg"})


def _ending(node: RosNode, model: Ros2Integration) -> str:
    """The core of a class is written in C++."""
    codes = [each.code for each in model.functions or () if each.info.function_name == node.function and each.code]
    return "cpp" if any(code.signature == CLASS for code in codes) else "c"


def _of_communication(communication: Communication, node: RosNode, places: Mapping[str, str]) -> Iterator[Entry]:
    for topic in communication.topics:
        if topic.node == node.name:
            yield from _of_topic(topic, node, places)
    for service in communication.services or ():
        if service.node == node.name:
            yield from _entries(node, "service", service, {**places, "interfaces": f"{service.service}.srv"})


def _of_topic(topic: RosTopic, node: RosNode, places: Mapping[str, str]) -> Iterator[Entry]:
    known = {**places, "interfaces": f"{topic.message}.msg"}
    way = "publisher" if topic.role == PUBLISHER else "subscription"
    yield from entries(node.function, topic.name, way, topic, TABLES["topic"], known)
    for mapping in topic.mappings:
        yield from entries(node.function, mapping.signal, "signal", mapping, TABLES["signal"], known)


def _entries(node: RosNode, kind: str, part: BaseModel, places: Mapping[str, str]) -> list[Entry]:
    first = next(iter(type(part).model_fields))
    return entries(node.function, str(getattr(part, first)), kind, part, TABLES[kind], places)
