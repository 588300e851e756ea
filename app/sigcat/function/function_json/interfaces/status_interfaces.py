"""Interfaces that say how the function is: errors, safety reactions and modes."""

import math
from typing import Any

from pydantic import field_serializer, model_validator

from sigcat.function.document.field_types import CExpression, Definer, Name, Quantity, UnknownAction, VssPath
from sigcat.function.document.text import Text
from sigcat.function.function_json.code import DEFINED_BY
from sigcat.function.function_json.datatypes.c_type import C_TYPE, CTypeName
from sigcat.function.function_json.datatypes.datatype import EnumerationValue
from sigcat.function.function_json.duration import exact_time
from sigcat.function.function_json.error_fields import SetErrorName
from sigcat.function.function_json.wire import (
    TABLE,
    Count,
    Integer,
    Listed,
    Number,
    TypeReference,
    WireModel,
    WrittenWhole,
    always,
    described,
    own,
    tabled,
)


class ErrorInterface(WireModel):
    """An error that the function reports to the fault management of the base software."""

    name: Name = described("Name", "Name of the error interface: <FunctionName>_<ErrorName>_ErrorSts.")
    description: Text = described("Description", "Condition that the error reports.")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    dependencies: Listed[Name] = described(
        "Dependancy", "Error interfaces of other functions or the base software that set this error too."
    )
    occurrence_count_limit: Count = described(
        "OccurenceCountLimit",
        "How often the error has to occur to be confirmed; 0 if that does not count.",
        unit="occurrences",
    )
    ignition_count_limit: Count = described(
        "IgnitionCountLimit",
        "Ignition cycles after which the error is confirmed; 0 if they do not count.",
        unit="ignition cycles",
    )
    maturation_time: WrittenWhole = described(
        "MaturationTime", "How long the error has to be present to be confirmed; 0 if it is at once.", unit="ms"
    )
    maturation_time_nanoseconds: Integer | None = own(
        "MaturationTimeNanoseconds", "The maturation time, where it is not whole milliseconds; `MaturationTime` is rounded up then.",
        unit="ns",
    )  # fmt: skip
    severity: Text = described("Severity", "What the error leads to.")
    reset_time: Number | None = tabled(
        "ResetTime", "Time from the reset condition to the reset of the error.", unit="ms"
    )
    reset_condition: Text | None = tabled("ResetCondition", "Condition that resets the error.")
    asil_level: Name | None = own("AsilLevel", "ASIL: QM, A, B, C or D.")
    vss_path: VssPath | None = own("VssPath", "Path of the interface in the catalogue.")
    variable: CExpression | None = own(
        "Variable", "Expression of the C code in which the function says whether the error is present: not 0."
    )
    status_variable: CExpression | None = own(
        "StatusVariable", "Expression of the C code that holds the state of the error, written before a call."
    )
    defined_by: Definer | None = own("DefinedBy", DEFINED_BY)
    c_type: CTypeName | None = own("CType", C_TYPE)
    reset: Name | None = own(
        "Reset",
        "What the error has to wait for: Restart, or the name of a signal that the function consumes and that is not 0 "
        "while the reset condition holds. If absent, the error is reset when it is no longer present.",
    )

    @model_validator(mode="before")
    @classmethod
    def _exact(cls, data: Any) -> Any:
        return exact_time(data, "maturation_time", "MaturationTime")

    @field_serializer("maturation_time")
    def _published(self, time: float) -> int:
        """The published schema has whole milliseconds only."""
        return math.ceil(time)


class SafetyReaction(WireModel):
    """A safety condition of which the base software informs the function."""

    name: Name = described("Name", "Name of the interface: <SafetyCondition>_SftyCondSts.")
    description: Text = described("Description", "What the condition means for the function.")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    errors: Listed[Name] = described("ErrorList", "Error interfaces, any of which sets the condition.")
    asil_level: Name | None = own("AsilLevel", "ASIL: QM, A, B, C or D.")
    vss_path: VssPath | None = own("VssPath", "Path of the interface in the catalogue.")
    variable: CExpression | None = own(
        "Variable", "Expression of the C code that holds the condition, written before a call."
    )
    defined_by: Definer | None = own("DefinedBy", DEFINED_BY)
    c_type: CTypeName | None = own("CType", C_TYPE)
    initial: Name | None = own("Initial", "Condition before any is known: one of the enumeration; INACTIVE if absent.")
    timeout: Quantity | None = own(
        "Timeout", "Longest time between two values from outside, as a number in a text.", unit="ms"
    )


class ModeInterface(WireModel):
    """The interface over which a function receives its mode (In), or reports it (Out)."""

    name: Name = described("Name", "Name of the interface: <FunctionName>_Mode_In or _Mode_Out.", source=TABLE)
    description: Text = described("Description", "What the interface says.", source=TABLE)
    direction: Name = described("Direction", "In or Out.", source=TABLE)
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.", source=TABLE)
    modes: Listed[Name] = always("Modes", "Names of the modes.")
    vss_path: VssPath | None = own("VssPath", "Path of the interface in the catalogue.")
    variable: CExpression | None = own("Variable", "Expression of the C code that holds the mode.")
    defined_by: Definer | None = own("DefinedBy", DEFINED_BY)
    c_type: CTypeName | None = own("CType", C_TYPE)
    initial: Name | None = own("Initial", "Mode before the first one is received; the first of `Modes` if absent.")
    unknown_action: UnknownAction | None = own(
        "UnknownAction", "What a mode that is none of `Modes` leads to: Keep the last one, also if absent, or Initial."
    )
    unknown_error: SetErrorName = own("UnknownError", "Error interface that is set while the mode is none of `Modes`.")
    values: Listed[EnumerationValue] | None = own(
        "Values", "Numbers of the modes in the C code, where they are not those of the datatype."
    )
