"""Findings of the rules about mappings to a network, for code that reads mappings and a CAN database."""

from collections.abc import Iterator

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.network.can_database import CanDatabase
from sigcat.catalogue.network.mapping_attributes import ATTRIBUTES
from sigcat.data import INTERFACE_RULES
from sigcat.findings import Finding
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.engine import found_in
from sigcat.rules.rule_set import RuleSet


def mapping_findings(catalogue: Catalogue, database: CanDatabase) -> Iterator[Finding]:
    """Return the findings of `sigcat lint` in the mappings."""
    rules = RuleSet(rule for rule in compiled_rules(INTERFACE_RULES) if rule.category == "mapping")
    judged = [each for each in catalogue.definitions.values() if not each.values.keys().isdisjoint(ATTRIBUTES)]
    for finding, _ in found_in(catalogue, rules, judged, can=database):
        if finding.rule in rules.codes:
            yield finding
