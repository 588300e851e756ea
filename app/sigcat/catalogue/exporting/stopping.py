"""Errors of a tree that stop its export: those where vss-tools 6.1 stops too, and the limits of sigcat."""

from collections.abc import Mapping
from typing import Literal

from sigcat import codes
from sigcat.findings import Finding, RuleCode

Decision = Literal["exported", "stops", "limit"]
"""Result for a tree with an error.

exported: vss-tools exports it, and so does sigcat, with the same bytes; the error is reported. stops: vss-tools refuses it, too.
limit: vss-tools may export it; sigcat reads nothing outside of the folders that are named, and bounds time and memory.
"""


def _decided(decision: Decision, *rules: RuleCode) -> dict[str, Decision]:
    return {rule.id: decision for rule in rules}


DECISIONS: Mapping[str, Decision] = {
    **_decided(
        "exported",
        codes.BRANCH_UNDEFINED, codes.DUPLICATE_KEY, codes.NODES_NESTED, codes.NUMBER_NOT_FINITE, codes.PATH_MALFORMED, codes.RANGE_WITH_SPACE,
    ),
    **_decided(
        "limit",
        codes.FILE_TOO_LARGE, codes.NESTING_TOO_DEEP, codes.INCLUDE_OUTSIDE, codes.INCLUDES_MULTIPLY,
        codes.INSTANCES_MULTIPLY, codes.TOO_MANY_WILDCARDS, codes.ALIAS_TO_ITSELF, codes.NOT_A_VALUE,
    ),
    **_decided(
        "stops",
        codes.NOT_YAML, codes.NOT_UTF_8, codes.NOT_A_MAPPING, codes.FILE_UNREADABLE, codes.TREE_EMPTY,
        codes.INCLUDE_MISSING, codes.INCLUDE_CYCLE, codes.INCLUDE_MALFORMED,
        codes.QUANTITY_UNKNOWN, codes.UNIT_INCOMPLETE, codes.UNITS_MISSING, codes.QUANTITIES_MISSING,
        codes.TYPE_MISSING_OR_UNKNOWN, codes.DATATYPE_MISSING, codes.DATATYPE_UNKNOWN, codes.ATTRIBUTE_OF_WRONG_KIND,
        codes.ATTRIBUTE_WITHOUT_MEANING, codes.UNIT_UNKNOWN, codes.UNIT_OF_WRONG_DATATYPE, codes.LIMIT_OUTSIDE_DATATYPE,
        codes.DEFAULT_OF_WRONG_DATATYPE, codes.DEFAULT_OUTSIDE_RANGE, codes.DEFAULT_NOT_ALLOWED,
        codes.ALLOWED_OF_WRONG_DATATYPE, codes.RESTRICTIONS_EXCLUDE_EACH_OTHER, codes.ENUM_INVALID,
        codes.ARRAYSIZE_WITHOUT_ARRAY, codes.PATTERN_NOT_MET, codes.IDENTIFIER_MALFORMED, codes.INSTANCES_RUN_BACKWARDS,
        codes.NODE_BELOW_SIGNAL, codes.SECOND_ROOT, codes.OUTSIDE_ROOT, codes.STRUCT_CONTAINS_ITSELF,
    ),
}  # fmt: skip
"""By the rule that is broken; an error of any other rule stops the export."""


def stops_export(finding: Finding) -> bool:
    """Whether a finding is an error with which a tree is not exported."""
    return finding.severity == "error" and DECISIONS.get(finding.rule) != "exported"
