"""The rules of a service, and what they find in each hosted catalogue."""

from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import NotFound
from sigcat.findings import Finding
from sigcat.names import nearest
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.engine import lint_catalogue
from sigcat.rules.record import Rule
from sigcat.rules.rule_set import RuleSet


class ServiceRules:
    """Rules by code, in order. Findings in a catalogue are computed once for each state of it."""

    def __init__(self, rules: tuple[Rule, ...]) -> None:
        self.rules = rules
        self._by_id: Mapping[str, Rule] = {rule.id: rule for rule in rules}
        self.active = RuleSet(rule for rule in rules if rule.default)
        """The rules that are on when nothing is configured."""
        self._findings = lru_cache(maxsize=8)(self._lint)

    def __reduce__(self) -> tuple[Any, ...]:
        """As another process needs them."""
        return ServiceRules, (self.rules,)

    def get(self, rule_id: str) -> Rule:
        """The rule with this code. Raises NotFound with the nearest codes."""
        rule = self._by_id.get(rule_id)
        if rule is None:
            raise NotFound(f"Unknown rule {rule_id!r}.", nearest(rule_id[:100], self._by_id))
        return rule

    def findings_in(self, catalogue: Catalogue) -> tuple[Finding, ...]:
        """Everything that the rules which are on by default find in a catalogue."""
        return self._findings(catalogue)

    def _lint(self, catalogue: Catalogue) -> tuple[Finding, ...]:
        return lint_catalogue(catalogue, self.active)


def service_rules(folder: Path) -> ServiceRules:
    """The rules of the files in a folder. Raises InputRefused with everything that is wrong with them.

    Services of a process share them, so that their worker processes get them once.
    """
    global _last  # noqa: PLW0603 - rules are read again when their files change
    rules = compiled_rules(folder)
    if rules is not _last.rules:
        _last = ServiceRules(rules)
    return _last


_last = ServiceRules(())
