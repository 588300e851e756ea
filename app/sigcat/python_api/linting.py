"""Findings of a text, with the rules of a project."""

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.file_kind import holds_function, root_branch
from sigcat.findings import Finding
from sigcat.names import nearest
from sigcat.rules.linting.options import LintOptions
from sigcat.rules.linting.posted import lint_text
from sigcat.rules.linting.selection import rules_for, selected
from sigcat.rules.rule_set import RuleSet


def findings_of(text: bytes, name: str, base: Catalogue, lint: LintOptions | None) -> tuple[Finding, ...]:
    """Return the findings of a function, a tree of another root, or an overlay over `base`.

    Raises UsageError or InputRefused where the rules of the project cannot be used.
    """
    if holds_function(text):
        from sigcat.function.sets.check_set import check_functions

        return check_functions([(text, name)], base, is_whole=False)
    options = lint or LintOptions()
    every_rule = rules_for(options)
    rules, known = RuleSet(selected(every_rule, options)), frozenset(rule.id for rule in every_rule)
    own = root_branch(text)
    is_tree = bool(own) and not nearest(own, (root.path for root in base.roots))
    return lint_text(text, name, base, rules, is_tree=is_tree, options=options, known=known)
