"""One schema for each noun of the API.

A name has one type wherever it stands, and is there always: generated clients have one class for each of these, and ask of no
field whether it is there. `tests/api/test_contract_shape.py` has the rules.
"""

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, RootModel

from sigcat.api.answers.named_types import (
    BindingClasses,
    CatalogueDigests,
    ChangeEvidence,
    ChangeKind,
    Compatibility,
    Count,
    Cursor,
    Digest,
    Facets,
    HealthState,
    Moment,
    NodeValues,
    Position,
    RuleOptions,
    Severity,
    TypeCounts,
    VissNodes,
)
from sigcat.limits import ANSWER_FINDINGS


class Schema(BaseModel):
    """Base of all: frozen, and made of the fields that it names."""

    model_config = ConfigDict(frozen=True, extra="forbid", json_schema_serialization_defaults_required=True)


class Place(Schema):
    """The position at which something was written."""

    file: str
    line: Position | None = Field(description="From 1; null: the file as a whole.")
    column: Position | None = Field(description="From 1; null: the line or file as a whole.")
    overlay: str | None = Field(description="The overlay that the file belongs to; null in the base tree.")


class Finding(Schema):
    """One problem in one place, and what to do about it."""

    rule: str
    severity: Severity
    message: str
    file: str | None = Field(description="The file, or the name of a posted text; null: no file.")
    line: Position | None = Field(description="From 1; null: the file as a whole.")
    column: Position | None = Field(description="From 1; null: the line or file as a whole.")
    path: str | None = Field(description="Path of the node, or name of the interface, that the finding is about.")
    pointer: str | None = Field(description="RFC 6901 pointer into the document; null: the document has none.")
    fix: str | None = Field(description="What to do; null if the message already says it.")


Findings = Annotated[list[Finding], Field(max_length=ANSWER_FINDINGS + 1)]
"""The first findings, with a last one that counts the others if there are too many."""


class Problem(Schema):
    """RFC 9457 problem details, with findings that give each error and its place."""

    type: str = Field(description="Stable address of a page about this kind of problem, such as `/problems/not-found`.")
    title: str
    status: int
    detail: str
    findings: Findings
    nearest: list[str] = Field(description="Names that exist and are near the one asked for.")
    request_id: str | None = Field(
        default=None, description="What the log calls the request; also in the header `X-Request-Id`."
    )


class FindingCounts(Schema):
    """Number of findings of each severity."""

    errors: Count
    warnings: Count
    infos: Count


class Layer(Schema):
    """A base tree or an overlay, in the order in which it applies."""

    name: str
    is_overlay: bool
    file_count: Count
    digest: Digest


class CatalogueSummary(Schema):
    """A hosted catalogue in a list."""

    id: str
    title: str
    digest: Digest = Field(description="SHA-256 of the content: equal for equal trees.")
    version: str = Field(
        pattern=r"^[0-9a-f]{24}$", description="Hash of all that is shown. Below `ID@VERSION` no address ever changes."
    )
    node_count: Count
    types: TypeCounts
    roots: list[str]
    finding_counts: FindingCounts


class VehicleFact(Schema):
    """A fact about a vehicle, such as its steering or its year."""

    name: str
    fact: str


class Vehicle(Schema):
    """A vehicle that the project composes of a catalogue, in one of its states."""

    name: str = Field(description="`ID`, or `ID@STATE`.")
    title: str
    catalogue: str = Field(description="Id of its catalogue, for addresses.")
    facts: list[VehicleFact] = Field(description="Facts such as `steering` and `year`.")


class Catalogue(CatalogueSummary):
    """A hosted catalogue with its layers and everything that is wrong with it."""

    layers: list[Layer]
    vehicles: list[Vehicle] = Field(description="Vehicles that are composed of it.")
    findings: Findings = Field(description="Findings of the catalogue as it is served.")
    rejected: Findings = Field(description="Findings of a newer state that was therefore not taken.")


class CatalogueList(Schema):
    """The hosted catalogues, the default one first."""

    catalogues: list[CatalogueSummary]


class FunctionFile(Schema):
    """A function that the service hosts."""

    id: str = Field(description="Name in addresses of its pages.")
    file: str
    rejected: Findings = Field(description="Findings of a newer state that was therefore not taken.")


class FunctionRun(Schema):
    """A stored run beside the functions that the service hosts."""

    id: str = Field(description="Name in addresses of the pages of its functions.")
    file: str


class FunctionFileList(Schema):
    """The functions that the service hosts, the operator's own first."""

    functions: list[FunctionFile]
    runs: list[FunctionRun]


class NodeSummary(Schema):
    """A node in a list. Whatever has a node has these fields."""

    path: str
    name: str
    type: str
    datatype: str | None
    unit: str | None = Field(description="Key of the unit.")
    description: str
    category: str | None = Field(
        description="Interface category: data, error, safety_reaction, mode or scheduling; null for a branch that only "
        "groups interfaces of a function."
    )
    deprecated: bool
    child_count: Count


class HistoryEntry(Schema):
    """A value that one layer gave an attribute."""

    value: Any
    origin: Place


class Attribute(Schema):
    """An attribute of a node: its value, where that was written, and what it was before."""

    name: str
    value: Any
    origin: Place
    is_extended: bool = Field(description="Whether VSS does not define the attribute.")
    history: list[HistoryEntry] = Field(description="Every value that the layers gave it, first to last.")


class Unit(Schema):
    """A unit of measurement."""

    key: str = Field(description="What trees write.")
    name: str = Field(description="The unit as text.")
    definition: str | None
    quantity: str | None
    allowed_datatypes: list[str]
    deprecation: str | None
    origin: Place


class Quantity(Schema):
    """A kind of property that units measure."""

    key: str
    definition: str | None
    remark: str | None
    origin: Place


class UnitList(Schema):
    """Units of a catalogue."""

    units: list[Unit]


class QuantityList(Schema):
    """Quantities of a catalogue."""

    quantities: list[Quantity]


class Node(NodeSummary):
    """Everything about one node."""

    definition_path: str = Field(description="Path of the definition; for an instance, without the names of instances.")
    interface_name: str | None = Field(description="Name of the interface that the node represents.")
    parent: str | None
    previous: str | None
    next: str | None
    origin: Place
    unit_definition: Unit | None = Field(description="The unit, if the catalogue knows it.")
    attributes: list[Attribute]
    children: list[NodeSummary]


class TreeNode(NodeSummary):
    """A node with the nodes below it."""

    subtrees: "list[TreeNode] | None" = Field(description="Its children; null where the depth asked for ends.")


class SearchHit(NodeSummary):
    """A node that a search found."""

    instance_count: Count = Field(
        description="How many nodes that share a definition were found; this is the first of them."
    )


class SearchPage(Schema):
    """One page of search results, best first."""

    total: Count = Field(description="How many hits there are.")
    hits: list[SearchHit]
    facets: Facets
    suggestions: list[str] = Field(description="Words of the catalogue near a word that is nowhere in it.")
    next_cursor: Cursor | None = Field(description="Give it as `cursor` to get the next page; null on the last.")


class NodePage(Schema):
    """One page of nodes with the fields that were asked for."""

    total: Count
    rows: list[NodeValues] = Field(description="Value by field; a field that a node lacks is null.")
    next_cursor: Cursor | None = Field(description="Give it as `cursor` to get the next page; null on the last.")


class AttributeChange(Schema):
    """One attribute of a changed node; null means that the attribute is absent."""

    name: str
    old_value: Any
    new_value: Any
    compatibility: Compatibility
    rule: str = Field(description="Row of the class table that decided.")


class Change(Schema):
    """One change; equal changes of the instances of a branch are one."""

    kind: ChangeKind
    compatibility: Compatibility
    rule: str = Field(description="Row of the class table that decided.")
    path: str = Field(description="Where the node is now, or was, if it is gone; of instances, without their names.")
    old_path: str | None = Field(description="Where the node was before, if it moved.")
    type: str
    paths: list[str] = Field(description="Every path that the change concerns; of a subtree, its topmost path.")
    old_paths: list[str] = Field(description="Where these paths were before, if they moved.")
    signal_count: Count = Field(description="Signals in the subtrees that were added, removed or moved with them.")
    evidence: ChangeEvidence | None
    is_guess: bool
    attribute_changes: list[AttributeChange]
    instances_added: list[str]
    instances_removed: list[str]
    note: str | None = Field(description="What the deprecation of a node that is gone said.")
    effects: list[str] = Field(description="Rows of the table of bindings that also apply.")
    bindings: BindingClasses


class ChangeCounts(Schema):
    """Number of changes of each class."""

    worst: Compatibility | None = Field(description="The worst class; null without changes.")
    total: Count
    breaking: Count
    risky: Count
    compatible: Count
    text: Count


class Diff(Schema):
    """Differences between two trees, as `sigcat diff --format json` writes them."""

    old: str
    new: str
    summary: ChangeCounts
    changes: list[Change]


class NodeEvent(Schema):
    """A fact about a node in one release, compared with the release before it."""

    kind: ChangeKind | None = Field(description="What happened; null: the oldest release has the node already.")
    release: str | None = Field(description="Number of the release; null: the catalogue itself.")
    path: str | None = Field(description="Path in this release; null if it was removed.")
    old_path: str | None = Field(description="Where the node was before, if it moved or was removed.")
    is_guess: bool = Field(description="Whether the node before is only probably the same.")
    attribute_changes: list[AttributeChange]
    note: str | None = Field(description="Why it moved or was removed, if that is known.")
    skipped_releases: list[str] = Field(
        description="Releases since the one before that are not hosted: it may have happened in one of them."
    )


class NodeHistory(Schema):
    """A node over the hosted releases of VSS."""

    path: str
    release: str | None = Field(description="The release that the catalogue is made of; null if it does not say so.")
    summary_text: str = Field(description="All events in one line.")
    events: list[NodeEvent] = Field(description="Oldest first.")
    releases: list[str] = Field(description="The releases that were compared, oldest first.")
    missing_releases: list[str] = Field(description="Known releases that are not hosted.")


class TrialNode(Schema):
    """A node as it would be."""

    path: str
    values: NodeValues


class Trial(Schema):
    """Effects of an overlay on a catalogue. Nothing is stored."""

    ok: bool = Field(description="Whether the overlay brings no error.")
    findings: Findings = Field(description="What the overlay would add to the findings of the catalogue.")
    node_count: Count = Field(description="Nodes that would be new or have other attributes.")
    nodes: list[TrialNode] = Field(description="The first of them.")
    summary: ChangeCounts
    changes: list[Change]


class RuleSummary(Schema):
    """A rule in a list."""

    id: str
    name: str
    title: str
    category: str
    severity: Severity
    on_by_default: bool = Field(description="Whether the rule is on when nothing is configured.")


class Rule(RuleSummary):
    """A rule: why it is there, what it checks, good and bad examples."""

    why: str
    check: str
    options: RuleOptions
    fix: str | None = Field(description="What to do; null if the check has no fix.")
    good: list[Any]
    bad: list[Any]
    source: str = Field(description="Where the rule comes from.")


class RuleList(Schema):
    """Every rule."""

    rules: list[RuleSummary]


class LintReport(Schema):
    """Findings of the rules in a posted text."""

    ok: bool = Field(description="Whether the findings have no error.")
    finding_counts: FindingCounts
    findings: Findings


class VissMetadata(Schema):
    """Metadata of a node and of all below it, as VISS has it."""

    metadata: VissNodes
    ts: Moment = Field(description="When it was answered.")


class VissError(Schema):
    """An error, as VISS describes it."""

    number: str
    reason: str
    message: str


class VissErrorAnswer(Schema):
    """An error in the form of VISS."""

    error: VissError
    ts: Moment


class SchemaList(Schema):
    """The JSON Schemas of the file formats for functions."""

    schemas: list[str] = Field(description="Addresses, relative to the service.")


class JsonSchema(RootModel[dict[str, Any]]):
    """A JSON Schema (2020-12)."""

    model_config = ConfigDict(frozen=True)


class VssTree(RootModel[dict[str, Any]]):
    """A tree as `vspec export json` writes it: each node by its name, with `children`."""

    model_config = ConfigDict(frozen=True)


class IntegrationJson(RootModel[dict[str, Any]]):
    """Integration JSON; its JSON Schema is at `/api/v1/schemas/integration-PLATFORM.json`."""

    model_config = ConfigDict(frozen=True)


class Health(Schema):
    """Answer of a health check."""

    state: HealthState
    digests: CatalogueDigests
    outdated: list[str] = Field(
        description="`catalogue ID` and `function ID`, where files have errors now: their last good state is served."
    )
    skipped: list[str] = Field(description="Files in folders of functions that are too large, and are not read.")
