"""The plan of a service: every name and number that its files have in C++."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.arxml.interfaces import Whole, wholes
from sigcat.adapter.autosar_adaptive.cpp_names import ServiceNames, TypeNames, member_name, service_names, type_names
from sigcat.function.document.text import Text, sentence
from sigcat.integration.autosar_adaptive.deployment.namespaces import parts
from sigcat.integration.autosar_adaptive.model import Event, IntegrationModel, Method, MethodArgument, ServiceField


class Protection(NamedTuple):
    """End-to-end protection of an element."""

    profile: int
    data_id: str
    max_delta_counter: int | None


class Element(NamedTuple):
    """An event or a field."""

    name: str
    """Its short name."""
    member: str
    constant: str
    type: str
    about: Text
    number: str
    """Id of the event, or of the notifier of the field."""
    group: str
    getter: str = ""
    is_field: bool = False
    protection: Protection | None = None


class Argument(NamedTuple):
    """An argument of a method, or what it gives."""

    type: str
    name: str


class ServiceMethod(NamedTuple):
    """A method. What it gives is in a struct, if it gives anything."""

    name: str
    """Its short name."""
    member: str
    number: str
    about: Text
    inputs: Sequence[Argument]
    outputs: Sequence[Argument]
    about_outputs: Text
    output: str
    """The struct, or `void`."""
    result: str
    """The same with its namespaces."""

    @property
    def types(self) -> str:
        """Types of its arguments."""
        return ", ".join(each.type for each in self.inputs)

    @property
    def arguments(self) -> str:
        """Its arguments as they are declared."""
        return ", ".join(f"const {each.type}& {each.name}" for each in self.inputs)

    @property
    def passed(self) -> str:
        """Its arguments as they are passed on."""
        return ", ".join(each.name for each in self.inputs)


class Service(NamedTuple):
    """A service. Its elements are events and fields, in the order of the table of ids."""

    whole: Whole
    names: ServiceNames
    types: TypeNames
    words: frozenset[str]
    """Datatypes of everything that it has."""
    events: Sequence[Element]
    fields: Sequence[Element]
    methods: Sequence[ServiceMethod]

    @property
    def name(self) -> str:
        """Its short name."""
        return self.whole.name

    @property
    def elements(self) -> Sequence[Element]:
        """Everything that is sent."""
        return (*self.events, *self.fields)

    @property
    def results(self) -> Sequence[ServiceMethod]:
        """Methods that give something."""
        return [method for method in self.methods if method.outputs]

    @property
    def tables(self) -> str:
        """Name of the namespace of its tables of ids."""
        return f"{self.names.stem.lower()}_tables"

    @property
    def tables_header(self) -> str:
        """Header of its tables of ids, as it is included."""
        return "/".join((*self.names.namespace, f"{self.tables}.h"))

    @property
    def outputs(self) -> str:
        """Name of the namespace of the results of its methods."""
        return f"{self.names.stem.lower()}_outputs"

    def namespace(self, name: str) -> str:
        """Return a namespace in its own."""
        return "::".join((*self.names.namespace, name))


def services(model: IntegrationModel) -> tuple[Service, ...]:
    """The services of a model, by name."""
    types = type_names(model)
    return tuple(_service(whole, service_names(whole, model), types) for whole in wholes(model))


def error_namespace(model: IntegrationModel) -> tuple[str, ...]:
    """Namespace of the errors of methods."""
    assert model.deployment is not None
    return tuple(parts(model.deployment.namespace or ""))


def hexadecimal(number: int | None) -> str:
    """Return an id as it is written; 0 if there is none."""
    return f"0x{number or 0:04X}"


def _service(whole: Whole, names: ServiceNames, types: TypeNames) -> Service:
    groups = {group.name: hexadecimal(group.id) for group in whole.event_groups}
    return Service(
        whole, names, types, frozenset(_words(whole)),
        [_event(event, groups.get(event.event_group or "", hexadecimal(0)), types) for event in whole.events],
        [_field(field, groups.get(field.event_group or "", hexadecimal(0)), types) for field in whole.fields],
        [_method(method, names, types) for method in whole.methods],
    )  # fmt: skip


def _words(whole: Whole) -> Iterable[str]:
    yield from (event.datatype for event in whole.events)
    yield from (field.word for field in whole.fields)
    for method in whole.methods:
        yield from (each.datatype for each in (*(method.inputs or ()), *(method.outputs or ())))


def _event(event: Event, group: str, types: TypeNames) -> Element:
    member = member_name(event.name)
    cycle = f"every {event.cycle_time:g} ms" if event.cycle_time else None
    about = sentence(event.vss_path or event.description or event.name, event.unit, cycle)
    return Element(
        event.name, member, f"k{member}", types.type(event.datatype), about, hexadecimal(event.event_id), group,
        protection=_protection(event),
    )  # fmt: skip


def _field(field: ServiceField, group: str, types: TypeNames) -> Element:
    member = member_name(field.name)
    about = sentence(field.vss_path or field.description or field.name)
    getter = hexadecimal(field.getter_id) if field.getter_id else ""
    return Element(
        field.name, member, f"k{member}", types.type(field.word), about, hexadecimal(field.notifier_id), group, getter,
        is_field=True, protection=_protection(field),
    )  # fmt: skip


def _protection(element: Event | ServiceField) -> Protection | None:
    found = element.protection
    return Protection(found.profile, hexadecimal(found.data_id), found.max_delta_counter) if found else None


def _method(method: Method, names: ServiceNames, types: TypeNames) -> ServiceMethod:
    member, inputs, outputs = member_name(method.name), method.inputs or (), method.outputs or ()
    output = f"{member}Output" if outputs else "void"
    namespace = (*names.namespace, f"{names.stem.lower()}_outputs") if outputs else ()
    return ServiceMethod(
        method.name, member, hexadecimal(method.method_id),
        sentence(method.description or method.name, *map(_with_unit, (*inputs, *outputs))),
        [Argument(types.type(each.datatype), each.name) for each in inputs],
        [Argument(types.type(each.datatype), each.name) for each in outputs],
        sentence(f"What {method.name} gives", *map(_with_unit, outputs)),
        output, "::".join((*namespace, output)),
    )  # fmt: skip


def _with_unit(argument: MethodArgument) -> str | None:
    return f"{argument.name} in {argument.unit}" if argument.unit else None
