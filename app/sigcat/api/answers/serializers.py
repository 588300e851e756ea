"""Data of the catalogue in the schemas of the API."""

import datetime as dt
import os
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from math import isfinite
from typing import Any

from sigcat import codes
from sigcat.api.answers import schemas
from sigcat.api.answers.versions import version_of
from sigcat.catalogue.comparing.changes import Change
from sigcat.catalogue.comparing.diff_report import attribute_data, diff_data
from sigcat.catalogue.comparing.trial import Trial
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.hosting.variants import vehicle_switches
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES
from sigcat.catalogue.model.interfaces import category_of, interface_name
from sigcat.catalogue.model.vehicle import Vehicle
from sigcat.catalogue.model.vocabulary import Quantity, Unit
from sigcat.catalogue.reading.statement import Origin
from sigcat.catalogue.search import Hit, overlay_name
from sigcat.data import VSPEC
from sigcat.findings import Finding, has_errors
from sigcat.limits import ANSWER_FINDINGS
from sigcat.migration.node_history import Event, NodeHistory, history_summary
from sigcat.rules.record import Rule

_SHIPPED = f"{VSPEC.parent}{os.sep}"


def plain(value: Any) -> Any:
    """A YAML value as JSON has it: dates and whatever else JSON lacks become text."""
    if isinstance(value, str):
        return plain_text(value)
    if isinstance(value, Mapping):
        return {plain_text(str(key)): plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple | set | frozenset):
        return [plain(item) for item in value]
    if isinstance(value, float) and not isfinite(value):
        return str(value)
    if value is None or isinstance(value, bool | int | float):
        return value
    return plain_text(value.isoformat() if isinstance(value, dt.date | dt.time) else str(value))


def plain_text(text: str) -> str:
    """Text that can be sent as UTF-8: half surrogate pairs are replaced."""
    return text if text.isascii() else text.encode("utf-8", "replace").decode()


def _place(origin: Origin) -> dict[str, Any]:
    return _place_at(origin.file, origin.line, origin.column, origin.overlay)


def _place_at(file: str, line: int, column: int, overlay: str) -> dict[str, Any]:
    shown_overlay = overlay_name(overlay) if overlay else None
    return {"file": shown_file(file), "line": line or None, "column": column or None, "overlay": shown_overlay}


@lru_cache(1024)
def shown_file(file: str) -> str:
    """A file as readers know it: what sigcat ships is named from its folder on, wherever it is installed."""
    return plain_text(file.removeprefix(_SHIPPED))


def finding_schema(finding: Finding) -> schemas.Finding:
    """A finding as the API has it."""
    fields = _present({**finding._asdict(), "file": shown_file(finding.file)})
    plain_fields: dict[str, Any] = {n: plain_text(v) if isinstance(v, str) else v for n, v in fields.items()}
    return schemas.Finding(**plain_fields)


def _present(fields: Mapping[str, Any]) -> dict[str, Any]:
    """Fields of a record, with None where it has an empty text or the position 0."""
    return {name: None if value in ("", 0) else value for name, value in fields.items()}


def listed_findings(findings: Sequence[Finding]) -> list[schemas.Finding]:
    """Findings as the API has them; of very many the first, and a last one that says how many more there are."""
    shown = [finding_schema(each) for each in findings[:ANSWER_FINDINGS]]
    more = len(findings) - len(shown)
    if more > 0:
        text = f"{more:,} more findings are not shown. Settle these first."
        shown.append(finding_schema(codes.MORE_FINDINGS_THAN_SHOWN.finding(text)))
    return shown


def finding_counts(findings: Iterable[Finding]) -> schemas.FindingCounts:
    """Count findings by severity."""
    counts = Counter(finding.severity for finding in findings)
    return schemas.FindingCounts(errors=counts["error"], warnings=counts["warning"], infos=counts["info"])


def catalogue_summary(hosted: Hosted) -> schemas.CatalogueSummary:
    """A hosted catalogue in a list."""
    return schemas.CatalogueSummary(**_summary_fields(hosted))


def _vehicle(vehicle: Vehicle, catalogue: str) -> schemas.Vehicle:
    facts = [schemas.VehicleFact(name=name, fact=fact) for name, fact in vehicle.labels]
    return schemas.Vehicle(name=vehicle.name, title=vehicle.shown, catalogue=catalogue, facts=facts)


def catalogue_detail(hosted: Hosted) -> schemas.Catalogue:
    """A hosted catalogue with layers and findings."""
    return schemas.Catalogue(
        **_summary_fields(hosted),
        layers=[
            schemas.Layer(
                name=shown_file(each.name), is_overlay=each.is_overlay, file_count=len(each.files), digest=each.digest
            )
            for each in hosted.catalogue.layers
        ],
        vehicles=[_vehicle(each, catalogue) for each, _, catalogue in vehicle_switches(hosted)],
        findings=listed_findings(hosted.catalogue.findings),
        rejected=listed_findings(hosted.rejected),
    )


def search_hit(hit: Hit) -> schemas.SearchHit:
    """A node that a search found."""
    return schemas.SearchHit(**_node_fields(hit.node), instance_count=hit.instances)


def node_detail(catalogue: Catalogue, node: Node) -> schemas.Node:
    """Everything about one node."""
    return schemas.Node.model_validate(node_data(catalogue, node))


def node_data(catalogue: Catalogue, node: Node) -> dict[str, Any]:
    """The same as plain data, as it is sent: values of a catalogue fit the schema, and checking takes half of the time."""
    parent = catalogue.parent(node)
    before, after = catalogue.beside(node)
    unit = catalogue.unit(node)
    return {
        **_node_fields(node),
        "definition_path": node.template,
        "interface_name": interface_name_of(node),
        "parent": parent.path if parent else None,
        "previous": before.path if before else None,
        "next": after.path if after else None,
        "origin": _place(catalogue.origin(node)),
        "unit_definition": _unit_fields(unit) if unit else None,
        "attributes": _attributes(node),
        "children": [_node_fields(child) for child in node.children],
    }


def interface_name_of(node: Node) -> str | None:
    """Name of the interface that a node of a function's own branch represents; None for data and for branches."""
    category = category_of(node.path)
    return interface_name(node.path) if category is not None and category != "data" else None


def _attributes(node: Node) -> list[dict[str, Any]]:
    """Attributes of a node with their origin and history, in the order in which they were written."""
    histories: dict[str, list[dict[str, Any]]] = {}
    for statement in node.definition.statements:
        values, file = statement.values, statement.file
        for name, line, column in statement.value_positions():
            origin = _place_at(file.name, line, column, file.overlay)
            histories.setdefault(name, []).append({"value": plain(values[name]), "origin": origin})
    return [_attribute(node, name, value, histories.get(name, [])) for name, value in node.values.items()]


def _attribute(node: Node, name: str, value: Any, history: list[dict[str, Any]]) -> dict[str, Any]:
    return {
        "name": plain_text(name),
        "value": plain(value),
        "origin": history[-1]["origin"] if history else _place(node.definition.origin(name)),
        "is_extended": name not in CORE_ATTRIBUTES,
        "history": history,
    }


def tree_node(node: Node, depth: int) -> schemas.TreeNode:
    """A node and the nodes below it, `depth` levels down."""
    subtrees = [tree_node(child, depth - 1) for child in node.children] if depth > 0 else None
    return schemas.TreeNode(**_node_fields(node), subtrees=subtrees)


def unit_schema(unit: Unit) -> schemas.Unit:
    """A unit as the API has it."""
    return schemas.Unit(**_unit_fields(unit))


@lru_cache(1024)
def _unit_fields(unit: Unit) -> Mapping[str, Any]:
    lists = {"allowed_datatypes": list(unit.allowed_datatypes), "origin": _place(unit.origin)}
    return {**_present(unit._asdict()), **lists}


def quantity_schema(quantity: Quantity) -> schemas.Quantity:
    """A quantity as the API has it."""
    return schemas.Quantity(**{**_present(quantity._asdict()), "origin": _place(quantity.origin)})


def _summary_fields(hosted: Hosted) -> dict[str, Any]:
    catalogue = hosted.catalogue
    return {
        "id": hosted.source.id,
        "title": hosted.source.title,
        "digest": catalogue.digest,
        "version": version_of(hosted),
        "node_count": len(catalogue.nodes),
        "types": dict(Counter(plain_text(node.type) for node in catalogue.nodes.values())),
        "roots": [plain_text(root.path) for root in catalogue.roots],
        "finding_counts": finding_counts(catalogue.findings),
    }


def _node_fields(node: Node) -> dict[str, Any]:
    return {
        "path": plain_text(node.path),
        "name": plain_text(node.name),
        "type": plain_text(node.type),
        "datatype": _text(node.values.get("datatype")),
        "unit": _text(node.values.get("unit")),
        "description": _text(node.values.get("description")) or "",
        "category": category_of(node.path),
        "deprecated": bool(node.values.get("deprecation")),
        "child_count": len(node.children),
    }


def _text(value: Any) -> str | None:
    return None if value is None else plain_text(str(value))


def rule_summary(rule: Rule) -> schemas.RuleSummary:
    """A rule in a list."""
    return schemas.RuleSummary(**_rule_fields(rule))


def rule_detail(rule: Rule) -> schemas.Rule:
    """Everything about one rule."""
    return schemas.Rule(
        **_rule_fields(rule),
        why=rule.why,
        check=rule.check,
        options=plain(rule.options),
        fix=rule.fix or None,
        good=plain(rule.good),
        bad=plain(rule.bad),
        source=rule.source,
    )


def lint_report(findings: Iterable[Finding]) -> schemas.LintReport:
    """Findings as a report."""
    listed = tuple(findings)
    return schemas.LintReport(
        ok=not has_errors(listed), finding_counts=finding_counts(listed), findings=listed_findings(listed)
    )


def _rule_fields(rule: Rule) -> dict[str, Any]:
    same = {name: getattr(rule, name) for name in ("id", "name", "title", "category", "severity")}
    return {**same, "on_by_default": rule.default}


def trial_schema(trial: Trial, most_nodes: int) -> schemas.Trial:
    """Return the effects of an overlay; of many nodes, only the first."""
    data = diff_data(trial.changes)
    return schemas.Trial(
        ok=not has_errors(trial.findings),
        findings=listed_findings(trial.findings),
        node_count=len(trial.nodes),
        nodes=[
            schemas.TrialNode(path=plain_text(node.path), values=plain(node.values))
            for node in trial.nodes[:most_nodes]
        ],
        summary=schemas.ChangeCounts.model_validate(data["summary"]),
        changes=changes_schema(trial.changes),
    )


def diff_schema(changes: Sequence[Change], old: str, new: str) -> schemas.Diff:
    """A comparison as `sigcat diff` prints it."""
    counts = schemas.ChangeCounts.model_validate(diff_data(changes)["summary"])
    return schemas.Diff(old=old, new=new, summary=counts, changes=changes_schema(changes))


def history_schema(history: NodeHistory) -> schemas.NodeHistory:
    """The history of a node as `sigcat show --history` prints it."""
    return schemas.NodeHistory(
        path=plain_text(history.path),
        release=history.release or None,
        summary_text=plain_text(history_summary(history)),
        events=[_event_schema(event) for event in history.events],
        releases=list(history.releases),
        missing_releases=list(history.missing),
    )


def _event_schema(event: Event) -> schemas.NodeEvent:
    return schemas.NodeEvent(
        kind=None if event.kind == "oldest" else event.kind,
        release=event.release or None,
        path=plain_text(event.path) or None,
        old_path=plain_text(event.former) or None,
        is_guess=not event.is_certain,
        attribute_changes=[schemas.AttributeChange.model_validate(plain(attribute_data(a))) for a in event.attributes],
        note=plain_text(event.note) or None,
        skipped_releases=list(event.skipped),
    )


def changes_schema(changes: Sequence[Change]) -> list[schemas.Change]:
    """Changes as the API has them."""
    return [schemas.Change.model_validate(plain(each)) for each in diff_data(changes)["changes"]]
