"""Facts about the C code of a function for its adapter, where the published schema has no place for them."""

from typing import TypeVar

from pydantic import BaseModel

from sigcat.function.document.field_types import (
    CallName,
    CIdentifier,
    Definer,
    ErrorName,
    FunctionName,
    Name,
    NumberText,
)
from sigcat.function.document.text import Text
from sigcat.function.function_json.code import Checkpoint, Member
from sigcat.function.function_json.datatypes.c_type import C_TYPE, CTypeName
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.wire import Integer, Listed, WireModel, always, own


class CallCode(WireModel):
    """A call in C, as it is in Function JSON."""

    symbol: CIdentifier | None = own("Symbol", "Function or member function; the name of the call if absent.")
    arguments: Listed[CIdentifier] | None = own("Arguments", "Objects that it takes pointers to, in order.")
    success_value: Integer | None = own("SuccessValue", "Result that means success.")
    pre_processing: Listed[CIdentifier] | None = own("PreProcessing", "C functions that run before it.")
    post_processing: Listed[CIdentifier] | None = own("PostProcessing", "C functions that run after it.")
    checkpoint: Checkpoint | None = own("Checkpoint", "Place of the call in the graph of the logical supervision.")
    overrun_error: ErrorName | None = own("OverrunError", "Error interface that is set when activations were missed.")


class ParameterCode(WireModel):
    """A parameter in C and in its storage, as it is in Function JSON."""

    factor: NumberText | None = own("Factor", "Scaling in the code: physical value = stored value × factor + offset.")
    offset: NumberText | None = own("Offset", "Offset of the scaling.")
    defined_by: Definer | None = own("DefinedBy", "Function or Adapter: whose code defines the variable.")
    c_type: CTypeName | None = own("CType", C_TYPE)
    members: Listed[Member] | None = own("Members", "Members of the struct in C.")
    key: Name | None = own("Key", "Key under which the value is stored.")
    storage: Name | None = own("Storage", "Key-value storage that holds it.")
    range_error: ErrorName | None = own("RangeError", "Error interface that is set while the value is out of range.")
    init_elements: Text | None = own("InitElements", "Value of an array or struct at start-up, as JSON.")


class MethodUse(WireModel):
    """One call's side of a method."""

    function: FunctionName = always("Function", "Name of the function.")
    component: Name = always("Component", "Name of the component.")
    call: CallName = always("Call", "Name of the call.")
    method: MethodInterface = always("Method", "The method as it is in Function JSON.")


Code = TypeVar("Code", CallCode, ParameterCode)


def code_of(part: BaseModel, kind: type[Code]) -> Code | None:
    """The fields that a part of Function JSON has of these; None if it has none of them."""
    given = {name: getattr(part, name) for name in kind.model_fields}
    return kind(**given) if any(value is not None for value in given.values()) else None
