"""Integration JSON for FMI: FMUs with their variables, and what importers connect."""

from typing import Annotated, Literal

from pydantic import Field

from sigcat.function.document.field_types import CIdentifier, FmiVariableName, FunctionName, Name, UnitKey
from sigcat.function.document.text import Text
from sigcat.function.function_json.model import FunctionInfo, FunctionJson, MetaInfo
from sigcat.function.function_json.wire import Integer, Listed, Number, WireModel, always, own
from sigcat.integration.fmi.bus import FmuBus
from sigcat.integration.source_functions import source_functions

Causality = Literal["independent", "input", "output", "parameter"]
FmiType = Literal[
    "Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Boolean", "Enumeration"
]  # fmt: skip


class EnumerationItem(WireModel):
    """A value of an enumeration."""

    name: Name = always("Name", "Name of the value.")
    value: Integer = always("Value", "Its number.")


class FmuVariable(WireModel):
    """A variable of an FMU."""

    name: FmiVariableName = always(
        "Name", "Name of the variable: the path in the catalogue, with the members of structs."
    )
    reference: Annotated[Integer, Field(ge=0, le=2**32 - 1)] = always(
        "ValueReference", "Number by which importers set and get it."
    )
    causality: Causality = always("Causality", "independent, input, output or parameter.")
    type: FmiType = always(
        "Type", "Datatype of FMI 3.0. FMI 2.0 has Real for floating-point numbers and for integers beyond 32 bits."
    )
    length: Annotated[Integer, Field(ge=1)] | None = own("Dimension", "Number of elements of an array.")
    unit: UnitKey | None = own("Unit", "Unit, by its key in the catalogue.")
    min: Number | None = own("Min", "Smallest valid value.")
    max: Number | None = own("Max", "Largest valid value.")
    start: Listed[Number | bool] = always("Start", "Value in the beginning, of each element.")
    items: Listed[EnumerationItem] | None = own("Items", "Values of an enumeration.")
    description: Text = always("Description", "What it means.")


class FmuClock(WireModel):
    """An input clock: the importer activates a call by it."""

    name: FmiVariableName = always("Name", "Name of the call.")
    reference: Annotated[Integer, Field(ge=0, le=2**32 - 1)] = always(
        "ValueReference", "Number by which importers activate it; it follows those of the variables."
    )
    interval: Annotated[Integer, Field(ge=1)] | None = own(
        "Interval", "Time between two activations; absent if a signal triggers the call.", unit="ns"
    )
    shift: Annotated[Integer, Field(ge=0)] = always("Shift", "Time of the first activation.", unit="ns")
    priority: Annotated[Integer, Field(ge=0, le=2**32 - 1)] = always(
        "Priority", "Order of activations at one time: the smallest first."
    )
    description: Text = always("Description", "What the call does.")


class Fmu(WireModel):
    """A functional mock-up unit."""

    name: CIdentifier = always("Name", "Name of the model, its file and its library.")
    description: Text = always("Description", "What it does.")
    functions: Listed[FunctionName] = always("FunctionNames", "Functions in it, in the order of their turns.")
    token: CIdentifier = always("InstantiationToken", "Digest of the functions and of the variables.")
    step_size: Annotated[Number, Field(gt=0)] = always("StepSize", "Proposed step.", unit="ms")
    variables: Listed[FmuVariable] = always("VariableList", "Variables, by value reference.")
    clocks: Listed[FmuClock] | None = own("ClockList", "Clocks of its calls, for scheduled execution.")
    bus: FmuBus | None = own("CanBus", "CAN bus that carries its variables.")


class FmuConnection(WireModel):
    """An output of one FMU that is an input of another one."""

    start_fmu: CIdentifier = always("StartFmu", "FMU that has the output.")
    start_variable: FmiVariableName = always("StartVariable", "Name of the output.")
    end_fmu: CIdentifier = always("EndFmu", "FMU that has the input.")
    end_variable: FmiVariableName = always("EndVariable", "Name of the input.")


class FmiIntegration(WireModel):
    """The whole document."""

    meta: MetaInfo = always("MetaInfo", "Who is responsible for the document, and its version.")
    info: FunctionInfo = always("FmiInformation", "Name, description and responsible team of the set.")
    version: Literal["2.0"] | None = own("FmiVersion", "2.0 for FMI 2.0; absent for FMI 3.0.")
    interface: Literal["scheduledExecution"] | None = own(
        "InterfaceType", "scheduledExecution if importers activate calls; absent for co-simulation."
    )
    license: Text = always("License", "License of the FMUs.")
    copyright: Text | None = own("Copyright", "Copyright notice of the FMUs.")
    fmus: Listed[Fmu] = always("FmuList", "The FMUs.")
    connections: Listed[FmuConnection] = always("ConnectionList", "What an importer connects.")
    functions: tuple[FunctionJson, ...] | None = source_functions()
