"""A text that a page checks against a catalogue: inputs beside the text, and what the page shows of its findings and effects."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from sigcat.api.answers.serializers import finding_counts
from sigcat.api.service_rules import ServiceRules
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.hosting.variants import choice_of
from sigcat.catalogue.model.datatypes import PRIMITIVES
from sigcat.findings import Finding
from sigcat.function.hosted_files import HostedFiles
from sigcat.limits import Limits
from sigcat.web.views.change_trees import SIGNS
from sigcat.web.views.proposing.overlay_outcome import OverlayOutcome
from sigcat.web.views.source_view import source_view
from sigcat.web.visits import Visit


class Asked(NamedTuple):
    """Inputs of a page beside its text."""

    visit: Visit
    hosted: Hosted
    rules: ServiceRules
    files: HostedFiles
    limits: Limits


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
