"""Enumerations and mappings of answers and requests.

Each has its own schema in the OpenAPI document: generated clients would make up a name for it otherwise.
"""

from typing import Annotated, Any, Literal

from pydantic import Field
from typing_extensions import TypeAliasType

from sigcat.catalogue.comparing.bindings import BINDINGS
from sigcat.limits import NAME_CHARACTERS

Count = Annotated[int, Field(ge=0)]
Position = Annotated[int, Field(ge=1)]
Digest = Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
Cursor = Annotated[str, Field(max_length=NAME_CHARACTERS)]
Moment = Annotated[str, Field(json_schema_extra={"format": "date-time"})]

Severity = TypeAliasType(
    "Severity", Annotated[Literal["error", "warning", "info"], Field(description="How bad a finding is.")]
)
Compatibility = TypeAliasType(
    "Compatibility",
    Annotated[
        Literal["breaking", "risky", "compatible", "text"], Field(description="Whom a change breaks, the worst first.")
    ],
)
Binding = TypeAliasType(
    "Binding",
    Annotated[
        str,
        Field(
            pattern=f"^({'|'.join(BINDINGS)})$",
            description="Form in which software uses a tree.",
            examples=["protobuf"],
        ),
    ],
)
BindingClasses = TypeAliasType(
    "BindingClasses", Annotated[dict[str, Compatibility], Field(description="Class of a change by binding.")]
)
ChangeKind = TypeAliasType(
    "ChangeKind", Annotated[Literal["removed", "moved", "changed", "added"], Field(description="What happened.")]
)
ChangeEvidence = TypeAliasType(
    "ChangeEvidence",
    Annotated[
        Literal["fka", "deprecation", "same definition"],
        Field(description="What says that a node moved; `same definition` is a guess."),
    ],
)
TextKind = TypeAliasType(
    "TextKind", Annotated[Literal["overlay", "tree", "function"], Field(description="What a posted text is.")]
)
HealthState = TypeAliasType(
    "HealthState", Annotated[Literal["alive", "ready"], Field(description="What a health check answers.")]
)
TypeCounts = TypeAliasType("TypeCounts", Annotated[dict[str, Count], Field(description="Nodes by type.")])
ValueCounts = TypeAliasType(
    "ValueCounts", Annotated[dict[str, Count], Field(description="Results by value of a filter.")]
)
Facets = TypeAliasType(
    "Facets", Annotated[dict[str, ValueCounts], Field(description="How many results have each value of each filter.")]
)
NodeValues = TypeAliasType(
    "NodeValues", Annotated[dict[str, Any], Field(description="Values of a node by name of the attribute.")]
)
RuleOptions = TypeAliasType("RuleOptions", Annotated[dict[str, Any], Field(description="Options of a check.")])
CatalogueDigests = TypeAliasType(
    "CatalogueDigests", Annotated[dict[str, Digest], Field(description="Content hash of each hosted catalogue by id.")]
)
VissNodes = TypeAliasType(
    "VissNodes", Annotated[dict[str, Any], Field(description="Attributes of a node by its name, with `children`.")]
)
