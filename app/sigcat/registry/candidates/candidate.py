"""A version to publish."""

from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.registry.changes import Nodes
from sigcat.registry.reference import Kind, Reference

_NO_NODES: Nodes = {}


class Candidate(NamedTuple):
    """A version to publish, resolved and checked."""

    kind: Kind
    name: str
    version: str
    owner: str
    content: bytes
    """The bytes of the file."""
    resolved: bytes
    """Function JSON; of an overlay and a catalogue, its nodes as JSON."""
    uses: bytes
    """Uses of a function, as JSON; of all else empty."""
    file: str = ""
    nodes: Nodes = _NO_NODES
    """All nodes of the catalogue with an overlay, to compare earlier versions with."""
    catalogue: Catalogue | None = None
    """The catalogue that these nodes are of, to find published functions that it breaks."""

    @property
    def reference(self) -> Reference:
        """The version as commands name it."""
        return Reference(self.name, self.version)
