"""For every field of every interface of a function: its place in the Integration JSON."""

from collections.abc import Iterator, Mapping, Sequence

from sigcat.function.exchange import Part, Side
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.autosar_adaptive.code import CallCode, ParameterCode
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.services.elements import Service, element_paths
from sigcat.integration.autosar_part_entries import PartTables, part_entries
from sigcat.integration.report import OF_ABSENT, Entry, FieldTarget, Targets, entries, fields_of, same_names

_CATALOGUE = "sent in the catalogue's datatype and unit; its use has those of the code"
_RANGE = "the event has the catalogue's range, or else the provider's"
_PLACE = "says which service and which side"
_PROCESS = "the process has that of its most urgent cyclic call, in Startup"


_DATA: Targets = {
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
_SIGNAL = {**same_names("Uses/{of}/", fields_of(Signal, DataQueue)), **_DATA}
_METHOD: Targets = {
    **same_names("Uses/Method/", fields_of(MethodInterface)),
    "Name": "Name", "Description": "Description", "Role": FieldTarget("Role", _PLACE),
    "InDataTypeList": "InArguments", "OutDataTypeList": "OutArguments",
}  # fmt: skip
_STATUS_HEAD: Targets = {
    "Name": "Name", "Description": "Description", "Datatype": "DataType", "VssPath": "VssPath",
}  # fmt: skip
_ERROR = {**same_names("Error/", fields_of(ErrorInterface)), **_STATUS_HEAD}
_REACTION = {**same_names("SafetyReaction/", fields_of(SafetyReaction)), **_STATUS_HEAD}
_MODE = {**same_names("Mode/", fields_of(ModeInterface)), **_STATUS_HEAD, "Direction": FieldTarget("Role", _PLACE)}
_CALL: Targets = {
    "Runtype": "RunType", "Cycletime": "CycleTime", "CycletimeNanoseconds": "CycleTime", "Scheduling": FieldTarget("Scheduling", _PROCESS),
    "Priority": FieldTarget("Priority", _PROCESS), "SupervisionType": "SupervisionType",
    "funcContractList": FieldTarget("ServiceInterfaceList and ParameterList", "each interface has its own entries"),
    **same_names("", (
        "Name", "Description", "StackSize", "PrevRunnable", "ExecOffset", "ParallelProcessing", "AsilLevel", "Watchdog",
        "DebounceDelay", "VssPath",
    )),
    "EventList": FieldTarget("EventList and Triggers", "each event as the event of a service"),
    **same_names("Code/", fields_of(CallCode)),
}  # fmt: skip
_PARAMETER: Targets = {
    "Datatype": "Datatype and CodeDatatype", "Asillevel": "AsilLevel", "Min": "Datatype/MinValue",
    "Max": "Datatype/MaxValue", "Default": "Datatype/Default", "InitValue": "Datatype/InitValue",
    "Units": "Datatype/Unit", "DefaultText": "Datatype/Default",
    "Interfacetype": FieldTarget("InterfaceType", "PersistenceMemory is spelled as the published schema has it"),
    **same_names("", (
        "Name", "Description", "RangeErrorAction", "Attribute", "VssPath", "VssDatatype", "VssUnit", "VssSymbols",
        "ConversionFactor", "ConversionOffset", "Variable",
    )),
    **same_names("Code/", fields_of(ParameterCode)),
    "Factor": "Code/Factor and Datatype/Scaling", "Offset": "Code/Offset and Datatype/Offset",
    "InitElements": "Code/InitElements and Datatype/InitValue",
}  # fmt: skip
_NO_RANGE: Targets = dict.fromkeys(
    ("Min", "Max", "Units"),
    FieldTarget("none", "a boolean or a text has no range, unit or number; the published schema has no place for it"),
)
_FUNCTION: Targets = {
    "FunctionName": "FunctionInformation/Functions, Component/Function",
    "FunctionResponsible": "FunctionInformation/Responsible", "Description": "Component/Description",
    "Version": FieldTarget("Component/Version", "the version of the document is that of the deployment"),
}  # fmt: skip
_COMPONENT: Targets = {"Name": "Name", "functionList": "FunctionList"}
_CONTRACT: Targets = {
    **OF_ABSENT,
    "Type": "ContractTypes",
    **dict.fromkeys(
        ("SignalList", "DataQList", "MethodList", "ErrorList", "SafetyReactionList"),
        FieldTarget("ServiceInterfaceList", "each interface has its own entries"),
    ),
    "ParameterList": FieldTarget("ParameterList", "each interface has its own entries"),
}
_MODES: Targets = {"Name": "Name", "Description": "Description", "RunnablesList": "Calls"}
_TABLES = PartTables(_FUNCTION, _MODES, _COMPONENT)

TABLES: Mapping[type, tuple[str, Targets]] = {
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
CALL_TARGETS: Targets = _CALL
PARAMETER_TARGETS: Targets = _PARAMETER


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
    part = side.interface
    kind, table = TABLES[type(part)]
    inside = _INSIDE.get(type(part))
    unknown = {
        field: FieldTarget(f"{inside}/{field}", "no field that sigcat knows; carried as it is")
        for field in (part.model_extra or () if inside else ())
    }
    names = {"of": "Queue" if isinstance(part, DataQueue) else "Signal"}
    return entries(side.function, part.name, kind, part, {**table, **unknown}, names, f"{side.part.name}/{element}")


def _of_part(part: Part) -> Iterator[Entry]:
    name = part.function_name
    yield from part_entries(part, _TABLES, f"{part.name}/FunctionModes")
    for call in part.component.runnables:
        place = f"{part.name}/FunctionList/{call.name}"
        yield from entries(name, call.name, "call", call, _CALL, below=place)
        for contract in call.contracts or ():
            yield from entries(name, call.name, "contract", contract, _CONTRACT, below=place)
            for parameter in contract.parameters or ():
                has_range = parameter.datatype not in ("DT_Bool", "DT_String")
                targets = _PARAMETER if has_range else {**_PARAMETER, **_NO_RANGE}
                place_of = f"{part.name}/ParameterList/{parameter.name}"
                yield from entries(name, parameter.name, "parameter", parameter, targets, below=place_of)
