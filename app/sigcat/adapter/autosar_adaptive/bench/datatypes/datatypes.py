"""Implementation datatypes: a header for each, `impl_type_<name>.h`."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.bench.headers import guard, includes
from sigcat.adapter.autosar_adaptive.cpp_names import TEXT, TypeNames
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import Text, composed, sentence
from sigcat.integration.autosar_adaptive.model import IntegrationModel, TypeEntry
from sigcat.integration.datatypes import BY_ADAPTIVE

_TEMPLATE = "adapter/autosar_adaptive/bench/datatypes/datatype.h.j2"


class _Member(NamedTuple):
    """A member of a structure."""

    about: Text
    type: str
    name: str


def headers(model: IntegrationModel, names: TypeNames) -> dict[str, str]:
    """The headers of the datatypes of a document, and of its texts, by their paths as they are included."""
    entries = {names.header(entry.name): _header(entry, names) for entry in model.datatypes or ()}
    return {names.header(TEXT): _text_header(names), **entries}


def used_words(entry: TypeEntry) -> tuple[str, ...]:
    """The words and names of datatypes that a datatype is made of."""
    if entry.kind == "structure":
        return tuple(field.type for field in entry.fields or ())
    return (entry.element if entry.kind == "array" else alias_of(entry),)


def alias_of(entry: TypeEntry) -> str:
    """The word that an enumeration is held in, or that a reference names."""
    return entry.storage or entry.c_definition or "uint8_t"


def array_of(element: str, entry: TypeEntry) -> str:
    """The type of an array, of an element's in C++."""
    return f"ara::core::Vector<{element}>" if entry.is_open else f"ara::core::Array<{element}, {entry.dimension}>"


def _header(entry: TypeEntry, names: TypeNames) -> str:
    path, words = names.header(entry.name), used_words(entry)
    about = sentence(entry.description, f"VSS: {entry.vss_datatype}" if entry.vss_datatype else None)
    return rendered(
        _TEMPLATE,
        about=composed(entry.name, ": ", about) if about else f"{entry.name}.",
        guard=guard(path),
        includes=includes([*_standard(entry, words), *names.headers(words)]),
        namespace="::".join(names.namespace),
        kind=entry.kind,
        name=entry.name,
        type=_type(entry, names),  # of an enumeration, or the one that the name means
        members=[
            _Member(sentence(each.description, each.unit), names.type(each.type), each.name)
            for each in entry.fields or ()
        ],
        symbols=entry.symbols or () if entry.kind != "array" else (),
    )


def _text_header(names: TypeNames) -> str:
    return rendered(
        _TEMPLATE,
        about="Texts.",
        guard=guard(names.header(TEXT)),
        includes=includes(["ara/core/string.h"]),
        namespace="::".join(names.namespace),
        kind="value",
        name=names.name(TEXT),
        type="ara::core::String",
        members=(),
        symbols=(),
    )


def _type(entry: TypeEntry, names: TypeNames) -> str:
    if entry.kind == "structure":
        return ""
    return array_of(names.type(entry.element), entry) if entry.kind == "array" else names.type(alias_of(entry))


def _standard(entry: TypeEntry, words: Iterable[str]) -> Iterable[str]:
    if entry.kind == "array":
        yield "ara/core/vector.h" if entry.is_open else "ara/core/array.h"
    if any(word in BY_ADAPTIVE and BY_ADAPTIVE[word].cpp.startswith("std::") and word != TEXT for word in words):
        yield "<cstdint>"
