"""A service with the names that are generated for it, and for what it is made of."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.arxml.interfaces import Whole, wholes
from sigcat.adapter.autosar_adaptive.cpp_names import ServiceNames, TypeNames, member_name, service_names, type_names
from sigcat.integration.autosar_adaptive.model import Event, IntegrationModel, Method, ServiceField
from sigcat.integration.autosar_adaptive.namespaces import parts


class Service(NamedTuple):
    """A service and its names in C++."""

    whole: Whole
    names: ServiceNames
    types: TypeNames
    errors: tuple[str, ...]
    """Namespace of the errors of methods."""

    @property
    def tables(self) -> tuple[str, ...]:
        """Namespace of its tables of ids."""
        return (*self.names.namespace, f"{self.names.stem.lower()}_tables")

    @property
    def tables_header(self) -> str:
        """Header of its tables of ids, as it is included."""
        return "/".join((*self.names.namespace, f"{self.names.stem.lower()}_tables.h"))

    @property
    def elements(self) -> tuple[Event | ServiceField, ...]:
        """Everything that is sent: events and notifiers of fields, in the order of the table."""
        return (*self.whole.events, *self.whole.fields)

    def words(self) -> set[str]:
        """Datatypes of everything that it has."""
        arguments = (
            each for method in self.whole.methods for each in (*(method.inputs or ()), *(method.outputs or ()))
        )
        return {
            *(event.datatype for event in self.whole.events),
            *(field.word for field in self.whole.fields),
            *(argument.datatype for argument in arguments),
        }

    def result(self, method: Method) -> str:
        """Type of what a method gives."""
        return "::".join((*self.outputs, output_name(method))) if method.outputs else "void"

    @property
    def outputs(self) -> tuple[str, ...]:
        """Namespace of what its methods give."""
        return (*self.names.namespace, f"{self.names.stem.lower()}_outputs")


def members(kinds: Mapping[str, Sequence[Event | ServiceField | Method]]) -> list[str]:
    """The members of a proxy or a skeleton; kinds: events, fields and methods."""
    return [
        f"    {kind}::{member_name(each.name)} {member_name(each.name)};"
        for kind, elements in kinds.items()
        for each in elements
    ]


def connected(service: Service) -> list[str]:
    """What the constructor of a proxy or a skeleton makes of its events and fields."""
    tables = service.tables[-1]
    events = (
        f"{member_name(each.name)}{{connection_, {tables}::{constant(each.name)}}}" for each in service.whole.events
    )
    fields = (
        f"{member_name(each.name)}{{connection_, {tables}::{constant(each.name)}{_getter(each)}}}"
        for each in service.whole.fields
    )
    return [*events, *fields]


def _getter(field: ServiceField) -> str:
    return f", 0x{field.getter_id:04X}" if field.getter_id else ""


def services(model: IntegrationModel) -> tuple[Service, ...]:
    """The services of a model, by name."""
    types = type_names(model)
    assert model.deployment is not None
    errors = tuple(parts(model.deployment.namespace or ""))
    return tuple(Service(whole, service_names(whole, model), types, errors) for whole in wholes(model))


def output_name(method: Method) -> str:
    """The struct of what a method gives."""
    return f"{member_name(method.name)}Output"


def constant(name: str) -> str:
    """Name of a constant: `kName`."""
    return f"k{member_name(name)}"
