"""Integration JSON for FMI: FMUs with their variables, and what importers connect."""

from typing import Annotated, Any, Literal

from pydantic import Field

from sigcat.function.document.field_types import CIdentifier, FmiVariableName, FunctionName, Name, UnitKey
from sigcat.function.document.text import Text
from sigcat.function.function_json.model import FunctionInfo, FunctionJson, MetaInfo
from sigcat.function.function_json.wire import OWN, Integer, Number, WireModel, described, own, written
from sigcat.integration.source_functions import source_functions

Causality = Literal["independent", "input", "output", "parameter"]
FmiType = Literal[
    "Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Boolean", "Enumeration"
]  # fmt: skip


class EnumerationItem(WireModel):
    """A value of an enumeration."""

    name: Name = described("Name", "Name of the value.", source=OWN)
    value: Integer = described("Value", "Its number.", source=OWN)


class FmuVariable(WireModel):
    """A variable of an FMU."""

    name: FmiVariableName = described(
        "Name", "Name of the variable: the path in the catalogue, with the members of structs.", source=OWN
    )
    reference: Annotated[Integer, Field(ge=0, le=2**32 - 1)] = described(
        "ValueReference", "Number by which importers set and get it.", source=OWN
    )
    causality: Causality = described("Causality", "independent, input, output or parameter.", source=OWN)
    type: FmiType = described("Type", "Datatype of FMI.", source=OWN)
    length: Annotated[Integer, Field(ge=1)] | None = own("Dimension", "Number of elements of an array.")
    unit: UnitKey | None = own("Unit", "Unit, by its key in the catalogue.")
    min: Number | None = own("Min", "Smallest valid value.")
    max: Number | None = own("Max", "Largest valid value.")
    start: tuple[Number | bool, ...] = described(
        "Start", "Value in the beginning, of each element.", source=OWN, strict=False
    )
    items: tuple[EnumerationItem, ...] | None = own("Items", "Values of an enumeration.", strict=False)
    description: Text = described("Description", "What it means.", source=OWN)


class Fmu(WireModel):
    """A functional mock-up unit."""

    name: CIdentifier = described("Name", "Name of the model, its file and its library.", source=OWN)
    description: Text = described("Description", "What it does.", source=OWN)
    functions: tuple[FunctionName, ...] = described(
        "FunctionNames", "Functions in it, in the order of their turns.", source=OWN, strict=False
    )
    token: CIdentifier = described("InstantiationToken", "Digest of the functions and of the variables.", source=OWN)
    step_size: Annotated[Number, Field(gt=0)] = described("StepSize", "Proposed step.", unit="ms", source=OWN)
    variables: tuple[FmuVariable, ...] = described(
        "VariableList", "Variables, by value reference.", source=OWN, strict=False
    )


class FmuConnection(WireModel):
    """An output of one FMU that is an input of another one."""

    start_fmu: CIdentifier = described("StartFmu", "FMU that has the output.", source=OWN)
    start_variable: FmiVariableName = described("StartVariable", "Name of the output.", source=OWN)
    end_fmu: CIdentifier = described("EndFmu", "FMU that has the input.", source=OWN)
    end_variable: FmiVariableName = described("EndVariable", "Name of the input.", source=OWN)


class FmiIntegration(WireModel):
    """The whole document."""

    meta: MetaInfo = described("MetaInfo", "Who is responsible for the document, and its version.", source=OWN)
    info: FunctionInfo = described("FmiInformation", "Name, description and responsible team of the set.", source=OWN)
    license: Text = described("License", "License of the FMUs.", source=OWN)
    copyright: Text | None = own("Copyright", "Copyright notice of the FMUs.")
    fmus: tuple[Fmu, ...] = described("FmuList", "The FMUs.", source=OWN, strict=False)
    connections: tuple[FmuConnection, ...] = described(
        "ConnectionList", "What an importer connects.", source=OWN, strict=False
    )
    functions: tuple[FunctionJson, ...] | None = source_functions()


def to_json(model: FmiIntegration) -> bytes:
    """The document as UTF-8 text with a stable layout."""
    return written(model)


def integration_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of Integration JSON for FMI."""
    schema = FmiIntegration.model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
