"""States of the functions of a service at a glance: the catalogue over which each builds, or its errors."""

from typing import NamedTuple

from sigcat.api.answers.serializers import finding_counts
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.catalogue.hosting.variants import expanded_of
from sigcat.function.hosted_files import HostedFiles
from sigcat.function.hosting import functions_over
from sigcat.web.views.needed_overlays import need_of


class FunctionState(NamedTuple):
    """A function with the catalogue over which its page shows it."""

    id: str
    name: str
    is_shipped: bool
    hosted: Hosted | None
    """The first catalogue over which it builds; None if there is none."""
    errors: int
    """Errors of its file as it is now, over the default catalogue if it builds over none."""


def function_states(files: HostedFiles, library: Library) -> tuple[FunctionState, ...]:
    """The functions in the order of their page. A shipped one that builds over no hosted catalogue is left out."""
    default = library.default
    catalogue = expanded_of(default.catalogue)
    states = []
    for each in functions_over(files, catalogue):
        need = need_of(each, files, catalogue, library)
        hosted = need.hosted if need else default if each.function else None
        errors = finding_counts(each.file.rejected or (() if hosted else each.findings)).errors
        if hosted or not each.file.is_shipped:
            states.append(FunctionState(each.id, each.name, each.file.is_shipped, hosted, errors))
    return tuple(states)
