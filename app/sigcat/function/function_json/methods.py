"""Methods of a call, with their arguments and return values."""

from sigcat.function.function_json.wire import TypeReference, WireModel, described


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
