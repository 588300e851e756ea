"""Internal behaviour of a component: runnables, what starts them, what they access."""

from typing import Literal

from sigcat.function.document.field_types import (
    CallName,
    CIdentifier,
    MethodName,
    Name,
    ParameterName,
    ShortName,
    SourceFile,
)
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import Integer, Listed, Number, WireModel, always, own

AccessKind = Literal[
    "ImplicitRead",
    "ExplicitRead",
    "QueuedReceive",
    "ExplicitWrite",
    "QueuedSend",
    "Mode",
    "ModeSwitch",
    "SynchronousCall",
    "AsynchronousCall",
    "Result",
    "Parameter",
    "InternalTrigger",
]
"""ImplicitRead: Rte_IRead, Rte_IStatus; ExplicitRead: Rte_Read, Rte_IsUpdated; QueuedReceive: Rte_Receive;
ExplicitWrite: Rte_Write; QueuedSend: Rte_Send; Mode: Rte_Mode; ModeSwitch: Rte_Switch; SynchronousCall,
AsynchronousCall: Rte_Call; Result: Rte_Result; Parameter: Rte_Prm; InternalTrigger: Rte_IrTrigger."""


class Access(WireModel):
    """A runnable's access to an element of a port; its kind decides which functions the RTE provides."""

    name: ShortName = always("Name", "Name of the access point, unique in the runnable.")
    kind: AccessKind = always("Kind", "Kind of access, which decides the functions of the RTE.")
    port: ShortName | None = own("Port", "Name of the port; absent for an internal trigger.")
    element: ShortName = always(
        "Element", "Name of the element, operation or mode prototype; of an internal trigger its runnable."
    )
    reason: Text | None = own("Reason", "Why it is accessed this way.")


class Runnable(WireModel):
    """A function in C that the RTE starts."""

    name: ShortName = always("Name", "Name of the runnable.")
    symbol: CIdentifier = always("Symbol", "Name of the function in C, unique on the ECU.")
    role: Literal["Init", "Step", "Method", "Receive", "Supervise", "JudgeWindows", "Answer", "Terminate"] = always(
        "Role", "What it does with the core."
    )
    call: CallName | None = own("Call", "Call of the function that it runs; absent where it runs none.")
    method: MethodName | None = own("Method", "Method of the function that it offers, or whose answer it takes.")
    description: Text | None = own("Description", "What it does.")
    concurrent: bool = always("CanBeInvokedConcurrently", "Whether it may run twice at the same time.")
    minimum_start_interval: Number = always("MinimumStartInterval", "Shortest time between two starts.", unit="s")
    accesses: Listed[Access] = always("Accesses", "What it does with ports.")
    exclusive_areas: Listed[ShortName] = always("ExclusiveAreas", "Exclusive areas that it enters.")
    parameters: Listed[ShortName] | None = own("Parameters", "Internal calibration parameters that it reads.")
    stack_size: Integer | None = own("StackSize", "Stack that the call needs.", unit="bytes")
    asil_level: Name | None = own("AsilLevel", "ASIL that it is implemented to.")
    section: ShortName = always("Section", "Memory section of its code: CODE, or with its ASIL.")


class Event(WireModel):
    """An event that starts a runnable."""

    name: ShortName = always("Name", "Name of the event.")
    kind: Literal[
        "Init", "Timing", "DataReceived", "ModeSwitch", "OperationInvoked", "CallReturns", "InternalTrigger"
    ] = always("Kind", "Kind of the event.")
    runnable: ShortName = always("Runnable", "Runnable that it starts.")
    period: Number | None = own("Period", "Period of a timing event.", unit="s")
    offset: Number | None = own("Offset", "Offset of a timing event.", unit="s")
    port: ShortName | None = own("Port", "Port that receives, calls or switches.")
    element: ShortName | None = own(
        "Element", "Data element, operation or mode prototype; of an internal trigger its access point."
    )
    source: ShortName | None = own("Source", "Runnable that has the access point which triggers or whose call returns.")
    mode: ShortName | None = own("Mode", "Mode that is entered or left.")
    activation: Literal["OnEntry", "OnExit"] | None = own("Activation", "OnEntry or OnExit of the mode.")


class ExclusiveArea(WireModel):
    """An area that only one runnable is in at a time."""

    name: ShortName = always("Name", "Name of the area, as in Rte_Enter_<name>.")
    description: Text = always("Description", "What it protects.")


class PerInstanceMemory(WireModel):
    """Memory of the component that the RTE holds, in a datatype of C."""

    name: ShortName = always("Name", "Name of the memory, as in Rte_Pim_<name>.")
    type: CIdentifier = always("Type", "Datatype of C.")
    type_definition: CIdentifier = always("TypeDefinition", "What the type is defined as, in C.")
    header: SourceFile | None = own("Header", "Header that defines it.")
    description: Text = always("Description", "What it holds.")


class InternalParameter(WireModel):
    """A calibration parameter that stays within the component."""

    name: ShortName = always("Name", "Name of the parameter, as in Rte_CData_<name>.")
    type: ShortName = always("Type", "Name of its application type.")
    init: object = own("InitValue", "Its value.")
    uses: Listed[ParameterName] = always("Uses", "Names of the parameters of the function behind it.")


class MemorySection(WireModel):
    """A section into which code or variables of the component are placed."""

    name: ShortName = always("Name", "Name, as in <Component>_START_SEC_<name>.")
    kind: Literal["CODE", "VAR_CLEARED", "VAR_INIT", "CONST", "CALIB"] = always("Kind", "What is in it.")
    asil_level: Name = always("AsilLevel", "ASIL of its content: QM, A, B, C or D.")
    alignment: Literal["UNSPECIFIED", "8", "32", "BOOLEAN"] = always("Alignment", "Alignment in bits.")
    stack_size: Integer | None = own("StackSize", "Largest stack that a runnable in it needs.", unit="bytes")
