"""C++ namespaces, in which the code that is generated from ARXML has its services and datatypes."""

from typing import Annotated, Literal

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from sigcat.function.document.field_types import CPP_NAMESPACE
from sigcat.integration.autosar_names import short_name
from sigcat.names import snake_case
from sigcat.reserved_words import is_reserved

HeaderFolders = Literal["namespaces", "none"]
DEFAULT_HEADER_FOLDERS: HeaderFolders = "namespaces"
"""As SWS_CM prescribes it for services."""
_TAKEN = ("ara", "std")
"""Outermost namespaces of the platform and of the standard library."""


def parts(namespace: str) -> list[str]:
    """Its names, the outermost first."""
    return namespace.split("::")


def namespace_of(application: str) -> str:
    """The namespace of an application that states none: `EcoControl` → `eco_control`."""
    name = short_name(snake_case(short_name(application)))
    return f"{name}_application" if _is_reserved(name) else name


def _is_reserved(namespace: str) -> bool:
    names = parts(namespace)
    return names[0] in _TAKEN or any(is_reserved(name) for name in names)


def _unreserved(namespace: str) -> str:
    if _is_reserved(namespace):
        message = "Input should not contain keywords of C++, and not begin with ara or std"
        raise PydanticCustomError("namespace_reserved", message)
    return namespace


Namespace = Annotated[
    str,
    Field(pattern=r"^[A-Za-z][A-Za-z0-9_]{0,127}(::[A-Za-z][A-Za-z0-9_]{0,127})*$", max_length=300),
    AfterValidator(_unreserved),
    CPP_NAMESPACE,
]
"""Namespaces within each other, as `eco::control`."""
