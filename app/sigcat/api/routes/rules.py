"""Routes that read the rules."""

from typing import Annotated

from fastapi import APIRouter, Path, Request
from fastapi.responses import Response

from sigcat.api.answers import schemas
from sigcat.api.answers.negotiation import answer, rows
from sigcat.api.answers.problems import reads
from sigcat.api.answers.serializers import rule_detail, rule_summary
from sigcat.api.requests.dependencies import TheRules
from sigcat.api.requests.thread_turns import InThread
from sigcat.limits import NAME_CHARACTERS

router = APIRouter(prefix="/api/v1/rules", tags=["rules"], route_class=InThread)

RuleId = Annotated[str, Path(description="Code of a rule.", examples=["I201"], max_length=NAME_CHARACTERS)]


@router.get("", **reads(schemas.RuleList, is_table=True))
def list_rules(request: Request, rules: TheRules) -> Response:
    """Every rule, in the order of the codes."""
    listed = [rule_summary(rule) for rule in rules.rules]
    return answer(request, schemas.RuleList(rules=listed), rows(listed))


@router.get("/{rule_id}", **reads(schemas.Rule, 404, 422))
def get_rule(request: Request, rule_id: RuleId, rules: TheRules) -> Response:
    """A rule: why it is there, what it checks, good and bad examples."""
    return answer(request, rule_detail(rules.get(rule_id)))
