"""The datatypes of the set: those of every function, each once, in the words of the integration schema."""

from functools import partial

from sigcat import codes
from sigcat.catalogue.model.datatypes import INTEGER_RANGES, element_of
from sigcat.function.function_json.datatypes.datatype import Datatype, innermost
from sigcat.function.function_json.datatypes.type_list import smallest_integer
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import data
from sigcat.integration.autosar_adaptive.model import StructField, Symbol, TypeEntry
from sigcat.integration.autosar_names import distinct_names, short_name
from sigcat.integration.datatypes import BY_VSS, of_reference, with_catalogue_elements
from sigcat.integration.finding_collector import FindingCollector, Subject

_STORAGE = "uint8"


class TypeTable:
    """Datatypes that were referred to, in the order in which they first were."""

    def __init__(self, findings: FindingCollector) -> None:
        self._findings = findings
        self._documents: dict[int, dict[str, Datatype]] = {}
        self._sent: dict[int, dict[str, Datatype]] = {}
        self._entries: dict[str, TypeEntry] = {}
        self._known: dict[tuple[int, str], str] = {}
        self._open: list[tuple[int, str]] = []

    @property
    def entries(self) -> tuple[TypeEntry, ...]:
        """All of them, by name."""
        return tuple(self._entries[name] for name in sorted(self._entries))

    def entry(self, name: str) -> TypeEntry | None:
        """The datatype of a name; None for the word of a primitive."""
        return self._entries.get(name)

    def c_definition(self, function: FunctionJson, reference: str) -> str | None:
        """Datatype of the C code for a reference of a function."""
        datatype = self._datatypes(function).get(reference)
        return datatype.c_definition if datatype else None

    def on_the_wire(self, function: FunctionJson, reference: str, vss_datatype: str | None) -> str:
        """Return the datatype on the wire: the catalogue's, if it is a primitive or an array of them; else the function's."""
        known = self._datatypes(function)
        datatype = known.get(reference)
        if (datatype is None or not datatype.kind) and vss_datatype in BY_VSS:
            return BY_VSS[vss_datatype].adaptive
        sent = datatype and with_catalogue_elements(datatype, vss_datatype, known)
        if sent is None or sent is datatype:
            return self.word(function, reference)
        return self._add(self._entry(function, sent), function)

    def symbols_of_code(self, function: FunctionJson, reference: str) -> tuple[Symbol, ...]:
        """Names and numbers of an enumeration, or of the elements of an array, as the code has them."""
        datatype = innermost(reference, self._datatypes(function))
        return _symbols(datatype) if datatype else ()

    def symbols_sent(self, word: str) -> tuple[Symbol, ...]:
        """Names and numbers of an enumeration, or of the elements of an array, as they are sent."""
        entry = self.entry(word)
        while entry is not None and entry.kind == "array":
            entry = self.entry(entry.element)
        return (entry.symbols or ()) if entry else ()

    def word(self, function: FunctionJson, reference: str) -> str:
        """The word or the name for a reference of a function."""
        key = (id(function), reference)
        if key in self._known:
            return self._known[key]
        datatype = self._datatypes(function).get(reference)
        if datatype is not None and datatype.kind:
            return self._user_defined(function, datatype, key)
        primitive = of_reference(reference, datatype.c_definition if datatype else "")
        self._known[key] = primitive.adaptive if primitive else self._opaque(function, reference, datatype)
        return self._known[key]

    def _datatypes(self, function: FunctionJson) -> dict[str, Datatype]:
        if id(function) not in self._documents:
            self._documents[id(function)] = {datatype.reference: datatype for datatype in function.datatypes}
        return self._documents[id(function)]

    def _enumerations_sent(self, function: FunctionJson) -> dict[str, Datatype]:
        """Enumerations as the catalogue has them where the code has other numbers, by the reference of the datatype."""
        if id(function) not in self._sent:
            known = self._datatypes(function)
            found = ((innermost(item.datatype, known), item) for _, _, item in data(function) if item.vss_symbols)
            self._sent[id(function)] = {each.reference: _as_sent(each, item) for each, item in found if each}
        return self._sent[id(function)]

    def _user_defined(self, function: FunctionJson, datatype: Datatype, key: tuple[int, str]) -> str:
        if key in self._open:
            self._recursive(function, datatype)
            return short_name(datatype.reference)
        self._open.append(key)
        entry = self._entry(function, datatype)
        self._open.pop()
        self._known[key] = self._add(entry, function)
        return self._known[key]

    def _entry(self, function: FunctionJson, datatype: Datatype) -> TypeEntry:
        name = short_name(datatype.reference)
        common = partial(TypeEntry, name=name, vss_datatype=datatype.vss_datatype)
        if datatype.kind == "enumeration":
            sent = self._enumerations_sent(function).get(datatype.reference, datatype)
            return common(kind="enumeration", symbols=_symbols(sent), storage=_storage(sent))
        if datatype.kind == "array":
            element = self.word(function, datatype.element or "")
            dimension: int | str = datatype.length if datatype.length is not None else "dynamic"
            is_number = element not in self._entries and element != "string" and not element.startswith("DT_")
            shape = {"type": element} if is_number else {"fields": (StructField(name="Element", type=element),)}
            return common(kind="array", dimension=dimension, reference=datatype.reference, **shape)
        fields = tuple(
            StructField(
                name=short_name(field.name),
                type=self.word(function, field.datatype),
                unit=field.units,
                description=field.description,
                min=field.min,
                max=field.max,
            )
            for field in datatype.fields or ()
        )
        return common(kind="structure", reference=datatype.reference, description=datatype.description, fields=fields)

    def _opaque(self, function: FunctionJson, reference: str, datatype: Datatype | None) -> str:
        """A datatype whose content the function does not define: an empty structure, so that it has a place."""
        what = f"C definition {datatype.c_definition!r}" if datatype else "no definition"
        message = f"Datatype {reference} of {function.info.function_name} must have content: it has {what}, and is written as an empty structure."
        fix = "Give it a `Kind` with members, symbols or elements."
        self._findings.report(codes.DATATYPE_WITHOUT_CONTENT, message, Subject("", datatype or function), fix)
        name = short_name(reference or "Unnamed")
        return self._add(TypeEntry(name=name, kind="structure", fields=(), reference=reference), function)

    def _add(self, entry: TypeEntry, function: FunctionJson) -> str:
        """Add a datatype; another one of the same name has its function in its name."""
        other = self._entries.get(entry.name)
        if other is not None and other != entry:
            entry = entry.model_copy(update={"name": short_name(f"{entry.name}_{function.info.function_name}")})
        self._entries[entry.name] = entry
        return entry.name

    def _recursive(self, function: FunctionJson, datatype: Datatype) -> None:
        message = f"Datatype {datatype.reference} of {function.info.function_name} must not contain itself: SOME/IP cannot send it."
        fix = "Break the cycle, for instance with an index."
        self._findings.report(codes.DATATYPE_CONTAINS_ITSELF, message, Subject("", datatype), fix)


def _as_sent(datatype: Datatype, item: Signal | DataQueue) -> Datatype:
    """An enumeration of the code with the numbers of the catalogue, in an integer that holds these."""
    symbols = {each.symbol: each.value for each in item.vss_symbols or ()}
    own = element_of(item.vss_datatype or "")
    stored = own if own in INTEGER_RANGES else smallest_integer(symbols)
    return datatype.model_copy(update={"symbols": item.vss_symbols, "c_definition": BY_VSS[stored].c})


def _symbols(datatype: Datatype) -> tuple[Symbol, ...]:
    listed = datatype.symbols or ()
    names = distinct_names([short_name(each.symbol) for each in listed])
    return tuple(Symbol(symbol=name, value=each.value) for name, each in zip(names, listed, strict=True))


def _storage(datatype: Datatype) -> str:
    primitive = of_reference("", datatype.c_definition)
    return primitive.adaptive if primitive else BY_VSS[_STORAGE].adaptive
