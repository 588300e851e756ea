"""The ends of a signal: each belongs to a call of a function, which reads or writes it."""

from typing import NamedTuple

from sigcat.function.document.document import Pointer
from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.role import CONSUMER, PROVIDER
from sigcat.function.function_json.runnable import Runnable

Datum = Signal | DataQueue


class End(NamedTuple):
    """A signal at a call of a function."""

    owner: FunctionJson
    pointer: Pointer
    """Pointer of the signal in the document of its owner."""
    runnable: Runnable
    signal: Datum

    @property
    def function(self) -> str:
        """Name of the function."""
        return self.owner.info.function_name

    @property
    def call(self) -> str:
        """Name of the call."""
        return self.runnable.name

    @property
    def path(self) -> str:
        """Name that both ends of a link share: the VSS path, or the name where a document has none."""
        return self.signal.vss_path or self.signal.name

    @property
    def is_provider(self) -> bool:
        """Whether the call writes the signal."""
        return self.signal.role == PROVIDER

    @property
    def is_consumer(self) -> bool:
        """Whether the call reads the signal."""
        return self.signal.role == CONSUMER
