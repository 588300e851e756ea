"""Data interfaces of a call: signals, queues and parameters."""

from typing import Annotated

from pydantic import BaseModel

from sigcat.function.document.field_types import (
    CExpression,
    Definer,
    Name,
    NumberText,
    Overflow,
    Quantity,
    TimeoutStart,
    TimeoutValue,
    UnitKey,
    VssDatatype,
    VssPath,
)
from sigcat.function.document.text import Text
from sigcat.function.function_json.code import DEFINED_BY, MEMBERS, Member
from sigcat.function.function_json.datatypes.c_type import C_TYPE, CTypeName
from sigcat.function.function_json.datatypes.datatype import EnumerationValue
from sigcat.function.function_json.error_fields import SetError, SetErrorName, SetsError, errors_set_by
from sigcat.function.function_json.wire import (
    PHYSICAL,
    Integer,
    Listed,
    Number,
    TypeReference,
    WireModel,
    described,
    optional,
    own,
    tabled,
)

RejectionErrorName = Annotated[Name | None, SetsError("rejected messages", is_of_consumer=True)]
"""Name of the error of messages that end-to-end protection rejects."""


class Signal(WireModel):
    """A data interface: a value that a call reads (Consumer) or writes (Provider)."""

    name: Name = described("Name", "Name of the signal inside the function.")
    description: Text = described("Description", "What the value means.")
    role: Name = described("Role", "Consumer or Provider.")
    asil_level: Name | None = optional("AsilLevel", "ASIL: QM, A, B, C or D.")
    timeout: Quantity | None = optional("Timeout", "Longest time between two values, as a number in a text.", unit="ms")
    access: Name | None = optional("Access", "Immediate, or buffered for the length of a call.")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    factor: NumberText | None = optional("Factor", "Scaling: physical value = stored value × factor + offset.")
    offset: NumberText | None = optional("Offset", "Offset of the scaling, in the unit of the signal.", unit=PHYSICAL)
    min: Number | None = optional("Min", "Smallest valid value, after scaling.", unit=PHYSICAL)
    max: Number | None = optional("Max", "Largest valid value, after scaling.", unit=PHYSICAL)
    default: Number | None = optional("Default", "Value that replaces a missing one.", unit=PHYSICAL)
    init_value: Number | None = optional("InitValue", "Value before the first one arrives.", unit=PHYSICAL)
    units: UnitKey | None = optional("Units", "Unit of the physical value, by its key in the catalogue.")
    range_error_action: Name | None = optional(
        "RangeErrorAction", "What replaces a value out of range: Default or Init."
    )
    timeout_error: SetErrorName = described(
        "TimeoutError", "Error interface that is set when the time-out passes.", default=None, source="paper, figure 7"
    )
    type: Name | None = tabled("Type", "Kind of the interface: sensor, actuator or attribute.")
    resolution: Number | None = own("Resolution", "Smallest step between two values.", unit=PHYSICAL)
    vss_path: VssPath | None = own("VssPath", "Path of the signal in the catalogue.")
    vss_datatype: VssDatatype | None = own("VssDatatype", "Datatype in the catalogue.")
    vss_unit: UnitKey | None = own("VssUnit", "Unit in the catalogue.")
    vss_min: Number | None = own("VssMin", "Smallest value in the catalogue.", unit="that of `VssUnit`")
    vss_max: Number | None = own("VssMax", "Largest value in the catalogue.", unit="that of `VssUnit`")
    vss_symbols: Listed[EnumerationValue] | None = own(
        "VssSymbols", "Values of an enumeration with the numbers of the catalogue, where the code has others."
    )
    conversion_factor: NumberText | None = own(
        "ConversionFactor",
        "Value in the catalogue's unit = physical value × factor + offset; absent where the units are the same. Exact: a "
        "decimal number, or where that has no end a fraction, 5/18.",
    )
    conversion_offset: NumberText | None = own(
        "ConversionOffset", "Offset of the conversion, in the catalogue's unit; exact, too.", unit="that of `VssUnit`"
    )
    external_provider: Text | None = own(
        "ExternalProvider", "Who provides a consumed signal, where no other function does."
    )
    variable: CExpression | None = own("Variable", "Expression of the C code that holds the value.")
    defined_by: Definer | None = own("DefinedBy", DEFINED_BY)
    c_type: CTypeName | None = own("CType", C_TYPE)
    members: Listed[Member] | None = own("Members", MEMBERS)
    timeout_start: TimeoutStart | None = own(
        "TimeoutStart",
        "Whether the time-out runs from the end of init (Init, also if absent) or the first value (First).",
    )
    timeout_value: TimeoutValue | None = own(
        "TimeoutValue", "Value after the time-out: the last one (Last, also if absent), Default or Init."
    )
    timeout_recovery: Integer | None = own(
        "TimeoutRecovery", "Valid values in a row that end the time-out; 1 if absent.", unit="values"
    )
    range_error: SetErrorName = own("RangeError", "Error interface that is set while a value is out of range.")
    e2e_error: RejectionErrorName = own(
        "E2eError", "Error interface that is set while end-to-end protection rejects messages."
    )
    init_elements: Text | None = own(
        "InitElements",
        "Value of an array or struct before the first one arrives, as JSON: a list or an object.",
        unit=PHYSICAL,
    )
    default_elements: Text | None = own(
        "DefaultElements", "Value of an array or struct that replaces a missing one, as JSON.", unit=PHYSICAL
    )
    is_optional: bool | None = own("Optional", "Whether a vehicle may lack the signal.")
    absent_error: SetErrorName = own("AbsentError", "Error interface that is set in vehicles without the signal.")


class DataQueue(WireModel):
    """A data interface whose values are queued, so that none is lost."""

    name: Name = described("Name", "Name of the queue inside the function.")
    description: Text = described("Description", "What the values mean.")
    role: Name = described("Role", "Consumer or Provider.")
    asil_level: Name = described("AsilInfo", "ASIL: QM, A, B, C or D.")
    queue_length: Integer = described("QueueLength", "Number of values that the queue holds.", unit="values")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    factor: Number = described("Factor", "Scaling: physical value = stored value × factor + offset.")
    offset: Number = described("Offset", "Offset of the scaling, in the unit of the signal.", unit=PHYSICAL)
    init_value: Number = described("InitValue", "Value before the first one arrives.", unit=PHYSICAL)
    units: UnitKey = described("Units", "Unit of the physical value; empty if it has none.")
    min: Number | None = tabled("Min", "Smallest valid value, after scaling.", unit=PHYSICAL)
    max: Number | None = tabled("Max", "Largest valid value, after scaling.", unit=PHYSICAL)
    default: Number | None = own("Default", "Value that replaces a missing one.", unit=PHYSICAL)
    resolution: Number | None = own("Resolution", "Smallest step between two values.", unit=PHYSICAL)
    access: Name | None = own("Access", "As in a signal.")
    timeout: Quantity | None = own("Timeout", "Longest time between two values, as a number in a text.", unit="ms")
    timeout_error: SetErrorName = own("TimeoutError", "Error interface that is set when the time-out passes.")
    range_error_action: Name | None = own("RangeErrorAction", "What replaces a value out of range: Default or Init.")
    type: Name | None = tabled("Type", "Kind of the interface: sensor, actuator or attribute.")
    vss_path: VssPath | None = own("VssPath", "Path of the signal in the catalogue.")
    vss_datatype: VssDatatype | None = own("VssDatatype", "Datatype in the catalogue.")
    vss_unit: UnitKey | None = own("VssUnit", "Unit in the catalogue.")
    vss_min: Number | None = own("VssMin", "Smallest value in the catalogue.", unit="that of `VssUnit`")
    vss_max: Number | None = own("VssMax", "Largest value in the catalogue.", unit="that of `VssUnit`")
    vss_symbols: Listed[EnumerationValue] | None = own("VssSymbols", "As in a signal.")
    conversion_factor: NumberText | None = own("ConversionFactor", "As in a signal.")
    conversion_offset: NumberText | None = own("ConversionOffset", "As in a signal.", unit="that of `VssUnit`")
    external_provider: Text | None = own("ExternalProvider", "As in a signal.")
    variable: CExpression | None = own("Variable", "Expression of the C code that holds the queue.")
    defined_by: Definer | None = own("DefinedBy", DEFINED_BY)
    c_type: CTypeName | None = own("CType", C_TYPE)
    members: Listed[Member] | None = own("Members", MEMBERS)
    timeout_start: TimeoutStart | None = own("TimeoutStart", "As in a signal.")
    timeout_value: TimeoutValue | None = own("TimeoutValue", "As in a signal.")
    timeout_recovery: Integer | None = own("TimeoutRecovery", "As in a signal.", unit="values")
    range_error: SetErrorName = own("RangeError", "Error interface that is set while a value is out of range.")
    e2e_error: RejectionErrorName = own(
        "E2eError", "Error interface that is set while end-to-end protection rejects messages."
    )
    init_elements: Text | None = own("InitElements", "As in a signal.", unit=PHYSICAL)
    default_elements: Text | None = own("DefaultElements", "As in a signal.", unit=PHYSICAL)
    overflow: Overflow | None = own(
        "Overflow", "What is lost when the queue is full: the oldest value (DropOldest, also if absent) or DropNewest."
    )
    overflow_error: SetErrorName = own("OverflowError", "Error interface that is set when a value is lost.")
    values_per_step: Integer | None = own(
        "ValuesPerStep", "Most values that a call takes at once; 1 if absent.", unit="values"
    )
    count_variable: CExpression | None = own(
        "CountVariable", "Expression of the C code that holds how many values arrived for the call."
    )
    is_optional: bool | None = own("Optional", "As in a signal.")
    absent_error: SetErrorName = own("AbsentError", "As in a signal.")


def rejection_error(item: BaseModel) -> SetError | None:
    """Return the error of rejected messages. If data names one, its platform tells the core of them."""
    return next((each for each in errors_set_by(item) if each.field == "e2e_error"), None)


class ParameterInterface(WireModel):
    """A value that is set before the function runs, or that it learns and keeps."""

    name: Name = described("Name", "Name of the parameter inside the function.")
    description: Text = described("Description", "What the value means.")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    asil_level: Name = described("Asillevel", "ASIL: QM, A, B, C or D.")
    min: Number = described("Min", "Smallest valid value; 0 for a text.", unit=PHYSICAL)
    max: Number = described("Max", "Largest valid value; 0 for a text.", unit=PHYSICAL)
    default: Number = described("Default", "Value of a new vehicle; 0 for a text.", unit=PHYSICAL)
    init_value: Number = described("InitValue", "Value at start-up; 0 for a text.", unit=PHYSICAL)
    range_error_action: Name = described("RangeErrorAction", "What replaces a value out of range: Default or Init.")
    interface_type: Name = described("Interfacetype", "Calibration, Measurement or PersistenceMemory.")
    attribute: Name = described("Attribute", "Normal, LearningParameter or NA.")
    units: UnitKey = described("Units", "Unit of the value; empty if it has none.")
    default_text: Text | None = own("DefaultText", "Default of a text; of an array its elements, as JSON.")
    vss_path: VssPath | None = own("VssPath", "Path of the parameter in the catalogue.")
    vss_datatype: VssDatatype | None = own("VssDatatype", "Datatype in the catalogue.")
    vss_unit: UnitKey | None = own("VssUnit", "Unit in the catalogue.")
    vss_symbols: Listed[EnumerationValue] | None = own("VssSymbols", "As in a signal.")
    conversion_factor: NumberText | None = own("ConversionFactor", "As in a signal.")
    conversion_offset: NumberText | None = own("ConversionOffset", "As in a signal.", unit="that of `VssUnit`")
    variable: CExpression | None = own("Variable", "Expression of the C code that holds the value.")
    factor: NumberText | None = own("Factor", "As in a signal.")
    offset: NumberText | None = own("Offset", "As in a signal.", unit=PHYSICAL)
    defined_by: Definer | None = own("DefinedBy", DEFINED_BY)
    c_type: CTypeName | None = own("CType", C_TYPE)
    members: Listed[Member] | None = own("Members", MEMBERS)
    key: Name | None = own("Key", "Key under which the value is stored; the name of the parameter if absent.")
    storage: Name | None = own("Storage", "Key-value storage that holds it; that of `Code` if absent.")
    range_error: SetErrorName = own("RangeError", "Error interface that is set while the value is out of range.")
    init_elements: Text | None = own("InitElements", "Value of an array or struct at start-up, as JSON.", unit=PHYSICAL)

    @property
    def default_elements(self) -> Text | None:
        """The default of an array, as a signal has it."""
        return self.default_text
