"""For every field of every interface of a function: its place in the Integration JSON."""

from collections.abc import Iterator, Mapping, Sequence

from pydantic import BaseModel

from sigcat.function.exchange import Part, Side
from sigcat.function.function_json.code import CodeInterface
from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.methods import MethodInterface
from sigcat.function.function_json.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.autosar_adaptive.code import CallCode, ParameterCode
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.elements import Service, element_paths
from sigcat.integration.report import Entry, FieldTarget, entries

_CATALOGUE = "sent in the catalogue's datatype and unit; its use has those of the code"
_RANGE = "the event has the catalogue's range, or else the provider's"
_PLACE = "says which service and which side"
_PROCESS = "the process has that of its most urgent cyclic call, in Startup"


def _kept(place: str, *models: type[BaseModel]) -> dict[str, FieldTarget | str]:
    """Targets of fields that are kept at a place, unless a table has another one."""
    return {str(field.alias): f"{place}/{field.alias}" for model in models for field in model.model_fields.values()}


_DATA: dict[str, FieldTarget | str] = {
    "Name": "Uses/{of}/Name", "Description": "Description", "Role": FieldTarget("Role", _PLACE),
    "Datatype": FieldTarget("DataType and Uses/CodeDatatype", _CATALOGUE),
    "Units": FieldTarget("Unit and Uses/{of}/Units", _CATALOGUE),
    "Min": FieldTarget("Uses/{of}/Min", _RANGE), "Max": FieldTarget("Uses/{of}/Max", _RANGE),
    "VssPath": FieldTarget("Name and VssPath", "the event is named by it"),
    "VssDatatype": FieldTarget("DataType and Uses/{of}/VssDatatype"),
    "VssMin": FieldTarget("Min and Uses/{of}/VssMin"), "VssMax": FieldTarget("Max and Uses/{of}/VssMax"),
    "VssSymbols": FieldTarget("DataTypes and Uses/{of}/VssSymbols", "sent with these numbers"),
    "VssUnit": FieldTarget("Unit and Uses/{of}/VssUnit"), "Variable": "DataMappingList",
    "Factor": FieldTarget("Uses/{of}/Factor", "scaling inside the code; also Scaling where no catalogue is known"),
    "Offset": FieldTarget("Uses/{of}/Offset", "scaling inside the code; also Offset where no catalogue is known"),
}  # fmt: skip
_SIGNAL = {**_kept("Uses/{of}", Signal, DataQueue), **_DATA}
_METHOD: dict[str, FieldTarget | str] = {
    **_kept("Uses/Method", MethodInterface),
    "Name": "Name", "Description": "Description", "Role": FieldTarget("Role", _PLACE),
    "InDataTypeList": "InArguments", "OutDataTypeList": "OutArguments",
}  # fmt: skip
_STATUS_HEAD: dict[str, FieldTarget | str] = {
    "Name": "Name", "Description": "Description", "Datatype": "DataType", "VssPath": "VssPath",
}  # fmt: skip
_ERROR = {**_kept("Error", ErrorInterface), **_STATUS_HEAD}
_REACTION = {**_kept("SafetyReaction", SafetyReaction), **_STATUS_HEAD}
_MODE = {**_kept("Mode", ModeInterface), **_STATUS_HEAD, "Direction": FieldTarget("Role", _PLACE)}
_CALL: dict[str, FieldTarget | str] = {
    "Runtype": "RunType", "Cycletime": "CycleTime", "CycletimeNanoseconds": "CycleTime", "Scheduling": FieldTarget("Scheduling", _PROCESS),
    "Priority": FieldTarget("Priority", _PROCESS), "SupervisionType": "SupervisionType",
    "funcContractList": FieldTarget("ServiceInterfaceList and ParameterList", "each interface has its own entries"),
    **{
        field: field
        for field in (
            "Name", "Description", "StackSize", "PrevRunnable", "ExecOffset", "ParallelProcessing", "AsilLevel",
            "Watchdog", "DebounceDelay", "VssPath",
        )
    },
    "EventList": FieldTarget("EventList and Triggers", "each event as the event of a service"),
    **{str(field.alias): f"Code/{field.alias}" for field in CallCode.model_fields.values()},
}  # fmt: skip
_PARAMETER: dict[str, FieldTarget | str] = {
    "Datatype": "Datatype and CodeDatatype", "Asillevel": "AsilLevel", "Min": "Datatype/MinValue",
    "Max": "Datatype/MaxValue", "Default": "Datatype/Default", "InitValue": "Datatype/InitValue",
    "Units": "Datatype/Unit", "DefaultText": "Datatype/Default",
    "Interfacetype": FieldTarget("InterfaceType", "PersistenceMemory is spelled as the published schema has it"),
    **{
        field: field
        for field in (
            "Name", "Description", "RangeErrorAction", "Attribute", "VssPath", "VssDatatype", "VssUnit", "VssSymbols",
            "ConversionFactor", "ConversionOffset", "Variable",
        )
    },
    **{str(field.alias): f"Code/{field.alias}" for field in ParameterCode.model_fields.values()},
    "Factor": "Code/Factor and Datatype/Scaling", "Offset": "Code/Offset and Datatype/Offset",
    "InitElements": "Code/InitElements and Datatype/InitValue",
}  # fmt: skip
_NO_RANGE = FieldTarget(
    "none", "a boolean or a text has no range, unit or number; the published schema has no place for it"
)
_FUNCTION: dict[str, FieldTarget | str] = {
    "FunctionName": "FunctionInformation/Functions, Component/Function",
    "FunctionResponsible": "FunctionInformation/Responsible", "Description": "Component/Description",
    "Version": FieldTarget("Component/Version", "the version of the document is that of the deployment"),
}  # fmt: skip
_META: dict[str, FieldTarget | str] = {
    "Authority": "MetaInformation/Authority", "SchemaAuthor": "MetaInformation/Author", "Date": "MetaInformation/Date",
    **dict.fromkeys(
        ("SchemaVersion", "SchemaDescription"), FieldTarget("none", "each format has its own version and description"),
    ),
}  # fmt: skip
_CODE: dict[str, FieldTarget | str] = {
    str(field.alias): f"Code/{field.alias}" for field in CodeInterface.model_fields.values()
}
_COMPONENT: dict[str, FieldTarget | str] = {"Name": "Name", "functionList": "FunctionList"}
_CONTRACT: dict[str, FieldTarget | str] = {
    "Type": "ContractTypes",
    **dict.fromkeys(
        ("SignalList", "DataQList", "MethodList", "ErrorList", "SafetyReactionList"),
        FieldTarget("ServiceInterfaceList", "each interface has its own entries"),
    ),
    "ParameterList": FieldTarget("ParameterList", "each interface has its own entries"),
}
_MODES: dict[str, FieldTarget | str] = {"Name": "Name", "Description": "Description", "RunnablesList": "Calls"}

TABLES: Mapping[type, tuple[str, Mapping[str, FieldTarget | str]]] = {
    Signal: ("signal", _SIGNAL),
    DataQueue: ("queue", _SIGNAL),
    MethodInterface: ("method", _METHOD),
    ErrorInterface: ("error", _ERROR),
    SafetyReaction: ("safety reaction", _REACTION),
    ModeInterface: ("mode", _MODE),
}
"""Kind and targets of each interface; targets are relative to the event, method or field."""
_INSIDE: Mapping[type, str] = {
    Signal: "Uses/Signal", DataQueue: "Uses/Queue", ErrorInterface: "Error", SafetyReaction: "SafetyReaction",
    ModeInterface: "Mode",
}  # fmt: skip
"""Targets of interfaces that are kept whole, with all of their fields."""
CALL_TARGETS: Mapping[str, FieldTarget | str] = _CALL
PARAMETER_TARGETS: Mapping[str, FieldTarget | str] = _PARAMETER


def field_targets(context: Context, all_services: Sequence[Service]) -> tuple[Entry, ...]:
    """An entry for each field that has a value, in the order of the documents."""
    names = element_paths(all_services)
    made: list[Entry] = []
    for part in context.parts:
        made.extend(_of_part(part))
    for side in context.exchange.sides:
        if side.provides or side.kind != "error":  # the entries of an error are those of who reports it
            made.extend(_of_interface(side, names[id(side.interface)]))
    return tuple(made)


def _of_interface(side: Side, element: str) -> list[Entry]:
    kind, table = TABLES[type(side.interface)]
    of = "Queue" if isinstance(side.interface, DataQueue) else "Signal"
    prefix = f"{side.part.name}/{element}"
    below = _below(prefix, table, of)
    if type(side.interface) in _INSIDE:
        inside = _INSIDE[type(side.interface)]
        for field in side.interface.model_extra or ():
            below[field] = FieldTarget(f"{prefix}/{inside}/{field}", "no field that sigcat knows; carried as it is")
    return entries(side.function, side.interface.name, kind, side.interface, below)


def _below(prefix: str, table: Mapping[str, FieldTarget | str], of: str = "") -> dict[str, FieldTarget | str]:
    placed: dict[str, FieldTarget | str] = {}
    for field, known in table.items():
        target = FieldTarget(known) if isinstance(known, str) else known
        placed[field] = FieldTarget(f"{prefix}/{target.target.replace('{of}', of)}", target.note)
    return placed


def _of_part(part: Part) -> Iterator[Entry]:
    function = part.function
    if part.is_first:
        yield from entries(part.function_name, part.function_name, "document", function.meta, _META)
        yield from entries(part.function_name, part.function_name, "function", function.info, _FUNCTION)
        if function.code is not None:
            below = _below(part.name, _CODE)
            yield from entries(part.function_name, part.function_name, "code", function.code, below)
        for mode in function.modes or ():
            prefix = f"{part.name}/FunctionModes/{mode.name}"
            yield from entries(part.function_name, mode.name, "active mode", mode, _below(prefix, _MODES))
    yield from entries(part.function_name, part.name, "component", part.component, _below(part.name, _COMPONENT))
    for call in part.component.runnables:
        prefix = f"{part.name}/FunctionList/{call.name}"
        yield from entries(part.function_name, call.name, "call", call, _below(prefix, _CALL))
        for contract in call.contracts or ():
            yield from entries(part.function_name, call.name, "contract", contract, _below(prefix, _CONTRACT))
            for parameter in contract.parameters or ():
                below = _below(f"{part.name}/ParameterList/{parameter.name}", _PARAMETER)
                if parameter.datatype in ("DT_Bool", "DT_String"):
                    below.update(dict.fromkeys(("Min", "Max", "Units"), _NO_RANGE))
                yield from entries(part.function_name, parameter.name, "parameter", parameter, below)
