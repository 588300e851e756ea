"""References to values that are too large to be sent with each piece of work: they are kept where the work is done.

A reference names the very catalogue that a request holds, and not the one that has its id by now.
"""

import copyreg
import io
import pickle
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from sigcat.api.service_rules import ServiceRules
from sigcat.catalogue.hosting.variants import Choice, origin_of, variant_of
from sigcat.catalogue.model.catalogue import Catalogue


class Work(NamedTuple):
    """A function of a module, and what it is called with."""

    function: Callable[..., Any]
    arguments: tuple[Any, ...]
    options: Mapping[str, Any]


def _mapping_proxy(mapping: dict[Any, Any]) -> MappingProxyType[Any, Any]:
    return MappingProxyType(mapping)


copyreg.pickle(MappingProxyType, lambda proxy: (_mapping_proxy, (dict(proxy),)))


class PickledWork(NamedTuple):
    """Work as bytes, and the values that it refers to by number."""

    data: bytes
    values: Mapping[int, object]


def pickled(work: Work, number_of: Callable[[object], int]) -> PickledWork:
    """Work with references instead of catalogues and rules. `number_of` gives each of these its number."""
    buffer = io.BytesIO()
    pickler = _Pickler(buffer, number_of)
    pickler.dump(work)
    return PickledWork(buffer.getvalue(), pickler.values)


def unpickled(data: io.BytesIO, kept: Mapping[int, Any]) -> Work:
    """The work, with what is kept here in place of the references. The bytes, which may be many, are given up."""
    with data:
        work: Work = _Unpickler(data, kept).load()
    return work


class _Reference(NamedTuple):
    """A value that is kept, by its number, or a variant that is made of it."""

    number: int
    variant: Choice | None


class _Pickler(pickle.Pickler):
    def __init__(self, file: io.BytesIO, number_of: Callable[[object], int]) -> None:
        super().__init__(file, pickle.HIGHEST_PROTOCOL)
        self._number_of = number_of
        self.values: dict[int, object] = {}

    def persistent_id(self, value: object) -> _Reference | None:
        if not isinstance(value, Catalogue | ServiceRules):
            return None
        origin = origin_of(value) if isinstance(value, Catalogue) else None
        kept, variant = origin or (value, None)
        number = self._number_of(kept)
        self.values[number] = kept
        return _Reference(number, variant)


class _Unpickler(pickle.Unpickler):  # reads only data that the service sends to its own process
    def __init__(self, file: io.BytesIO, kept: Mapping[int, Any]) -> None:
        super().__init__(file)
        self._kept = kept

    def persistent_load(self, reference: _Reference) -> object:
        value = self._kept[reference.number]
        return value if reference.variant is None else variant_of(value, reference.variant)
