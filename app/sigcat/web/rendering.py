"""Templates to responses. Every value is escaped; an undefined one is an error."""

from collections.abc import Callable, Mapping
from functools import partial
from http import HTTPStatus
from pathlib import Path
from typing import Any

from fastapi import Request
from fastapi.responses import HTMLResponse, Response
from jinja2 import Environment, FileSystemLoader, StrictUndefined

from sigcat import __version__
from sigcat.api.answers.schemas import Problem
from sigcat.api.answers.serializers import finding_schema, plain_text, shown_file
from sigcat.api.requests.dependencies import library_of
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.hosting.variants import choice_of
from sigcat.compiled_templates import CompiledTemplates
from sigcat.errors import UsageError
from sigcat.findings import has_errors
from sigcat.web.addresses import Addresses
from sigcat.web.basket import EMPTY, Basket
from sigcat.web.catalogue_titles import title_in
from sigcat.web.template_filters import breakable, count, datatype, date, marked, number, scalar, unit, with_code
from sigcat.web.visits import Visit, visit_of

TYPE_LETTERS = {
    "branch": "", "sensor": "sen", "actuator": "act", "attribute": "att", "struct": "{}", "property": "·",
}  # fmt: skip
"""Marks before a name in the tree, which need no legend."""

CATEGORY_WORDS = {
    "data": "Data", "error": "Error", "safety_reaction": "Safety reaction", "mode": "Mode", "scheduling": "Scheduling",
}  # fmt: skip

CHAPTER_OF = {
    "tree": "reference/interfaces.md", "functions": "reference/functions.md",
    "basket": "how-to/work-in-the-browser.md", "compare": "how-to/work-in-the-browser.md", "history": "how-to/work-in-the-browser.md", "propose": "how-to/work-in-the-browser.md", "changes": "reference/compatibility.md", "vehicles": "how-to/vehicles.md", "try": "how-to/own-catalogue-and-rules.md", "rules": "reference/linting.md",
    "units": "how-to/define-a-unit.md", "docs": "reference/api.md", "registry": "how-to/registry.md", "catalogue": "how-to/own-catalogue-and-rules.md",
}  # fmt: skip
"""The chapter of the documentation about a page; the index where there is none."""

_ENVIRONMENT = Environment(
    loader=FileSystemLoader(Path(__file__).parent / "templates"),
    autoescape=True,
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
    bytecode_cache=CompiledTemplates(Path(__file__)),
)
_FILTERS = (number, scalar, unit, date, datatype, breakable, marked, with_code)
_ENVIRONMENT.filters.update({each.__name__: each for each in _FILTERS})
_ENVIRONMENT.filters.update(shown_file=shown_file, shown_finding=finding_schema)
_ENVIRONMENT.globals.update(
    count=count, letters=TYPE_LETTERS, category_words=CATEGORY_WORDS, chapter_of=CHAPTER_OF, version=__version__
)


def compile_templates() -> None:
    """Compile all of them, which otherwise happens to each when it is first rendered: in each worker again."""
    for name in _ENVIRONMENT.list_templates():
        _ENVIRONMENT.get_template(name)


def page(request: Request, template: str, status: int = 200, **context: Any) -> HTMLResponse:
    """A page. With `part` in the query only the part of it that changes while one stays on it."""
    return page_for(visit_of(request), template, status, **context)


def page_for(visit: Visit, template: str, status: int = 200, **context: Any) -> HTMLResponse:
    """The same, in whatever process."""
    part = template.replace(".html", ".part.html")
    name = part if visit.wants_part and part in _ENVIRONMENT.list_templates() else template
    context.setdefault("hosted", None)
    to = Addresses(visit.below, _basket_of(visit, is_problem=status >= HTTPStatus.BAD_REQUEST))
    text = _ENVIRONMENT.get_template(name).render(
        to=to,
        for_catalogue=_for_catalogue(visit, to, is_problem=status >= HTTPStatus.BAD_REQUEST),
        library=visit.library,
        title_of=partial(title_in, visit.library),
        address=visit.path,
        request_method=visit.method,
        has_registry=visit.has_registry,
        may_read_catalogues=visit.may_read_catalogues,
        session=visit.session,
        is_composed_with_errors=_is_composed_with_errors(context["hosted"]),
        **context,
    )
    return HTMLResponse(plain_text(text), status, headers={"Cache-Control": "no-cache"})


def text_file(text: str, name: str, media_type: str) -> Response:
    """A text as a file to be kept."""
    headers = {"Content-Disposition": f'attachment; filename="{name}"', "Cache-Control": "no-cache"}
    return Response(text.encode("utf-8", "replace"), media_type=f"{media_type}; charset=utf-8", headers=headers)


def _basket_of(visit: Visit, *, is_problem: bool) -> Basket:
    """The basket of the address; the page of a problem has none where the basket is the problem."""
    try:
        return visit.basket
    except UsageError:
        if is_problem:
            return EMPTY
        raise


def _is_composed_with_errors(hosted: Hosted | None) -> bool:
    """Whether a tree is shown whose files had errors when they were read first."""
    return hosted is not None and bool(hosted.catalogue.roots) and has_errors(hosted.catalogue.findings)


def _for_catalogue(visit: Visit, to: Addresses, *, is_problem: bool) -> Callable[[str], str]:
    """Addresses of this page for other catalogues; of the tree where the page would make no sense."""
    query = visit.query if visit.method == "GET" else ()
    return partial(to.other_catalogue, "" if is_problem else visit.route, visit.names, query)


def problem_page(request: Request, problem: Problem, headers: Mapping[str, str] | None = None) -> HTMLResponse:
    """A problem as a page with its headers; near paths become links into the catalogue that the address names."""
    catalogue = request.path_params.get("catalogue")
    known = {hosted.source.id: hosted for hosted in library_of(request)}
    hosted = known.get(choice_of(catalogue).base) if isinstance(catalogue, str) else None
    given = dict(headers or {})
    shown = page(
        request,
        "problem.html",
        problem.status,
        problem=problem,
        hosted=hosted,
        retry_after=given.get("Retry-After", ""),
    )
    shown.headers.update(given)
    return shown
