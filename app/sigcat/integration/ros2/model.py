"""Integration JSON for ROS 2: the published schema, which is Function JSON with topics, and what it lacks.

Fields of the authors' schema keep their spelling (`ROSTopicList`, `GlobalVariableName`). Everything else is optional
there: packages with messages and services, nodes with their life cycle, quality of service, conversions.
"""

from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import Field

from sigcat.function.document.field_types import (
    CallName,
    CDefinition,
    CExpression,
    ComponentName,
    Email,
    ErrorName,
    FunctionName,
    InterfaceName,
    MethodName,
    Name,
    NumberText,
    ParameterName,
    RosConstant,
    RosDatatype,
    RosField,
    RosInterface,
    RosMessage,
    RosName,
    RosNamespace,
    RosPlugin,
    RosTopicName,
    UnitKey,
    Version,
    VssPath,
)
from sigcat.function.document.text import AnyValue, Text
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.wire import OWN, Integer, Number, WireModel, described, written
from sigcat.integration.ros2.settings import MOST_VALUES, SchedulingPolicy
from sigcat.integration.source_functions import source_functions

ROS2 = "published ROS 2 integration schema 1.0.0"


class SymbolMap(WireModel):
    """A text of a field and its number in the code."""

    text: Name = described("Text", "Value in the message.", source=OWN)
    value: Integer = described("Value", "Number in the code.", source=OWN)
    number: Integer | None = described(
        "Number", "Number in the message, where that has numbers.", default=None, source=OWN
    )


class Conversion(WireModel):
    """A conversion between a variable of the code and a field of a message."""

    name: RosName = described("Name", "Name of the conversion.", source=ROS2)
    return_type: CDefinition = described("ReturnDataType", "Datatype of the result.", source=ROS2)
    field: RosField | None = described("Field", "Field of the message that it belongs to.", default=None, source=OWN)
    kind: Name | None = described("Kind", "Cast, Linear or Symbols.", default=None, source=OWN)
    factor: NumberText | None = described("Factor", "Result = value × factor + offset.", default=None, source=OWN)
    offset: NumberText | None = described("Offset", "Offset of the result, in its unit.", default=None, source=OWN)
    rounding: Name | None = described("Rounding", "Nearest, where the result is an integer.", default=None, source=OWN)
    saturates: bool | None = described(
        "Saturates", "Whether the result stops at the limits of its datatype.", default=None, source=OWN
    )
    symbols: tuple[SymbolMap, ...] | None = described(
        "Symbols", "Texts and their numbers.", default=None, source=OWN, strict=False
    )


class FieldMapping(WireModel):
    """Everything that the adapter has to know about one field of a topic."""

    signal: InterfaceName = described("Signal", "Name of the signal in the function.", source=OWN)
    field: RosField = described("Field", "Field of the message, or of a message in it.", source=OWN)
    number_field: RosName | None = described(
        "NumberField", "Field that has the number of an enumeration, beside its text. A publisher fills both.",
        default=None, source=OWN,
    )  # fmt: skip
    field_type: RosDatatype = described("FieldDataType", "Datatype of the field.", source=OWN)
    field_units: UnitKey | None = described(
        "FieldUnits", "Unit of the field: the catalogue's.", default=None, source=OWN
    )
    catalogue_factor: NumberText | None = described(
        "CatalogueFactor", "Value in the catalogue's unit = value of the field × factor + offset; absent where they are "
        "the same. Exact: a decimal number or a fraction.", default=None, source=OWN,
    )  # fmt: skip
    catalogue_offset: NumberText | None = described(
        "CatalogueOffset", "Offset of it, in the catalogue's unit.", default=None, source=OWN
    )
    variable: CExpression = described("Variable", "Expression of the C code.", source=OWN)
    variable_type: CDefinition = described("VariableDataType", "Its datatype.", source=OWN)
    variable_units: UnitKey | None = described("VariableUnits", "Its unit.", default=None, source=OWN)
    conversion: RosName | None = described(
        "Conversion", "Name of the conversion, if one is needed.", default=None, source=OWN
    )
    min: Number | None = described(
        "Min", "Smallest valid value, in the unit of the variable.", default=None, source=OWN
    )
    max: Number | None = described("Max", "Largest valid value, in the unit of the variable.", default=None, source=OWN)
    default: Number | None = described("Default", "Value that replaces a missing one.", default=None, source=OWN)
    init_value: Number | None = described("InitValue", "Value before the first one.", default=None, source=OWN)
    range_error_action: Name | None = described("RangeErrorAction", "Default or Init.", default=None, source=OWN)
    timeout: Number | None = described("Timeout", "Longest age of a value.", default=None, unit="ms", source=OWN)
    timeout_error: ErrorName | None = described("TimeoutError", "Error that it sets.", default=None, source=OWN)
    access: Name | None = described("Access", "Immediate or Buffered.", default=None, source=OWN)
    queue_length: Integer | None = described("QueueLength", "Values to queue.", default=None, source=OWN)
    external_provider: Text | None = described(
        "ExternalProvider", "Who provides it, where no other function does.", default=None, source=OWN
    )
    asil_level: Name | None = described("AsilLevel", "ASIL of the signal.", default=None, source=OWN)
    vss_path: VssPath | None = described("VssPath", "Path in the catalogue.", default=None, source=OWN)


class DataMap(WireModel):
    """Fields of a topic and variables of the code: the n-th of each list belong together."""

    variables: tuple[CExpression, ...] = described("GlobalVariableName", "Variables.", source=ROS2, strict=False)
    variable_types: tuple[CDefinition, ...] = described(
        "GlobalVariableDataType", "Their datatypes.", source=ROS2, strict=False
    )
    fields: tuple[RosField, ...] = described("ROSTopicFieldName", "Fields.", source=ROS2, strict=False)
    field_types: tuple[RosDatatype, ...] = described(
        "ROSTopicFieldDataType", "Their datatypes.", source=ROS2, strict=False
    )
    conversions: tuple[Conversion, ...] | None = described(
        "ConversionAPI", "Conversions, where datatypes or units differ.", source=ROS2, strict=False
    )
    mappings: tuple[FieldMapping, ...] | None = described(
        "FieldList", "The same, with all that is known of each field.", default=None, source=OWN, strict=False
    )


class FixedField(WireModel):
    """A field of an existing message that always has one value."""

    field: RosField = described("Field", "Field of the message.", source=OWN)
    field_type: RosDatatype = described("FieldDataType", "Its datatype.", source=OWN)
    value: AnyValue = described("Value", "Its value.", source=OWN)


Reliability = Literal["reliable", "best_effort"]
Durability = Literal["transient_local", "volatile"]


class QualityOfService(WireModel):
    """Quality of service of one end of a topic."""

    reliability: Reliability = described("Reliability", "reliable or best_effort.", source=OWN)
    durability: Durability = described("Durability", "transient_local or volatile.", source=OWN)
    history: Literal["keep_last"] = described("History", "keep_last.", source=OWN)
    depth: Annotated[Integer, Field(ge=0, le=MOST_VALUES)] = described("Depth", "Values that are kept.", source=OWN)
    deadline: Number | None = described(
        "Deadline", "Longest time between two values; absent if there is none.", default=None, unit="ms", source=OWN
    )
    liveliness: Literal["automatic", "manual_by_topic"] = described(
        "Liveliness", "automatic or manual_by_topic.", source=OWN
    )
    lease_duration: Number | None = described(
        "LeaseDuration", "Time after which a silent publisher is taken for dead.", default=None, unit="ms", source=OWN
    )
    reasons: tuple[Text, ...] = described("Reasons", "What led to it.", source=OWN, strict=False)


class RosTopic(WireModel):
    """A topic that a call publishes or subscribes to."""

    name: RosTopicName = described("TopicName", "Name of the topic.", source=ROS2)
    interface: Name = described("InterfaceName", "Name of the interface in the function.", source=ROS2)
    data_maps: tuple[DataMap, ...] = described("DataMappingList", "Fields and variables.", source=ROS2, strict=False)
    role: Name | None = described("Role", "Publisher or Subscription.", default=None, source=OWN)
    message: RosInterface | None = described("MessageType", "Package, `msg` and message.", default=None, source=OWN)
    stamp: RosField | None = described(
        "StampField", "Field that has the time of the call; absent if the message has none.", default=None, source=OWN
    )
    values: tuple[FixedField, ...] | None = described(
        "FixedFields", "Fields that always have one value.", default=None, source=OWN, strict=False
    )
    node: RosName | None = described(
        "NodeName", "Node that has the publisher or subscription.", default=None, source=OWN
    )
    providers: tuple[FunctionName, ...] | None = described(
        "Providers", "Functions of the set that publish it; empty if it comes from outside.", default=None, source=OWN,
        strict=False,
    )  # fmt: skip
    quality: QualityOfService | None = described(
        "QualityOfService", "Quality of service of this end.", default=None, source=OWN
    )

    @property
    def mappings(self) -> Iterator[FieldMapping]:
        """All fields, of whichever data mapping."""
        return (mapping for data_map in self.data_maps for mapping in data_map.mappings or ())


class ArgumentMap(WireModel):
    """An argument or a return value of a service."""

    name: Name = described("Name", "Name in the function.", source=OWN)
    field: RosName = described("Field", "Field of the request or response.", source=OWN)
    field_type: RosDatatype = described("FieldDataType", "Datatype of the field.", source=OWN)
    variable_type: CDefinition = described("VariableDataType", "Datatype in the code.", source=OWN)


class RosService(WireModel):
    """A service that a call offers or uses."""

    name: RosTopicName = described("ServiceName", "Name of the service.", source=OWN)
    method: MethodName = described("MethodName", "Name of the method in the function.", source=OWN)
    role: Name = described("Role", "Server or Client.", source=OWN)
    service: RosInterface = described("ServiceType", "Package, `srv` and service.", source=OWN)
    node: RosName = described("NodeName", "Node that has the server or client.", source=OWN)
    request: tuple[ArgumentMap, ...] = described("Request", "Arguments.", source=OWN, strict=False)
    response: tuple[ArgumentMap, ...] = described("Response", "Return values.", source=OWN, strict=False)
    success: RosName | None = described(
        "Success", "Field of the response that tells whether the function has answered.", default=None, source=OWN
    )


class Communication(WireModel):
    """Communications of one call with others."""

    runnable: CallName = described("RunnableName", "Name of the call.", source=ROS2)
    topics: tuple[RosTopic, ...] = described("ROSTopicList", "Topics of the call.", source=ROS2, strict=False)
    services: tuple[RosService, ...] | None = described(
        "ROSServiceList", "Services of the call.", default=None, source=OWN, strict=False
    )


class MessageConstant(WireModel):
    """A constant of a message."""

    name: RosConstant = described("Name", "Name of the constant.", source=OWN)
    datatype: RosDatatype = described("DataType", "Its datatype.", source=OWN)
    value: Text = described("Value", "Its value.", source=OWN)


class MessageField(WireModel):
    """A field of a message."""

    name: RosName = described("Name", "Name of the field.", source=OWN)
    datatype: RosDatatype = described("DataType", "Its datatype, as a message file writes it.", source=OWN)
    description: Text = described("Description", "What it means.", source=OWN)
    units: UnitKey | None = described("Units", "Its unit.", default=None, source=OWN)
    vss_path: VssPath | None = described("VssPath", "Path in the catalogue.", default=None, source=OWN)


class Message(WireModel):
    """A message."""

    name: RosMessage = described("Name", "Name of the message.", source=OWN)
    description: Text = described("Description", "What it carries.", source=OWN)
    constants: tuple[MessageConstant, ...] = described("Constants", "Its constants.", source=OWN, strict=False)
    fields: tuple[MessageField, ...] = described("Fields", "Its fields, in order.", source=OWN, strict=False)


class Service(WireModel):
    """A service."""

    name: RosMessage = described("Name", "Name of the service.", source=OWN)
    description: Text = described("Description", "What it does.", source=OWN)
    request: tuple[MessageField, ...] = described("Request", "Fields of the request.", source=OWN, strict=False)
    response: tuple[MessageField, ...] = described("Response", "Fields of the response.", source=OWN, strict=False)


class Transition(WireModel):
    """A transition of the life cycle and the calls that it makes."""

    name: Name = described("Transition", "configure, activate, deactivate, cleanup, shutdown or error.", source=OWN)
    callback: RosName = described("Callback", "Callback of the lifecycle node.", source=OWN)
    start: Name = described("From", "State or states before.", source=OWN)
    end: Name = described("To", "State after.", source=OWN)
    runnables: tuple[CallName, ...] = described("Runnables", "Calls that are made, in order.", source=OWN, strict=False)
    starts: tuple[CallName, ...] = described("Starts", "Calls whose timer or trigger starts.", source=OWN, strict=False)
    stops: tuple[CallName, ...] = described("Stops", "Calls whose timer or trigger stops.", source=OWN, strict=False)


class Schedule(WireModel):
    """When a call runs while the node is active."""

    runnable: CallName = described("RunnableName", "Name of the call.", source=OWN)
    trigger: Name = described("Trigger", "Timer or Topics.", source=OWN)
    period: Number | None = described("Period", "Period of the timer.", default=None, unit="ms", source=OWN)
    offset: Number | None = described("Offset", "Delay of the timer's first call.", default=None, unit="ms", source=OWN)
    debounce: Number | None = described("Debounce", "Shortest time between calls.", default=None, unit="ms", source=OWN)
    topics: tuple[RosTopicName, ...] = described(
        "Topics", "Topics whose values trigger the call.", source=OWN, strict=False
    )
    after: Name | None = described("After", "Calls of the node that it follows.", default=None, source=OWN)
    thread_priority: Integer | None = described(
        "ThreadPriority", "Priority of the thread under SCHED_FIFO.", default=None, source=OWN
    )
    modes: tuple[Name, ...] | None = described(
        "ActiveModes", "Modes in which it runs; absent if in all.", default=None, source=OWN, strict=False
    )
    alive_min: Number | None = described("AliveMin", "Fewest calls in the reference.", default=None, source=OWN)
    alive_max: Number | None = described("AliveMax", "Most calls in the reference.", default=None, source=OWN)
    alive_reference: Number | None = described("AliveReference", "Cycles counted.", default=None, source=OWN)
    alive_error: ErrorName | None = described("AliveError", "Error that it sets.", default=None, source=OWN)
    deadline_min: Number | None = described("DeadlineMin", "Shortest duration.", default=None, unit="ms", source=OWN)
    deadline_max: Number | None = described("DeadlineMax", "Longest duration.", default=None, unit="ms", source=OWN)
    deadline_error: ErrorName | None = described("DeadlineError", "Error that it sets.", default=None, source=OWN)
    logical: Text | None = described("LogicalSupervision", "Order of calls, as text.", default=None, source=OWN)
    logical_error: ErrorName | None = described("LogicalError", "Error that it sets.", default=None, source=OWN)


class RosParameter(WireModel):
    """A parameter of a node."""

    name: RosName = described("Name", "Name of the parameter of the node.", source=OWN)
    parameter: ParameterName = described("Parameter", "Name in the function.", source=OWN)
    type: Name = described("Type", "bool, integer, double or string, or an array of them.", source=OWN)
    description: Text = described("Description", "What it means.", source=OWN)
    default: AnyValue = described(
        "Default", "Value without a parameter file, in the unit of the parameter.", source=OWN
    )
    low: Number | None = described("From", "Smallest value.", default=None, source=OWN)
    high: Number | None = described("To", "Largest value.", default=None, source=OWN)
    constraints: Text | None = described("AdditionalConstraints", "What else holds.", default=None, source=OWN)
    read_only: bool = described("ReadOnly", "Whether it is set at start-up only.", source=OWN)
    units: UnitKey | None = described("Units", "Its unit: the catalogue's.", default=None, source=OWN)
    variable: CExpression = described("Variable", "Expression of the C code.", source=OWN)
    variable_type: CDefinition = described("VariableDataType", "Its datatype.", source=OWN)
    variable_units: UnitKey | None = described("VariableUnits", "Its unit.", default=None, source=OWN)
    conversion: Conversion | None = described(
        "Conversion", "From the parameter to the variable.", default=None, source=OWN
    )
    storage: Name = described("Interfacetype", "Calibration, Measurement or PersistenceMemory.", source=OWN)
    attribute: Name = described("Attribute", "Normal, LearningParameter or NA.", source=OWN)
    range_error_action: Name = described("RangeErrorAction", "Default or Init.", source=OWN)
    vss_path: VssPath | None = described("VssPath", "Path in the catalogue.", default=None, source=OWN)


class Diagnostic(WireModel):
    """The diagnostic status of an error."""

    name: Name = described("Name", "Name of the status: node and error interface.", source=OWN)
    error: ErrorName = described("Error", "Error interface.", source=OWN)
    message: Text = described("Message", "Text of the status while the error is present.", source=OWN)
    level: Literal["WARN", "ERROR"] = described("Level", "Level while the error is confirmed.", source=OWN)
    severity: Text = described("Severity", "What the error leads to.", source=OWN)
    maturation_time: Number = described("MaturationTime", "Time until confirmed.", unit="ms", source=OWN)
    occurrence_count_limit: Integer = described("OccurenceCountLimit", "Occurrences until confirmed.", source=OWN)
    ignition_count_limit: Integer = described(
        "IgnitionCountLimit", "Ignition cycles with the error until confirmed; each configuring begins one.", source=OWN
    )
    reset_time: Number | None = described("ResetTime", "Time until reset.", default=None, unit="ms", source=OWN)
    reset_condition: Text | None = described(
        "ResetCondition", "Condition of the reset, as text.", default=None, source=OWN
    )
    dependencies: tuple[Name, ...] = described(
        "Dependencies", "Names of statuses that set this error too.", source=OWN, strict=False
    )
    vss_path: VssPath | None = described("VssPath", "Path in the catalogue.", default=None, source=OWN)


class ConditionMonitor(WireModel):
    """A safety condition: present while one of these statuses is FAILED, or while its provider says so."""

    condition: InterfaceName = described("SafetyReaction", "Name of the interface.", source=OWN)
    description: Text = described("Description", "What the condition means.", source=OWN)
    topic: RosTopicName = described("TopicName", "Topic on which the node tells it.", source=OWN)
    statuses: tuple[Name, ...] = described(
        "Statuses", "Names of the diagnostic statuses of its errors.", source=OWN, strict=False
    )
    provider: Text | None = described(
        "Provider", "Who informs of the condition, as the deployment names it.", default=None, source=OWN
    )
    variable_type: CDefinition = described("VariableDataType", "Datatype in the code.", source=OWN)
    vss_path: VssPath | None = described("VssPath", "Path in the catalogue.", default=None, source=OWN)


class StatusTopic(WireModel):
    """The topic of a mode, an error or a safety reaction."""

    interface: InterfaceName = described("InterfaceName", "Name of the interface.", source=OWN)
    topic: RosTopicName = described("TopicName", "Name of the topic.", source=OWN)
    role: Name = described("Role", "Publisher or Subscription.", source=OWN)
    message: RosInterface = described("MessageType", "Package, `msg` and message.", source=OWN)
    field: RosName = described("Field", "Field that has the mode, the status or the state.", source=OWN)
    provider: Text | None = described(
        "Provider", "Who sends it to a subscription: a node of the set, or whom the deployment names.", default=None,
        source=OWN,
    )  # fmt: skip
    quality: QualityOfService = described("QualityOfService", "Quality of service.", source=OWN)
    vss_path: VssPath | None = described("VssPath", "Path in the catalogue.", default=None, source=OWN)


class RosNode(WireModel):
    """A lifecycle node: one component of a function."""

    name: RosName = described("NodeName", "Name of the node.", source=OWN)
    namespace: RosNamespace = described("Namespace", "Its namespace.", source=OWN)
    function: FunctionName = described("FunctionName", "Function that it belongs to.", source=OWN)
    component: ComponentName = described("ComponentName", "Component that it runs.", source=OWN)
    executable: RosName = described("Executable", "Executable that runs this node alone.", source=OWN)
    plugin: RosPlugin = described("Plugin", "Class of the node, as a component container loads it.", source=OWN)
    transitions: tuple[Transition, ...] = described("Lifecycle", "Transitions.", source=OWN, strict=False)
    schedules: tuple[Schedule, ...] = described("Schedules", "When calls run.", source=OWN, strict=False)
    parameters: tuple[RosParameter, ...] = described("Parameters", "Parameters.", source=OWN, strict=False)
    modes: tuple[StatusTopic, ...] = described("ModeTopics", "Topics of modes.", source=OWN, strict=False)
    error_topics: tuple[StatusTopic, ...] = described(
        "ErrorTopics", "Topics of its errors, and of those of others on which they depend.", source=OWN, strict=False
    )
    reaction_topics: tuple[StatusTopic, ...] = described(
        "SafetyReactionTopics", "Topics of its safety reactions that it publishes and receives.", source=OWN,
        strict=False,
    )  # fmt: skip
    diagnostics: tuple[Diagnostic, ...] = described("Diagnostics", "Statuses of errors.", source=OWN, strict=False)
    diagnostics_topic: RosTopicName = described("DiagnosticsTopic", "Topic of the statuses.", source=OWN)
    scheduling_policy: SchedulingPolicy | None = described(
        "SchedulingPolicy", "Policy of the thread that runs its calls; other if absent.", default=None, source=OWN
    )
    conditions: tuple[ConditionMonitor, ...] = described(
        "SafetyReactions", "Safety conditions.", source=OWN, strict=False
    )


class Package(WireModel):
    """A package: of messages and services, or of a node."""

    name: RosName = described("Name", "Name of the package.", source=OWN)
    version: Version = described("Version", "Version, as three numbers.", source=OWN)
    description: Text = described("Description", "What it is.", source=OWN)
    maintainer: Text = described("Maintainer", "Who maintains it.", source=OWN)
    email: Email = described("MaintainerEmail", "Mail address of the maintainer.", source=OWN)
    license: Text = described("License", "License.", source=OWN)
    dependencies: tuple[RosName, ...] = described("Dependencies", "Packages that it needs.", source=OWN, strict=False)


class InterfacePackage(Package):
    """A package of messages and services."""

    messages: tuple[Message, ...] = described("Messages", "Messages.", source=OWN, strict=False)
    services: tuple[Service, ...] = described("Services", "Services.", source=OWN, strict=False)


class NodePackage(Package):
    """A package of nodes."""

    nodes: tuple[RosNode, ...] = described("Nodes", "Its nodes.", source=OWN, strict=False)
    bond: bool | None = described(
        "Bond", "Whether its nodes send heartbeats to their lifecycle manager; no if absent.", default=None, source=OWN
    )


class Ros2Integration(FunctionJson):
    """The whole document."""

    communications: tuple[Communication, ...] = described(
        "CommunicationList", "What each call exchanges.", source=ROS2, strict=False
    )
    interface_packages: tuple[InterfacePackage, ...] | None = described(
        "InterfacePackageList", "Packages of messages and services.", default=None, source=OWN, strict=False
    )
    node_packages: tuple[NodePackage, ...] | None = described(
        "NodePackageList", "Packages of nodes.", default=None, source=OWN, strict=False
    )
    functions: tuple[FunctionJson, ...] | None = source_functions()


def to_json(model: Ros2Integration) -> bytes:
    """The document as UTF-8 text with a stable layout."""
    return written(model)


def integration_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of Integration JSON for ROS 2."""
    schema = Ros2Integration.model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
