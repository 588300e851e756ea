"""The rules of a service, and what they find in each hosted catalogue."""

from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import OVERLAYS, VSPEC
from sigcat.errors import NotFound
from sigcat.findings import Finding, in_order
from sigcat.limits import Limits
from sigcat.names import bounded_proposals, nearest
from sigcat.rules.engine import found_in
from sigcat.rules.linting.options import LintOptions
from sigcat.rules.linting.posted import lint_text
from sigcat.rules.linting.selection import rules_for, selected
from sigcat.rules.linting.severity import Grading
from sigcat.rules.record import Rule
from sigcat.rules.rule_set import RuleSet


class ServiceRules:
    """Rules by code, in order, with the settings of a project. Findings in a catalogue are computed once for each state of it."""

    def __init__(self, rules: tuple[Rule, ...], options: LintOptions) -> None:
        self.rules = rules
        self.options = options
        self._by_id: Mapping[str, Rule] = {rule.id: rule for rule in rules}
        self.active = RuleSet(selected(rules, options))
        """The rules that the project selects; without one, those that are on by default."""
        self._findings = lru_cache(maxsize=8)(self._lint)

    def __reduce__(self) -> tuple[Any, ...]:
        """As another process needs them."""
        return ServiceRules, (self.rules, self.options)

    def get(self, rule_id: str) -> Rule:
        """The rule with this code. Raises NotFound with the nearest codes."""
        rule = self._by_id.get(rule_id)
        if rule is None:
            raise NotFound(f"Unknown rule {rule_id!r}.", nearest(rule_id[:100], self._by_id))
        return rule

    def findings_in(self, catalogue: Catalogue) -> tuple[Finding, ...]:
        """Everything that the active rules find in a catalogue; those of the project, not in files that sigcat ships."""
        return self._findings(catalogue)

    def findings_in_text(
        self, text: bytes, name: str, catalogue: Catalogue, limits: Limits, *, is_tree: bool = False
    ) -> tuple[Finding, ...]:
        """Everything that the active rules find in an overlay over a catalogue, or in a tree by itself."""
        return lint_text(
            text, name, catalogue, self.active,
            is_tree=is_tree, limits=limits, options=self.options, known=frozenset(self._by_id),
        )  # fmt: skip

    @bounded_proposals()
    def _lint(self, catalogue: Catalogue) -> tuple[Finding, ...]:
        found = [finding for finding, _ in found_in(catalogue, self.active, attributes=self.options.attributes)]
        graded = Grading(self.active.severities, frozenset(self._by_id), self.options).graded(found)
        return in_order(each for each in graded if not (self._is_own(each.rule) and _is_shipped(each.file)))

    def _is_own(self, rule_id: str) -> bool:
        rule = self._by_id.get(rule_id)
        return rule is not None and not rule.trusted


def _is_shipped(file: str) -> bool:
    return any(Path(file).is_relative_to(folder) for folder in (VSPEC, OVERLAYS))


def service_rules(options: LintOptions) -> ServiceRules:
    """The rules that sigcat ships and those of a project. Raises InputRefused with everything that is wrong with them.

    Services of a process share them, so that their worker processes get them once.
    """
    global _last  # noqa: PLW0603 - rules are read again when their files change
    rules = rules_for(options)
    plain = options._replace(
        severities=dict(options.severities),
        rule_options={code: dict(given) for code, given in options.rule_options.items()},
    )  # as another process can have them
    if _last is None or (rules, plain) != (_last.rules, _last.options):
        _last = ServiceRules(rules, plain)
    return _last


_last: ServiceRules | None = None
