"""Pages of the rules, each with its findings in a catalogue."""

from collections import Counter

from fastapi import APIRouter
from fastapi.responses import JSONResponse, Response

from sigcat.api.answers.serializers import rule_detail
from sigcat.api.requests.thread_turns import InThread
from sigcat.findings import Finding
from sigcat.integration.grouping import grouped
from sigcat.limits import PAGE_FINDINGS
from sigcat.web.pages.checked_text import Asked, TheAsked
from sigcat.web.rendering import page_for
from sigcat.web.views.catalogue_findings import findings_over

router = APIRouter(route_class=InThread)


@router.get("/rules")
def show_rules(asked: TheAsked) -> Response:
    """Every rule, with the number of its findings in a catalogue and the functions over it."""
    by_category = grouped(asked.rules.rules, lambda rule: rule.category)
    found = Counter(finding.rule for finding in _found(asked))
    return page_for(asked.visit, "rules.html", hosted=asked.hosted, by_category=by_category, found=found)


@router.get("/rules/{rule_id}")
def show_rule(asked: TheAsked, rule_id: str) -> Response:
    """A rule with its findings in a catalogue and the functions over it; with `.json` after its code, the rule as the API has it."""
    if rule_id.endswith(".json"):
        return JSONResponse(rule_detail(asked.rules.get(rule_id.removesuffix(".json"))).model_dump())
    rule = rule_detail(asked.rules.get(rule_id))
    findings = [finding for finding in _found(asked) if finding.rule == rule_id]
    return page_for(
        asked.visit,
        "rule.html",
        hosted=asked.hosted,
        rule=rule,
        beside=[each for each in asked.rules.rules if each.category == rule.category],
        findings=findings[:PAGE_FINDINGS],
        total=len(findings),
    )


def _found(asked: Asked) -> tuple[Finding, ...]:
    return findings_over(asked.hosted, asked.rules, asked.files, asked.visit.library)
