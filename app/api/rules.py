"""Routes that read the rules."""

from typing import Annotated

from fastapi import APIRouter, Path

from app.api import schemas
from app.api.presenting import rule_detail, rule_summary
from app.api.problems import problem_documentation
from app.api.requests import TheRules

router = APIRouter(prefix="/api/v1/rules", tags=["rules"])

RuleId = Annotated[str, Path(description="Code of a rule.", examples=["I201"])]


@router.get("")
def list_rules(rules: TheRules) -> schemas.Rules:
    """Every rule, in the order of the codes."""
    return schemas.Rules(rules=[rule_summary(rule) for rule in rules.rules])


@router.get("/{rule_id}", responses=problem_documentation(404, 422))
def get_rule(rule_id: RuleId, rules: TheRules) -> schemas.Rule:
    """A rule: why it is there, what it checks, good and bad examples."""
    return rule_detail(rules.get(rule_id))
