"""For every field of a function.yaml: where it stands in Function JSON. With it the report of an integration begins."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import PurePath
from typing import Any

from sigcat.function.declaration import code_section as code
from sigcat.function.declaration import declaration as yaml
from sigcat.function.declaration.form import DeclarationModel
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.report import Entry

_INTERFACE = "Name, VssPath and what the catalogue says of the interface"
_VALUE = {
    "path": "VssPath, VssDatatype, VssUnit and what the catalogue says of the signal", "name": "Name",
    "variable": "Variable", "rangeErrorAction": "RangeErrorAction", "init": "InitValue or InitElements", "min": "Min", "max": "Max",
    "datatype": "Datatype", "unit": "Units, ConversionFactor, ConversionOffset", "values": "Datatypes and VssSymbols",
    "factor": "Factor", "offset": "Offset", "definedBy": "DefinedBy", "cType": "CType", "members": "Members", "rangeError": "RangeError",
}  # fmt: skip
_MODE = {
    key: f"ModeInterfaceList: {target}"
    for key, target in {"variable": "Variable", "definedBy": "DefinedBy", "cType": "CType", "values": "Values"}.items()
}
TARGETS: Mapping[type[DeclarationModel], Mapping[str, str]] = {
    yaml.Declaration: {
        "function": "FunctionInfo: FunctionName", "description": "FunctionInfo: Description",
        "responsible": "FunctionInfo: FunctionResponsible", "version": "FunctionInfo: Version",
        "authority": "MetaInfo: Authority", "author": "MetaInfo: SchemaAuthor", "date": "MetaInfo: Date",
        "define": "Provenance: Definitions, TypeDefinitions, and each interface that refers to it",
    },
    yaml.ComponentItem: {"name": "ComponentList: Name"},
    yaml.RunnableItem: {
        "interface": f"functionList: {_INTERFACE}", "contract": "funcContractList: Type",
        "parallel": "functionList: ParallelProcessing", "events": "functionList: EventList",
        "symbol": "functionList: Symbol", "arguments": "functionList: Arguments",
        "success": "functionList: SuccessValue", "before": "functionList: PreProcessing",
        "after": "functionList: PostProcessing", "overrunError": "functionList: OverrunError",
    },
    yaml.DataItem: {key: f"SignalList or DataQList: {target}" for key, target in {
        **_VALUE, "role": "Role", "asil": "AsilLevel, AsilInfo of a queue", "access": "Access", "timeout": "Timeout",
        "timeoutError": "TimeoutError", "provider": "ExternalProvider", "queueLength": "QueueLength",
        "timeoutStart": "TimeoutStart", "timeoutValue": "TimeoutValue", "timeoutRecovery": "TimeoutRecovery",
        "e2eError": "E2eError", "overflow": "Overflow", "overflowError": "OverflowError", "valuesPerStep": "ValuesPerStep",
        "countVariable": "CountVariable",
    }.items()},
    yaml.ParameterItem: {key: f"ParameterList: {target}" for key, target in {
        **_VALUE, "kind": "Interfacetype", "attribute": "Attribute", "asil": "Asillevel", "key": "Key", "storage": "Storage",
    }.items()},
    yaml.ErrorItem: {
        "interface": f"ErrorList: {_INTERFACE}", "occurrenceCountLimit": "ErrorList: OccurenceCountLimit",
        "ignitionCountLimit": "ErrorList: IgnitionCountLimit", "variable": "ErrorList: Variable",
        "statusVariable": "ErrorList: StatusVariable", "definedBy": "ErrorList: DefinedBy",
        "cType": "ErrorList: CType", "reset": "ErrorList: Reset",
    },
    yaml.ReactionItem: {
        "interface": f"SafetyReactionList: {_INTERFACE}", "variable": "SafetyReactionList: Variable",
        "definedBy": "SafetyReactionList: DefinedBy", "cType": "SafetyReactionList: CType", "initial": "SafetyReactionList: Initial",
        "timeout": "SafetyReactionList: Timeout",
    },
    yaml.MethodItem: {
        "name": "MethodList: Name", "description": "MethodList: Description", "role": "MethodList: Role",
        "symbol": "MethodList: Symbol", "timeout": "MethodList: Timeout",
        "requestVariable": "MethodList: RequestVariable", "statusVariable": "MethodList: StatusVariable",
    },
    yaml.ArgumentItem: {key: f"InDataTypeList or OutDataTypeList: {target}" for key, target in {
        "name": "Name", "datatype": "Datatype", "unit": "Units", "variable": "Variable",
    }.items()},
    yaml.ModesItem: {"interfaces": f"ModeInterfaceList: {_INTERFACE}"},
    yaml.ModeInItem: {**_MODE, **{key: f"ModeInterfaceList: {target}" for key, target in {
        "initial": "Initial", "unknown": "UnknownAction", "unknownError": "UnknownError",
    }.items()}},
    yaml.ModeOutItem: _MODE,
    code.CodeSection: {key: f"Code: {target}" for key, target in {
        "signature": "Signature", "sources": "Sources", "headers": "Headers", "includeFolders": "IncludeFolders",
        "definitions": "Macros", "class": "ClassName", "storage": "Storage", "accessors": "Accessors",
    }.items()},
    code.ObjectItem: {key: f"Code: Objects: {target}" for key, target in {
        "name": "Name", "type": "Type", "length": "Length", "member": "Member", "definedBy": "DefinedBy",
    }.items()},
    code.CheckpointItem: {key: f"functionList: Checkpoint: {target}" for key, target in {
        "initial": "BeginsSequence", "final": "EndsSequence", "next": "Next",
    }.items()},
    yaml.ActiveMode: {
        "mode": "ModesList: Name", "description": "ModesList: Description", "runnables": "ModesList: RunnablesList",
    },
}  # fmt: skip
"""Targets of each field of a function.yaml, without those that hold other parts of it."""


def declared_fields(functions: Sequence[ResolvedFunction]) -> tuple[Entry, ...]:
    """An entry for each field that an author wrote; none of Function JSON, with whose fields the report begins then."""
    declared = [function for function in functions if function.origin is not None]
    return tuple(entry for each in declared for entry in _of_part(_declaration(each), (), each))


def _declaration(function: ResolvedFunction) -> yaml.Declaration:
    return yaml.Declaration.model_validate(function.document.value)


def _of_part(part: DeclarationModel, at: Pointer, function: ResolvedFunction) -> Iterator[Entry]:
    for field, info in type(part).model_fields.items():
        if field not in part.model_fields_set:
            continue
        key, value = info.alias or field, getattr(part, field)
        inner = list(_parts(value, (*at, key)))
        if inner and type(inner[0][1]) in TARGETS:
            for pointer, each in inner:
                yield from _of_part(each, pointer, function)
        elif value not in (None, []):
            yield _entry((*at, key), TARGETS[type(part)].get(key, ""), function)


def _parts(value: Any, at: Pointer) -> Iterator[tuple[Pointer, DeclarationModel]]:
    """The parts of a declaration that a field holds."""
    for pointer, each in ([((*at, i), item) for i, item in enumerate(value)] if isinstance(value, list) else [(at, value)]):  # fmt: skip
        if isinstance(each, DeclarationModel):
            yield pointer, each


def _entry(at: Pointer, target: str, function: ResolvedFunction) -> Entry:
    place = f"{PurePath(function.document.name).name}:{function.document.position(at).line}"
    return Entry(function.name, place, "declaration", ".".join(map(str, at)), f"Function JSON, {target}")
