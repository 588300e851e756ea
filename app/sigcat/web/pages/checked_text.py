"""A text that a page checks against a catalogue: inputs beside the text, and what the page shows of its findings and effects."""

from collections.abc import Mapping, Sequence
from typing import Annotated, Any, NamedTuple

from fastapi import Depends, Request

from sigcat.api.answers.serializers import finding_counts
from sigcat.api.requests.dependencies import (
    NamedCatalogue,
    PostedBody,
    TheFunctions,
    TheRules,
    library_of,
    settings_of,
)
from sigcat.api.service_rules import ServiceRules
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.hosting.variants import choice_of, expanded_of
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.datatypes import PRIMITIVES
from sigcat.findings import Finding
from sigcat.function.hosted_comparisons import HostedComparisons
from sigcat.function.hosted_files import HostedFiles
from sigcat.limits import Limits
from sigcat.web.forms import Form, PostedForm, form_catalogue, posted_form, read_form
from sigcat.web.views.change_trees import SIGNS
from sigcat.web.views.proposing.overlay_outcome import OverlayOutcome
from sigcat.web.views.source_view import source_view
from sigcat.web.visits import Visit, visit_of


class Asked(NamedTuple):
    """Inputs of a page beside its text: who asks, over which catalogue, by which rules, and the functions of the service."""

    visit: Visit
    hosted: Hosted
    rules: ServiceRules
    files: HostedFiles
    comparisons: HostedComparisons
    limits: Limits

    @property
    def catalogue(self) -> Catalogue:
        """The catalogue with every instance: functions name those."""
        return expanded_of(self.hosted.catalogue)


class Posted(NamedTuple):
    """A form that was posted to a page. It is read in a worker."""

    asked: Asked
    """Its inputs over the default catalogue."""
    form: PostedForm

    def read(self) -> tuple[Asked, Form]:
        """Return the inputs over the catalogue that the form names, and the form. Raises UsageError."""
        form = read_form(self.form)
        return self.asked._replace(hosted=form_catalogue(form, self.asked.visit.library)), form


async def _asked(request: Request, hosted: NamedCatalogue, rules: TheRules, functions: TheFunctions) -> Asked:
    limits = settings_of(request).limits
    return Asked(visit_of(request), hosted, rules, functions.files, functions.comparisons, limits)


async def _posted(request: Request, rules: TheRules, functions: TheFunctions, body: PostedBody) -> Posted:
    form = posted_form(body, request.headers.get("content-type", ""))
    return Posted(await _asked(request, library_of(request).default, rules, functions), form)


TheAsked = Annotated[Asked, Depends(_asked)]
ThePosted = Annotated[Posted, Depends(_posted)]


def text_values(
    hosted: Hosted, text: str, findings: Sequence[Finding], outcome: OverlayOutcome | None, *, is_folded: bool
) -> Mapping[str, Any]:
    """Values of a template that shows a text with its findings and effects. Typed paths are completed, folded for a tree."""
    return {
        "hosted": hosted,
        "posted": text,
        "findings": findings,
        "counts": finding_counts(findings),
        "source": source_view(text, findings),
        "outcome": outcome,
        "old": hosted,
        "new": hosted,
        "signs": SIGNS,
        "completed_from": choice_of(hosted.source.id).folded(is_folded=is_folded).id,
        "datatypes": sorted(PRIMITIVES | {f"{each}[]" for each in PRIMITIVES}),
    }
