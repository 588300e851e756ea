"""Integration JSON for AUTOSAR Classic, in the words of AUTOSAR: a format of sigcat, since no other is published."""

from typing import Annotated, Literal

from pydantic import Field

from sigcat.function.document.field_types import (
    DATE,
    VERSION,
    CallName,
    Carried,
    CIdentifier,
    ErrorName,
    FunctionName,
    InterfaceName,
    MethodName,
    Name,
    NumberText,
    ParameterName,
    ShortName,
    SourceFile,
    UnitKey,
    Version,
    VssPath,
)
from sigcat.function.document.text import AnyValue, Text
from sigcat.function.function_json.code import CodeInterface
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.wire import Integer, Listed, Number, WireModel, always, own
from sigcat.integration.autosar_classic.deployment.releases import DEFAULT_RELEASE, ReleaseName
from sigcat.integration.source_functions import source_functions

# -- datatypes ----------------------------------------------------------------------------------------------------


class Symbol(WireModel):
    """A named value of an enumeration."""

    symbol: ShortName = always("Symbol", "Name of the value.")
    value: Integer = always("Value", "Its number.")


class Unit(WireModel):
    """A unit."""

    name: ShortName = always("Name", "Short name of the unit.")
    display_name: UnitKey = always("DisplayName", "Unit as the catalogue has it: km/h.")


class CompuMethod(WireModel):
    """Meaning of the numbers of a datatype. Values travel in the unit of the catalogue: no number is scaled."""

    name: ShortName = always("Name", "Name of the method.")
    category: Literal["IDENTICAL", "LINEAR", "TEXTTABLE"] = always(
        "Category", "IDENTICAL: the number itself; LINEAR: scaled; TEXTTABLE: an enumeration."
    )
    unit: ShortName | None = own("Unit", "Name of the unit.")
    factor: NumberText | None = own(
        "Factor", "Value = number × factor + offset; exact: a decimal number or a fraction."
    )
    offset: NumberText | None = own("Offset", "Offset of that.")
    symbols: Listed[Symbol] | None = own("Symbols", "Values of an enumeration.")


class DataConstraint(WireModel):
    """The range of a datatype."""

    name: ShortName = always("Name", "Name of the constraint.")
    min: Number | None = own("Min", "Smallest value, in the unit of the datatype.")
    max: Number | None = own("Max", "Largest value.")


class TypeMember(WireModel):
    """A member of a structure."""

    name: ShortName = always("Name", "Name of the member.")
    type: ShortName = always(
        "Type", "Name of its datatype: an implementation type in one of these, an application type else."
    )
    description: Text | None = own("Description", "What the member means.")


class ImplementationType(WireModel):
    """A datatype of the code, as the RTE generates it into Rte_Type.h."""

    name: ShortName = always("Name", "Name of the datatype, which is its name in C.")
    category: Literal["VALUE", "TYPE_REFERENCE", "ARRAY", "STRUCTURE"] = always(
        "Category",
        "VALUE: a platform type, which the vendor has; TYPE_REFERENCE: another name for one; ARRAY, STRUCTURE.",
    )
    base: ShortName | None = own(
        "Base", "Platform type of a value (uint8, sint16, float32, boolean, ...), or the one that is referred to."
    )
    element: ShortName | None = own("ElementType", "Implementation type of the elements of an array.")
    length: Integer | None = own("Length", "Elements of an array.")
    members: Listed[TypeMember] | None = own("Members", "Members of a structure, in order.")
    compu_method: ShortName | None = own("CompuMethod", "Name of the method of an enumeration.")
    literal_prefix: CIdentifier | None = own(
        "LiteralPrefix", "What the names of its values begin with in C, where two enumerations may have one name."
    )
    reference: ShortName | None = own("TypeRef", "Reference in Function JSON.")


class ApplicationType(WireModel):
    """Meaning of the values of a data element: unit, range, names."""

    name: ShortName = always("Name", "Name of the datatype.")
    category: Literal["VALUE", "BOOLEAN", "ARRAY", "STRUCTURE"] = always(
        "Category", "VALUE, BOOLEAN, ARRAY or STRUCTURE."
    )
    implementation: ShortName = always("ImplementationType", "Name of the datatype of the code that it is mapped to.")
    compu_method: ShortName | None = own("CompuMethod", "Name of the method; absent for arrays and structures.")
    constraint: ShortName | None = own("DataConstraint", "Name of the range.")
    unit: ShortName | None = own("Unit", "Name of the unit.")
    element: ShortName | None = own("ElementType", "Application type of the elements of an array.")
    length: Integer | None = own("Length", "Elements of an array.")
    members: Listed[TypeMember] | None = own("Members", "Members of a structure, in order.")
    description: Text | None = own("Description", "What the values mean.")


class ModeNumber(WireModel):
    """A mode of a group."""

    name: ShortName = always("Name", "Name of the mode.")
    value: Integer = always("Value", "Number of the mode, which the core takes and gives.")


class ModeGroup(WireModel):
    """A mode declaration group: the modes of an interface."""

    name: ShortName = always("Name", "Name of the group.")
    modes: Listed[ModeNumber] = always("Modes", "Modes, in the order of the declaration.")
    initial: ShortName = always("InitialMode", "Mode in which the mode machine starts.")
    type: ShortName = always("Type", "Implementation type that holds a mode.")
    on_transition: Integer = always("OnTransitionValue", "Number that Rte_Mode returns during a transition.")


# -- port interfaces ----------------------------------------------------------------------------------------------


Kind = Literal["SenderReceiver", "ClientServer", "ModeSwitch", "Parameter"]
"""Kind of a port interface."""


class DataElement(WireModel):
    """A variable of a sender-receiver interface, or a parameter of a parameter interface."""

    name: ShortName = always("Name", "Name of the element.")
    type: ShortName = always("Type", "Name of its application type; of an implementation type where there is none.")
    description: Text | None = own("Description", "What the value means.")
    queued: bool | None = own("Queued", "Whether values are queued; each is then an event that is not lost.")
    vss_path: VssPath | None = own("VssPath", "Path in the catalogue.")
    unit: UnitKey | None = own("Unit", "Unit in which the value is sent, as the catalogue has it.")


class SenderReceiverInterface(WireModel):
    """Data that one component sends and others receive."""

    name: ShortName = always("Name", "Name of the interface.")
    elements: Listed[DataElement] = always("Elements", "Data elements.")
    description: Text | None = own("Description", "What it carries.")


class ParameterInterface(WireModel):
    """Calibration parameters."""

    name: ShortName = always("Name", "Name of the interface.")
    elements: Listed[DataElement] = always("Elements", "Parameters.")


class OperationArgument(WireModel):
    """An argument of an operation."""

    name: ShortName = always("Name", "Name of the argument.")
    type: ShortName = always("Type", "Name of its implementation type.")
    direction: Literal["IN", "OUT", "INOUT"] = always("Direction", "IN, OUT or INOUT.")
    unit: UnitKey | None = own("Unit", "Unit of the value.")


class ApplicationError(WireModel):
    """An error that an operation can return."""

    name: ShortName = always("Name", "Name of the error.")
    value: Integer = always("Value", "Its number: 1 to 63.")


class Operation(WireModel):
    """An operation of a client-server interface."""

    name: ShortName = always("Name", "Name of the operation.")
    arguments: Listed[OperationArgument] = always("Arguments", "Arguments, in order.")
    errors: Listed[Name] | None = own("PossibleErrors", "Names of the errors that it can return.")
    description: Text | None = own("Description", "What it does.")


class ClientServerInterface(WireModel):
    """Operations that one component offers and others call; or a service of the base software."""

    name: ShortName = always("Name", "Name of the interface.")
    operations: Listed[Operation] = always("Operations", "Operations.")
    errors: Listed[ApplicationError] | None = own("ApplicationErrors", "Errors that operations return.")
    service: Name | None = own(
        "ServiceKind",
        "Module of the base software that offers it: DiagnosticEventManager, NvRamManager, WatchdogManager, FunctionInhibitionManager; "
        "absent if a component does.",
    )


class ModeSwitchInterface(WireModel):
    """A mode that one component switches and others follow."""

    name: ShortName = always("Name", "Name of the interface.")
    group: ShortName = always("ModeGroup", "Name of its mode declaration group.")
    prototype: ShortName = always(
        "Prototype", "Name of the mode within the interface, as in Rte_Mode_<port>_<prototype>."
    )
    service: Name | None = own("ServiceKind", "Module of the base software that switches it: EcuManager.")


# -- ports --------------------------------------------------------------------------------------------------------


class Use(WireModel):
    """An interface of the function for an element of a port."""

    interface: InterfaceName = always("Interface", "Name of the interface in the function.")
    kind: Literal["signal", "queue", "method", "parameter", "error", "safety reaction", "mode"] = always(
        "Kind", "Which of its lists it is in."
    )
    function: FunctionName = always("Function", "Name of the function that has the port.")
    call: CallName | None = own("Call", "Call that has it; absent for modes.")
    timeout: Number | None = own("Timeout", "Longest age of a value: the core checks it, not COM.", unit="ms")


Messages = Annotated[Integer, Field(ge=0, le=255)]
"""A number of messages: AUTOSAR counts them in 8 bits."""


class E2eWindow(WireModel):
    """Messages that a state of the end-to-end state machine counts."""

    size: Annotated[Integer, Field(ge=1, le=255)] = always("WindowSize", "Last messages that count.")
    min_ok: Messages = always("MinOkState", "Fewest of them that passed.")
    max_error: Messages = always("MaxErrorState", "Most of them with an error.")


class E2eWindows(WireModel):
    """Windows of the states of the end-to-end state machine."""

    init: E2eWindow = always("Init", "Window of INIT.")
    valid: E2eWindow = always("Valid", "Window of VALID.")
    invalid: E2eWindow = always("Invalid", "Window of INVALID.")

    @property
    def sizes(self) -> frozenset[int]:
        """Sizes of the windows. Up to release 4.4.0 all states have one."""
        return frozenset(each.size for each in (self.init, self.valid, self.invalid))


class Element(WireModel):
    """Communication specification of a port for an element of its interface."""

    name: ShortName = always("Name", "Name of the data element, operation, mode or parameter.")
    init: AnyValue = own(
        "InitValue",
        "Value before the first one, in the unit of the interface: a number, a list, an object; of an enumeration its number.",
    )
    queue_length: Integer | None = own("QueueLength", "Values or calls that wait; absent if nothing is queued.")
    never_received: bool | None = own("HandleNeverReceived", "Whether the RTE tells that no value has come yet.")
    update: bool | None = own("EnableUpdate", "Whether Rte_IsUpdated tells the core what is fresh.")
    alive_timeout: Number | None = own("AliveTimeout", "Time-out of COM: 0, since the core has its own.", unit="s")
    transformer_errors: bool | None = own(
        "TransformerErrors", "Whether the RTE reports what end-to-end protection has rejected, for the core."
    )
    windows: E2eWindows | None = own("E2eWindows", "Windows of the state machine that checks the received data.")
    uses: Listed[Use] | None = own("Uses", "Interfaces of the function behind it.")


class Port(WireModel):
    """A port prototype of a component."""

    name: ShortName = always("Name", "Name of the port.")
    direction: Literal["Required", "Provided"] = always("Direction", "Required or Provided.")
    kind: Kind = always("Kind", "Kind of its interface.")
    interface: ShortName = always("Interface", "Name of its interface.")
    elements: Listed[Element] = always("Elements", "Elements that are used, with their attributes.")
    service: Name | None = own(
        "ServiceKind", "Module of the base software that it is connected to, if it is a service port."
    )
    description: Text | None = own("Description", "What goes through it.")

    @property
    def reports_transformer_errors(self) -> bool:
        """Whether its functions have the argument for transformer errors: AUTOSAR has one option for all elements of a port."""
        return any(element.transformer_errors for element in self.elements)


# -- internal behaviour -------------------------------------------------------------------------------------------


AccessKind = Literal[
    "ImplicitRead",
    "ExplicitRead",
    "QueuedReceive",
    "ExplicitWrite",
    "QueuedSend",
    "Mode",
    "ModeSwitch",
    "SynchronousCall",
    "AsynchronousCall",
    "Result",
    "Parameter",
    "InternalTrigger",
]
"""ImplicitRead: Rte_IRead, Rte_IStatus; ExplicitRead: Rte_Read, Rte_IsUpdated; QueuedReceive: Rte_Receive;
ExplicitWrite: Rte_Write; QueuedSend: Rte_Send; Mode: Rte_Mode; ModeSwitch: Rte_Switch; SynchronousCall,
AsynchronousCall: Rte_Call; Result: Rte_Result; Parameter: Rte_Prm; InternalTrigger: Rte_IrTrigger."""


class Access(WireModel):
    """A runnable's access to an element of a port; its kind decides which functions the RTE provides."""

    name: ShortName = always("Name", "Name of the access point, unique in the runnable.")
    kind: AccessKind = always("Kind", "Kind of access, which decides the functions of the RTE.")
    port: ShortName | None = own("Port", "Name of the port; absent for an internal trigger.")
    element: ShortName = always(
        "Element", "Name of the element, operation or mode prototype; of an internal trigger its runnable."
    )
    reason: Text | None = own("Reason", "Why it is accessed this way.")


class Runnable(WireModel):
    """A function in C that the RTE starts."""

    name: ShortName = always("Name", "Name of the runnable.")
    symbol: CIdentifier = always("Symbol", "Name of the function in C, unique on the ECU.")
    role: Literal["Init", "Step", "Method", "Receive", "Supervise", "JudgeWindows", "Answer", "Terminate"] = always(
        "Role", "What it does with the core."
    )
    call: CallName | None = own("Call", "Call of the function that it runs; absent where it runs none.")
    method: MethodName | None = own("Method", "Method of the function that it offers, or whose answer it takes.")
    description: Text | None = own("Description", "What it does.")
    concurrent: bool = always("CanBeInvokedConcurrently", "Whether it may run twice at the same time.")
    minimum_start_interval: Number = always("MinimumStartInterval", "Shortest time between two starts.", unit="s")
    accesses: Listed[Access] = always("Accesses", "What it does with ports.")
    exclusive_areas: Listed[ShortName] = always("ExclusiveAreas", "Exclusive areas that it enters.")
    parameters: Listed[ShortName] | None = own("Parameters", "Internal calibration parameters that it reads.")
    stack_size: Integer | None = own("StackSize", "Stack that the call needs.", unit="bytes")
    asil_level: Name | None = own("AsilLevel", "ASIL that it is implemented to.")
    section: ShortName = always("Section", "Memory section of its code: CODE, or with its ASIL.")


class Event(WireModel):
    """An event that starts a runnable."""

    name: ShortName = always("Name", "Name of the event.")
    kind: Literal[
        "Init", "Timing", "DataReceived", "ModeSwitch", "OperationInvoked", "CallReturns", "InternalTrigger"
    ] = always("Kind", "Kind of the event.")
    runnable: ShortName = always("Runnable", "Runnable that it starts.")
    period: Number | None = own("Period", "Period of a timing event.", unit="s")
    offset: Number | None = own("Offset", "Offset of a timing event.", unit="s")
    port: ShortName | None = own("Port", "Port that receives, calls or switches.")
    element: ShortName | None = own(
        "Element", "Data element, operation or mode prototype; of an internal trigger its access point."
    )
    source: ShortName | None = own("Source", "Runnable that has the access point which triggers or whose call returns.")
    mode: ShortName | None = own("Mode", "Mode that is entered or left.")
    activation: Literal["OnEntry", "OnExit"] | None = own("Activation", "OnEntry or OnExit of the mode.")


class ExclusiveArea(WireModel):
    """An area that only one runnable is in at a time."""

    name: ShortName = always("Name", "Name of the area, as in Rte_Enter_<name>.")
    description: Text = always("Description", "What it protects.")


class PerInstanceMemory(WireModel):
    """Memory of the component that the RTE holds, in a datatype of C."""

    name: ShortName = always("Name", "Name of the memory, as in Rte_Pim_<name>.")
    type: CIdentifier = always("Type", "Datatype of C.")
    type_definition: CIdentifier = always("TypeDefinition", "What the type is defined as, in C.")
    header: SourceFile | None = own("Header", "Header that defines it.")
    description: Text = always("Description", "What it holds.")


class InternalParameter(WireModel):
    """A calibration parameter that stays within the component."""

    name: ShortName = always("Name", "Name of the parameter, as in Rte_CData_<name>.")
    type: ShortName = always("Type", "Name of its application type.")
    init: object = own("InitValue", "Its value.")
    uses: Listed[ParameterName] = always("Uses", "Names of the parameters of the function behind it.")


class MemorySection(WireModel):
    """A section into which code or variables of the component are placed."""

    name: ShortName = always("Name", "Name, as in <Component>_START_SEC_<name>.")
    kind: Literal["CODE", "VAR_CLEARED", "VAR_INIT", "CONST", "CALIB"] = always("Kind", "What is in it.")
    asil_level: Name = always("AsilLevel", "ASIL of its content: QM, A, B, C or D.")
    alignment: Literal["UNSPECIFIED", "8", "32", "BOOLEAN"] = always("Alignment", "Alignment in bits.")
    stack_size: Integer | None = own("StackSize", "Largest stack that a runnable in it needs.", unit="bytes")


# -- service needs ------------------------------------------------------------------------------------------------


class NvBlock(WireModel):
    """A block of the NVRAM manager."""

    name: ShortName = always("Name", "Name of the need.")
    memory: ShortName = always("PerInstanceMemory", "Memory of the component that is its RAM block.")
    port: ShortName = always("Port", "Service port through which its state is asked and set.")
    parameters: Listed[ParameterName] = always("Parameters", "Parameters whose values are kept in it.")
    errors: Listed[ErrorName] = always("Errors", "Errors whose counts are kept in it.")
    reliability: Literal["NO-PROTECTION", "ERROR-DETECTION", "ERROR-CORRECTION"] = always(
        "Reliability", "How it is protected: a checksum, and a second copy above QM."
    )
    restore_at_start: bool = always("RestoreAtStart", "Whether it is read before the component starts.")
    store_at_shutdown: bool = always("StoreAtShutdown", "Whether it is written when the ECU shuts down.")
    asil_level: Name = always("AsilLevel", "Highest ASIL of its content.")


class DiagnosticEvent(WireModel):
    """An event of the diagnostic event manager: an error of the function."""

    name: ShortName = always("Name", "Name of the need.")
    error: ErrorName = always("Error", "Name of the error interface.")
    port: ShortName = always("Port", "Service port through which its status is set.")
    debouncing: Literal["MonitorInternal"] = always("Debouncing", "MonitorInternal: the core has matured it.")
    description: Text | None = own("Description", "Meaning of the error.")
    severity: Text | None = own("Severity", "What the error leads to.")
    occurrence_limit: Integer | None = own("OccurrenceCountLimit", "How often it has to occur to be confirmed.")
    ignition_limit: Integer | None = own("IgnitionCountLimit", "Ignition cycles after which it is confirmed.")
    asil_level: Name | None = own("AsilLevel", "ASIL of the error.")


class Inhibition(WireModel):
    """A function identifier of the function inhibition manager: others ask whether it may run."""

    name: ShortName = always("Name", "Name of the function identifier.")
    condition: Name = always("Condition", "Safety condition that it represents.")
    events: Listed[ErrorName] = always("Events", "Errors, each of which takes the permission away while it is failed.")
    mask: Literal["LAST_FAILED"] = always("Mask", "LAST_FAILED: while the last test has failed.")


class AliveSupervision(WireModel):
    """Alive supervision of an entity, as the watchdog manager takes it."""

    checkpoint: ShortName = always("Checkpoint", "Checkpoint that is counted.")
    expected: Integer = always("ExpectedIndications", "Indications in a reference cycle.")
    min_margin: Integer = always("MinMargin", "Indications that may be missing.")
    max_margin: Integer = always("MaxMargin", "Indications that may be too many.")
    reference_cycle: Number = always("ReferenceCycle", "Time in which indications are counted.", unit="s")
    error: ErrorName = always("Error", "Error that the core sets when a limit is broken.")


class DeadlineSupervision(WireModel):
    """Deadline supervision between two checkpoints."""

    start: ShortName = always("Start", "Checkpoint at which the time begins.")
    end: ShortName = always("End", "Checkpoint at which it ends.")
    min: Number = always("Min", "Shortest time.", unit="s")
    max: Number = always("Max", "Longest time.", unit="s")
    error: ErrorName = always("Error", "Error that the core sets when a limit is broken.")


class LogicalTransition(WireModel):
    """Two checkpoints, one of which may follow the other."""

    source: ShortName = always("Source", "Checkpoint before.")
    target: ShortName = always("Target", "Checkpoint after.")


class Checkpoint(WireModel):
    """A place in the flow of a supervised entity."""

    name: ShortName = always("Name", "Name of the checkpoint.")
    number: Integer = always("Number", "Its number.")
    port: ShortName = always("Port", "Service port through which it is reported.")
    call: CallName = always("Call", "Call that reports it.")
    moment: Literal["Begin", "End"] = always("Moment", "When: before the call, or after it.")
    initial: bool | None = own("Initial", "Whether a sequence begins with it.")
    final: bool | None = own("Final", "Whether a sequence may end with it.")


class SupervisedEntity(WireModel):
    """A supervised entity of the watchdog manager."""

    name: ShortName = always("Name", "Name of the entity.")
    checkpoints: Listed[Checkpoint] = always("Checkpoints", "Checkpoints.")
    alive: Listed[AliveSupervision] = always("Alive", "Alive supervisions.")
    deadlines: Listed[DeadlineSupervision] = always("Deadline", "Deadline supervisions.")
    transitions: Listed[LogicalTransition] = always("Logical", "Transitions of the logical supervision.")


# -- the components together --------------------------------------------------------------------------------------


class Prototype(WireModel):
    """A component of the composition."""

    name: ShortName = always("Name", "Name of the component prototype.")
    type: ShortName = always("Type", "Name of the component type.")


class OuterPort(WireModel):
    """A port of the composition: data from outside of the set, or to it."""

    name: ShortName = always("Name", "Name of the port.")
    direction: Literal["Required", "Provided"] = always("Direction", "Required or Provided.")
    kind: Kind = always("Kind", "Kind of its interface.")
    interface: ShortName = always("Interface", "Name of its interface.")
    init: AnyValue = own("InitValue", "Value before the first one, of the data element that the interface has.")
    provider: Text | None = own("ExternalProvider", "Who provides it, as the functions or the deployment say.")


class PortReference(WireModel):
    """A port of a component of the composition."""

    component: ShortName = always("Component", "Name of the component prototype.")
    port: ShortName = always("Port", "Name of its port.")


class Assembly(WireModel):
    """A connection between two components."""

    name: ShortName = always("Name", "Name of the connector.")
    provider: PortReference = always("Provider", "The port that provides.")
    requester: PortReference = always("Requester", "The port that requires.")


class Delegation(WireModel):
    """A connection between a component and a port of the composition."""

    name: ShortName = always("Name", "Name of the connector.")
    inner: PortReference = always("Inner", "The port of the component.")
    outer: ShortName = always("Outer", "Name of the port of the composition.")


class Composition(WireModel):
    """The components and how they are connected."""

    name: ShortName = always("Name", "Name of the composition.")
    prototypes: Listed[Prototype] = always("Components", "Components.")
    ports: Listed[OuterPort] = always("Ports", "Ports to the outside.")
    assemblies: Listed[Assembly] = always("Assemblies", "Connections between components.")
    delegations: Listed[Delegation] = always("Delegations", "Connections to the outside.")


class SystemSignal(WireModel):
    """A data element of the composition that travels over a bus."""

    port: ShortName = always("Port", "Port of the composition.")
    element: ShortName = always("Element", "Data element.")
    signal: ShortName = always("SystemSignal", "Name of the system signal.")
    message: ShortName | None = own("Message", "Message of the CAN database that has it.")
    database: Text | None = own("Database", "File name of the database.")
    length: Integer | None = own("Length", "Length of the signal.", unit="bits")


class TaskEvent(WireModel):
    """An event that is mapped to a task."""

    component: ShortName = always("Component", "Name of the component prototype.")
    event: ShortName = always("Event", "Name of the event.")
    position: Integer = always("Position", "Place of the event in the task, from 1: no two have one.")


class Task(WireModel):
    """A task of the operating system: a proposal from cycles and priorities."""

    name: ShortName = always("Name", "Name of the task.")
    priority: Integer = always("Priority", "Priority; a higher number runs first.")
    preemptable: bool = always("Preemptable", "Whether others may interrupt it.")
    period: Number | None = own("Period", "Period, if it is cyclic.", unit="s")
    offset: Number | None = own("Offset", "Offset of the first activation.", unit="s")
    stack_size: Integer | None = own("StackSize", "Largest stack that one of its runnables needs.", unit="bytes")
    events: Listed[TaskEvent] = always("Events", "Events, in the order in which their runnables run.")
    reason: Text = always("Reason", "What led to it.")


class InitBatch(WireModel):
    """Runnables that run one after the other before anything else does: `Rte_Init_<Name>`, which the ECU's state manager calls."""

    name: ShortName = always("Name", "Name of the batch.")
    events: Listed[TaskEvent] = always("Events", "Init events, in the order in which their runnables run.")
    reason: Text = always("Reason", "What led to it.")


class Ecu(WireModel):
    """The ECU that runs the components."""

    name: ShortName = always("Name", "Name of the ECU.")
    signals: Listed[SystemSignal] = always("Signals", "Data elements that travel over a bus.")
    init_batches: Listed[InitBatch] = always("InitBatches", "What runs before the tasks do.", default=())
    tasks: Listed[Task] = always("Tasks", "Tasks, the highest priority first.")


# -- the document -------------------------------------------------------------------------------------------------


class MetaInformation(WireModel):
    """Responsible team of the document, and its version."""

    authority: Text = always("Authority", "Organization that the document belongs to.")
    author: Text = always("Author", "Author of the document.")
    date: Annotated[str, Field(pattern=r"^\d{4}-\d{2}-\d{2}$"), DATE] = always("Date", "Date of the document.")
    version: Annotated[str, Field(pattern=r"^\d+\.\d+\.\d+$"), VERSION] = always("Version", "Version of the document.")


class ApplicationInformation(WireModel):
    """Identity of the application: a function, or a set of them."""

    name: Name = always("Name", "Name of the application.")
    responsible: Text = always("Responsible", "Who answers for it.")
    description: Text = always("Description", "What it does.")
    functions: Listed[FunctionName] = always("Functions", "Names of the functions.")


class Component(WireModel):
    """A software component type: a component of a function."""

    name: ShortName = always("Name", "Name of the component type.")
    kind: Literal["Application"] = always("Kind", "Application.")
    function: FunctionName = always("Function", "Name of the function.")
    version: Version | None = own("Version", "Version of the function.")
    description: Text | None = own("Description", "What the function does.")
    ports: Listed[Port] = always("Ports", "Ports, by name.")
    runnables: Listed[Runnable] = always("Runnables", "Runnables.")
    events: Listed[Event] = always("Events", "What starts them.")
    exclusive_areas: Listed[ExclusiveArea] = always("ExclusiveAreas", "Exclusive areas.")
    memories: Listed[PerInstanceMemory] = always("PerInstanceMemories", "Memories.")
    parameters: Listed[InternalParameter] = always("InternalParameters", "Internal parameters.")
    nv_blocks: Listed[NvBlock] = always("NvBlocks", "Blocks of the NVRAM manager.")
    diagnostic_events: Listed[DiagnosticEvent] = always("DiagnosticEvents", "Events of the DEM.")
    supervised_entities: Listed[SupervisedEntity] = always(
        "SupervisedEntities", "Supervised entities of the watchdog manager."
    )
    inhibitions: Listed[Inhibition] = always("Inhibitions", "Function identifiers that its safety conditions inhibit.")
    sections: Listed[MemorySection] = always("MemorySections", "Memory sections.")
    asil_level: Name = always("AsilLevel", "Highest ASIL of its calls and interfaces.")
    code: CodeInterface | None = own("Code", "How the code of the function is compiled and called.")


class ParameterComponent(WireModel):
    """A component that has nothing but the values of calibration parameters."""

    name: ShortName = always("Name", "Name of the component type.")
    ports: Listed[Port] = always("Ports", "Ports that provide parameters.")


class ClassicDeployment(WireModel):
    """Settings of ARXML and code besides the elements, as the deployment file has them."""

    package: ShortName = always("Package", "Outermost package of the ARXML.")
    release: ReleaseName = always("Release", "Release of AUTOSAR that the ARXML is of.", default=DEFAULT_RELEASE)
    tick: Integer = always("Tick", "Period of the counter that starts timing events.", unit="µs")


class ClassicIntegration(WireModel):
    """The whole document."""

    meta: MetaInformation = always("MetaInformation", "Who is responsible, and the version.")
    info: ApplicationInformation = always("ApplicationInformation", "Identity of the application.")
    deployment: ClassicDeployment = always("ClassicDeployment", "What ARXML and code take beside the elements.")
    units: Listed[Unit] = always("Units", "Units, by name.")
    compu_methods: Listed[CompuMethod] = always("CompuMethods", "What numbers mean, by name.")
    constraints: Listed[DataConstraint] = always("DataConstraints", "Ranges, by name.")
    implementation_types: Listed[ImplementationType] = always(
        "ImplementationTypes", "Datatypes of the code, each after those that it has in it."
    )
    application_types: Listed[ApplicationType] = always(
        "ApplicationTypes", "What values mean, each after those that it has in it."
    )
    mode_groups: Listed[ModeGroup] = always("ModeGroups", "Mode declaration groups, by name.")
    sender_receiver_interfaces: Listed[SenderReceiverInterface] = always("SenderReceiverInterfaces", "Data, by name.")
    client_server_interfaces: Listed[ClientServerInterface] = always("ClientServerInterfaces", "Operations, by name.")
    mode_switch_interfaces: Listed[ModeSwitchInterface] = always("ModeSwitchInterfaces", "Modes, by name.")
    parameter_interfaces: Listed[ParameterInterface] = always("ParameterInterfaces", "Calibration parameters, by name.")
    components: Listed[Component] = always("Components", "Component types, by name.")
    parameter_components: Listed[ParameterComponent] = always(
        "ParameterComponents", "Component types with parameter values, by name."
    )
    composition: Composition = always("Composition", "How components are connected.")
    ecu: Ecu = always("Ecu", "The ECU, its signals and tasks.")
    provenance: Listed[dict[Name, Carried]] | None = own("Provenance", "What each function was made from.")
    functions: tuple[FunctionJson, ...] | None = source_functions()
