"""Sources of a document."""

from typing import Annotated

from pydantic import Field
from typing_extensions import TypeAliasType

from sigcat.function.document.field_types import Carried, Digest, Name, VssPath
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import Listed, WireModel, always, own

VspecAttributes = TypeAliasType(
    "VspecAttributes", Annotated[dict[Name, Carried], Field(description="Attributes by name, as in a vspec file.")]
)


class CatalogueLayer(WireModel):
    """A tree or an overlay that took part."""

    name: Text = always("Name", "Name of its file.")
    digest: Digest = always("Digest", "SHA-256 over its files.")


class DefinedInterface(WireModel):
    """An interface that the declaration itself defines, as an overlay would have it."""

    path: VssPath = always("Path", "Path of the interface in the catalogue.")
    attributes: VspecAttributes = always("Attributes", "Its attributes, as in a vspec file.")


class Provenance(WireModel):
    """Sources of the document: from the same, it can be made again, byte for byte."""

    generator: Text = always("Generator", "Program and version.")
    declaration: Text = always("Declaration", "Name of the file that declares the function.")
    declaration_digest: Digest = always("DeclarationDigest", "SHA-256 of its bytes.")
    catalogue: Text = always("Catalogue", "Name of the catalogue.")
    catalogue_digest: Digest = always("CatalogueDigest", "SHA-256 of its content, however split into files.")
    release: Text | None = own("Release", "Release of VSS, if the tree states it.")
    layers: Listed[CatalogueLayer] = always("Layers", "The tree and its overlays, in the order in which they apply.")
    definitions: Listed[DefinedInterface] | None = own("Definitions", "Interfaces that the declaration defines itself.")
    type_definitions: Listed[DefinedInterface] | None = own("TypeDefinitions", "Struct types that it defines itself.")
