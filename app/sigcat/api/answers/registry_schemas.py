"""Schemas of the registry. Names of fields are those of xRegistry where it has one for the same thing."""

from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field, RootModel
from typing_extensions import TypeAliasType

from sigcat.api.answers.named_types import Count, Cursor, Digest, Moment, NodeValues, Severity
from sigcat.api.answers.schemas import Finding, Schema

RegistryGroup = TypeAliasType(
    "RegistryGroup",
    Annotated[
        Literal["functions", "overlays", "catalogues"], Field(description="Kind of published names, as a plural.")
    ],
)
CompatibilityRule = TypeAliasType(
    "CompatibilityRule",
    Annotated[
        Literal["backward", "full", "approval", "none"],
        Field(
            description="What a new version may change: `backward`, anything with the right part of the version; `full`, "
            "nothing that breaks; `none`, anything."
        ),
    ],
)
ApprovalDecision = TypeAliasType(
    "ApprovalDecision", Annotated[Literal["approved", "rejected"], Field(description="Decision of an owner.")]
)
Lifecycle = TypeAliasType(
    "Lifecycle",
    Annotated[
        Literal["draft", "pending", "published", "deprecated", "retired"], Field(description="State of a version.")
    ],
)
EventValues = TypeAliasType(
    "EventValues", Annotated[dict[str, Any], Field(description="Values of an entry of the log.")]
)
Xid = Annotated[str, Field(description="Address below `/api/v1/registry`.")]


class LogHead(Schema):
    """The last entry of the log. Whoever keeps it can prove later that no entry is missing."""

    epoch: Count = Field(description="Number of the entry.")
    createdat: Moment
    hash: Digest = Field(description="SHA-256 of this entry and of all before it.")
    signature: str | None = Field(description="Ed25519 over the hash, in hexadecimal; null without a key.")


class LogEntry(Schema):
    """An entry of the log, as its hash needs it."""

    epoch: Count = Field(description="Number of the entry.")
    entry: str = Field(description="The entry as JSON, byte for byte.")
    previous: str = Field(description="The hash before it. `hash` is SHA-256 of this, a line feed, and the entry.")
    hash: Digest
    signature: str | None = Field(description="Ed25519 over the hash, in hexadecimal; null without a key.")


class LogPage(Schema):
    """One page of the log, in its order."""

    entries: list[LogEntry]
    next_cursor: Cursor | None = Field(description="Give it as `cursor` to get the next page; null on the last.")


class RegistryEvent(Schema):
    """A change of the registry as an event of CloudEvents 1.0."""

    specversion: str
    id: str = Field(description="Hash of the entry of the log.")
    source: str
    type: str = Field(description="Such as `io.sigcat.registry.published`.")
    subject: str = Field(description="Name, with its version if the event is about one.")
    time: str
    datacontenttype: str
    sequence: str = Field(description="Number of the entry of the log.")
    data: EventValues


class RegistryEventList(Schema):
    """Events in the order of the log."""

    registry_events: list[RegistryEvent]
    epoch: Count = Field(
        description="Number of the last entry of these events: give it as `after` to get the next ones."
    )


class Registry(Schema):
    """The registry: how many names it has, and the head of its log."""

    xid: Xid
    epoch: Count = Field(description="Number of the last entry of the log; 0 if there is none.")
    head: LogHead | None = Field(description="Null if nothing is published.")
    functionscount: Count
    overlayscount: Count
    cataloguescount: Count
    linescount: Count


class RegistryName(Schema):
    """A published name."""

    xid: Xid
    group: RegistryGroup
    name: str
    owner: str | None = Field(description="Owner of the default version.")
    compatibility_rule: CompatibilityRule
    defaultversionid: str = Field(
        description="The newest release that may be deployed; without one, the newest version."
    )
    versionscount: Count
    createdat: Moment
    versions: "list[RegistryVersion] | None" = Field(description="By precedence; null without `?inline=versions`.")


class RegistryNamePage(Schema):
    """One page of published names, in the order in which they were published."""

    total: Count = Field(description="How many names there are.")
    names: list[RegistryName]
    next_cursor: Cursor | None = Field(description="Give it as `cursor` to get the next page; null on the last.")


class RegistryUse(Schema):
    """A use of a node, or of an interface without one, by a function."""

    verb: str
    element: str = Field(description="What is used: a path, or the name of an interface.")
    path: str | None = Field(description="Path of the node; null if it has none.")
    name: str = Field(description="Name that all functions use.")
    call: str | None
    variable: str | None = Field(description="Expression of the C code that has the value.")
    via: str | None = Field(description="Path of the signal whose struct type the node belongs to.")
    values: NodeValues = Field(description="Attributes of the node that the function relies on.")
    is_in_catalogue: bool = Field(description="Whether the catalogue defines the node, and not a function.")
    is_needed: bool = Field(description="Whether another function must provide it.")
    is_optional: bool = Field(description="Whether the function runs without it.")
    leads_to: list[str] = Field(description="Errors, reactions and modes that follow from it in this function.")


class VersionAddress(Schema):
    """A version of a name, and its address."""

    xid: Xid
    group: RegistryGroup
    name: str
    versionid: str


class RegistryVersion(VersionAddress):
    """A version, without its content."""

    isdefault: bool = Field(description="Whether the address of the name answers with this version.")
    ancestorid: str = Field(description="The version before it; of the first one, itself.")
    lifecycle: Lifecycle
    owner: str | None
    removal: str | None = Field(description="Day on which the support of a deprecated version may end.")
    alternative: str | None = Field(description="Version that replaces a deprecated one.")
    createdat: Moment
    content_digest: Digest = Field(description="SHA-256 of the published bytes.")
    resolved_digest: Digest = Field(description="SHA-256 of its Function JSON; of others, of its nodes as JSON.")
    vehicle_lines: list[str] = Field(description="Lines whose vehicles run it.")
    uses: list[RegistryUse] | None = Field(description="Null without `?inline=uses`.")


class RegistryVersionList(Schema):
    """Versions of a name by precedence."""

    versions: list[RegistryVersion]


class VersionReference(Schema):
    """A version of a function."""

    name: str
    versionid: str


class RegistryUser(VersionReference):
    """A use of an element by a version of a function."""

    lifecycle: Lifecycle
    owner: str | None
    vehicle_lines: list[str]
    through: list[str] = Field(description="Elements between the one asked for and this use.")
    use: RegistryUse


class RegistryUserList(Schema):
    """Users of an element, directly and through errors, safety reactions and modes."""

    users: list[RegistryUser]
    more: Count = Field(description="How many are not shown.")


class Deployment(VersionReference):
    """A version that vehicles of a line run."""

    lifecycle: Lifecycle
    owner: str | None
    since: Moment


class VehicleLine(Schema):
    """A vehicle line, and what its vehicles run."""

    name: str
    deployments: list[Deployment]


class VehicleLineList(Schema):
    """All vehicle lines by name."""

    lines: list[VehicleLine]


class RegistryApproval(Schema):
    """The decision of an owner whose functions a pending version breaks."""

    owner: str
    broken_functions: str = Field(description="Functions of the owner that break, with their versions.")
    approval_decision: ApprovalDecision | None = Field(description="Null as long as there is none.")
    decided: Moment | None
    valid_until: Moment | None = Field(description="When the approval ends.")
    reason: str | None = Field(description="Reason of a rejection.")


class RegistryOutcome(VersionAddress):
    """A posted version, and whether it is new."""

    is_new: bool = Field(description="False: the same bytes were published under this version before.")
    is_draft: bool
    is_pending: bool = Field(
        description="It is not published before the owners of the functions that it breaks approve."
    )
    owner: str | None
    previous_owner: str | None = Field(description="Owner of the newest version before; null if it is the same.")
    approvals: list[RegistryApproval]


class RegistryPending(VersionAddress):
    """A version that is stored, and not published."""

    owner: str | None
    content_digest: Digest = Field(description="SHA-256 of the content to approve.")
    approvals: list[RegistryApproval]


class RegistryPendingList(Schema):
    """Pending versions by kind, name and precedence."""

    versions_pending: list[RegistryPending]


class RegistryAcknowledgement(Schema):
    """An owner of functions that use a deprecated version."""

    owner: str
    using_functions: str = Field(description="Functions of the owner that use it, with their versions.")
    acknowledged: Moment | None = Field(description="When the owner acknowledged the deprecation; null if it did not.")


class RegistryDeprecation(VersionAddress):
    """A deprecated version, and the owners that use it."""

    owner: str | None
    removal: str | None = Field(description="Day on which its support may end.")
    alternative: str | None = Field(description="Version that replaces it.")
    acknowledgements: list[RegistryAcknowledgement]


class RegistryDeprecationList(Schema):
    """Deprecated versions by kind, name and precedence."""

    versions_deprecated: list[RegistryDeprecation]


class RegistryDecision(Schema):
    """All decisions about a pending version, and the log that proves the change."""

    approvals: list[RegistryApproval]
    head: LogHead | None = Field(description="The last entry of the log behind the change.")


class RegistryReceipt(Schema):
    """Published versions, and the log that proves it."""

    versions_posted: list[RegistryOutcome]
    head: LogHead | None = Field(description="The last entry of the log behind the change.")


class RegistryChange(Schema):
    """A change of the registry, and the log that proves it."""

    head: LogHead | None = Field(description="The last entry of the log behind the change.")


class ConflictSide(VersionReference):
    """A function of a conflict."""

    owner: str | None
    calls: list[str]


class RegistryConflict(Schema):
    """Two functions that do not fit, or one that loses its provider. The function at fault is the first side."""

    rule: str
    severity: Severity
    message: str
    path: str | None
    attribute: str | None = Field(description="Attribute of the signal in which both differ.")
    fix: str | None
    sides: list[ConflictSide]
    vehicle_lines: list[str]


Decision = TypeAliasType(
    "Decision",
    Annotated[Literal["yes", "no", "unknown"], Field(description="`unknown`: nothing is recorded for the line.")],
)


class DeploymentAnswer(Schema):
    """Whether versions may be deployed to the vehicles of a line, and why not."""

    decision: Decision
    vehicle_line: str
    deployed: list[VersionReference]
    checked: list[VersionReference] = Field(description="Versions in the vehicles that they were checked with.")
    conflicts: list[RegistryConflict]
    finding: Finding | None = Field(description="Why nothing is known; null if it is.")


class RegistryCapabilities(RootModel[dict[str, Any]]):
    """Capabilities of the registry, as xRegistry has them."""

    model_config = ConfigDict(frozen=True)


class RegistryModel(RootModel[dict[str, Any]]):
    """Kinds of names in the registry, as xRegistry describes resources."""

    model_config = ConfigDict(frozen=True)
