"""Function JSON: a function with everything that an integration needs to know, independent of any platform.

A superset of the authors' published schema, field for field and spelling for spelling (`Dependancy`, `Asillevel`,
`functionList`); Python names are the correct ones. What the paper's tables have and the published schema lacks is
added as optional fields, and so is what later stages need, such as the VSS path of a signal.
"""

from typing import Annotated, Any

from pydantic import Field

from sigcat.function.document.field_types import DATE, VERSION, Name, Version
from sigcat.function.document.text import Text
from sigcat.function.function_json.code import CodeInterface
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.interfaces.status_interfaces import ModeInterface
from sigcat.function.function_json.provenance import Provenance
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.wire import (
    Listed,
    WireModel,
    described,
    document_schema,
    optional,
    own,
    tabled,
    written,
)


class MetaInfo(WireModel):
    """Responsible team of the document, and its version."""

    authority: Text | None = optional("Authority", "Organization that the document belongs to.")
    schema_author: Text | None = optional("SchemaAuthor", "Author of the document.")
    date: Annotated[str, Field(pattern=r"^\d{2}.\d{2}.\d{4}$"), DATE] | None = optional(
        "Date", "Date of the document, as DD.MM.YYYY."
    )
    schema_version: Annotated[str, Field(pattern=r"^\d+\.\d+\.\d+$"), VERSION] | None = optional(
        "SchemaVersion", "Version of the document's format, as three numbers."
    )
    schema_description: Text | None = optional("SchemaDescription", "What the document is.")


class FunctionInfo(WireModel):
    """Identity of the function."""

    function_name: Name = described("FunctionName", "Name of the function.")
    function_responsible: Text = described("FunctionResponsible", "Team that answers for the function.")
    description: Text = described("Description", "What the function does.")
    version: Version | None = own("Version", "Version of the function.")


class Component(WireModel):
    """A part of the function that is deployed as a whole."""

    name: Name = described("Name", "Name of the component.")
    runnables: Listed[Runnable] = described("functionList", "Calls of the component.")


class Mode(WireModel):
    """A mode of the function and what runs in it."""

    name: Name = described("Name", "Name of the mode.")
    description: Text = described("Description", "What the mode means.")
    runnables: Listed[Name] = described("RunnablesList", "Names of the calls that run in the mode.")


class FunctionJson(WireModel):
    """The whole document."""

    meta: MetaInfo = described("MetaInfo", "Who is responsible for the document, and its version.")
    info: FunctionInfo = described("FunctionInfo", "Identity of the function.")
    components: Listed[Component] = described("ComponentList", "Components of the function.")
    modes: Listed[Mode] | None = described("ModesList", "Modes of the function and the calls that run in them.")
    datatypes: Listed[Datatype] = described("Datatypes", "Datatypes that interfaces refer to.")
    mode_interfaces: Listed[ModeInterface] | None = tabled("ModeInterfaceList", "Mode management interfaces.")
    code: CodeInterface | None = own("Code", "How the code of the function is compiled and called.")
    provenance: Provenance | None = own("Provenance", "What the document was made from.")


def to_json(function: FunctionJson) -> bytes:
    """The document as UTF-8 text with a stable layout: the same function gives the same bytes."""
    return written(function)


def function_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of Function JSON."""
    return document_schema(FunctionJson)
