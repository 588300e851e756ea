"""Stored values: parameters, and the counts of errors."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.plan import ComponentPlan, Storage, Stored
from sigcat.adapter.autosar_adaptive.arxml.components import IGNITION_CYCLE
from sigcat.integration.autosar_adaptive.storages import ADAPTER_STORAGE


class StoredValues(NamedTuple):
    """All that a component stores beside its parameters, and what it writes at the end."""

    adapter: str
    """The storage of the adapter itself."""
    cycle: str
    """Key of the ignition cycle."""
    learned: Sequence[Stored]
    written: Sequence[Storage]


def stored_values(component: ComponentPlan) -> StoredValues:
    """The stored values of a component."""
    learned = [each for each in component.stored if each.parameter.learned is not None]
    storages = {each.storage for each in learned}
    written = [each for each in component.storages if each in storages or each.name == ADAPTER_STORAGE]
    return StoredValues(f"storage_{ADAPTER_STORAGE}_", IGNITION_CYCLE, learned, written)
