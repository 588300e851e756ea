"""One schema for each noun of the API."""

from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, RootModel

Compatibility = Literal["breaking", "risky", "compatible", "text"]


class Schema(BaseModel):
    """Base of all: frozen, and closed to fields that it does not name."""

    model_config = ConfigDict(frozen=True, extra="forbid", validate_by_name=True, validate_by_alias=True)


class Place(Schema):
    """Where something was written. Lines and columns count from 1; 0 means the file as a whole."""

    file: str
    line: int
    column: int
    overlay: str = Field("", description="The overlay that the file belongs to; empty in the base tree.")


class Finding(Schema):
    """One problem in one place, and what to do about it."""

    rule: str
    severity: Literal["error", "warning", "info"]
    message: str
    file: str = ""
    line: int = Field(0, description="From 1; 0: the file as a whole.")
    column: int = Field(0, description="From 1; 0: the file as a whole.")
    path: str = Field("", description="Path of the node, or name of the interface, that the finding is about.")
    pointer: str = Field("", description="RFC 6901 pointer into the document, where there is one.")
    fix: str = Field("", description="What to do; empty if the message already says it.")


class Problem(Schema):
    """RFC 9457 problem details, with findings that say what is wrong and where."""

    type: str = Field(description="Stable address of a page about this kind of problem, such as `/problems/not-found`.")
    title: str
    status: int
    detail: str
    findings: list[Finding] = Field(default_factory=list)
    nearest: list[str] = Field(default_factory=list, description="Names that exist and are near the one asked for.")
    request_id: str = Field(
        default="", description="What the log calls the request; also in the header `X-Request-Id`."
    )


class FindingCounts(Schema):
    """How many findings there are of each severity."""

    error: int = 0
    warning: int = 0
    info: int = 0


class Layer(Schema):
    """A base tree or an overlay, in the order in which it applies."""

    name: str
    is_overlay: bool
    files: int
    digest: str


class CatalogueSummary(Schema):
    """A hosted catalogue in a list."""

    id: str
    title: str
    digest: str = Field(description="SHA-256 of the content: equal for equal trees.")
    version: str = Field(description="Hash of all that is shown. Below `ID@VERSION` no address ever changes.")
    nodes: int
    types: dict[str, int] = Field(description="Nodes by type.")
    roots: list[str]
    findings: FindingCounts


class Catalogue(CatalogueSummary):
    """A hosted catalogue with its layers and everything that is wrong with it."""

    layers: list[Layer]
    problems: list[Finding] = Field(description="Findings of the catalogue as it is served.")
    rejected: list[Finding] = Field(description="Findings of a newer state that was therefore not taken.")


class CatalogueList(Schema):
    """The hosted catalogues, the default one first."""

    catalogues: list[CatalogueSummary]


class FunctionFile(Schema):
    """A function that the service hosts."""

    id: str = Field(description="Name in addresses of its pages.")
    file: str


class FunctionFiles(Schema):
    """The functions that the service hosts, those of one's own first."""

    functions: list[FunctionFile]


class NodeSummary(Schema):
    """A node in a list."""

    path: str
    name: str
    type: str
    datatype: str | None
    unit: str | None
    description: str
    category: str | None = Field(description="Interface category: data, error, safety_reaction, mode or scheduling.")
    deprecated: bool
    child_count: int


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
    name: str = Field(description="The unit in words.")
    definition: str
    quantity: str
    allowed_datatypes: list[str]
    deprecation: str
    origin: Place


class Quantity(Schema):
    """A kind of property that units measure."""

    key: str
    definition: str
    remark: str
    origin: Place


class UnitList(Schema):
    """Units of a catalogue."""

    units: list[Unit]


class QuantityList(Schema):
    """Quantities of a catalogue."""

    quantities: list[Quantity]


class Node(Schema):
    """Everything about one node."""

    path: str
    name: str
    type: str
    template: str = Field(description="Path of the definition; for an instance, without the names of instances.")
    category: str | None
    interface_name: str | None = Field(description="Name of the interface that the node stands for.")
    parent: str | None
    previous: str | None
    next: str | None
    origin: Place
    unit: Unit | None
    attributes: list[Attribute]
    children: list[NodeSummary]


class TreeNode(NodeSummary):
    """A node with what stands below it; `children` is null where the depth asked for ends."""

    children: "list[TreeNode] | None"


class FoundNode(NodeSummary):
    """A hit of a search."""

    instances: int = Field(description="How many nodes that share a definition were found; this is the first of them.")


class SearchPage(Schema):
    """One page of search results, best first."""

    total: int = Field(description="How many hits there are.")
    nodes: list[FoundNode]
    facets: dict[str, dict[str, int]] = Field(description="How many results have each value of each filter.")
    did_you_mean: list[str] = Field(description="Words of the catalogue near a word that is nowhere in it.")
    next_cursor: str | None = Field(description="Give it as `cursor` to get the next page; null on the last.")


class NodeRows(Schema):
    """One page of nodes with the fields that were asked for."""

    total: int
    nodes: list[dict[str, Any]] = Field(description="Value by field; a field that a node lacks is null.")
    next_cursor: str | None = Field(description="Give it as `cursor` to get the next page; null on the last.")


class AttributeChange(Schema):
    """One attribute of a changed node; null stands for an attribute that is not there."""

    name: str
    old: Any
    new: Any
    compatibility: Compatibility = Field(alias="class")
    rule: str = Field(description="Row of the class table that decided.")


class Change(Schema):
    """One change; equal changes of the instances of a branch are one."""

    kind: Literal["removed", "moved", "changed", "added"]
    compatibility: Compatibility = Field(alias="class")
    rule: str = Field(description="Row of the class table that decided.")
    path: str = Field(description="Where the node is now, or was, if it is gone; of instances, without their names.")
    former: str | None = Field(description="Where the node was before, if it moved.")
    type: str
    paths: list[str] = Field(description="Every path that the change concerns; of a subtree, its topmost path.")
    former_paths: list[str] = Field(alias="formerPaths")
    leaves: int = Field(description="Signals in the subtrees that came, went or moved with them.")
    evidence: Literal["fka", "deprecation", "same definition"] | None
    is_guess: bool = Field(alias="isGuess")
    attributes: list[AttributeChange]
    instances_came: list[str] = Field(alias="instancesCame")
    instances_went: list[str] = Field(alias="instancesWent")
    note: str | None = Field(description="What the deprecation of a node that is gone said.")


class ChangeCounts(Schema):
    """How many changes there are of each class."""

    compatibility: Compatibility | None = Field(alias="class", description="The worst class; null without changes.")
    changes: int
    breaking: int
    risky: int
    compatible: int
    text: int


class Diff(Schema):
    """What changed between two trees, as `sigcat diff --format json` writes it."""

    old: str
    new: str
    summary: ChangeCounts
    changes: list[Change]


class TriedNode(Schema):
    """A node as it would be."""

    path: str
    attributes: dict[str, Any]


class Trial(Schema):
    """What an overlay would make of a catalogue. Nothing of it is stored."""

    ok: bool = Field(description="Whether the overlay brings no error.")
    findings: list[Finding] = Field(description="What the overlay would add to the findings of the catalogue.")
    node_count: int = Field(description="Nodes that would be new or have other attributes.")
    nodes: list[TriedNode] = Field(description="The first of them.")
    summary: ChangeCounts
    changes: list[Change]


class RuleSummary(Schema):
    """A rule in a list."""

    id: str
    name: str
    title: str
    category: str
    severity: Literal["error", "warning", "info"]
    default: bool = Field(description="Whether the rule is on when nothing is configured.")


class Rule(RuleSummary):
    """A rule: why it is there, what it checks, good and bad examples."""

    why: str
    check: str
    options: dict[str, Any]
    fix: str
    good: list[Any]
    bad: list[Any]
    source: str = Field(description="Where the rule comes from.")


class RuleList(Schema):
    """Every rule."""

    rules: list[RuleSummary]


class LintReport(Schema):
    """What the rules found in a posted text."""

    ok: bool = Field(description="Whether there is no error among the findings.")
    counts: FindingCounts
    findings: list[Finding]


class VissMetadata(Schema):
    """Metadata of a node and of all below it, as VISS has it."""

    metadata: dict[str, Any] = Field(description="The attributes of the node by its name, with `children`.")
    ts: str = Field(description="When it was answered.")


class VissError(Schema):
    """What VISS says of an error."""

    number: str
    reason: str
    message: str


class VissRefusal(Schema):
    """An error in the form of VISS."""

    error: VissError
    ts: str


class SchemaAddresses(RootModel[list[str]]):
    """Addresses of JSON Schemas, relative to the service."""

    model_config = ConfigDict(frozen=True)


class JsonSchema(RootModel[dict[str, Any]]):
    """A JSON Schema (2020-12)."""

    model_config = ConfigDict(frozen=True)
