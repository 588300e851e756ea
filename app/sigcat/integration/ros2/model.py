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
from sigcat.function.function_json.wire import Integer, Listed, Number, WireModel, always, described, own
from sigcat.integration.ros2.settings import MOST_VALUES, SchedulingPolicy
from sigcat.integration.source_functions import source_functions

ROS2 = "published ROS 2 integration schema 1.0.0"


def published(alias: str, description: str, **more: Any) -> Any:
    """A field of the published schema."""
    return described(alias, description, source=ROS2, **more)


class SymbolMap(WireModel):
    """A text of a field and its number in the code."""

    text: Name = always("Text", "Value in the message.")
    value: Integer = always("Value", "Number in the code.")
    number: Integer | None = own("Number", "Number in the message, where that has numbers.")


class Conversion(WireModel):
    """A conversion between a variable of the code and a field of a message."""

    name: RosName = published("Name", "Name of the conversion.")
    return_type: CDefinition = published("ReturnDataType", "Datatype of the result.")
    field: RosField | None = own("Field", "Field of the message that it belongs to.")
    kind: Name | None = own("Kind", "Cast, Linear or Symbols.")
    factor: NumberText | None = own("Factor", "Result = value × factor + offset.")
    offset: NumberText | None = own("Offset", "Offset of the result, in its unit.")
    rounding: Name | None = own("Rounding", "Nearest, where the result is an integer.")
    saturates: bool | None = own("Saturates", "Whether the result stops at the limits of its datatype.")
    symbols: Listed[SymbolMap] | None = own("Symbols", "Texts and their numbers.")


class FieldMapping(WireModel):
    """Everything that the adapter has to know about one field of a topic."""

    signal: InterfaceName = always("Signal", "Name of the signal in the function.")
    field: RosField = always("Field", "Field of the message, or of a message in it.")
    number_field: RosName | None = own(
        "NumberField", "Field that has the number of an enumeration, beside its text. A publisher fills both."
    )
    field_type: RosDatatype = always("FieldDataType", "Datatype of the field.")
    field_units: UnitKey | None = own("FieldUnits", "Unit of the field: the catalogue's.")
    catalogue_factor: NumberText | None = own(
        "CatalogueFactor",
        "Value in the catalogue's unit = value of the field × factor + offset; absent where they are "
        "the same. Exact: a decimal number or a fraction.",
    )
    catalogue_offset: NumberText | None = own("CatalogueOffset", "Offset of it, in the catalogue's unit.")
    variable: CExpression = always("Variable", "Expression of the C code.")
    variable_type: CDefinition = always("VariableDataType", "Its datatype.")
    variable_units: UnitKey | None = own("VariableUnits", "Its unit.")
    conversion: RosName | None = own("Conversion", "Name of the conversion, if one is needed.")
    min: Number | None = own("Min", "Smallest valid value, in the unit of the variable.")
    max: Number | None = own("Max", "Largest valid value, in the unit of the variable.")
    default: Number | None = own("Default", "Value that replaces a missing one.")
    init_value: Number | None = own("InitValue", "Value before the first one.")
    range_error_action: Name | None = own("RangeErrorAction", "Default or Init.")
    timeout: Number | None = own("Timeout", "Longest age of a value.", unit="ms")
    timeout_error: ErrorName | None = own("TimeoutError", "Error that it sets.")
    access: Name | None = own("Access", "Immediate or Buffered.")
    queue_length: Integer | None = own("QueueLength", "Values to queue.")
    external_provider: Text | None = own("ExternalProvider", "Who provides it, where no other function does.")
    asil_level: Name | None = own("AsilLevel", "ASIL of the signal.")
    vss_path: VssPath | None = own("VssPath", "Path in the catalogue.")


class DataMap(WireModel):
    """Fields of a topic and variables of the code: the n-th of each list belong together."""

    variables: Listed[CExpression] = published("GlobalVariableName", "Variables.")
    variable_types: Listed[CDefinition] = published("GlobalVariableDataType", "Their datatypes.")
    fields: Listed[RosField] = published("ROSTopicFieldName", "Fields.")
    field_types: Listed[RosDatatype] = published("ROSTopicFieldDataType", "Their datatypes.")
    conversions: Listed[Conversion] | None = published("ConversionAPI", "Conversions, where datatypes or units differ.")
    mappings: Listed[FieldMapping] | None = own("FieldList", "The same, with all that is known of each field.")


class FixedField(WireModel):
    """A field of an existing message that always has one value."""

    field: RosField = always("Field", "Field of the message.")
    field_type: RosDatatype = always("FieldDataType", "Its datatype.")
    value: AnyValue = always("Value", "Its value.")


Reliability = Literal["reliable", "best_effort"]
Durability = Literal["transient_local", "volatile"]


class QualityOfService(WireModel):
    """Quality of service of one end of a topic."""

    reliability: Reliability = always("Reliability", "reliable or best_effort.")
    durability: Durability = always("Durability", "transient_local or volatile.")
    history: Literal["keep_last"] = always("History", "keep_last.")
    depth: Annotated[Integer, Field(ge=0, le=MOST_VALUES)] = always("Depth", "Values that are kept.")
    deadline: Number | None = own("Deadline", "Longest time between two values; absent if there is none.", unit="ms")
    liveliness: Literal["automatic", "manual_by_topic"] = always("Liveliness", "automatic or manual_by_topic.")
    lease_duration: Number | None = own(
        "LeaseDuration", "Time after which a silent publisher is taken for dead.", unit="ms"
    )
    reasons: Listed[Text] = always("Reasons", "What led to it.")


class RosTopic(WireModel):
    """A topic that a call publishes or subscribes to."""

    name: RosTopicName = published("TopicName", "Name of the topic.")
    interface: Name = published("InterfaceName", "Name of the interface in the function.")
    data_maps: Listed[DataMap] = published("DataMappingList", "Fields and variables.")
    role: Name | None = own("Role", "Publisher or Subscription.")
    message: RosInterface | None = own("MessageType", "Package, `msg` and message.")
    stamp: RosField | None = own("StampField", "Field that has the time of the call; absent if the message has none.")
    values: Listed[FixedField] | None = own("FixedFields", "Fields that always have one value.")
    node: RosName | None = own("NodeName", "Node that has the publisher or subscription.")
    providers: Listed[FunctionName] | None = own(
        "Providers", "Functions of the set that publish it; empty if it comes from outside."
    )
    quality: QualityOfService | None = own("QualityOfService", "Quality of service of this end.")

    @property
    def mappings(self) -> Iterator[FieldMapping]:
        """All fields, of whichever data mapping."""
        return (mapping for data_map in self.data_maps for mapping in data_map.mappings or ())


class ArgumentMap(WireModel):
    """An argument or a return value of a service."""

    name: Name = always("Name", "Name in the function.")
    field: RosName = always("Field", "Field of the request or response.")
    field_type: RosDatatype = always("FieldDataType", "Datatype of the field.")
    variable_type: CDefinition = always("VariableDataType", "Datatype in the code.")


class RosService(WireModel):
    """A service that a call offers or uses."""

    name: RosTopicName = always("ServiceName", "Name of the service.")
    method: MethodName = always("MethodName", "Name of the method in the function.")
    role: Name = always("Role", "Server or Client.")
    service: RosInterface = always("ServiceType", "Package, `srv` and service.")
    node: RosName = always("NodeName", "Node that has the server or client.")
    request: Listed[ArgumentMap] = always("Request", "Arguments.")
    response: Listed[ArgumentMap] = always("Response", "Return values.")
    success: RosName | None = own("Success", "Field of the response that tells whether the function has answered.")


class Communication(WireModel):
    """Communications of one call with others."""

    runnable: CallName = published("RunnableName", "Name of the call.")
    topics: Listed[RosTopic] = published("ROSTopicList", "Topics of the call.")
    services: Listed[RosService] | None = own("ROSServiceList", "Services of the call.")


class MessageConstant(WireModel):
    """A constant of a message."""

    name: RosConstant = always("Name", "Name of the constant.")
    datatype: RosDatatype = always("DataType", "Its datatype.")
    value: Text = always("Value", "Its value.")


class MessageField(WireModel):
    """A field of a message."""

    name: RosName = always("Name", "Name of the field.")
    datatype: RosDatatype = always("DataType", "Its datatype, as a message file writes it.")
    description: Text = always("Description", "What it means.")
    units: UnitKey | None = own("Units", "Its unit.")
    vss_path: VssPath | None = own("VssPath", "Path in the catalogue.")


class Message(WireModel):
    """A message."""

    name: RosMessage = always("Name", "Name of the message.")
    description: Text = always("Description", "What it carries.")
    constants: Listed[MessageConstant] = always("Constants", "Its constants.")
    fields: Listed[MessageField] = always("Fields", "Its fields, in order.")


class Service(WireModel):
    """A service."""

    name: RosMessage = always("Name", "Name of the service.")
    description: Text = always("Description", "What it does.")
    request: Listed[MessageField] = always("Request", "Fields of the request.")
    response: Listed[MessageField] = always("Response", "Fields of the response.")


class Transition(WireModel):
    """A transition of the life cycle and the calls that it makes."""

    name: Name = always("Transition", "configure, activate, deactivate, cleanup, shutdown or error.")
    callback: RosName = always("Callback", "Callback of the lifecycle node.")
    start: Name = always("From", "State or states before.")
    end: Name = always("To", "State after.")
    runnables: Listed[CallName] = always("Runnables", "Calls that are made, in order.")
    starts: Listed[CallName] = always("Starts", "Calls whose timer or trigger starts.")
    stops: Listed[CallName] = always("Stops", "Calls whose timer or trigger stops.")


class Schedule(WireModel):
    """When a call runs while the node is active."""

    runnable: CallName = always("RunnableName", "Name of the call.")
    trigger: Name = always("Trigger", "Timer or Topics.")
    period: Number | None = own("Period", "Period of the timer.", unit="ms")
    offset: Number | None = own("Offset", "Delay of the timer's first call.", unit="ms")
    debounce: Number | None = own("Debounce", "Shortest time between calls.", unit="ms")
    topics: Listed[RosTopicName] = always("Topics", "Topics whose values trigger the call.")
    after: Name | None = own("After", "Calls of the node that it follows.")
    thread_priority: Integer | None = own("ThreadPriority", "Priority of the thread under SCHED_FIFO.")
    modes: Listed[Name] | None = own("ActiveModes", "Modes in which it runs; absent if in all.")
    alive_min: Number | None = own("AliveMin", "Fewest calls in the reference.")
    alive_max: Number | None = own("AliveMax", "Most calls in the reference.")
    alive_reference: Number | None = own("AliveReference", "Cycles counted.")
    alive_error: ErrorName | None = own("AliveError", "Error that it sets.")
    deadline_min: Number | None = own("DeadlineMin", "Shortest duration.", unit="ms")
    deadline_max: Number | None = own("DeadlineMax", "Longest duration.", unit="ms")
    deadline_error: ErrorName | None = own("DeadlineError", "Error that it sets.")
    logical: Text | None = own("LogicalSupervision", "Order of calls, as text.")
    logical_error: ErrorName | None = own("LogicalError", "Error that it sets.")


class RosParameter(WireModel):
    """A parameter of a node."""

    name: RosName = always("Name", "Name of the parameter of the node.")
    parameter: ParameterName = always("Parameter", "Name in the function.")
    type: Name = always("Type", "bool, integer, double or string, or an array of them.")
    description: Text = always("Description", "What it means.")
    default: AnyValue = always("Default", "Value without a parameter file, in the unit of the parameter.")
    low: Number | None = own("From", "Smallest value.")
    high: Number | None = own("To", "Largest value.")
    constraints: Text | None = own("AdditionalConstraints", "What else holds.")
    read_only: bool = always("ReadOnly", "Whether it is set at start-up only.")
    units: UnitKey | None = own("Units", "Its unit: the catalogue's.")
    variable: CExpression = always("Variable", "Expression of the C code.")
    variable_type: CDefinition = always("VariableDataType", "Its datatype.")
    variable_units: UnitKey | None = own("VariableUnits", "Its unit.")
    conversion: Conversion | None = own("Conversion", "From the parameter to the variable.")
    storage: Name = always("Interfacetype", "Calibration, Measurement or PersistenceMemory.")
    attribute: Name = always("Attribute", "Normal, LearningParameter or NA.")
    range_error_action: Name = always("RangeErrorAction", "Default or Init.")
    vss_path: VssPath | None = own("VssPath", "Path in the catalogue.")


class Diagnostic(WireModel):
    """The diagnostic status of an error."""

    name: Name = always("Name", "Name of the status: node and error interface.")
    error: ErrorName = always("Error", "Error interface.")
    message: Text = always("Message", "Text of the status while the error is present.")
    level: Literal["WARN", "ERROR"] = always("Level", "Level while the error is confirmed.")
    severity: Text = always("Severity", "What the error leads to.")
    maturation_time: Number = always("MaturationTime", "Time until confirmed.", unit="ms")
    occurrence_count_limit: Integer = always("OccurenceCountLimit", "Occurrences until confirmed.")
    ignition_count_limit: Integer = always(
        "IgnitionCountLimit", "Ignition cycles with the error until confirmed; each configuring begins one."
    )
    reset_time: Number | None = own("ResetTime", "Time until reset.", unit="ms")
    reset_condition: Text | None = own("ResetCondition", "Condition of the reset, as text.")
    dependencies: Listed[Name] = always("Dependencies", "Names of statuses that set this error too.")
    vss_path: VssPath | None = own("VssPath", "Path in the catalogue.")


class ConditionMonitor(WireModel):
    """A safety condition: present while one of these statuses is FAILED, or while its provider says so."""

    condition: InterfaceName = always("SafetyReaction", "Name of the interface.")
    description: Text = always("Description", "What the condition means.")
    topic: RosTopicName = always("TopicName", "Topic on which the node tells it.")
    statuses: Listed[Name] = always("Statuses", "Names of the diagnostic statuses of its errors.")
    provider: Text | None = own("Provider", "Who informs of the condition, as the deployment names it.")
    variable_type: CDefinition = always("VariableDataType", "Datatype in the code.")
    vss_path: VssPath | None = own("VssPath", "Path in the catalogue.")


class StatusTopic(WireModel):
    """The topic of a mode, an error or a safety reaction."""

    interface: InterfaceName = always("InterfaceName", "Name of the interface.")
    topic: RosTopicName = always("TopicName", "Name of the topic.")
    role: Name = always("Role", "Publisher or Subscription.")
    message: RosInterface = always("MessageType", "Package, `msg` and message.")
    field: RosName = always("Field", "Field that has the mode, the status or the state.")
    provider: Text | None = own(
        "Provider", "Who sends it to a subscription: a node of the set, or whom the deployment names."
    )
    quality: QualityOfService = always("QualityOfService", "Quality of service.")
    vss_path: VssPath | None = own("VssPath", "Path in the catalogue.")


class RosNode(WireModel):
    """A lifecycle node: one component of a function."""

    name: RosName = always("NodeName", "Name of the node.")
    namespace: RosNamespace = always("Namespace", "Its namespace.")
    function: FunctionName = always("FunctionName", "Function that it belongs to.")
    component: ComponentName = always("ComponentName", "Component that it runs.")
    executable: RosName = always("Executable", "Executable that runs this node alone.")
    plugin: RosPlugin = always("Plugin", "Class of the node, as a component container loads it.")
    transitions: Listed[Transition] = always("Lifecycle", "Transitions.")
    schedules: Listed[Schedule] = always("Schedules", "When calls run.")
    parameters: Listed[RosParameter] = always("Parameters", "Parameters.")
    modes: Listed[StatusTopic] = always("ModeTopics", "Topics of modes.")
    error_topics: Listed[StatusTopic] = always(
        "ErrorTopics", "Topics of its errors, and of those of others on which they depend."
    )
    reaction_topics: Listed[StatusTopic] = always(
        "SafetyReactionTopics", "Topics of its safety reactions that it publishes and receives."
    )
    diagnostics: Listed[Diagnostic] = always("Diagnostics", "Statuses of errors.")
    diagnostics_topic: RosTopicName = always("DiagnosticsTopic", "Topic of the statuses.")
    scheduling_policy: SchedulingPolicy | None = own(
        "SchedulingPolicy", "Policy of the thread that runs its calls; other if absent."
    )
    conditions: Listed[ConditionMonitor] = always("SafetyReactions", "Safety conditions.")


class Package(WireModel):
    """A package: of messages and services, or of a node."""

    name: RosName = always("Name", "Name of the package.")
    version: Version = always("Version", "Version, as three numbers.")
    description: Text = always("Description", "What it is.")
    maintainer: Text = always("Maintainer", "Who maintains it.")
    email: Email = always("MaintainerEmail", "Mail address of the maintainer.")
    license: Text = always("License", "License.")
    dependencies: Listed[RosName] = always("Dependencies", "Packages that it needs.")


class InterfacePackage(Package):
    """A package of messages and services."""

    messages: Listed[Message] = always("Messages", "Messages.")
    services: Listed[Service] = always("Services", "Services.")


class NodePackage(Package):
    """A package of nodes."""

    nodes: Listed[RosNode] = always("Nodes", "Its nodes.")
    bond: bool | None = own("Bond", "Whether its nodes send heartbeats to their lifecycle manager; no if absent.")


class Ros2Integration(FunctionJson):
    """The whole document."""

    communications: Listed[Communication] = published("CommunicationList", "What each call exchanges.")
    interface_packages: Listed[InterfacePackage] | None = own(
        "InterfacePackageList", "Packages of messages and services."
    )
    node_packages: Listed[NodePackage] | None = own("NodePackageList", "Packages of nodes.")
    functions: tuple[FunctionJson, ...] | None = source_functions()
