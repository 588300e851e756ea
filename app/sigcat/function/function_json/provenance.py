"""What a document was made from."""

from typing import Annotated, Any

from pydantic import Field
from typing_extensions import TypeAliasType

from sigcat.function.function_json.wire import OWN, WireModel, described

VspecAttributes = TypeAliasType(
    "VspecAttributes", Annotated[dict[str, Any], Field(description="Attributes by name, as in a vspec file.")]
)


class CatalogueLayer(WireModel):
    """A tree or an overlay that took part."""

    name: str = described("Name", "Name of its file.", source=OWN)
    digest: str = described("Digest", "SHA-256 over its files.", source=OWN)


class DefinedInterface(WireModel):
    """An interface that the declaration itself defines, as an overlay would have it."""

    path: str = described("Path", "Path of the interface in the catalogue.", source=OWN)
    attributes: VspecAttributes = described("Attributes", "Its attributes, as in a vspec file.", source=OWN)


class Provenance(WireModel):
    """What the document was made from: with the same, it can be made again, byte for byte."""

    generator: str = described("Generator", "Program and version.", source=OWN)
    declaration: str = described("Declaration", "Name of the file that declares the function.", source=OWN)
    declaration_digest: str = described("DeclarationDigest", "SHA-256 of its bytes.", source=OWN)
    catalogue: str = described("Catalogue", "Name of the catalogue.", source=OWN)
    catalogue_digest: str = described(
        "CatalogueDigest", "SHA-256 of its content, however split into files.", source=OWN
    )
    release: str | None = described("Release", "Release of VSS, if the tree states it.", default=None, source=OWN)
    layers: tuple[CatalogueLayer, ...] = described(
        "Layers", "The tree and its overlays, in the order in which they apply.", source=OWN, strict=False
    )
    definitions: tuple[DefinedInterface, ...] | None = described(
        "Definitions", "Interfaces that the declaration defines itself.", default=None, source=OWN, strict=False
    )
    type_definitions: tuple[DefinedInterface, ...] | None = described(
        "TypeDefinitions", "Struct types that it defines itself.", default=None, source=OWN, strict=False
    )
