"""For every field of a function.yaml: its place in Function JSON. The report of an integration begins with it."""

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
    "path": "VssPath, VssDatatype, VssUnit and what the catalogue says of the signal", "init": "InitValue or InitElements",
    "unit": "Units, ConversionFactor, ConversionOffset", "values": "Datatypes and VssSymbols",
}  # fmt: skip
_MODES = "ModeInterfaceList"
TARGETS: Mapping[type[DeclarationModel], tuple[str, Mapping[str, str]]] = {
    yaml.Declaration: ("", {
        "function": "FunctionInfo: FunctionName", "description": "FunctionInfo: Description",
        "responsible": "FunctionInfo: FunctionResponsible", "version": "FunctionInfo: Version",
        "authority": "MetaInfo: Authority", "author": "MetaInfo: SchemaAuthor", "date": "MetaInfo: Date",
        "define": "Provenance: Definitions, TypeDefinitions, and each interface that refers to it",
    }),
    yaml.ComponentItem: ("ComponentList", {}),
    yaml.RunnableItem: ("functionList", {
        "interface": _INTERFACE, "contract": "funcContractList: Type", "parallel": "ParallelProcessing", "events": "EventList",
        "success": "SuccessValue", "before": "PreProcessing", "after": "PostProcessing",
    }),
    yaml.DataItem: ("SignalList or DataQList", {**_VALUE, "asil": "AsilLevel, AsilInfo of a queue", "provider": "ExternalProvider"}),
    yaml.ParameterItem: ("ParameterList", {**_VALUE, "kind": "Interfacetype", "asil": "Asillevel"}),
    yaml.ErrorItem: ("ErrorList", {"interface": _INTERFACE, "occurrenceCountLimit": "OccurenceCountLimit"}),
    yaml.ReactionItem: ("SafetyReactionList", {"interface": _INTERFACE}),
    yaml.MethodItem: ("MethodList", {}),
    yaml.ArgumentItem: ("InDataTypeList or OutDataTypeList", {"unit": "Units"}),
    yaml.ModesItem: (_MODES, {"interfaces": _INTERFACE}),
    yaml.ModeInItem: (_MODES, {"unknown": "UnknownAction"}),
    yaml.ModeOutItem: (_MODES, {}),
    code.CodeSection: ("Code", {"definitions": "Macros", "class": "ClassName"}),
    code.ObjectItem: ("Code: Objects", {}),
    code.CheckpointItem: ("functionList: Checkpoint", {"initial": "BeginsSequence", "final": "EndsSequence"}),
    yaml.ActiveMode: ("ModesList", {"mode": "Name", "runnables": "RunnablesList"}),
}  # fmt: skip
"""Places of the parts of a function.yaml in Function JSON, with the fields whose names differ there by more than the first capital."""


def target(part: type[DeclarationModel], key: str) -> str:
    """Return the place of a field of a function.yaml in Function JSON."""
    place, names = TARGETS[part]
    name = names.get(key) or key[0].upper() + key[1:]
    return f"{place}: {name}" if place else name


def declared_fields(functions: Sequence[ResolvedFunction]) -> tuple[Entry, ...]:
    """An entry for each field that an author wrote; none of Function JSON, with whose fields the report begins then."""
    return tuple(
        entry
        for each in functions
        if each.origin is not None
        for entry in _of_part(yaml.Declaration.model_validate(each.document.value), (), each)
    )


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
            yield _entry((*at, key), target(type(part), key), function)


def _parts(value: Any, at: Pointer) -> Iterator[tuple[Pointer, DeclarationModel]]:
    """The parts of a declaration that a field holds."""
    listed = (((*at, i), item) for i, item in enumerate(value)) if isinstance(value, list) else ((at, value),)
    yield from ((pointer, each) for pointer, each in listed if isinstance(each, DeclarationModel))


def _entry(at: Pointer, goes_to: str, function: ResolvedFunction) -> Entry:
    place = f"{PurePath(function.document.name).name}:{function.document.position(at).line}"
    return Entry(function.name, place, "declaration", ".".join(map(str, at)), f"Function JSON, {goes_to}")
