"""Codecs: how each datatype that is sent becomes bytes."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.bench.datatypes.datatypes import alias_of, array_of
from sigcat.adapter.autosar_adaptive.bench.headers import includes
from sigcat.adapter.autosar_adaptive.bench.services.services import Service
from sigcat.adapter.autosar_adaptive.cpp_names import TEXT, TypeNames
from sigcat.adapter.templates import rendered
from sigcat.integration.autosar_adaptive.model import IntegrationModel, TypeEntry
from sigcat.integration.datatypes import BY_ADAPTIVE

NAME = "codecs.cpp"
_TEMPLATE = "adapter/autosar_adaptive/bench/datatypes/codecs.cpp.j2"


class _Struct(NamedTuple):
    """A struct with its members."""

    type: str
    members: Sequence[str]


def codecs_source(model: IntegrationModel, services: Sequence[Service], names: TypeNames) -> str:
    """Codecs of everything that the services send, each once however many names it has."""
    entries = {entry.name: entry for entry in model.datatypes or ()}
    structs = [
        _Struct(names.type(entry.name), [field.name for field in entry.fields or ()])
        for entry in entries.values()
        if entry.kind == "structure"
    ]
    outputs = [
        _Struct(method.result, [each.name for each in method.outputs])
        for service in services
        for method in service.results
    ]
    types = {_resolved(word, entries, names) for service in services for word in service.words}
    headers = ["bench/codecs.h", *names.headers([*entries, TEXT])]
    headers += [service.names.common_header for service in services if service.methods]
    sent = [*sorted(types), *(struct.type for struct in outputs)]
    return rendered(_TEMPLATE, includes=includes(headers), structs=structs, outputs=outputs, sent=sent)


def _resolved(word: str, entries: Mapping[str, TypeEntry], names: TypeNames) -> str:
    """The type behind all names, as two names may be of one type."""
    if word == TEXT:
        return "ara::core::String"
    entry = entries.get(word)
    if word in BY_ADAPTIVE or entry is None or entry.kind == "structure":
        return names.type(word)
    if entry.kind == "array":
        return array_of(_resolved(entry.element, entries, names), entry)
    return names.type(word) if entry.symbols else _resolved(alias_of(entry), entries, names)
