"""Routes that read the rules."""

from typing import Annotated

from fastapi import APIRouter, Path, Request
from fastapi.responses import Response

from sigcat.api.answers import schemas
from sigcat.api.answers.negotiation import answer, offered, rows
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.answers.serializers import rule_detail, rule_summary
from sigcat.api.requests.dependencies import TheRules
from sigcat.api.requests.thread_turns import InThread
from sigcat.limits import NAME_CHARACTERS

router = APIRouter(prefix="/api/v1/rules", tags=["rules"], route_class=InThread)

RuleId = Annotated[str, Path(description="Code of a rule.", examples=["I201"], max_length=NAME_CHARACTERS)]


@router.get("", response_model=schemas.RuleList, responses=offered("table") | problem_documentation(406))
def list_rules(request: Request, rules: TheRules) -> Response:
    """Every rule, in the order of the codes."""
    listed = [rule_summary(rule) for rule in rules.rules]
    return answer(request, schemas.RuleList(rules=listed), rows(listed))


@router.get("/{rule_id}", response_model=schemas.Rule, responses=offered() | problem_documentation(404, 406, 422))
def get_rule(request: Request, rule_id: RuleId, rules: TheRules) -> Response:
    """A rule: why it is there, what it checks, good and bad examples."""
    return answer(request, rule_detail(rules.get(rule_id)))
