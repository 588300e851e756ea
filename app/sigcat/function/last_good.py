"""Function files that changed: each is taken as it is now, or as it was last good, with its present errors."""

from collections.abc import Callable, Mapping
from pathlib import Path

from sigcat.findings import Finding
from sigcat.function.hosted_files import HostedFiles

Faults = Mapping[Path, tuple[Finding, ...]]
"""Findings that keep files from being built, by path: none for files that are good."""


def with_last_good(fresh: HostedFiles, before: HostedFiles, faults_of: Callable[[HostedFiles], Faults]) -> HostedFiles:
    """The files as they are now, but for those that were good before and are not any more.

    Files use what others of their folder define: as long as another one is found broken, the rest is checked again without it.
    """
    earlier = {file.path: file for file in before}
    changed = [file.path for file in fresh if file.path in earlier and file.data != earlier[file.path].data]
    faults_before = faults_of(before) if changed else {}
    good = {path for path in changed if faults_before.get(path) == ()}
    rejected: dict[Path, tuple[Finding, ...]] = {}
    taken = fresh
    while good:
        faults = faults_of(taken)
        broken = {path: faults[path] for path in good if faults.get(path)}
        if not broken:
            break
        rejected.update(broken)
        good -= broken.keys()
        taken = tuple(
            each._replace(data=earlier[each.path].data, rejected=rejected[each.path]) if each.path in rejected else each
            for each in fresh
        )
    return taken
