"""The options of a lint in a project: the tree that is chosen, and what `[lint]` adds."""

from typing import NamedTuple

from sigcat.catalogue.hosting.source import Source
from sigcat.project.chosen_tree import TreeOptions, chosen_tree
from sigcat.project.project import Project
from sigcat.rules.linting.options import LintOptions


class ChosenLint(NamedTuple):
    """What a lint checks against."""

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
    is_named = named is not None or bool(project.catalogues)
    chosen = lint._replace(
        base=tree.spec if is_named else None,
        overlays=tree.overlays if is_named else options.overlays,
        include_dirs=tree.include_dirs,
        units=tree.units,
        quantities=tree.quantities,
        types=tree.types,
        has_standard_units=tree.has_standard_units,
    )
    return ChosenLint(chosen, tree)
