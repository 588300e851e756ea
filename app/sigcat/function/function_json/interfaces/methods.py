"""Methods of a call, with their arguments and return values."""

from sigcat.function.document.field_types import CExpression, CIdentifier, Name, Quantity, UnitKey
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import Listed, TypeReference, WireModel, described, own


class Argument(WireModel):
    """An argument or a return value of a method."""

    name: Name = described("Name", "Name of the argument or return value.")
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.")
    units: UnitKey = described("Units", "Unit of the value; empty if it has none.")
    variable: CExpression | None = own("Variable", "Expression of the C code that holds the value.")


class MethodInterface(WireModel):
    """A call that one function offers and others use."""

    name: Name = described("Name", "Name of the method.")
    description: Text = described("Description", "What the method does.")
    role: Name = described("Role", "Consumer or Provider.")
    inputs: Listed[Argument] = described("InDataTypeList", "Arguments, in order.")
    outputs: Listed[Argument] = described("OutDataTypeList", "Return values, in order.")
    symbol: CIdentifier | None = own("Symbol", "C function that does what a provided method offers.")
    timeout: Quantity | None = own("Timeout", "Longest time until the answer, as a number in a text.", unit="ms")
    request_variable: CExpression | None = own(
        "RequestVariable", "Expression of the C code that asks for a call of a consumed method: not 0."
    )
    status_variable: CExpression | None = own(
        "StatusVariable",
        "Expression of the C code that holds what became of it: IDLE 0, PENDING 1, DONE 2, FAILED 3 or TIMEOUT 4.",
    )
