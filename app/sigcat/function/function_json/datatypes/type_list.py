"""The datatypes that a function refers to, gathered while its interfaces are resolved."""

import re
from collections.abc import Mapping

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import INTEGER_RANGES, element_of, is_array
from sigcat.function.function_json.datatypes.datatype import Datatype, EnumerationValue, TypeField
from sigcat.function.function_json.datatypes.primitive_types import BY_VSS
from sigcat.names import last_name

Symbols = Mapping[str, int]


def symbols_of(node: Node) -> Symbols | None:
    """Names and numbers of an enumeration: as `enum` says, or for allowed texts their position, from 0."""
    enum = node.values.get("enum")
    if isinstance(enum, dict):
        return enum
    allowed = node.values.get("allowed")
    is_text = element_of(str(node.values.get("datatype"))) == "string"
    return {str(name): number for number, name in enumerate(allowed)} if is_text and isinstance(allowed, list) else None


def listed(symbols: Symbols) -> tuple[EnumerationValue, ...]:
    """An enumeration as Function JSON has it."""
    return tuple(EnumerationValue(symbol=name, value=value) for name, value in symbols.items())


def smallest_integer(symbols: Symbols) -> str:
    """The smallest VSS integer that holds every number of an enumeration."""
    low, high = min(symbols.values(), default=0), max(symbols.values(), default=0)
    names = sorted(INTEGER_RANGES, key=lambda n: (INTEGER_RANGES[n][1] - INTEGER_RANGES[n][0], n.startswith("i")))
    fitting = (n for n in names if INTEGER_RANGES[n][0] <= low and high <= INTEGER_RANGES[n][1])
    return next(fitting, names[-1])  # numbers beyond 64 bits are a finding of the catalogue


class TypeList:
    """Datatypes in the order in which they are first referred to, each once."""

    def __init__(self, catalogue: Catalogue) -> None:
        self._catalogue = catalogue
        self._types: dict[str, Datatype] = {}
        self._open: dict[str, str] = {}
        """References of structs whose members are being resolved: a struct may hold a list of itself."""

    @property
    def datatypes(self) -> tuple[Datatype, ...]:
        """All of them."""
        return tuple(self._types.values())

    def get(self, reference: str) -> Datatype | None:
        """The datatype of a reference; None if there is none yet."""
        return self._types.get(reference)

    def reference(
        self, datatype: str, template: str = "", symbols: Symbols | None = None, length: object = None
    ) -> str:
        """Reference to a VSS datatype; of an enumeration, named after the path of its definition, with symbols."""
        if is_array(datatype):
            return self._array(datatype, template, symbols, length)
        if symbols is not None:
            return self._enumeration(datatype, template, symbols)
        if datatype in BY_VSS:
            row = BY_VSS[datatype]
            known = self._types.get(row.reference)
            if known is not None and known.vss_datatype == row.vss and known.kind is None:
                return row.reference
            return self._add(
                Datatype(reference=row.reference, category="primitive", c_definition=row.c, vss_datatype=row.vss)
            )
        return self._struct(datatype)

    def _array(self, datatype: str, template: str, symbols: Symbols | None, length: object) -> str:
        element = self.reference(element_of(datatype), template, symbols)
        size = length if isinstance(length, int) and not isinstance(length, bool) and length >= 0 else None
        c = self._types[element].c_definition if element in self._types else f"struct {last_name(element_of(datatype))}"
        made = Datatype(
            reference=f"{element}Array{size if size is not None else ''}",
            category="userdefined",
            c_definition=f"{c}[{size}]" if size is not None else f"{c} *",
            kind="array",
            vss_datatype=datatype,
            element=element,
            length=size,
        )
        return self._add(made)

    def _enumeration(self, datatype: str, template: str, symbols: Symbols) -> str:
        stored = datatype if datatype in INTEGER_RANGES else smallest_integer(symbols)
        made = Datatype(
            reference=_reference(template),
            category="userdefined",
            c_definition=BY_VSS[stored].c,
            kind="enumeration",
            vss_datatype=stored,
            symbols=listed(symbols),
        )
        return self._add(made)

    def _struct(self, path: str) -> str:
        if path in self._open:
            return self._open[path]
        self._open[path] = _reference(path)
        node = self._catalogue.get(path)
        children = node.children if node else ()
        fields = tuple(self._field(child) for child in children)
        del self._open[path]
        name = f"struct {last_name(path)}"
        made = Datatype(
            reference=_reference(path),
            category="userdefined",
            c_definition=name,
            kind="struct",
            vss_datatype=path,
            fields=fields,
            description=node.values.get("description") if node else None,
        )
        return self._add(made)

    def _field(self, node: Node) -> TypeField:
        values = node.values
        limits = {name: values[name] for name in ("min", "max") if isinstance(values.get(name), int | float)}
        return TypeField(
            name=node.name,
            datatype=self._of_node(node),
            units=values.get("unit"),
            description=values.get("description"),
            **limits,
        )

    def _of_node(self, node: Node) -> str:
        datatype, length = str(node.values.get("datatype")), node.values.get("arraysize")
        return self.reference(datatype, node.template, symbols_of(node), length)

    def _add(self, datatype: Datatype) -> str:
        """Add a datatype, unless it is there; another one of the same name makes a number part of the name."""
        name, number = datatype.reference, 1
        known = self._types.get(name)
        while known is not None and known != datatype:
            number += 1
            name = f"{datatype.reference}V{number}"
            known = self._types.get(name)
            known = known and known.model_copy(update={"reference": datatype.reference})
        if known is None:
            self._types[name] = datatype if number == 1 else datatype.model_copy(update={"reference": name})
        return name


def _reference(path: str) -> str:
    """`Vehicle.ADAS.EcoControl.Status` → `DT_ADASEcoControlStatus`."""
    names = path.split(".")
    joined = "".join(names[1:] or names)
    return "DT_" + re.sub(r"[^A-Za-z0-9]", "", joined)
