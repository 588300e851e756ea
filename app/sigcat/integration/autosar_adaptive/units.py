"""The units that a model uses."""

from collections.abc import Iterator

from sigcat.integration.autosar_adaptive.model import IntegrationModel


def units_of(model: IntegrationModel) -> frozenset[str]:
    """Units of events, arguments, parameters and members of structs."""
    return frozenset(unit for unit in _units(model) if unit)


def _units(model: IntegrationModel) -> Iterator[str | None]:
    for entry in model.datatypes or ():
        yield from (field.unit for field in entry.fields or ())
    for component in model.components:
        yield from (parameter.datatype.unit for parameter in component.parameters or ())
    for interface in model.interfaces:
        yield from (event.unit for event in interface.events)
        for method in interface.methods:
            yield from (argument.unit for argument in (*(method.inputs or ()), *(method.outputs or ())))
