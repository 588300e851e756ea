"""Pages of the rules, each with its findings in a catalogue."""

from collections import Counter

from fastapi import APIRouter, Request
from fastapi.responses import JSONResponse, Response

from sigcat.api.answers.serializers import rule_detail
from sigcat.api.requests.dependencies import NamedCatalogue, TheFunctions, TheLibrary, TheRules
from sigcat.api.requests.thread_turns import InThread
from sigcat.integration.grouping import grouped
from sigcat.limits import PAGE_FINDINGS
from sigcat.web.rendering import page
from sigcat.web.views.catalogue_findings import findings_over

router = APIRouter(route_class=InThread)


@router.get("/rules")
def show_rules(
    request: Request, hosted: NamedCatalogue, rules: TheRules, functions: TheFunctions, library: TheLibrary
) -> Response:
    """Every rule, with the number of its findings in a catalogue and the functions over it."""
    by_category = grouped(rules.rules, lambda rule: rule.category)
    found = Counter(finding.rule for finding in findings_over(hosted, rules, functions.files, library))
    return page(request, "rules.html", hosted=hosted, by_category=by_category, found=found)


@router.get("/rules/{rule_id}")
def show_rule(
    request: Request,
    hosted: NamedCatalogue,
    rules: TheRules,
    functions: TheFunctions,
    library: TheLibrary,
    rule_id: str,
) -> Response:
    """A rule with its findings in a catalogue and the functions over it; with `.json` after its code, the rule as the API has it."""
    if rule_id.endswith(".json"):
        return JSONResponse(rule_detail(rules.get(rule_id.removesuffix(".json"))).model_dump())
    rule = rule_detail(rules.get(rule_id))
    found = findings_over(hosted, rules, functions.files, library)
    findings = [finding for finding in found if finding.rule == rule_id]
    return page(
        request,
        "rule.html",
        hosted=hosted,
        rule=rule,
        beside=[each for each in rules.rules if each.category == rule.category],
        findings=findings[:PAGE_FINDINGS],
        total=len(findings),
    )
