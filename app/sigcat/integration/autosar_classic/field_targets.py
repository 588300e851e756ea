"""For every field of every interface of a function: its place in the Integration JSON, or that the core has it.

The document carries each function whole: what the core decides is taken from there, and stands nowhere else.
"""

from collections.abc import Iterator, Mapping, Sequence

from pydantic import BaseModel

from sigcat.function.exchange import Part, Side
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.wire import own_fields
from sigcat.integration.autosar_classic.context import Context, named_calls
from sigcat.integration.autosar_classic.elements import Element
from sigcat.integration.autosar_classic.parameters import parameters_of
from sigcat.integration.autosar_part_entries import PartTables, part_entries
from sigcat.integration.grouping import grouped
from sigcat.integration.report import OF_ABSENT, Entry, FieldTarget, Targets, entries

_CORE = FieldTarget("SourceFunctionList", "the core decides it, from the function that the document carries")
_SENT = "values are sent in the catalogue's datatype and unit; the core converts"


def _of_core(*models: type[BaseModel]) -> dict[str, FieldTarget | str]:
    """Targets of the fields that the published schema lacks, unless a table has another one."""
    return dict.fromkeys(own_fields(*models), _CORE)


_DATA: Targets = {
    **_of_core(Signal, DataQueue),
    "Name": "{port}/Elements/Uses/Interface", "Description": "{interface}/Description",
    "Role": FieldTarget("{port}/Direction", "and which accesses the runnable has"),
    "Datatype": FieldTarget("{interface}/Elements/Type", _SENT), "Units": FieldTarget("{interface}/Elements/Unit", _SENT),
    "VssPath": FieldTarget("{interface}/Elements/VssPath", "interface and ports are named by it"),
    "VssDatatype": "{interface}/Elements/Type", "VssUnit": "{interface}/Elements/Unit",
    "VssMin": "DataConstraints/{element}/Min", "VssMax": "DataConstraints/{element}/Max", "VssSymbols": "CompuMethods",
    "InitValue": FieldTarget("{port}/Elements/InitValue", "in the catalogue's unit"),
    "InitElements": FieldTarget("{port}/Elements/InitValue", "in the catalogue's unit"),
    "Default": FieldTarget("{port}/Elements/InitValue", "if the element has no InitValue; the core has it too"),
    "Timeout": FieldTarget("{port}/Elements/Uses/Timeout", "the core checks it: AliveTimeout of COM is 0"),
    "Access": FieldTarget("Runnables/Accesses/Kind", "Buffered: implicit, where the core need not know what is fresh"),
    "QueueLength": "{port}/Elements/QueueLength", "ExternalProvider": "Composition/Ports/ExternalProvider",
    "AsilLevel": "AsilLevel and MemorySections", "AsilInfo": "AsilLevel and MemorySections",
    "E2eError": FieldTarget("{port}/Elements/TransformerErrors", "the core gets what the transformer rejects"),
    **dict.fromkeys(("Min", "Max", "Factor", "Offset", "Type"), _CORE),
}  # fmt: skip
_METHOD: Targets = {
    **_of_core(MethodInterface),
    "Name": "{interface}/Operations/Name", "Description": "{interface}/Operations/Description",
    "Role": "{port}/Direction", "InDataTypeList": "{interface}/Operations/Arguments",
    "OutDataTypeList": "{interface}/Operations/Arguments",
    "Timeout": FieldTarget("{port}/Elements/Uses/Timeout", "the core checks it"),
}  # fmt: skip
_HEAD: Targets = {
    "Name": "{interface}/Name", "Description": "{interface}/Description", "Datatype": "{interface}/Elements/Type",
    "VssPath": "{interface}/Elements/VssPath", "AsilLevel": "AsilLevel and MemorySections",
}  # fmt: skip
_ERROR: Targets = {
    **_of_core(ErrorInterface), **_HEAD, "ResetTime": _CORE, "ResetCondition": _CORE,
    "Severity": "DiagnosticEvents/Severity", "OccurenceCountLimit": "DiagnosticEvents/OccurrenceCountLimit",
    "IgnitionCountLimit": "DiagnosticEvents/IgnitionCountLimit",
    "MaturationTime": FieldTarget("SourceFunctionList", "the core matures the error: DEM debounces nothing"),
    "MaturationTimeNanoseconds": FieldTarget("SourceFunctionList", "the core matures the error: DEM debounces nothing"),
    "Dependancy": FieldTarget("Ports", "a required port for each error of another component; the core decides"),
}  # fmt: skip
_REACTION: Targets = {
    **_of_core(SafetyReaction), **_HEAD, "ErrorList": "Inhibitions/Events", "Initial": "{port}/Elements/InitValue",
    "Timeout": FieldTarget("{port}/Elements/Uses/Timeout", "the core checks it"),
}  # fmt: skip
_MODE: Targets = {
    **_of_core(ModeInterface), **_HEAD, "Datatype": "ModeGroups/Type", "VssPath": FieldTarget("SourceFunctionList", "modes are named by their interface"),
    "Description": "{port}/Description", "Direction": "{port}/Direction", "Modes": "ModeGroups/Modes",
    "Initial": "ModeGroups/InitialMode",
}  # fmt: skip
_CALL: Targets = {
    **_of_core(Runnable),
    "Name": "{runnable}/Call", "Description": "{runnable}/Description", "Runtype": "{runnable}/Role",
    "Cycletime": "Events/Period", "CycletimeNanoseconds": "Events/Period", "ExecOffset": "Events/Offset",
    "EventList": FieldTarget("Events", "a data received event for each, of the runnable that receives values"),
    "DebounceDelay": FieldTarget("SourceFunctionList", "the core debounces; a timing event at each tick asks it"),
    "StackSize": "{runnable}/StackSize and MemorySections",
    "AsilLevel": "{runnable}/AsilLevel and Section", "Scheduling": "Ecu/Tasks/Preemptable",
    "Priority": FieldTarget("Ecu/Tasks/Events/Position", "among calls of one period; the task's follows from its period"),
    "PrevRunnable": _CORE, "ParallelProcessing": FieldTarget("SourceFunctionList", "the core answers no call then"),
    "Watchdog": "SupervisedEntities", "SupervisionType": "SupervisedEntities",
    "Checkpoint": "SupervisedEntities/Checkpoints and Logical",
    "funcContractList": FieldTarget("Ports and {runnable}/Accesses", "each interface has its own entries"),
    "VssPath": FieldTarget("SourceFunctionList", "a call is not a port"),
}  # fmt: skip
_PARAMETER: Targets = {
    **_of_core(ParameterInterface),
    "Name": "{parameter}/Name", "Description": "{parameter}/Description", "Datatype": "{parameter}/Type",
    "Min": FieldTarget("DataConstraints", "in the catalogue's unit"), "Max": FieldTarget("DataConstraints", "in the catalogue's unit"),
    "InitValue": "{parameter}/InitValue", "InitElements": "{parameter}/InitValue", "DefaultText": "{parameter}/InitValue",
    "Units": "{parameter}/Unit", "VssUnit": "{parameter}/Unit", "VssPath": "{parameter}/VssPath",
    "VssDatatype": "{parameter}/Type", "VssSymbols": "CompuMethods",
    "Asillevel": "AsilLevel and MemorySections",
    "Interfacetype": FieldTarget("ParameterInterfaces or NvBlocks", "PersistenceMemory is kept, the others are calibrated"),
    "Attribute": FieldTarget("NvBlocks/Parameters", "what is learned is kept"),
    "Default": _CORE, "RangeErrorAction": _CORE,
}  # fmt: skip
_FUNCTION: Targets = {
    "FunctionName": "ApplicationInformation/Functions, Components/Function",
    "FunctionResponsible": "ApplicationInformation/Responsible", "Description": "Components/Description",
    "Version": FieldTarget("Components/Version", "the version of the document is that of the deployment"),
}  # fmt: skip
_COMPONENT: Targets = {"Name": "Name", "functionList": "Runnables"}
_CONTRACT: Targets = {
    **OF_ABSENT,
    "Type": _CORE,
    **dict.fromkeys(
        ("SignalList", "DataQList", "MethodList", "ErrorList", "SafetyReactionList"),
        FieldTarget("Ports", "each interface has its own entries"),
    ),
    "ParameterList": FieldTarget("Ports or InternalParameters", "each interface has its own entries"),
}
_MODES: Targets = {"Name": "ModeGroups/Modes", "Description": _CORE, "RunnablesList": _CORE}
_TABLES = PartTables(_FUNCTION, _MODES, _COMPONENT)

TABLES: Mapping[type, tuple[str, Targets]] = {
    Signal: ("signal", _DATA),
    DataQueue: ("queue", _DATA),
    MethodInterface: ("method", _METHOD),
    ErrorInterface: ("error", _ERROR),
    SafetyReaction: ("safety reaction", _REACTION),
    ModeInterface: ("mode", _MODE),
}
"""Kind and targets of each interface."""
CALL_TARGETS, PARAMETER_TARGETS = _CALL, _PARAMETER


def field_targets(context: Context, elements: Sequence[Element]) -> tuple[Entry, ...]:
    """An entry for each field that has a value, in the order of the documents."""
    named = {(each.kind, each.identity): each for each in elements}
    told = (side for side in context.exchange.sides if side.provides or side.kind != "error")
    sides = grouped(told, lambda side: side.part.name)  # the entries of an error are those of who reports it
    made: list[Entry] = []
    for part in context.parts:
        made += _of_part(part)
        for side in sides.get(part.name, ()):
            made += _of_interface(side, named[side.kind, side.identity])
    return tuple(made)


def _of_interface(side: Side, element: Element) -> list[Entry]:
    kind, table = TABLES[type(side.interface)]
    lists = {"method": "ClientServerInterfaces", "mode": "ModeSwitchInterfaces"}
    names = {
        "port": f"{side.part.name}/Ports/{element.name}",
        "interface": f"{lists.get(kind, 'SenderReceiverInterfaces')}/{element.name}",
        "element": element.name,
    }
    return entries(side.function, side.interface.name, kind, side.interface, table, names)


def _of_part(part: Part) -> Iterator[Entry]:
    name = part.function_name
    yield from part_entries(part, _TABLES)
    parameters = {each.interface.name: each for each in reversed(parameters_of(part))}
    for each in named_calls(part):
        runnable = {"runnable": f"Runnables/{each.name if each.role == 'Step' else each.role}"}
        yield from entries(name, each.call.name, "call", each.call, _CALL, runnable, part.name)
        for contract in each.call.contracts or ():
            yield from entries(name, each.call.name, "contract", contract, _CONTRACT, runnable, part.name)
            for parameter in contract.parameters or ():
                found = parameters[parameter.name]
                place = {"parameter": f"{'NvBlocks' if found.is_stored else 'Parameters'}/{found.name}"}
                yield from entries(name, parameter.name, "parameter", parameter, _PARAMETER, place, part.name)
