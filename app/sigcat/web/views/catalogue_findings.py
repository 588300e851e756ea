"""Everything that the rules find in a catalogue, and in the functions that a service builds over it: what pages count."""

from collections.abc import Iterable, Iterator

from sigcat.api.service_rules import ServiceRules
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.hosting.variants import expanded_of
from sigcat.findings import Finding
from sigcat.function.hosted_files import HostedFiles
from sigcat.function.hosting import buildable, functions_over
from sigcat.web.views.needed_overlays import need_of


def findings_over(
    hosted: Hosted, rules: ServiceRules, files: HostedFiles, library: Iterable[Hosted]
) -> tuple[Finding, ...]:
    """The findings in a catalogue, then those in functions."""
    return (*rules.findings_in(hosted.catalogue), *_in_functions(hosted, files, library))


def _in_functions(hosted: Hosted, files: HostedFiles, library: Iterable[Hosted]) -> Iterator[Finding]:
    """Return the findings in functions, without those that are made for another catalogue."""
    catalogue = expanded_of(hosted.catalogue)
    for each in functions_over(buildable(files, catalogue), catalogue):
        if need_of(each, files, catalogue, library) is None:
            yield from each.findings
