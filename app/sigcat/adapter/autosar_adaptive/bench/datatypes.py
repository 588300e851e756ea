"""Implementation datatypes: a header for each, `impl_type_<name>.h`."""

from collections.abc import Iterable

from sigcat.adapter.autosar_adaptive.bench.text import comment, header, within
from sigcat.adapter.autosar_adaptive.cpp_names import TEXT, TypeNames
from sigcat.function.document.text import composed, sentence
from sigcat.integration.autosar_adaptive.model import IntegrationModel, StructField, TypeEntry
from sigcat.integration.datatypes import BY_ADAPTIVE


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
    includes = [*_standard(entry, words), *names.headers(words)]
    body = _definition(entry, names)
    title = composed(entry.name, ": ", about) if about else f"{entry.name}."
    return header(path, title, includes, within(names.namespace, [body]))


def _text_header(names: TypeNames) -> str:
    body = f"using {names.name(TEXT)} = ara::core::String;"
    return header(names.header(TEXT), "Texts.", ["ara/core/string.h"], within(names.namespace, [body]))


def _standard(entry: TypeEntry, words: Iterable[str]) -> Iterable[str]:
    if entry.kind == "array":
        yield "ara/core/vector.h" if entry.is_open else "ara/core/array.h"
    if any(word in BY_ADAPTIVE and BY_ADAPTIVE[word].cpp.startswith("std::") and word != TEXT for word in words):
        yield "<cstdint>"


def _definition(entry: TypeEntry, names: TypeNames) -> str:
    if entry.kind == "structure":
        members = "\n".join(_member(field, names) for field in entry.fields or ())
        return f"struct {entry.name} {{\n{members}\n}};"
    if entry.kind == "array":
        return f"using {entry.name} = {array_of(names.type(entry.element), entry)};"
    if entry.symbols:
        values = "\n".join(f"    {item.symbol} = {item.value}," for item in entry.symbols)
        return f"enum class {entry.name} : {names.type(alias_of(entry))} {{\n{values}\n}};"
    return f"using {entry.name} = {names.type(alias_of(entry))};"


def _member(field: StructField, names: TypeNames) -> str:
    about = sentence(field.description, field.unit)
    before = f"{comment(about, 1)}\n" if about else ""
    return f"{before}    {names.type(field.type)} {field.name}{{}};"
