"""The catalogue with everything that function files define laid over it."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.layers import Layer
from sigcat.catalogue.reading.statement import Origin, SourceFile, Statement
from sigcat.function.declaration.declaration import Declared
from sigcat.function.document.document import Document
from sigcat.function.extension.carried import carried_definitions
from sigcat.function.extension.defined_nodes import DefinedNode, Definitions, definitions_of
from sigcat.function.extension.sound_catalogue import sound


class ExtendedCatalogue(NamedTuple):
    """A catalogue with what files define, and what each of them does, in their order."""

    catalogue: Catalogue
    definitions: tuple[Definitions, ...]


def extended(catalogue: Catalogue, files: Sequence[Declared | Document]) -> ExtendedCatalogue:
    """The catalogue with everything that the files define: what one defines, the others may use.

    Values that are errors are left out.
    """
    definitions = tuple(_definitions(each, catalogue) for each in files)
    documents = (each.document if isinstance(each, Declared) else each for each in files)
    pairs = list(zip(documents, definitions, strict=True))
    overlays = [_layer(made.nodes, document, is_overlay=True) for document, made in pairs if made.nodes]
    types = [_layer(made.types, document, is_overlay=False) for document, made in pairs if made.types]
    if not overlays and not types:
        return ExtendedCatalogue(sound(catalogue), definitions)
    layers, type_layers = [*catalogue.tree_layers, *overlays], [*catalogue.type_layers, *types]
    composed = compose(layers, catalogue.vocabulary, type_layers, name=catalogue.name, earlier=catalogue)
    return ExtendedCatalogue(sound(composed), definitions)


def _definitions(file: Declared | Document, catalogue: Catalogue) -> Definitions:
    if not isinstance(file, Declared):
        return carried_definitions(file, catalogue)
    return definitions_of(file.declaration, catalogue) if file.declaration is not None else Definitions()


def _layer(nodes: tuple[DefinedNode, ...], document: Document, *, is_overlay: bool) -> Layer:
    file = SourceFile(document.name, document.name if is_overlay else "", document.digest)
    statements = tuple(DefinedStatement(node, file, document) for node in nodes)
    return Layer(document.name, is_overlay, (file,), statements, ())


class DefinedStatement(Statement):
    """A statement of a declaration about a node; positions are those of the declaration."""

    __slots__ = ("_node", "_position")

    def __init__(self, node: DefinedNode, file: SourceFile, document: Document) -> None:
        super().__init__(node.path, file, node.values, 0, ())
        self._node = node
        self._position = document.position

    def origin(self, attribute: str = "") -> Origin:
        """Position of an attribute's value, or of the interface if it is not written."""
        return Origin(self.file.name, *self._position(self._node.pointer(attribute)), self.file.overlay)

    def origin_within(self, attribute: str, steps: Sequence[int | str], *, at_key: bool = False) -> Origin | None:
        """Position of an item of a list or mapping."""
        position = self._position((*self._node.pointer(attribute), *steps), of_key=at_key)
        return Origin(self.file.name, *position, self.file.overlay)

    def origin_of_key(self, attribute: str) -> Origin:
        """Position of the attribute; a declaration knows no better."""
        return self.origin(attribute)

    def spelled(self, attribute: str) -> str:
        """The key of the declaration."""
        return self._node.keys.get(attribute, attribute)

    def placed(self, prefix: str) -> "Statement":
        """Nothing includes a declaration."""
        raise NotImplementedError(prefix)
