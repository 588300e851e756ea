"""Sources of a document."""

from typing import Annotated

from pydantic import Field
from typing_extensions import TypeAliasType

from sigcat.function.document.field_types import Carried, Digest, Name, VssPath
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import OWN, WireModel, described

VspecAttributes = TypeAliasType(
    "VspecAttributes", Annotated[dict[Name, Carried], Field(description="Attributes by name, as in a vspec file.")]
)


class CatalogueLayer(WireModel):
    """A tree or an overlay that took part."""

    name: Text = described("Name", "Name of its file.", source=OWN)
    digest: Digest = described("Digest", "SHA-256 over its files.", source=OWN)


class DefinedInterface(WireModel):
    """An interface that the declaration itself defines, as an overlay would have it."""

    path: VssPath = described("Path", "Path of the interface in the catalogue.", source=OWN)
    attributes: VspecAttributes = described("Attributes", "Its attributes, as in a vspec file.", source=OWN)


class Provenance(WireModel):
    """Sources of the document: from the same, it can be made again, byte for byte."""

    generator: Text = described("Generator", "Program and version.", source=OWN)
    declaration: Text = described("Declaration", "Name of the file that declares the function.", source=OWN)
    declaration_digest: Digest = described("DeclarationDigest", "SHA-256 of its bytes.", source=OWN)
    catalogue: Text = described("Catalogue", "Name of the catalogue.", source=OWN)
    catalogue_digest: Digest = described(
        "CatalogueDigest", "SHA-256 of its content, however split into files.", source=OWN
    )
    release: Text | None = described("Release", "Release of VSS, if the tree states it.", default=None, source=OWN)
    layers: tuple[CatalogueLayer, ...] = described(
        "Layers", "The tree and its overlays, in the order in which they apply.", source=OWN, strict=False
    )
    definitions: tuple[DefinedInterface, ...] | None = described(
        "Definitions", "Interfaces that the declaration defines itself.", default=None, source=OWN, strict=False
    )
    type_definitions: tuple[DefinedInterface, ...] | None = described(
        "TypeDefinitions", "Struct types that it defines itself.", default=None, source=OWN, strict=False
    )
