"""Datatypes of the set: implementation types of the code, and application types that say what a value means."""

from collections.abc import Mapping
from functools import partial
from typing import Any, Literal, NamedTuple

from sigcat import codes
from sigcat.catalogue.model.datatypes import INTEGER_RANGES, element_of
from sigcat.function.document.text import Text
from sigcat.function.function_json.datatypes.datatype import Datatype, EnumerationValue, innermost
from sigcat.function.function_json.datatypes.type_list import smallest_integer
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_names import distinct, distinct_names, short_name
from sigcat.integration.datatypes import BY_VSS, of_reference, with_catalogue_elements
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.sent_values import Enumeration, Scaled

_FALLBACK = "uint8"


class Meaning(NamedTuple):
    """Contents of an application type, besides the datatype of the code."""

    unit: str | None = None
    low: float | None = None
    high: float | None = None
    description: Text | None = None


class Sent(NamedTuple):
    """The datatype of the catalogue for a value that the code has in another one."""

    symbols: tuple[EnumerationValue, ...] | None = None
    """Those of an enumeration, if they differ from those of the code."""
    vss_datatype: str | None = None


_AS_IN_CODE = Sent()


class TypeTable:
    """Datatypes that were referred to. Names are unique over the set; equal ones are one."""

    def __init__(self, findings: FindingCollector) -> None:
        self._findings = findings
        self._implementation: dict[str, model.ImplementationType] = {}
        self._application: dict[str, model.ApplicationType] = {}
        self._methods: dict[str, model.CompuMethod] = {}
        self._constraints: dict[str, model.DataConstraint] = {}
        self._units: dict[str, model.Unit] = {}
        self._open: list[tuple[int, str]] = []
        self._documents: dict[int, dict[str, Datatype]] = {}

    def lists(self) -> dict[str, Any]:
        """Lists of a document: datatypes, each after those that it has in it, and what they refer to, by name."""
        return {
            "implementation_types": tuple(self._implementation.values()),
            "application_types": tuple(self._application.values()),
            "compu_methods": tuple(self._methods[name] for name in sorted(self._methods)),
            "constraints": tuple(self._constraints[name] for name in sorted(self._constraints)),
            "units": tuple(self._units[name] for name in sorted(self._units)),
        }

    def datatypes(self, function: FunctionJson) -> Mapping[str, Datatype]:
        """Datatypes of a function by their references."""
        if id(function) not in self._documents:
            self._documents[id(function)] = {datatype.reference: datatype for datatype in function.datatypes}
        return self._documents[id(function)]

    def sent(self, function: FunctionJson, interface: Scaled) -> str:
        """Implementation type on the wire for a data interface: in the catalogue's datatype, whatever the code's."""
        datatype = self.datatypes(function).get(interface.datatype)
        if (datatype is None or not datatype.kind) and interface.vss_datatype in BY_VSS:
            return self.primitive(interface.vss_datatype)
        sent = datatype and with_catalogue_elements(datatype, interface.vss_datatype, self.datatypes(function))
        if sent is None or sent is datatype:
            return self.of_reference(function, interface.datatype, Sent(interface.vss_symbols, interface.vss_datatype))
        return self._add(self._array(function, sent, _AS_IN_CODE), function)

    def numbers(self, function: FunctionJson, interface: Scaled) -> Enumeration | None:
        """Return the names of an enumeration's numbers in the code, and the numbers that are sent for these names."""
        datatype = innermost(interface.datatype, self.datatypes(function))
        if datatype is None or datatype.kind != "enumeration":
            return None
        own = datatype.symbols or ()
        names = {each.value: each.symbol for each in own}
        return names, {each.symbol: each.value for each in interface.vss_symbols or own}

    def primitive(self, vss: str) -> str:
        """Platform type of a primitive."""
        name = BY_VSS[vss].classic or _FALLBACK
        self._implementation.setdefault(name, model.ImplementationType(name=name, category="VALUE", base=name))
        return name

    def service_type(self, name: str, base: str) -> None:
        """A datatype of the base software."""
        self._implementation.setdefault(name, model.ImplementationType(name=name, category="TYPE_REFERENCE", base=base))

    def of_reference(self, function: FunctionJson, reference: str, sent: Sent = _AS_IN_CODE) -> str:
        """Implementation type of a reference of a function."""
        datatype = self.datatypes(function).get(reference)
        if datatype is not None and datatype.kind:
            return self._user_defined(function, datatype, sent)
        primitive = of_reference(reference, datatype.c_definition if datatype else "")
        if primitive is None or not primitive.classic:
            self._report_without_content(function, reference, datatype)
            return self.primitive(_FALLBACK)
        return self.primitive(primitive.vss)

    def _user_defined(self, function: FunctionJson, datatype: Datatype, sent: Sent) -> str:
        key = (id(function), datatype.reference)
        if key in self._open:
            message = f"Datatype {datatype.reference} of {function.info.function_name} must not contain itself: nothing in C does."
            self._findings.report(codes.DATATYPE_UNFIT_CLASSIC, message, Subject("", datatype))
            return self.primitive(_FALLBACK)
        self._open.append(key)
        try:
            if datatype.kind == "enumeration":
                return self._enumeration(function, datatype, sent)
            if datatype.kind == "array":
                return self._add(self._array(function, datatype, sent), function)
            return self._add(self._struct(function, datatype), function)
        finally:
            self._open.pop()

    def _enumeration(self, function: FunctionJson, datatype: Datatype, sent: Sent) -> str:
        name = short_name(datatype.reference)
        listed = sent.symbols or datatype.symbols or ()
        names = distinct_names([short_name(each.symbol) for each in listed])
        symbols = tuple(
            model.Symbol(symbol=symbol, value=each.value) for symbol, each in zip(names, listed, strict=True)
        )
        own = element_of(sent.vss_datatype or "")
        primitive = of_reference("", datatype.c_definition)
        if sent.symbols:
            numbers = {each.symbol: each.value for each in listed}
            stored = own if own in INTEGER_RANGES else smallest_integer(numbers)
        else:
            stored = primitive.vss if primitive else _FALLBACK
        method = model.CompuMethod(name=name, category="TEXTTABLE", symbols=symbols)
        if self._methods.get(name, method) != method:
            method = method.model_copy(update={"name": short_name(f"{name}_{function.info.function_name}")})
        self._methods[method.name] = method
        made = model.ImplementationType(
            name=name,
            category="TYPE_REFERENCE",
            base=self.primitive(stored),
            compu_method=method.name,
            literal_prefix=f"{name}_",
            reference=datatype.reference,
        )
        return self._add(made, function)

    def _array(self, function: FunctionJson, datatype: Datatype, sent: Sent) -> model.ImplementationType:
        element = self.of_reference(function, datatype.element or "", sent)
        if datatype.length is None:
            message = f"Datatype {datatype.reference} of {function.info.function_name} must have a length: nothing in an RTE grows."
            self._findings.report(codes.DATATYPE_UNFIT_CLASSIC, message, Subject("", datatype))
        return model.ImplementationType(
            name=short_name(datatype.reference),
            category="ARRAY",
            element=element,
            length=datatype.length or 1,
            reference=datatype.reference,
        )

    def _struct(self, function: FunctionJson, datatype: Datatype) -> model.ImplementationType:
        return model.ImplementationType(
            name=short_name(datatype.reference),
            category="STRUCTURE",
            members=tuple(
                model.TypeMember(
                    name=short_name(field.name),
                    type=self.of_reference(function, field.datatype),
                    description=field.description,
                )
                for field in datatype.fields or ()
            ),
            reference=datatype.reference,
        )

    def _add(self, made: model.ImplementationType, function: FunctionJson) -> str:
        """Add a datatype; another one of the same name has its function in its name."""
        if self._implementation.get(made.name, made) != made:
            name = short_name(f"{made.name}_{function.info.function_name}")
            prefix = f"{name}_" if made.literal_prefix else None
            made = made.model_copy(update={"name": name, "literal_prefix": prefix})
        self._implementation[made.name] = made
        return made.name

    def _report_without_content(self, function: FunctionJson, reference: str, datatype: Datatype | None) -> None:
        what = f"C definition {datatype.c_definition!r}" if datatype else "no definition"
        message = f"Datatype {reference} of {function.info.function_name} must be a number, an array or a struct: it has {what}."
        self._findings.report(
            codes.DATATYPE_UNFIT_CLASSIC, message, Subject("", datatype or function), "Give it a `Kind` with content."
        )

    # -- what values mean ------------------------------------------------------------------------------------------

    def application(self, name: str, implementation: str, meaning: Meaning) -> str:
        """The application type of an element, under its name, and those of its elements and members."""
        code = self._implementation[implementation]
        common = partial(
            model.ApplicationType, name=name, implementation=implementation, description=meaning.description
        )
        if code.category == "ARRAY":
            element = self.application(f"{name}_Element", code.element or "", meaning)
            made = common(category="ARRAY", element=element, length=code.length)
        elif code.category == "STRUCTURE":
            members = (
                each.model_copy(update={"type": self.application(f"{name}_{each.name}", each.type, Meaning())})
                for each in code.members or ()
            )
            made = common(category="STRUCTURE", members=tuple(members))
        else:
            unit = self._unit(meaning.unit)
            method = code.compu_method or self._identical(unit)
            category: Literal["BOOLEAN", "VALUE"] = "BOOLEAN" if code.base == "boolean" else "VALUE"
            constraint = self._constraint(name, meaning) if category == "VALUE" else None
            made = common(category=category, compu_method=method, constraint=constraint, unit=unit)
        self._application[name] = made
        return name

    def _constraint(self, name: str, meaning: Meaning) -> str | None:
        if meaning.low is None and meaning.high is None:
            return None
        self._constraints[name] = model.DataConstraint(name=name, min=meaning.low, max=meaning.high)
        return name

    def _unit(self, key: str | None) -> str | None:
        if not key:
            return None
        for unit in self._units.values():
            if unit.display_name == key:
                return unit.name
        words = key.replace("/", "_per_").replace("^", "").replace("%", "percent")
        name = distinct({key: short_name(words)}, [unit.name for unit in self._units.values()])[key]
        self._units[name] = model.Unit(name=name, display_name=key)
        return name

    def _identical(self, unit: str | None) -> str:
        name = short_name(f"Identical_{unit}") if unit else "Identical"
        self._methods.setdefault(name, model.CompuMethod(name=name, category="IDENTICAL", unit=unit))
        return name
