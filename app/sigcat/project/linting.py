"""The options of a lint in a project: the tree that is chosen, and what `[lint]` adds."""

from collections.abc import Iterator
from typing import NamedTuple

from sigcat.catalogue.hosting.source import Source
from sigcat.project.chosen_tree import TreeOptions, chosen_tree
from sigcat.project.project import Project
from sigcat.rules.linting.options import LintOptions


class ChosenLint(NamedTuple):
    """Options of a lint, and the tree that functions are checked against."""

    options: LintOptions
    tree: Source
    """The catalogue that functions are checked against."""


def chosen_lint(project: Project, given: TreeOptions) -> ChosenLint:
    """The options of a lint. Without a tree of the options or the project, overlays are checked over the tree near them."""
    lint = project.lint
    named = given.tree or (str(lint.base) if lint.base is not None else None)
    options = TreeOptions(
        named,
        (*lint.overlays, *given.overlays),
        (*lint.include_dirs, *given.include_dirs),
        (*lint.units, *given.units),
        (*lint.quantities, *given.quantities),
        (*lint.types, *given.types),
    )
    tree = chosen_tree(project, options)
    if named is not None or project.catalogues:
        added = tuple(path for vehicle in project.vehicles for path in vehicle.overlays)
        linted = tuple(_linted(project, options))
        return ChosenLint(lint.over(tree)._replace(catalogues=linted, of_vehicles=added), tree)
    return ChosenLint(lint.over(tree)._replace(base=None, overlays=options.overlays), tree)


def _linted(project: Project, options: TreeOptions) -> Iterator[Source]:
    """The catalogues that are linted: all of the project, or the one that the options name."""
    if options.tree is not None:
        yield chosen_tree(project, options)
        return
    for catalogue in project.catalogues:
        yield chosen_tree(project, options._replace(tree=catalogue.id))
