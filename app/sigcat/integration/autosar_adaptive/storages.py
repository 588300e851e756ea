"""Key-value storages of a component, and what each of them holds."""

from collections.abc import Iterator
from typing import NamedTuple

from sigcat.function.function_json.code import DEFAULT_STORAGE
from sigcat.integration.autosar_adaptive.model import Component, ParameterEntry
from sigcat.integration.autosar_names import short_name

ADAPTER_STORAGE = "Adapter"
"""Values that the adapter itself stores: counts of errors and the ignition cycle. No parameter is in it."""


def storage_name(component: Component, storage: str) -> str:
    """Name of the interface over which a component reads and writes a storage."""
    return short_name(f"{component.name}_{storage}")


class StoredParameter(NamedTuple):
    """A parameter, and where it is stored."""

    storage: str
    key: str
    parameter: ParameterEntry

    @property
    def is_learned(self) -> bool:
        """Whether it is written too."""
        return self.parameter.attribute == "LearningParameter"


def stored_parameters(component: Component) -> tuple[StoredParameter, ...]:
    """The parameters of a component, in their order."""
    return tuple(_stored(component))


def _stored(component: Component) -> Iterator[StoredParameter]:
    """One that two calls describe differently is listed twice, but stored once: the second entry keeps its own name."""
    default = (component.code.storage if component.code else None) or DEFAULT_STORAGE
    holders: dict[tuple[str, str], str | None] = {}
    for entry in component.parameters or ():
        storage = (entry.code.storage if entry.code else None) or default
        key = (entry.code.key if entry.code else None) or entry.name
        is_known = entry.variable is not None and holders.get((storage, key)) == entry.variable
        yield StoredParameter(storage, entry.name if is_known else key, entry)
        holders.setdefault((storage, key), entry.variable)


def storages(component: Component) -> dict[str, tuple[StoredParameter, ...]]:
    """The storages of its parameters by name."""
    stored = stored_parameters(component)
    return {
        name: tuple(each for each in stored if each.storage == name)
        for name in dict.fromkeys(each.storage for each in stored)
    }
