"""Data interfaces of a call: signals, queues and parameters."""

from sigcat.function.function_json.datatype import Symbol
from sigcat.function.function_json.wire import (
    OWN,
    PHYSICAL,
    TABLE,
    Integer,
    Number,
    TypeReference,
    WireModel,
    described,
)


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
    vss_min: Number | None = described(
        "VssMin", "Smallest value in the catalogue.", default=None, source=OWN, unit="that of `VssUnit`"
    )
    vss_max: Number | None = described(
        "VssMax", "Largest value in the catalogue.", default=None, source=OWN, unit="that of `VssUnit`"
    )
    vss_symbols: tuple[Symbol, ...] | None = described(
        "VssSymbols",
        "Values of an enumeration with the numbers of the catalogue, where the code has others.",
        default=None,
        source=OWN,
        strict=False,
    )
    conversion_factor: str | None = described(
        "ConversionFactor",
        "Value in the catalogue's unit = physical value × factor + offset; absent where the units are the same. Exact: a "
        "decimal number, or where that has no end a fraction, 5/18.",
        default=None,
        source=OWN,
    )
    conversion_offset: str | None = described(
        "ConversionOffset",
        "Offset of the conversion, in the catalogue's unit; exact, too.",
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
    default: Number | None = described(
        "Default", "Value that stands in for a missing one.", default=None, source=OWN, unit=PHYSICAL
    )
    resolution: Number | None = described(
        "Resolution", "Smallest step between two values.", default=None, source=OWN, unit=PHYSICAL
    )
    access: str | None = described("Access", "As in a signal.", default=None, source=OWN)
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
    vss_min: Number | None = described(
        "VssMin", "Smallest value in the catalogue.", default=None, source=OWN, unit="that of `VssUnit`"
    )
    vss_max: Number | None = described(
        "VssMax", "Largest value in the catalogue.", default=None, source=OWN, unit="that of `VssUnit`"
    )
    vss_symbols: tuple[Symbol, ...] | None = described(
        "VssSymbols", "As in a signal.", default=None, source=OWN, strict=False
    )
    conversion_factor: str | None = described("ConversionFactor", "As in a signal.", default=None, source=OWN)
    conversion_offset: str | None = described(
        "ConversionOffset", "As in a signal.", default=None, source=OWN, unit="that of `VssUnit`"
    )
    external_provider: str | None = described("ExternalProvider", "As in a signal.", default=None, source=OWN)
    variable: str | None = described(
        "Variable", "Expression of the C code that holds the queue.", default=None, source=OWN
    )


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
    vss_symbols: tuple[Symbol, ...] | None = described(
        "VssSymbols", "As in a signal.", default=None, source=OWN, strict=False
    )
    conversion_factor: str | None = described("ConversionFactor", "As in a signal.", default=None, source=OWN)
    conversion_offset: str | None = described(
        "ConversionOffset", "As in a signal.", default=None, source=OWN, unit="that of `VssUnit`"
    )
    variable: str | None = described(
        "Variable", "Expression of the C code that holds the value.", default=None, source=OWN
    )
