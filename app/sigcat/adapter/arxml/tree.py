"""ARXML elements as plain values, and their way into the AUTOSAR metamodel of `autosar-data`."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Literal, NamedTuple

from autosar_data import AutosarDataError, AutosarModel, AutosarVersion, Element
from pydantic import BaseModel

from sigcat.adapter.files import GeneratedFile
from sigcat.errors import InputRefused
from sigcat.function.document.text import Text
from sigcat.function.document.text_filters import AnyText, arxml_text
from sigcat.integration.autosar_names import distinct


class Tag(NamedTuple):
    """An element: its children, or its text. One with a name has it as SHORT-NAME."""

    tag: str
    children: "tuple[Tag, ...]" = ()
    text: AnyText | None = None
    name: str | None = None
    attributes: tuple[tuple[str, str], ...] = ()


AnyValue = AnyText | float | None
Child = Tag | Mapping[str, AnyValue] | None
"""A child of an element, or the texts of several by their tags."""


def tag(tag_name: str, *children: Child, text: AnyValue = None, name: str | None = None) -> Tag:
    """An element; children and texts of children that are None are left out."""
    shown = str(text).lower() if isinstance(text, bool) else str(text) if isinstance(text, int | float) else text
    return Tag(tag_name, tuple(element for child in children for element in _elements(child)), shown, name)


def _elements(child: Child) -> Iterator[Tag]:
    if isinstance(child, Mapping):
        yield from (tag(tag_name, text=text) for tag_name, text in child.items() if text is not None)
    elif child is not None:
        yield child


def listed(tag_name: str, children: Iterable[Tag | None]) -> Tag | None:
    """An element that holds a list; None if the list is empty, as the metamodel has no empty lists."""
    kept = tuple(child for child in children if child is not None)
    return Tag(tag_name, kept) if kept else None


def seconds(milliseconds: float) -> str:
    """A time as the metamodel has it: in seconds."""
    return f"{Decimal(str(milliseconds)) / 1000:f}"


def reference(tag_name: str, path: str, kind: str) -> Tag:
    """A reference to an element by its path and kind."""
    return Tag(tag_name, (), path, None, (("DEST", kind),))


def references(tag_name: str, paths: Iterable[str], kind: str) -> Tag | None:
    """The list of references to elements of a kind; None without any."""
    return listed(f"{tag_name}S", (reference(tag_name, path, kind) for path in paths))


def conditional(target: Tag) -> Tag:
    """A reference within the element that could make it hold only under a condition."""
    return tag(f"{target.tag}-CONDITIONAL", target)


def port(side: Literal["P", "R", "PR"], interface: str, kind: str, *content: Tag | None, name: str) -> Tag:
    """A port that provides an interface, requires it, or does both. `interface` is its path."""
    word = {"P": "PROVIDED", "R": "REQUIRED", "PR": "PROVIDED-REQUIRED"}[side]
    return tag(f"{side}-PORT-PROTOTYPE", *content, reference(f"{word}-INTERFACE-TREF", interface, kind), name=name)


def namespaces(names: Sequence[str], beside: Iterable[str] = ()) -> Tag | None:
    """NAMESPACES of the code for an element, the outermost first; None without any.

    A namespace has its own name as short name, unless an element `beside` it has that name.
    """
    symbols = {f"{index:03d}": name for index, name in enumerate(names)}
    short_names = distinct(symbols, beside)
    return listed(
        "NAMESPACES", (tag("SYMBOL-PROPS", {"SYMBOL": name}, name=short_names[key]) for key, name in symbols.items())
    )


def description(text: Text | None) -> Tag | None:
    """DESC in English; None without a text."""
    if not text:
        return None
    return tag("DESC", Tag("L-2", (), text, None, (("L", "EN"),)))


def definition_properties(*content: Tag | None) -> Tag | None:
    """SW-DATA-DEF-PROPS with the properties that are there; None without any."""
    properties = listed("SW-DATA-DEF-PROPS-CONDITIONAL", content)
    return tag("SW-DATA-DEF-PROPS", tag("SW-DATA-DEF-PROPS-VARIANTS", properties)) if properties else None


def document_trace(meta: BaseModel, info: BaseModel, provenance: object) -> Tag | None:
    """Admin data about a document: its author, and its sources."""
    facts = [fact for part in (meta, info) for fact in part.model_dump(mode="json").items()]
    return trace([*facts, ("Provenance", provenance)])


def trace(values: Iterable[tuple[str, object]]) -> Tag | None:
    """Admin data: where the element comes from, and what of it the metamodel has no place for."""
    kept = tuple(Tag("SD", (), text, None, (("GID", key),)) for pair in values for key, text in _facts(*pair))
    return tag("ADMIN-DATA", tag("SDGS", Tag("SDG", kept, None, None, (("GID", "sigcat"),)))) if kept else None


def _facts(key: str, value: object) -> Iterator[tuple[str, AnyText]]:
    """A value as texts that tools of any language read: `Watchdog.Min` for what a mapping holds, a list with commas."""
    if isinstance(value, BaseModel):
        yield from _facts(key, value.model_dump(mode="json"))
    elif isinstance(value, Mapping):
        for inner, item in value.items():
            yield from _facts(f"{key}.{inner}", item)
    elif isinstance(value, list | tuple) and any(isinstance(item, Mapping | list) for item in value):
        for number, item in enumerate(value, 1):
            yield from _facts(f"{key}.{number}", item)
    elif isinstance(value, list | tuple) and value:
        yield key, ", ".join(map(str, value))
    elif isinstance(value, bool):
        yield key, str(value).lower()
    elif value not in (None, "", Text(""), [], ()):
        yield key, value if isinstance(value, Text) else str(value)


class Package(NamedTuple):
    """A package below the outermost one."""

    name: str
    elements: tuple[Tag, ...]


def files(
    content: Mapping[str, Sequence[Package]], root: str, schema: str, about: Mapping[str, Tag | None]
) -> tuple[GeneratedFile, ...]:
    """ARXML files by name, with the packages that hold anything. Raises InputRefused for what AUTOSAR cannot write.

    `about`: admin data of the outermost package of a file.
    """
    try:
        return tuple(
            GeneratedFile(name, _written(name, root, packages, schema, about.get(name)))
            for name, packages in content.items()
        )
    except AutosarDataError as error:
        raise InputRefused(f"The integration cannot be written as ARXML: {error}") from error


def _written(filename: str, root: str, packages: Sequence[Package], schema: str, about: Tag | None) -> bytes:
    """An ARXML file. Elements land in the order of the metamodel."""
    model = AutosarModel()
    file = model.create_file(filename, getattr(AutosarVersion, schema))
    outermost = model.root_element.create_sub_element("AR-PACKAGES").create_named_sub_element("AR-PACKAGE", root)
    _fill(outermost, [about] if about else [])
    filled = [package for package in packages if package.elements]
    if filled:
        inner = outermost.create_sub_element("AR-PACKAGES")
        for package in filled:
            elements = inner.create_named_sub_element("AR-PACKAGE", package.name).create_sub_element("ELEMENTS")
            _fill(elements, package.elements)
    return (file.serialize().rstrip("\n") + "\n").encode()


def _fill(parent: Element, children: Sequence[Tag]) -> None:
    for child in children:
        if child.name is not None:
            element = parent.create_named_sub_element(child.tag, child.name)
        else:
            element = parent.create_sub_element(child.tag)
        for key, value in child.attributes:
            element.set_attribute(key, arxml_text(value))  # type: ignore[arg-type]
        if child.text is not None:
            element.character_data = arxml_text(child.text)
        _fill(element, child.children)
