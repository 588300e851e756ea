"""Function JSON: a function with everything that an integration needs to know, independent of any platform.

A superset of the authors' published schema, field for field and spelling for spelling (`Dependancy`, `Asillevel`,
`functionList`); Python names are the correct ones. What the paper's tables have and the published schema lacks is
added as optional fields, and so is what later stages need, such as the VSS path of a signal.
"""

import re
from typing import Annotated, Any

from pydantic import Field

from sigcat.function.function_json.wire import (
    OWN,
    PHYSICAL,
    TABLE,
    Integer,
    Number,
    TypeReference,
    WireModel,
    described,
    written,
)

CONSUMER = "Consumer"
PROVIDER = "Provider"

_DURATION = re.compile(r"\s*(\d+(?:\.\d*)?|\.\d+)\s*(us|µs|ms|s|)\s*", re.IGNORECASE)
_MILLISECONDS = {"": 1.0, "ms": 1.0, "s": 1000.0, "us": 0.001, "µs": 0.001}


def milliseconds(text: str | None) -> float | None:
    """The duration that a text of the wire format means, in ms: `100`, `100 ms`, `0.1 s`; None if it means none."""
    match = _DURATION.fullmatch(text) if text else None
    return float(match[1]) * _MILLISECONDS[match[2].lower()] if match else None


class MetaInfo(WireModel):
    """Who is responsible for the document, and its version."""

    authority: str | None = described("Authority", "Organization that the document belongs to.", default=None)
    schema_author: str | None = described("SchemaAuthor", "Author of the document.", default=None)
    date: Annotated[str, Field(pattern=r"^\d{2}.\d{2}.\d{4}$")] | None = described(
        "Date", "Date of the document, as DD.MM.YYYY.", default=None
    )
    schema_version: Annotated[str, Field(pattern=r"^\d+\.\d+\.\d+$")] | None = described(
        "SchemaVersion", "Version of the document's format, as three numbers.", default=None
    )
    schema_description: str | None = described("SchemaDescription", "What the document is.", default=None)


class FunctionInfo(WireModel):
    """Identity of the function."""

    function_name: str = described("FunctionName", "Name of the function.")
    function_responsible: str = described("FunctionResponsible", "Team that answers for the function.")
    description: str = described("Description", "What the function does.")
    version: str | None = described("Version", "Version of the function.", default=None, source=OWN)


class Signal(WireModel):
    """A data interface: a value that a call reads (Consumer) or writes (Provider)."""

    name: str = described("Name", "Name of the signal inside the function.")
    description: str = described("Description", "What the value means.")
    role: str = described("Role", "Consumer or Provider.")
    asil_level: str | None = described("AsilLevel", "ASIL: QM, A, B, C or D.", default=None)
    timeout: str | None = described(
        "Timeout", "Longest time between two values, as a number in a text.", default=None, unit="ms"
    )
    access: str | None = described("Access", "Immediate, or buffered for the length of a call.", default=None)
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    factor: str | None = described("Factor", "Scaling: physical value = stored value × factor + offset.", default=None)
    offset: str | None = described(
        "Offset", "Offset of the scaling, in the unit of the signal.", default=None, unit=PHYSICAL
    )
    min: Number | None = described("Min", "Smallest valid value, after scaling.", default=None, unit=PHYSICAL)
    max: Number | None = described("Max", "Largest valid value, after scaling.", default=None, unit=PHYSICAL)
    default: Number | None = described(
        "Default", "Value that stands in for a missing one.", default=None, unit=PHYSICAL
    )
    init_value: Number | None = described(
        "InitValue", "Value before the first one arrives.", default=None, unit=PHYSICAL
    )
    units: str | None = described("Units", "Unit of the physical value, by its key in the catalogue.", default=None)
    range_error_action: str | None = described(
        "RangeErrorAction", "What replaces a value out of range: Default or Init.", default=None
    )
    timeout_error: str | None = described(
        "TimeoutError", "Error interface that is set when the time-out passes.", default=None, source="paper, figure 7"
    )
    type: str | None = described(
        "Type", "Kind of the interface: sensor, actuator or attribute.", default=None, source=TABLE
    )
    resolution: Number | None = described(
        "Resolution", "Smallest step between two values.", default=None, source=OWN, unit=PHYSICAL
    )
    vss_path: str | None = described("VssPath", "Path of the signal in the catalogue.", default=None, source=OWN)
    vss_datatype: str | None = described("VssDatatype", "Datatype in the catalogue.", default=None, source=OWN)
    vss_unit: str | None = described("VssUnit", "Unit in the catalogue.", default=None, source=OWN)
    conversion_factor: str | None = described(
        "ConversionFactor",
        "Value in the catalogue's unit = physical value × factor + offset; absent where the units are the same.",
        default=None,
        source=OWN,
    )
    conversion_offset: str | None = described(
        "ConversionOffset",
        "Offset of the conversion, in the catalogue's unit.",
        default=None,
        source=OWN,
        unit="that of `VssUnit`",
    )
    external_provider: str | None = described(
        "ExternalProvider", "Who provides a consumed signal, where no other function does.", default=None, source=OWN
    )
    variable: str | None = described(
        "Variable", "Expression of the C code that holds the value.", default=None, source=OWN
    )


class DataQueue(WireModel):
    """A data interface whose values are queued, so that none is lost."""

    name: str = described("Name", "Name of the queue inside the function.")
    description: str = described("Description", "What the values mean.")
    role: str = described("Role", "Consumer or Provider.")
    asil_level: str = described("AsilInfo", "ASIL: QM, A, B, C or D.")
    queue_length: Integer = described("QueueLength", "Number of values that the queue holds.", unit="values")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    factor: Number = described("Factor", "Scaling: physical value = stored value × factor + offset.")
    offset: Number = described("Offset", "Offset of the scaling, in the unit of the signal.", unit=PHYSICAL)
    init_value: Number = described("InitValue", "Value before the first one arrives.", unit=PHYSICAL)
    units: str = described("Units", "Unit of the physical value; empty if it has none.")
    min: Number | None = described(
        "Min", "Smallest valid value, after scaling.", default=None, source=TABLE, unit=PHYSICAL
    )
    max: Number | None = described(
        "Max", "Largest valid value, after scaling.", default=None, source=TABLE, unit=PHYSICAL
    )
    timeout: str | None = described(
        "Timeout", "Longest time between two values, as a number in a text.", default=None, unit="ms", source=OWN
    )
    timeout_error: str | None = described(
        "TimeoutError", "Error interface that is set when the time-out passes.", default=None, source=OWN
    )
    range_error_action: str | None = described(
        "RangeErrorAction", "What replaces a value out of range: Default or Init.", default=None, source=OWN
    )
    type: str | None = described(
        "Type", "Kind of the interface: sensor, actuator or attribute.", default=None, source=TABLE
    )
    vss_path: str | None = described("VssPath", "Path of the signal in the catalogue.", default=None, source=OWN)
    vss_datatype: str | None = described("VssDatatype", "Datatype in the catalogue.", default=None, source=OWN)
    vss_unit: str | None = described("VssUnit", "Unit in the catalogue.", default=None, source=OWN)
    conversion_factor: str | None = described("ConversionFactor", "As in a signal.", default=None, source=OWN)
    conversion_offset: str | None = described(
        "ConversionOffset", "As in a signal.", default=None, source=OWN, unit="that of `VssUnit`"
    )
    external_provider: str | None = described("ExternalProvider", "As in a signal.", default=None, source=OWN)
    variable: str | None = described(
        "Variable", "Expression of the C code that holds the queue.", default=None, source=OWN
    )


class Argument(WireModel):
    """An argument or a return value of a method."""

    name: str = described("Name", "Name of the argument or return value.")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    units: str = described("Units", "Unit of the value; empty if it has none.")


class Method(WireModel):
    """A call that one function offers and others use."""

    name: str = described("Name", "Name of the method.")
    description: str = described("Description", "What the method does.")
    role: str = described("Role", "Consumer or Provider.")
    inputs: tuple[Argument, ...] = described("InDataTypeList", "Arguments, in order.", strict=False)
    outputs: tuple[Argument, ...] = described("OutDataTypeList", "Return values, in order.", strict=False)


class Parameter(WireModel):
    """A value that is set before the function runs, or that it learns and keeps."""

    name: str = described("Name", "Name of the parameter inside the function.")
    description: str = described("Description", "What the value means.")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    asil_level: str = described("Asillevel", "ASIL: QM, A, B, C or D.")
    min: Number = described("Min", "Smallest valid value; 0 for a text.", unit=PHYSICAL)
    max: Number = described("Max", "Largest valid value; 0 for a text.", unit=PHYSICAL)
    default: Number = described("Default", "Value of a new vehicle; 0 for a text.", unit=PHYSICAL)
    init_value: Number = described("InitValue", "Value at start-up; 0 for a text.", unit=PHYSICAL)
    range_error_action: str = described("RangeErrorAction", "What replaces a value out of range: Default or Init.")
    interface_type: str = described("Interfacetype", "Calibration, Measurement or PersistenceMemory.")
    attribute: str = described("Attribute", "Normal, LearningParameter or NA.")
    units: str = described("Units", "Unit of the value; empty if it has none.")
    default_text: str | None = described(
        "DefaultText", "Default of a text; of an array its elements, as JSON.", default=None, source=OWN
    )
    vss_path: str | None = described("VssPath", "Path of the parameter in the catalogue.", default=None, source=OWN)
    vss_datatype: str | None = described("VssDatatype", "Datatype in the catalogue.", default=None, source=OWN)
    vss_unit: str | None = described("VssUnit", "Unit in the catalogue.", default=None, source=OWN)
    conversion_factor: str | None = described("ConversionFactor", "As in a signal.", default=None, source=OWN)
    conversion_offset: str | None = described(
        "ConversionOffset", "As in a signal.", default=None, source=OWN, unit="that of `VssUnit`"
    )
    variable: str | None = described(
        "Variable", "Expression of the C code that holds the value.", default=None, source=OWN
    )


class Error(WireModel):
    """An error that the function reports to the fault management of the base software."""

    name: str = described("Name", "Name of the error interface: <FunctionName>_<ErrorName>_ErrorSts.")
    description: str = described("Description", "Condition that the error stands for.")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    dependencies: tuple[str, ...] = described(
        "Dependancy", "Error interfaces of other functions or the base software that set this error too.", strict=False
    )
    occurrence_count_limit: Integer = described(
        "OccurenceCountLimit",
        "How often the error has to occur to be confirmed; 0 if that does not count.",
        unit="occurrences",
    )
    ignition_count_limit: Integer = described(
        "IgnitionCountLimit",
        "Ignition cycles after which the error is confirmed; 0 if they do not count.",
        unit="ignition cycles",
    )
    maturation_time: Integer = described(
        "MaturationTime", "How long the error has to be present to be confirmed; 0 if it is at once.", unit="ms"
    )
    severity: str = described("Severity", "What the error leads to.")
    reset_time: Number | None = described(
        "ResetTime", "Time from the reset condition to the reset of the error.", default=None, unit="ms", source=TABLE
    )
    reset_condition: str | None = described(
        "ResetCondition", "Condition that resets the error.", default=None, source=TABLE
    )
    asil_level: str | None = described("AsilLevel", "ASIL: QM, A, B, C or D.", default=None, source=OWN)
    vss_path: str | None = described("VssPath", "Path of the interface in the catalogue.", default=None, source=OWN)


class SafetyReaction(WireModel):
    """A safety condition of which the base software informs the function."""

    name: str = described("Name", "Name of the interface: <SafetyCondition>_SftyCondSts.")
    description: str = described("Description", "What the condition means for the function.")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    errors: tuple[str, ...] = described("ErrorList", "Error interfaces, any of which sets the condition.", strict=False)
    asil_level: str | None = described("AsilLevel", "ASIL: QM, A, B, C or D.", default=None, source=OWN)
    vss_path: str | None = described("VssPath", "Path of the interface in the catalogue.", default=None, source=OWN)


class WatchdogLimits(WireModel):
    """Limits of the alive supervision (in cycles) or the deadline supervision (in ms)."""

    min: Number = described("Min", "Fewest indications, or shortest duration.", unit="cycles or ms")
    max: Number = described("Max", "Most indications, or longest duration.", unit="cycles or ms")
    reference: Number = described("Ref", "Cycles in which indications are counted; 0 for a deadline.", unit="cycles")
    error_name: str = described("ErrorName", "Error interface that is set when a limit is broken.")
    description: str | None = described("Description", "Explanation, if needed.", default=None, source=TABLE)


class Watchdog(WireModel):
    """Supervision of a call by the watchdog."""

    alive: WatchdogLimits | None = described("AliveSupervision", "Limits in cycles.")
    deadline: WatchdogLimits | None = described("DeadlineSupervision", "Limits in ms.")
    logical: str | None = described("LogicalSupervision", "Order relative to other calls, in words.")
    logical_error: str | None = described(
        "LogicalError", "Error interface that is set when the order is broken.", default=None, source=TABLE
    )


class Contract(WireModel):
    """What a call reads and writes."""

    type: str | None = described("Type", "How data is handed over: global variables or C calls.", default=None)
    signals: tuple[Signal, ...] | None = described("SignalList", "Data interfaces.", strict=False)
    queues: tuple[DataQueue, ...] | None = described("DataQList", "Queued data interfaces.", strict=False)
    methods: tuple[Method, ...] | None = described("MethodList", "Methods.", strict=False)
    parameters: tuple[Parameter, ...] | None = described("ParameterList", "Parameters.", strict=False)
    errors: tuple[Error, ...] | None = described("ErrorList", "Error interfaces.", strict=False)
    safety_reactions: tuple[SafetyReaction, ...] | None = described(
        "SafetyReactionList", "Safety reaction interfaces.", strict=False
    )


class Runnable(WireModel):
    """A call of the function: init, a step, terminate."""

    name: str = described("Name", "Name of the call: <FunctionName>_Init, _Step or _Terminate.")
    description: str = described("Description", "What the call does.")
    run_type: str = described("Runtype", "Init, Cyclic, EventTriggered or Shutdown.")
    cycle_time: Integer | None = described("Cycletime", "Time from one call to the next.", default=None, unit="ms")
    stack_size: str | None = described(
        "StackSize", "Stack that the call needs, as a number in a text.", default=None, unit="bytes"
    )
    previous_runnable: str | None = described("PrevRunnable", "Call after which this one runs.", default=None)
    execution_offset: str | None = described(
        "ExecOffset", "Offset of the first call, as a number in a text.", default=None, unit="ms"
    )
    parallel_processing: bool | None = described(
        "ParallelProcessing", "Whether calls may run at the same time.", default=None
    )
    asil_level: str | None = described("AsilLevel", "ASIL that the call is implemented to.", default=None)
    watchdog: Watchdog | None = described("Watchdog", "Supervision; null if there is none.")
    scheduling: str = described("Scheduling", "Preemptive or Non-Preemptive.")
    debounce_delay: str | None = described(
        "DebounceDelay", "Shortest time between two calls, as a number in a text.", default=None, unit="ms"
    )
    priority: str = described("Priority", "Priority relative to other calls; a higher number runs first.")
    events: str | None = described("EventList", "Events that trigger the call.", default=None)
    contracts: tuple[Contract, ...] | None = described(
        "funcContractList", "What the call reads and writes.", default=None, strict=False
    )
    supervision_types: tuple[str, ...] | None = described(
        "SupervisionType", "Alive, Deadline, Logical; empty if unsupervised.", default=None, source=TABLE, strict=False
    )
    vss_path: str | None = described("VssPath", "Path of the interface in the catalogue.", default=None, source=OWN)


class Component(WireModel):
    """A part of the function that is deployed as a whole."""

    name: str = described("Name", "Name of the component.")
    runnables: tuple[Runnable, ...] = described("functionList", "Calls of the component.", strict=False)


class Mode(WireModel):
    """A mode of the function and what runs in it."""

    name: str = described("Name", "Name of the mode.")
    description: str = described("Description", "What the mode means.")
    runnables: tuple[str, ...] = described("RunnablesList", "Names of the calls that run in the mode.", strict=False)


class Symbol(WireModel):
    """A named value of an enumeration."""

    symbol: str = described("Symbol", "Name of the value.", source=OWN)
    value: Integer = described("Value", "Number that stands for it.", source=OWN)


class ModeInterface(WireModel):
    """The interface over which a function receives its mode (In), or reports it (Out)."""

    name: str = described("Name", "Name of the interface: <FunctionName>_Mode_In or _Mode_Out.", source=TABLE)
    description: str = described("Description", "What the interface says.", source=TABLE)
    direction: str = described("Direction", "In or Out.", source=TABLE)
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.", source=TABLE)
    modes: tuple[str, ...] = described("Modes", "Names of the modes.", source=OWN, strict=False)
    vss_path: str | None = described("VssPath", "Path of the interface in the catalogue.", default=None, source=OWN)


class TypeField(WireModel):
    """A member of a struct."""

    name: str = described("Name", "Name of the member.", source=OWN)
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.", source=OWN)
    units: str | None = described("Units", "Unit of the member.", default=None, source=OWN)
    description: str | None = described("Description", "What the member means.", default=None, source=OWN)
    min: Number | None = described("Min", "Smallest value of the member.", default=None, source=OWN, unit="Units")
    max: Number | None = described("Max", "Largest value of the member.", default=None, source=OWN, unit="Units")


class Datatype(WireModel):
    """A datatype that interfaces refer to."""

    reference: TypeReference = described("typeRef", "Name of the datatype, such as DT_UInt16.")
    category: str = described("category", "primitive or userdefined.")
    c_definition: str = described("cDef", "Definition in C.")
    kind: str | None = described(
        "Kind", "enumeration, array or struct, where the datatype is one.", default=None, source=OWN
    )
    vss_datatype: str | None = described("VssDatatype", "Datatype of VSS.", default=None, source=OWN)
    symbols: tuple[Symbol, ...] | None = described(
        "Symbols", "Values of an enumeration.", default=None, source=OWN, strict=False
    )
    element: TypeReference | None = described(
        "ElementType", "Datatype of the elements of an array.", default=None, source=OWN
    )
    length: Integer | None = described(
        "Length", "Elements of an array; absent if that is open.", default=None, source=OWN, unit="elements"
    )
    fields: tuple[TypeField, ...] | None = described(
        "Fields", "Members of a struct, in order.", default=None, source=OWN, strict=False
    )
    description: str | None = described("Description", "What a struct is.", default=None, source=OWN)


class CatalogueLayer(WireModel):
    """A tree or an overlay that took part."""

    name: str = described("Name", "Name of its file.", source=OWN)
    digest: str = described("Digest", "SHA-256 over its files.", source=OWN)


class DefinedInterface(WireModel):
    """An interface that the declaration itself defines, as an overlay would have it."""

    path: str = described("Path", "Path of the interface in the catalogue.", source=OWN)
    attributes: dict[str, Any] = described("Attributes", "Its attributes, as in a vspec file.", source=OWN)


class Provenance(WireModel):
    """What the document was made from: with the same, it can be made again, byte for byte."""

    generator: str = described("Generator", "Program and version.", source=OWN)
    declaration: str = described("Declaration", "Name of the file that declares the function.", source=OWN)
    declaration_digest: str = described("DeclarationDigest", "SHA-256 of its bytes.", source=OWN)
    catalogue: str = described("Catalogue", "Name of the catalogue.", source=OWN)
    catalogue_digest: str = described(
        "CatalogueDigest", "SHA-256 of its content, however split into files.", source=OWN
    )
    release: str | None = described("Release", "Release of VSS, if the tree tells it.", default=None, source=OWN)
    layers: tuple[CatalogueLayer, ...] = described(
        "Layers", "The tree and its overlays, in the order in which they apply.", source=OWN, strict=False
    )
    definitions: tuple[DefinedInterface, ...] | None = described(
        "Definitions", "Interfaces that the declaration defines itself.", default=None, source=OWN, strict=False
    )
    type_definitions: tuple[DefinedInterface, ...] | None = described(
        "TypeDefinitions", "Struct types that it defines itself.", default=None, source=OWN, strict=False
    )


class FunctionJson(WireModel):
    """The whole document."""

    meta: MetaInfo = described("MetaInfo", "Who is responsible for the document, and its version.")
    info: FunctionInfo = described("FunctionInfo", "Identity of the function.")
    components: tuple[Component, ...] = described("ComponentList", "Components of the function.", strict=False)
    modes: tuple[Mode, ...] | None = described(
        "ModesList", "Modes of the function and the calls that run in them.", strict=False
    )
    datatypes: tuple[Datatype, ...] = described("Datatypes", "Datatypes that interfaces refer to.", strict=False)
    mode_interfaces: tuple[ModeInterface, ...] | None = described(
        "ModeInterfaceList", "Mode management interfaces.", default=None, source=TABLE, strict=False
    )
    provenance: Provenance | None = described(
        "Provenance", "What the document was made from.", default=None, source=OWN
    )


def to_json(function: FunctionJson) -> bytes:
    """The document as UTF-8 text with a stable layout: the same function gives the same bytes."""
    return written(function)


def function_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of Function JSON."""
    schema = FunctionJson.model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
