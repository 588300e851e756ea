"""Port interfaces."""

from typing import Literal

from sigcat.function.document.field_types import Name, ShortName, UnitKey, VssPath
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import Integer, Listed, WireModel, always, own

Kind = Literal["SenderReceiver", "ClientServer", "ModeSwitch", "Parameter"]
"""Kind of a port interface."""


class DataElement(WireModel):
    """A variable of a sender-receiver interface, or a parameter of a parameter interface."""

    name: ShortName = always("Name", "Name of the element.")
    type: ShortName = always("Type", "Name of its application type; of an implementation type where there is none.")
    description: Text | None = own("Description", "What the value means.")
    queued: bool | None = own("Queued", "Whether values are queued; each is then an event that is not lost.")
    vss_path: VssPath | None = own("VssPath", "Path in the catalogue.")
    unit: UnitKey | None = own("Unit", "Unit in which the value is sent, as the catalogue has it.")


class SenderReceiverInterface(WireModel):
    """Data that one component sends and others receive."""

    name: ShortName = always("Name", "Name of the interface.")
    elements: Listed[DataElement] = always("Elements", "Data elements.")
    description: Text | None = own("Description", "What it carries.")


class ParameterInterface(WireModel):
    """Calibration parameters."""

    name: ShortName = always("Name", "Name of the interface.")
    elements: Listed[DataElement] = always("Elements", "Parameters.")


class OperationArgument(WireModel):
    """An argument of an operation."""

    name: ShortName = always("Name", "Name of the argument.")
    type: ShortName = always("Type", "Name of its implementation type.")
    direction: Literal["IN", "OUT", "INOUT"] = always("Direction", "IN, OUT or INOUT.")
    unit: UnitKey | None = own("Unit", "Unit of the value.")


class ApplicationError(WireModel):
    """An error that an operation can return."""

    name: ShortName = always("Name", "Name of the error.")
    value: Integer = always("Value", "Its number: 1 to 63.")


class Operation(WireModel):
    """An operation of a client-server interface."""

    name: ShortName = always("Name", "Name of the operation.")
    arguments: Listed[OperationArgument] = always("Arguments", "Arguments, in order.")
    errors: Listed[Name] | None = own("PossibleErrors", "Names of the errors that it can return.")
    description: Text | None = own("Description", "What it does.")


class ClientServerInterface(WireModel):
    """Operations that one component offers and others call; or a service of the base software."""

    name: ShortName = always("Name", "Name of the interface.")
    operations: Listed[Operation] = always("Operations", "Operations.")
    errors: Listed[ApplicationError] | None = own("ApplicationErrors", "Errors that operations return.")
    service: Name | None = own(
        "ServiceKind",
        "Module of the base software that offers it: DiagnosticEventManager, NvRamManager, WatchdogManager, FunctionInhibitionManager; "
        "absent if a component does.",
    )


class ModeSwitchInterface(WireModel):
    """A mode that one component switches and others follow."""

    name: ShortName = always("Name", "Name of the interface.")
    group: ShortName = always("ModeGroup", "Name of its mode declaration group.")
    prototype: ShortName = always(
        "Prototype", "Name of the mode within the interface, as in Rte_Mode_<port>_<prototype>."
    )
    service: Name | None = own("ServiceKind", "Module of the base software that switches it: EcuManager.")
