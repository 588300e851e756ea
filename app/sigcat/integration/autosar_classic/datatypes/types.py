"""Datatypes of the set: implementation types of the code, and application types that say what a value means."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.datatypes import INTEGER_RANGES, element_of
from sigcat.function.document.text import Text
from sigcat.function.function_json.datatypes.datatype import Datatype, EnumerationValue, innermost
from sigcat.function.function_json.datatypes.type_list import smallest_integer
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import Context
from sigcat.integration.autosar_names import distinct, short_name
from sigcat.integration.datatypes import BY_VSS, of_reference, with_catalogue_elements
from sigcat.integration.finding_collector import Subject

Scaled = Signal | DataQueue | ParameterInterface
_FALLBACK = "uint8"


class Meaning(NamedTuple):
    """Contents of an application type, besides the datatype of the code."""

    unit: str | None = None
    low: float | None = None
    high: float | None = None
    description: Text | None = None


class TypeTable:
    """Datatypes that were referred to. Names are unique over the set; equal ones are one."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._implementation: dict[str, model.ImplementationType] = {}
        self._application: dict[str, model.ApplicationType] = {}
        self._methods: dict[str, model.CompuMethod] = {}
        self._constraints: dict[str, model.DataConstraint] = {}
        self._units: dict[str, model.Unit] = {}
        self._open: list[tuple[int, str]] = []
        self._documents: dict[int, dict[str, Datatype]] = {}

    @property
    def implementation_types(self) -> tuple[model.ImplementationType, ...]:
        """Each after those that it has in it."""
        return tuple(self._implementation.values())

    @property
    def application_types(self) -> tuple[model.ApplicationType, ...]:
        """Each after those that it has in it."""
        return tuple(self._application.values())

    @property
    def compu_methods(self) -> tuple[model.CompuMethod, ...]:
        """By name."""
        return tuple(self._methods[name] for name in sorted(self._methods))

    @property
    def constraints(self) -> tuple[model.DataConstraint, ...]:
        """By name."""
        return tuple(self._constraints[name] for name in sorted(self._constraints))

    @property
    def units(self) -> tuple[model.Unit, ...]:
        """By name."""
        return tuple(sorted(self._units.values(), key=lambda unit: unit.name))

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
            return self.of_reference(function, interface.datatype, interface.vss_symbols, interface.vss_datatype)
        return self._add(self._array(function, sent, None, None), function)

    def numbers(self, function: FunctionJson, interface: Scaled) -> tuple[Mapping[int, str], Mapping[str, int]] | None:
        """Return the names of an enumeration's numbers in the code, and the numbers that are sent for these names."""
        datatype = innermost(interface.datatype, self.datatypes(function))
        if datatype is None or datatype.kind != "enumeration":
            return None
        own = datatype.symbols or ()
        return {each.value: each.symbol for each in own}, {
            each.symbol: each.value for each in interface.vss_symbols or own
        }

    def primitive(self, vss: str) -> str:
        """Platform type of a primitive."""
        name = BY_VSS[vss].classic or _FALLBACK
        self._implementation.setdefault(name, model.ImplementationType(name=name, category="VALUE", base=name))
        return name

    def service_type(self, name: str, base: str) -> None:
        """A datatype of the base software."""
        self._implementation.setdefault(name, model.ImplementationType(name=name, category="TYPE_REFERENCE", base=base))

    def of_reference(
        self,
        function: FunctionJson,
        reference: str,
        symbols: tuple[EnumerationValue, ...] | None = None,
        vss_datatype: str | None = None,
    ) -> str:
        """Implementation type of a reference of a function; `symbols` are those of the catalogue, if they differ."""
        datatype = self.datatypes(function).get(reference)
        if datatype is not None and datatype.kind:
            return self._user_defined(function, datatype, symbols, vss_datatype)
        primitive = of_reference(reference, datatype.c_definition if datatype else "")
        if primitive is None or not primitive.classic:
            self._report_without_content(function, reference, datatype)
            return self.primitive(_FALLBACK)
        return self.primitive(primitive.vss)

    def _user_defined(
        self,
        function: FunctionJson,
        datatype: Datatype,
        symbols: tuple[EnumerationValue, ...] | None,
        vss_datatype: str | None,
    ) -> str:
        key = (id(function), datatype.reference)
        if key in self._open:
            message = f"Datatype {datatype.reference} of {function.info.function_name} must not contain itself: nothing in C does."
            self._context.findings.report(codes.DATATYPE_UNFIT_CLASSIC, message, Subject("", datatype))
            return self.primitive(_FALLBACK)
        self._open.append(key)
        try:
            if datatype.kind == "enumeration":
                return self._enumeration(function, datatype, symbols, vss_datatype)
            made = (
                self._array(function, datatype, symbols, vss_datatype)
                if datatype.kind == "array"
                else self._struct(function, datatype)
            )
            return self._add(made, function)
        finally:
            self._open.pop()

    def _enumeration(
        self,
        function: FunctionJson,
        datatype: Datatype,
        symbols: tuple[EnumerationValue, ...] | None,
        vss_datatype: str | None,
    ) -> str:
        name = short_name(datatype.reference)
        listed = [(each.symbol, each.value) for each in symbols or datatype.symbols or ()]
        names = distinct({f"{index:06d}": short_name(symbol) for index, (symbol, _) in enumerate(listed)})
        made = tuple(model.Symbol(symbol=names[f"{index:06d}"], value=value) for index, (_, value) in enumerate(listed))
        own = element_of(vss_datatype or "")
        primitive = of_reference("", datatype.c_definition)
        if symbols:
            stored = own if own in INTEGER_RANGES else smallest_integer(dict(listed))
        else:
            stored = primitive.vss if primitive else _FALLBACK
        base = self.primitive(stored)
        method = model.CompuMethod(name=name, category="TEXTTABLE", symbols=made)
        if self._methods.get(name, method) != method:
            method = method.model_copy(update={"name": short_name(f"{name}_{function.info.function_name}")})
        self._methods[method.name] = method
        return self._add(
            model.ImplementationType(
                name=name,
                category="TYPE_REFERENCE",
                base=base,
                compu_method=method.name,
                literal_prefix=f"{name}_",
                reference=datatype.reference,
            ),
            function,
        )

    def _array(
        self,
        function: FunctionJson,
        datatype: Datatype,
        symbols: tuple[EnumerationValue, ...] | None,
        vss_datatype: str | None,
    ) -> model.ImplementationType:
        element = self.of_reference(function, datatype.element or "", symbols, vss_datatype)
        if datatype.length is None:
            message = f"Datatype {datatype.reference} of {function.info.function_name} must have a length: nothing in an RTE grows."
            self._context.findings.report(codes.DATATYPE_UNFIT_CLASSIC, message, Subject("", datatype))
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
        self._context.findings.report(
            codes.DATATYPE_UNFIT_CLASSIC, message, Subject("", datatype or function), "Give it a `Kind` with content."
        )

    # -- what values mean ------------------------------------------------------------------------------------------

    def application(self, name: str, implementation: str, meaning: Meaning) -> str:
        """The application type of an element, under its name, and those of its elements and members."""
        code = self._implementation[implementation]
        if code.category == "ARRAY":
            element = self.application(f"{name}_Element", code.element or "", meaning)
            return self._add_application(
                model.ApplicationType(
                    name=name, category="ARRAY", implementation=implementation, element=element, length=code.length,
                    description=meaning.description,
                )
            )  # fmt: skip
        if code.category == "STRUCTURE":
            members = tuple(
                each.model_copy(update={"type": self.application(f"{name}_{each.name}", each.type, Meaning())})
                for each in code.members or ()
            )
            return self._add_application(
                model.ApplicationType(
                    name=name, category="STRUCTURE", implementation=implementation, members=members,
                    description=meaning.description,
                )
            )  # fmt: skip
        return self._add_application(self._primitive_application(name, code, meaning))

    def _primitive_application(
        self, name: str, code: model.ImplementationType, meaning: Meaning
    ) -> model.ApplicationType:
        has_range = code.base != "boolean" and (meaning.low is not None or meaning.high is not None)
        if has_range:
            self._constraints[name] = model.DataConstraint(name=name, min=meaning.low, max=meaning.high)
        unit = self._unit(meaning.unit)
        return model.ApplicationType(
            name=name,
            category="BOOLEAN" if code.base == "boolean" else "VALUE",
            implementation=code.name,
            compu_method=code.compu_method or self._identical(unit),
            constraint=name if has_range else None,
            unit=unit,
            description=meaning.description,
        )

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

    def _add_application(self, made: model.ApplicationType) -> str:
        self._application[made.name] = made
        return made.name
