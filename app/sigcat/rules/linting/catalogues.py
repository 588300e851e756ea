"""The catalogues of a project that is linted: which options hold for a file of one of them."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from sigcat.real_path import each_once, real_path
from sigcat.rules.linting.options import LintOptions


def all_trees(options: LintOptions) -> tuple[Path, ...]:
    """The trees that are known to be such."""
    base = (options.base,) if options.base is not None else ()
    return each_once((*base, *(source.spec for source in options.catalogues)))


def all_overlays(options: LintOptions) -> tuple[Path, ...]:
    """The overlays that are known to be such."""
    return each_once((*options.overlays, *(path for source in options.catalogues for path in source.overlays)))


def all_types(options: LintOptions) -> tuple[Path, ...]:
    """The files that are known to have struct types."""
    return each_once((*options.types, *(path for source in options.catalogues for path in source.types)))


def all_units(options: LintOptions) -> tuple[Path, ...]:
    """The files that are known to have units."""
    return each_once((*options.units, *(path for source in options.catalogues for path in source.units)))


def all_quantities(options: LintOptions) -> tuple[Path, ...]:
    """The files that are known to have quantities."""
    return each_once((*options.quantities, *(path for source in options.catalogues for path in source.quantities)))


def of_tree(root: Path, options: LintOptions) -> LintOptions:
    """The options of the catalogue with this tree; those given if there is none."""
    return next((options.over(s) for s in options.catalogues if real_path(s.spec) == real_path(root)), options)


def of_types(file: Path, options: LintOptions) -> LintOptions:
    """The options of the first catalogue with these struct types; those given if there is none."""
    real = real_path(file)
    return next((options.over(s) for s in options.catalogues if real in map(real_path, s.types)), options)


def by_catalogue(overlays: Sequence[Path], options: LintOptions) -> Iterator[tuple[LintOptions, Sequence[Path]]]:
    """The overlays of each catalogue with its options, then those that no catalogue lists. One of several is in each."""
    rest = dict.fromkeys(overlays)
    for source in options.catalogues:
        listed = {real_path(path) for path in source.overlays}
        own = [path for path in overlays if real_path(path) in listed]
        for path in own:
            rest.pop(path, None)
        if own:
            yield options.over(source), own
    if rest:
        yield options, list(rest)
