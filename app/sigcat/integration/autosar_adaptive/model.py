"""Integration JSON for AUTOSAR adaptive: the authors' published schema and a superset of it.

What the published schema lacks is added as optional fields; source says which is which. Where a function's own
interface is carried on, it stands inside as it is in Function JSON, so that no field of it can be lost.
"""

from collections.abc import Callable, Iterator
from typing import Annotated, Any, Self

from pydantic import Field

from sigcat.function.document.field_types import (
    DATE,
    NAME,
    VERSION,
    CallName,
    Carried,
    CDefinition,
    CExpression,
    FunctionName,
    Name,
    NumberText,
    Quantity,
    ServiceEvent,
    ShortName,
    SourceFile,
    UnitKey,
    Version,
    VssDatatype,
    VssPath,
    Words,
)
from sigcat.function.document.text import Text
from sigcat.function.function_json.code import CodeInterface
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.interfaces.methods import Argument
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Watchdog
from sigcat.function.function_json.wire import OWN, Integer, Listed, Number, WireModel, always, described, own
from sigcat.integration.autosar_adaptive.code import CallCode, MethodUse, ParameterCode
from sigcat.integration.autosar_adaptive.deployment.namespaces import DEFAULT_HEADER_FOLDERS, HeaderFolders, Namespace
from sigcat.integration.autosar_adaptive.deployment.releases import DEFAULT_RELEASE, ReleaseName
from sigcat.integration.autosar_adaptive.deployment.someip_settings import (
    DEFAULT_SERVICE_DISCOVERY,
    DEFAULT_TRANSFORMATION,
    ServiceDiscoverySettings,
    TransformationSettings,
)
from sigcat.integration.autosar_adaptive.deployment.transport import TransportSettings
from sigcat.integration.autosar_adaptive.e2e import E2eProtection
from sigcat.integration.autosar_adaptive.startup import StartupSettings, Wish
from sigcat.integration.autosar_si_units import UnitSettings
from sigcat.integration.grouping import grouped
from sigcat.integration.source_functions import source_functions

ADAPTIVE = "published integration schema for AUTOSAR adaptive"


def published(alias: str, description: str, **more: Any) -> Any:
    """A field of the published schema."""
    return described(alias, description, source=ADAPTIVE, **more)


class MetaInformation(WireModel):
    """Responsible team of the document, and its version."""

    authority: Text = published("Authority", "Organization that the document belongs to.")
    author: Text = published("Author", "Author of the document.")
    date: Annotated[str, Field(pattern=r"^\d{4}-\d{2}-\d{2}$"), DATE] = published("Date", "Date of the document.")
    version: Annotated[str, Field(pattern=r"^\d+\.\d+\.\d+$"), VERSION] = published(
        "Version", "Version of the document."
    )


class FunctionInformation(WireModel):
    """Identity of the application: a function, or a set of them."""

    name: Name = published("FunctionName", "Name of the application.")
    responsible: Text = published("Responsible", "Who answers for it.")
    description: Text = published("Description", "What it does.")
    functions: Listed[FunctionName] | None = own("Functions", "Names of the functions.")


class Call(WireModel):
    """A call of a function: init, a step, terminate."""

    name: CallName = published("Name", "Name of the call.")
    modes: Listed[Name] = published("Modes", "Function group modes in which it runs.")
    run_type: Name = published("RunType", "Init, Cyclic or Terminate.")
    cycle_time: Number | None = published("CycleTime", "Time from one call to the next.", unit="ms")
    scheduling: Name | None = published("Scheduling", "Preemptive or Non-preemptive.")
    function: FunctionName | None = own("Function", "Name of the function that it belongs to.")
    description: Text | None = own("Description", "What the call does.")
    trigger: Name | None = own("Trigger", "Event, where the call is not cyclic but triggered by events.")
    events: Name | None = own("EventList", "Events that trigger the call.")
    triggers: Listed[ServiceEvent] | None = own("Triggers", "Events whose values trigger the call, as `Service/Event`.")
    function_modes: Listed[Name] | None = own("FunctionModes", "Modes of the function in which the call runs.")
    previous_runnable: Name | None = own("PrevRunnable", "Call after which this one runs.")
    execution_offset: Quantity | None = own("ExecOffset", "Offset of the first call.", unit="ms")
    debounce_delay: Quantity | None = own("DebounceDelay", "Shortest time between two calls.", unit="ms")
    priority: Words | None = own("Priority", "Priority relative to other calls; a higher number runs first.")
    parallel_processing: bool | None = own("ParallelProcessing", "Whether calls may run at the same time.")
    stack_size: Quantity | None = own("StackSize", "Stack that the call needs.", unit="bytes")
    asil_level: Name | None = own("AsilLevel", "ASIL that the call is implemented to.")
    supervision_types: Listed[Name] | None = own("SupervisionType", "Alive, Deadline, Logical.")
    watchdog: Watchdog | None = own("Watchdog", "Supervision by the watchdog.")
    contracts: Listed[Name] | None = own("ContractTypes", "How data is handed over to the code.")
    code: CallCode | None = own("Code", "The call in C.")
    vss_path: VssPath | None = own("VssPath", "Path of the interface in the catalogue.")


class StructField(WireModel):
    """A member of a structure."""

    name: Name = published("Name", "Name of the member.")
    type: Name = published("Type", "Word for a primitive, or the name of a datatype of the document.")
    unit: UnitKey | None = own("Unit", "Unit of the member.")
    description: Text | None = own("Description", "What the member means.")
    min: Number | None = own("MinValue", "Smallest value of the member.")
    max: Number | None = own("MaxValue", "Largest value of the member.")


class Symbol(WireModel):
    """A named value of an enumeration."""

    symbol: Name = published("Symbol", "Name of the value.")
    value: Integer = published("Value", "Its number.")


class TypeEntry(WireModel):
    """A datatype of the document: type_reference, structure, array or enumeration, as `Class` says.

    The published schema has no array of anything but numbers; such an array is written with its element as the only
    member, which that schema takes for a structure.
    """

    name: Name = published("Name", "Name of the datatype.")
    kind: Name = published("Class", "type_reference, structure, array or enumeration.")
    c_definition: Name | None = published("cDef", "Word for the primitive that is referred to.", default=None)
    type: Name | None = published("Type", "Word for the numbers of an array.", default=None)
    dimension: Integer | Name | None = published(
        "Dimension", "Number of elements of an array; `dynamic` if that is open.", default=None
    )
    fields: Listed[StructField] | None = published("Field", "Members, in order.", default=None)
    reference: Name | None = published("TypeRef", "Reference in Function JSON.", default=None)
    symbols: Listed[Symbol] | None = published("EnumField", "Values, in order.", default=None)
    storage: Name | None = own("StorageType", "Word for the integer that holds an enumeration.")
    vss_datatype: VssDatatype | None = own("VssDatatype", "Datatype of VSS, or path of the struct.")
    description: Text | None = own("Description", "What a struct is.")

    @property
    def is_open(self) -> bool:
        """Whether it is an array of open length."""
        return self.kind == "array" and not isinstance(self.dimension, int)

    @property
    def element(self) -> str:
        """Type of the elements of an array."""
        return self.type or (self.fields[0].type if self.fields else "")


class ParameterType(WireModel):
    """Datatype, range and values of a parameter, in one of the forms of the published schema."""

    datatype: Name | None = published("Datatype", "Word for a number, or boolean.", default=None)
    text_datatype: Name | None = published("DataType", "string.", default=None)
    name: Name | None = published("Name", "Name of a structure, array or enumeration.", default=None)
    kind: Name | None = published("Class", "structure.", default=None)
    fields: Listed[StructField] | None = published("Field", "Members.", default=None)
    reference: Name | None = published("TypeRef", "Name of a datatype of the document.", default=None)
    min: Number | None = published("MinValue", "Smallest valid value.", default=None)
    max: Number | None = published("MaxValue", "Largest valid value.", default=None)
    offset: Number | None = published("Offset", "Offset of the scaling.", default=None)
    scaling: Number | None = published("Scaling", "Factor of the scaling.", default=None)
    unit: UnitKey | None = published("Unit", "Unit of the value; empty if it has none.", default=None)
    default: bool | Number | Text | None = published("Default", "Value of a new vehicle.", default=None)
    init_value: bool | Number | Text | None = published("InitValue", "Value at start-up.", default=None)

    @property
    def word(self) -> str:
        """Word for a primitive, or the name of a datatype of the document."""
        word = self.reference or self.datatype or self.text_datatype or self.name or "uint8_t"
        return "bool" if word == "boolean" else word


class ParameterEntry(WireModel):
    """A value that is set before the function runs, or that it learns and keeps."""

    name: Name = published("Name", "Name of the parameter.")
    description: Text = published("Description", "What the value means.")
    datatype: ParameterType = published("Datatype", "Datatype, range and values.")
    range_error_action: Name | None = published("RangeErrorAction", "What replaces a value out of range.")
    interface_type: Name = published("InterfaceType", "Storage class: PersistanceMemory, Calibration or Measurement.")
    attribute: Name = published("Attribute", "NA, Normal or LearningParameter.")
    function: FunctionName | None = own("Function", "Name of the function.")
    calls: Listed[CallName] | None = own("Calls", "Names of the calls that use it.")
    asil_level: Name | None = own("AsilLevel", "ASIL: QM, A, B, C or D.")
    code_datatype: CDefinition | None = own("CodeDatatype", "Datatype of the C code.")
    variable: CExpression | None = own("Variable", "Expression of the C code that holds the value.")
    vss_path: VssPath | None = own("VssPath", "Path of the parameter in the catalogue.")
    vss_datatype: VssDatatype | None = own("VssDatatype", "Datatype in the catalogue.")
    vss_unit: UnitKey | None = own("VssUnit", "Unit in the catalogue.")
    vss_symbols: Listed[Symbol] | None = own(
        "VssSymbols", "Numbers of an enumeration in the catalogue, where the code has others."
    )
    conversion_factor: NumberText | None = own(
        "ConversionFactor", "Value in the catalogue's unit = value × factor + offset."
    )
    conversion_offset: NumberText | None = own("ConversionOffset", "Offset of the conversion, in the catalogue's unit.")
    code: ParameterCode | None = own("Code", "The parameter in C and in its storage.")


class Use(WireModel):
    """One call's side of an event: the interface of the function, and the datatype of its code."""

    function: FunctionName = always("Function", "Name of the function.")
    component: Name = always("Component", "Name of the component.")
    call: CallName = always("Call", "Name of the call.")
    code_datatype: CDefinition | None = own("CodeDatatype", "Datatype of the C code.")
    code_symbols: Listed[Symbol] | None = own(
        "CodeSymbols", "Numbers of an enumeration in the code, where others are sent."
    )
    signal: Signal | None = own("Signal", "The data interface as it is in Function JSON.")
    queue: DataQueue | None = own("Queue", "The queued data interface as it is in Function JSON.")

    @property
    def interface(self) -> Signal | DataQueue:
        """The existing one of the two."""
        assert self.signal or self.queue
        return self.signal or self.queue  # type: ignore[return-value]


class Event(WireModel):
    """A value that a service sends. It travels in the catalogue's datatype and unit, whatever the code of a side has."""

    name: Name = published("Name", "Name of the event, from the VSS path.")
    datatype: Name = published("DataType", "Word for a primitive, or the name of a datatype of the document.")
    data_mapping: Listed[CExpression] | None = published(
        "DataMappingList", "Expressions of the C code that hold the value."
    )
    description: Text | None = own("Description", "What the value means.")
    event_id: Integer | None = own("EventID", "SOME/IP id of the event.")
    event_group: Name | None = own("EventGroup", "Name of the event group.")
    unit: UnitKey | None = own("Unit", "Unit in which the value is sent.")
    min: Number | None = own("Min", "Smallest value, in that unit.")
    max: Number | None = own("Max", "Largest value, in that unit.")
    scaling: NumberText | None = own(
        "Scaling", "Factor, where the value is sent scaled: value = sent × factor + offset."
    )
    offset: NumberText | None = own("Offset", "Offset of that scaling.")
    cycle_time: Number | None = own("CycleTime", "Time from one value to the next.", unit="ms")
    protection: E2eProtection | None = own("E2eProtection", "How it is protected end to end, if it is.")
    segment_length: Annotated[Integer, Field(ge=16, le=1392, multiple_of=16)] | None = own(
        "SegmentLength", "Length of a segment of SOME/IP-TP, where a value may be longer than a datagram.", unit="bytes"
    )
    vss_path: VssPath | None = own("VssPath", "Path of the signal in the catalogue.")
    uses: Listed[Use] | None = own("Uses", "The sides of the event within this component.")


class MethodArgument(WireModel):
    """An argument or a return value of a method."""

    name: Name = always("Name", "Name of the argument.")
    datatype: Name = always("DataType", "Word for a primitive, or the name of a datatype of the document.")
    unit: UnitKey | None = own("Unit", "Unit of the value.")
    code_datatype: CDefinition | None = own("CodeDatatype", "Datatype of the C code.")
    argument: Argument | None = own("Argument", "The argument as it is in Function JSON.")


class Method(WireModel):
    """A call that a service offers."""

    name: Name = published("Name", "Name of the method.")
    description: Text | None = own("Description", "What it does.")
    method_id: Integer | None = own("MethodID", "SOME/IP id of the method.")
    inputs: Listed[MethodArgument] | None = own("InArguments", "Arguments, in order.")
    outputs: Listed[MethodArgument] | None = own("OutArguments", "Return values, in order.")
    calls: Listed[Name] | None = own("Calls", "Calls that use or offer it.")
    uses: Listed[MethodUse] | None = own("Uses", "The sides of the method within this component.")


class ServiceField(WireModel):
    """A status that a service keeps, sends when it changes and returns on request: error, safety reaction or mode."""

    name: Name = published("Name", "Name of the interface.")
    description: Text | None = own("Description", "What the status means.")
    datatype: Name | None = own("DataType", "Word for a primitive, or the name of a datatype of the document.")
    notifier_id: Integer | None = own("NotifierID", "SOME/IP id of the event that notifies of a change.")
    getter_id: Integer | None = own("GetterID", "SOME/IP id of the method that asks for the value.")
    event_group: Name | None = own("EventGroup", "Name of the event group of the notifier.")
    protection: E2eProtection | None = own(
        "E2eProtection", "How its notifier is protected end to end, if it is: then it has no getter."
    )
    calls: Listed[Name] | None = own("Calls", "Calls that report or read it.")
    vss_path: VssPath | None = own("VssPath", "Path of the interface in the catalogue.")
    error: ErrorInterface | None = own("Error", "The error interface as it is in Function JSON.")
    safety_reaction: SafetyReaction | None = own(
        "SafetyReaction", "The safety reaction interface as it is in Function JSON."
    )
    mode: ModeInterface | None = own("Mode", "The mode interface as it is in Function JSON.")

    @property
    def word(self) -> str:
        """Word for a primitive, or the name of a datatype of the document; a status without one is a byte."""
        return self.datatype or "uint8_t"


class Services(WireModel):
    """Elements of a service interface that a component uses or offers."""

    events: Listed[Event] = published("Events", "Events.")
    methods: Listed[Method] = published("Methods", "Methods.")
    fields: Listed[ServiceField] = published("Fields", "Fields.")


class EventGroup(WireModel):
    """Events that are subscribed to together."""

    name: Name = always("Name", "Name of the group.")
    id: Integer = always("EventGroupID", "SOME/IP id of the group.")


class Provider(WireModel):
    """Provider of a service, and its address."""

    name: Text = published("Name", "Component that provides the service; SOME/IP if none of the set does.")
    deployment: Name = published("ServiceDeploymentType", "SOME/IP.")
    instance_id: Integer | None = published("ServiceInstanceID", "SOME/IP id of the instance.")
    contract: Text = published("ContractName", "Name of the middleware framework.")


class ServiceInterface(WireModel):
    """A service that a component consumes or provides."""

    name: Name = published("Name", "Name of the service interface.")
    role: Annotated[str, Field(pattern="^(Consumer|Provider)$"), NAME] = published("Role", "Consumer or Provider.")
    services: Listed[Services] = published("ServiceList", "What is used of it.")
    providers: Listed[Provider] | None = published("Provider", "Who offers it.")
    service_id: Integer | None = own("ServiceID", "SOME/IP id of the service.")
    major_version: Annotated[Integer, Field(ge=0, le=0xFE)] | None = own(
        "MajorVersion", "Major version: peers with another one do not find the service; 1 if absent."
    )
    minor_version: Annotated[Integer, Field(ge=0, le=0xFFFFFFFE)] | None = own(
        "MinorVersion", "Minor version; 0 if absent."
    )
    instance_id: Integer | None = own("ServiceInstanceID", "SOME/IP id of the instance.")
    event_groups: Listed[EventGroup] | None = own("EventGroups", "Event groups.")
    namespace: Namespace | None = own("Namespace", "C++ namespace of the service; that of all if absent.")
    transformation: TransformationSettings | None = own(
        "Transformation", "How SOME/IP lays out what the service sends; as for all if absent."
    )
    transport: TransportSettings | None = own(
        "Transport", "How the messages of the service are sent; over UDP if absent."
    )
    origin: Name | None = own("Origin", "Branch of the tree, or component, that provides what is gathered here.")

    @property
    def events(self) -> Iterator[Event]:
        """Events of all of its lists."""
        return (event for services in self.services for event in services.events)

    @property
    def methods(self) -> Iterator[Method]:
        """Methods of all of its lists."""
        return (method for services in self.services for method in services.methods)

    @property
    def fields(self) -> Iterator[ServiceField]:
        """Fields of all of its lists."""
        return (field for services in self.services for field in services.fields)


class FunctionMode(WireModel):
    """A mode of a function and what runs in it."""

    function: FunctionName = always("Function", "Name of the function.")
    name: Name = always("Name", "Name of the mode.")
    description: Text | None = own("Description", "What the mode means.")
    calls: Listed[CallName] | None = own("Calls", "Calls that run in it.")


class ProcessInstance(WireModel):
    """The instance of a service that a further process offers or uses."""

    service: Name = always("Service", "Name of the service interface.")
    instance_id: Integer = always("ServiceInstanceID", "SOME/IP id of the instance.")


class FurtherProcess(WireModel):
    """Another process of the executable, with its own instances."""

    name: ShortName = always("Name", "Name of the process.")
    instances: Listed[ProcessInstance] = always("Instances", "Instances that are not those of the component.")


class Component(WireModel):
    """A component, its calls and its services; one executable each."""

    name: Name = published("Name", "Name of the component.")
    executable: Name = published("ExecutableName", "Name of the executable.")
    header_files: Listed[SourceFile] | None = published("HeaderFiles", "Header files of the code.")
    modes: Listed[Name] = published("FunctionGroupModes", "Function group modes in which it runs.")
    calls: Listed[Call] = published("FunctionList", "Calls.")
    parameters: Listed[ParameterEntry] | None = published("ParameterList", "Parameters.")
    services: Listed[ServiceInterface] = published("ServiceInterfaceList", "Services.")
    function: FunctionName | None = own("Function", "Name of the function.")
    version: Version | None = own("Version", "Version of the function.")
    description: Text | None = own("Description", "What the function does.")
    code: CodeInterface | None = own("Code", "How the code of the function is compiled and called.")
    function_modes: Listed[FunctionMode] | None = own("FunctionModes", "Modes of the function.")
    startup: StartupSettings | None = own("Startup", "How the process is started.")
    processes: Listed[FurtherProcess] | None = own("Processes", "Further processes of the executable.")

    @property
    def wishes(self) -> tuple[Wish, ...]:
        """Scheduling that its cyclic calls ask for, as they run all the time. Without any, that of all calls."""
        cyclic = [call for call in self.calls if call.run_type == "Cyclic"]
        return tuple(Wish(call.name, call.scheduling, call.priority) for call in cyclic or self.calls)


class ArxmlDeployment(WireModel):
    """Settings of the ARXML besides the elements, as the deployment file has them."""

    package: Name = always("Package", "Outermost package of the ARXML.")
    function_group: Name = always("FunctionGroup", "Function group of the executables.")
    release: ReleaseName = described(
        "Release", "Release of AUTOSAR that the ARXML is of.", default=DEFAULT_RELEASE, source=OWN
    )
    namespace: Namespace | None = own("Namespace", "C++ namespace of services.")
    type_namespace: Namespace | None = own("TypeNamespace", "C++ namespace of datatypes; that of services if absent.")
    header_folders: HeaderFolders = described(
        "HeaderFolders", "Folders of the headers of services and datatypes.", default=DEFAULT_HEADER_FOLDERS, source=OWN
    )
    transformation: TransformationSettings = described(
        "Transformation", "How SOME/IP lays out what is sent.", default=DEFAULT_TRANSFORMATION, source=OWN
    )
    service_discovery: ServiceDiscoverySettings = described(
        "ServiceDiscovery",
        "When services are offered, looked for and subscribed to.",
        default=DEFAULT_SERVICE_DISCOVERY,
        source=OWN,
    )
    units: dict[UnitKey, UnitSettings] | None = own("Units", "Units that are not those of VSS, in SI units.")


class IntegrationModel(WireModel):
    """The whole document."""

    meta: MetaInformation = published("MetaInformation", "Who is responsible, and the version.")
    info: FunctionInformation = published("FunctionInformation", "Identity of the application.")
    components: Listed[Component] = published("ComponentList", "Components.")
    datatypes: Listed[TypeEntry] | None = published("DataTypes", "Datatypes.")
    deployment: ArxmlDeployment | None = own("Deployment", "What the ARXML takes beside the elements.")
    provenance: Listed[dict[Name, Carried]] | None = own("Provenance", "What each function was made from.")
    functions: tuple[FunctionJson, ...] | None = source_functions()

    @property
    def interfaces(self) -> Iterator[ServiceInterface]:
        """Services of all components, each as the component has it."""
        return (interface for component in self.components for interface in component.services)

    def interfaces_by_name(self) -> dict[str, list[ServiceInterface]]:
        """Each service as its components have it."""
        return grouped(self.interfaces, lambda each: each.name)

    def with_interfaces(self, changed: Callable[[ServiceInterface], ServiceInterface]) -> Self:
        """The document with changed services."""
        components = tuple(
            each.model_copy(update={"services": tuple(map(changed, each.services))}) for each in self.components
        )
        return self.model_copy(update={"components": components})
