"""Codecs: how each datatype that is sent becomes bytes."""

from collections.abc import Mapping, Sequence

from sigcat.adapter.autosar_adaptive.bench.datatypes import alias_of, array_of
from sigcat.adapter.autosar_adaptive.bench.services import Service
from sigcat.adapter.autosar_adaptive.bench.text import source
from sigcat.adapter.autosar_adaptive.cpp_names import TEXT, TypeNames
from sigcat.integration.autosar_adaptive.model import IntegrationModel, TypeEntry
from sigcat.integration.datatypes import BY_ADAPTIVE

NAME = "codecs.cpp"


def codecs_source(model: IntegrationModel, services: Sequence[Service], names: TypeNames) -> str:
    """Codecs of everything that the services send, each once however many names it has."""
    entries = {entry.name: entry for entry in model.datatypes or ()}
    words = sorted({word for service in services for word in service.words()})
    outputs = [(service.result(method), [each.name for each in method.outputs])
               for service in services for method in service.whole.methods if method.outputs]  # fmt: skip
    structs = [
        (names.type(entry.name), [field.name for field in entry.fields or ()])
        for entry in entries.values()
        if entry.kind == "structure"
    ]
    types = sorted({_resolved(word, entries, names) for word in words})
    includes = [
        "bench/codecs.h",
        *names.headers([*entries, TEXT]),
        *(service.names.common_header for service in services if service.whole.methods),
    ]
    body = [
        *(_members(name, members) for name, members in (*structs, *outputs)),
        *(_parameters(name) for name, _ in outputs),
        "\n".join(f"template struct bench::Codec<{name}>;" for name in (*types, *(name for name, _ in outputs))),
    ]
    return source("How datatypes become bytes, and are read of them.", includes, body)


def _members(name: str, members: Sequence[str]) -> str:
    each = " ".join(f"each(value.{member});" for member in members)
    return f"""template <>
struct bench::Members<{name}> {{
    template <typename Each, typename Value>
    static void ForEach(Each&& each, Value& value) {{
        {each}
    }}
}};"""


def _parameters(name: str) -> str:
    return f"template <>\nstruct bench::IsArguments<{name}> : std::true_type {{}};"


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
