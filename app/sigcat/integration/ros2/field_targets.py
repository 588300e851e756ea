"""For every field of every interface of a function: its place in the Integration JSON."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from pydantic import BaseModel

from sigcat.function.exchange import Part
from sigcat.function.function_json.code import CodeInterface
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.role import CONSUMER, PROVIDER
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.wire import own_fields
from sigcat.integration.report import (
    NOT_CARRIED,
    OF_ABSENT,
    Entry,
    FieldTarget,
    Targets,
    entries,
    fields_of,
    same_names,
)
from sigcat.integration.ros2.model import Communication, FieldMapping, RosNode, RosTopic
from sigcat.integration.ros2.services import SERVER
from sigcat.integration.ros2.signal_uses import INIT, SHUTDOWN, run_kind
from sigcat.integration.ros2.topics import PUBLISHER

_VERBATIM = FieldTarget("ComponentList", "kept as it was declared; nothing of ROS 2 depends on it")
_CORE = FieldTarget("SourceFunctionList", "the core of the adapter has it from there, on every platform")
_NO_ASIL = FieldTarget("ComponentList", "ROS 2 itself has no ASIL")
_FIELD = "{topic}, field {field}"
_FACTORS = ("Factor", "Offset", "ConversionFactor", "ConversionOffset")


def _of_core(*models: type[BaseModel]) -> dict[str, FieldTarget | str]:
    """Targets of the fields that the published schema lacks, unless a table has another one."""
    return dict.fromkeys(own_fields(*models), _CORE)


_DATA: Targets = {
    **_of_core(Signal, DataQueue),
    "Name": _FIELD + ": Signal",
    "Description": "message {message}: description of {field}",
    "Role": "{topic}: Role",
    **dict.fromkeys(("AsilLevel", "AsilInfo"), FieldTarget("{topic}: QualityOfService", "ROS 2 itself has no ASIL")),
    **same_names(_FIELD + ": ", ("TimeoutError", "Access", "Min", "Max", "Default", "InitValue", "RangeErrorAction")),
    **same_names(_FIELD + ": ", ("ExternalProvider", "Variable")),
    "Timeout": "{topic}: Deadline; " + _FIELD + ": Timeout",
    "QueueLength": "{topic}: Depth",
    "Datatype": _FIELD + ": VariableDataType",
    **dict.fromkeys(_FACTORS, "{conversion}"),
    "Units": _FIELD + ": VariableUnits",
    "Type": FieldTarget("{topic}: QualityOfService", "attributes are kept for late subscribers"),
    "Resolution": FieldTarget("ComponentList", "no field of a message has a resolution"),
    "VssPath": "{topic}: TopicName",
    "VssDatatype": _FIELD + ": FieldDataType",
    **dict.fromkeys(("VssMin", "VssMax"), FieldTarget("ComponentList", "no field of a message has a range")),
    "VssSymbols": "message {message}: Constants; {conversion}",
    "VssUnit": _FIELD + ": FieldUnits",
    "E2eError": FieldTarget("ComponentList", "ROS 2 checks no messages end to end; it is never set"),
}
_PARAMETER: Targets = {
    **_of_core(ParameterInterface),
    **same_names(
        "{parameter}: ", ("Description", "RangeErrorAction", "Interfacetype", "Attribute", "VssPath", "Variable")
    ),
    **dict.fromkeys(("InitValue", "DefaultText", "InitElements"), "{parameter}: Default"),
    **dict.fromkeys(_FACTORS, "{parameter}: Conversion"),
    "Name": "{parameter}: Parameter",
    "Datatype": "{parameter}: VariableDataType",
    "Asillevel": _NO_ASIL,
    "Min": FieldTarget("{parameter}: From", "in the catalogue's unit; absent if it is the datatype's own limit"),
    "Max": FieldTarget("{parameter}: To", "in the catalogue's unit; absent if it is the datatype's own limit"),
    "Default": FieldTarget("ComponentList", "a node has one default: the value at start-up"),
    "Units": "{parameter}: VariableUnits",
    "VssDatatype": "{parameter}: Type",
    "VssUnit": "{parameter}: Units",
    "VssSymbols": "{parameter}: AdditionalConstraints and Conversion",
}
_METHOD: Targets = {
    **_of_core(MethodInterface),
    "Name": "{service}: MethodName",
    "Description": "service {type}: description",
    "Role": "{service}: Role",
    "InDataTypeList": "service {type}: Request",
    "OutDataTypeList": "service {type}: Response",
}
_ERROR: Targets = {
    **_of_core(ErrorInterface),
    "Name": "{topic}: InterfaceName; {status}: Error",
    "Description": "{status}: Message",
    "Datatype": FieldTarget("{topic}: MessageType", "sent as PASSED or FAILED"),
    "Dependancy": "{status}: Dependencies",
    **same_names("{status}: ", ("OccurenceCountLimit", "ResetTime")),
    "IgnitionCountLimit": FieldTarget("{status}: IgnitionCountLimit", "each configuring begins a cycle"),
    **dict.fromkeys(("MaturationTime", "MaturationTimeNanoseconds"), "{status}: MaturationTime"),
    "Severity": "{status}: Severity and Level",
    "ResetCondition": FieldTarget("{status}: ResetCondition", "as text, for people"),
    "AsilLevel": _NO_ASIL,
    "VssPath": "{topic}: VssPath; {status}: VssPath",
}
_REACTION: Targets = {
    **_of_core(SafetyReaction),
    "Name": "{topic}: InterfaceName; {condition}: SafetyReaction",
    "Description": "{condition}: Description",
    "Datatype": FieldTarget("{topic}: MessageType; {condition}: VariableDataType", "sent as INACTIVE or ACTIVE"),
    "ErrorList": "{condition}: Statuses",
    "AsilLevel": _NO_ASIL,
    "VssPath": "{topic}: VssPath; {condition}: VssPath",
}
_CALL: Targets = {
    **_of_core(Runnable),
    "Name": "{schedule}: RunnableName",
    "Description": _VERBATIM,
    "Runtype": "{schedule}: Trigger",
    **dict.fromkeys(("Cycletime", "CycletimeNanoseconds"), "{schedule}: Period"),
    "StackSize": FieldTarget(NOT_CARRIED, "a thread has the stack size of the process"),
    "PrevRunnable": FieldTarget("{schedule}: After", "a call of the same node; the life cycle runs init first"),
    "ExecOffset": "{schedule}: Offset",
    "ParallelProcessing": _CORE,
    "AsilLevel": _NO_ASIL,
    "Watchdog": FieldTarget(
        "{schedule}: Alive…, Deadline…, Logical…", "of a logical supervision the words; its graph is in ComponentList"
    ),
    "Scheduling": FieldTarget("ComponentList", "the calls of a node run in one thread, one after the other"),
    "DebounceDelay": "{schedule}: Debounce",
    "Priority": FieldTarget("{schedule}: ThreadPriority", "if it is a priority of a thread"),
    "EventList": FieldTarget("{schedule}: Topics", "the topics that bring these signals"),
    "funcContractList": "CommunicationList, and the node's Parameters, ErrorTopics and SafetyReactionTopics",
    "SupervisionType": FieldTarget("{schedule}: Alive…, Deadline…", "the limits say which there are"),
    "VssPath": _VERBATIM,
}
_TRANSITIONS: Targets = {
    **_of_core(Runnable),
    **{
        field: FieldTarget("ComponentList", "a transition runs when it is asked for, in the thread of the service")
        for field in ("Cycletime", "CycletimeNanoseconds", "ExecOffset", "ParallelProcessing", "Scheduling", "DebounceDelay", "Priority",
                      "Watchdog", "SupervisionType", "PrevRunnable", "EventList", "Description", "VssPath")
    },
    **dict.fromkeys(("Name", "Runtype"), "{schedule}: Runnables"),
    "StackSize": FieldTarget(NOT_CARRIED, "a thread has the stack size of the process"),
    "AsilLevel": _NO_ASIL,
    "funcContractList": "CommunicationList, and the node's Parameters, ErrorTopics and SafetyReactionTopics",
}  # fmt: skip
_MODE_INTERFACE: Targets = {
    **_of_core(ModeInterface),
    "Name": "{topic}: InterfaceName",
    "Description": "message {message}: description",
    "Direction": "{topic}: Role",
    "Datatype": "message {message}: field mode",
    "Modes": "message {message}: Constants",
    "VssPath": "{topic}: VssPath",
}
_MODE: Targets = {
    "Name": "Schedules: ActiveModes",
    "Description": "ModesList",
    "RunnablesList": "Schedules: ActiveModes",
}
_DATATYPE: Targets = dict.fromkeys(
    ("typeRef", "category", "cDef", "Kind", "VssDatatype", "Symbols", "ElementType", "Length", "Fields", "Description"),
    FieldTarget("Datatypes", "messages use the catalogue's datatypes; conversions lead to these"),
)
_INFO: Targets = dict.fromkeys(
    ("FunctionName", "FunctionResponsible", "Description", "Version"), "FunctionInfo, packages"
)

_CODE: Targets = dict.fromkeys(fields_of(CodeInterface), "SourceFunctionList: Code")
_META: Targets = {
    "Authority": "MetaInfo: Authority", "SchemaAuthor": "MetaInfo: SchemaAuthor", "Date": "MetaInfo: Date",
    **dict.fromkeys(
        ("SchemaVersion", "SchemaDescription"), FieldTarget("MetaInfo", "each document has its own version and description"),
    ),
}  # fmt: skip
_COMPONENT: Targets = {"Name": "node {node}: ComponentName", "functionList": "node {node}: Lifecycle and Schedules"}
_CONTRACT: Targets = {
    **OF_ABSENT,
    "Type": _VERBATIM,
    **dict.fromkeys(
        ("SignalList", "DataQList", "MethodList", "ParameterList", "ErrorList", "SafetyReactionList"),
        FieldTarget("CommunicationList, node {node}", "each interface has its own entries"),
    ),
}

TABLES: Mapping[str, Targets] = {
    "signal": _DATA, "queue": _DATA, "parameter": _PARAMETER, "method": _METHOD, "error": _ERROR,
    "safety reaction": _REACTION, "call": _CALL, "transition": _TRANSITIONS, "mode interface": _MODE_INTERFACE,
    "mode": _MODE, "datatype": _DATATYPE, "function": _INFO, "document": _META, "component": _COMPONENT,
    "contract": _CONTRACT, "code": _CODE,
}  # fmt: skip


def field_targets(
    parts: Sequence[Part], nodes: Mapping[str, RosNode], communications: Sequence[Communication]
) -> tuple[Entry, ...]:
    """Every field that has a value, in the order of the functions."""
    exchanged = _exchanged(communications)
    made: list[Entry] = []
    for part in parts:
        if part.is_first:
            made.extend(_of_function(part, nodes[part.name]))
        made.extend(_entries(part, part.component.name, "component", part.component, node=part.name))
        for call in part.component.runnables:
            made.extend(_of_call(call, part))
            made.extend(_of_contracts(call, part, nodes[part.name], exchanged))
    return tuple(made)


_Exchanged = Mapping[tuple[str, str, str, str, str], Mapping[str, str]]
"""Names of the topic and the field of a signal, and of the service of a method: by kind, node, call, name and role."""


def _exchanged(communications: Iterable[Communication]) -> _Exchanged:
    found: dict[tuple[str, str, str, str, str], Mapping[str, str]] = {}
    for communication in communications:
        for topic in communication.topics:
            role = PROVIDER if topic.role == PUBLISHER else CONSUMER
            for mapping in topic.mappings:
                found["data", topic.node or "", communication.runnable, mapping.signal, role] = _places(topic, mapping)
        for service in communication.services or ():
            role = PROVIDER if service.role == SERVER else CONSUMER
            names = {"service": f"service {service.name}", "type": service.service}
            found["method", service.node, communication.runnable, service.method, role] = names
    return found


def _entries(part: Part, interface: str, kind: str, model: BaseModel, **names: str) -> list[Entry]:
    return entries(part.function_name, interface, "call" if kind == "transition" else kind, model, TABLES[kind], names)


def _found(part: Part, interface: str, kind: str, model: BaseModel, names: Mapping[str, str] | None) -> list[Entry]:
    """Entries of an interface with the names of its place; without these it was left out."""
    if names is not None:
        return _entries(part, interface, kind, model, **names)
    gone = FieldTarget(NOT_CARRIED, "left out: see the findings")
    return entries(part.function_name, interface, kind, model, dict.fromkeys(TABLES[kind], gone))


def _of_function(part: Part, node: RosNode) -> Iterator[Entry]:
    function = part.function
    yield from _entries(part, part.function_name, "document", function.meta)
    yield from _entries(part, part.function_name, "function", function.info)
    if function.code is not None:
        yield from _entries(part, part.function_name, "code", function.code)
    for datatype in function.datatypes:
        yield from _entries(part, datatype.reference, "datatype", datatype)
    for mode in function.modes or ():
        yield from _entries(part, mode.name, "mode", mode)
    modes = {each.interface: {"topic": f"topic {each.topic}", "message": each.message} for each in node.modes}
    for interface in function.mode_interfaces or ():
        yield from _found(part, interface.name, "mode interface", interface, modes.get(interface.name))


def _of_call(call: Runnable, part: Part) -> list[Entry]:
    kind = run_kind(call)
    if kind in (INIT, SHUTDOWN):
        callback = "on_configure" if kind == INIT else "on_cleanup, on_shutdown, on_error"
        return _entries(part, call.name, "transition", call, schedule=f"node {part.name}, {callback}")
    return _entries(part, call.name, "call", call, schedule=f"node {part.name}, Schedules")


def _of_contracts(call: Runnable, part: Part, node: RosNode, exchanged: _Exchanged) -> Iterator[Entry]:
    parameters = {each.parameter: {"parameter": f"node {node.name}, parameter {each.name}"} for each in node.parameters}
    for contract in call.contracts or ():
        yield from _entries(part, call.name, "contract", contract, node=part.name)
        for kind, items in (("signal", contract.signals), ("queue", contract.queues)):
            for item in items or ():
                places = exchanged.get(("data", part.name, call.name, item.name, item.role))
                name = item.vss_path or item.name
                yield from _found(part, name, kind, item, places)
        for method in contract.methods or ():
            places = exchanged.get(("method", part.name, call.name, method.name, method.role))
            yield from _found(part, method.name, "method", method, places)
        for parameter in contract.parameters or ():
            yield from _found(part, parameter.name, "parameter", parameter, parameters.get(parameter.name))
        topics = {
            end.interface: end.topic for end in (*node.error_topics, *node.reaction_topics) if end.role == PUBLISHER
        }
        for error in contract.errors or ():
            names = {"topic": f"topic {topics[error.name]}", "status": f"diagnostic status {part.name}: {error.name}"}
            yield from _entries(part, error.name, "error", error, **names)
        for reaction in contract.safety_reactions or ():
            names = {"topic": f"topic {topics[reaction.name]}", "condition": f"node {node.name}, SafetyReactions"}
            yield from _entries(part, reaction.name, "safety reaction", reaction, **names)


def _places(topic: RosTopic, mapping: FieldMapping) -> Mapping[str, str]:
    return {
        "topic": f"topic {topic.name}",
        "field": mapping.field,
        "message": topic.message or "",
        "conversion": f"conversion {mapping.conversion}" if mapping.conversion else "no conversion: nothing changes",
    }
