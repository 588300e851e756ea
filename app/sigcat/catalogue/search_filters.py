"""Filters of a search: which values each can have, checked in one place for the command line, the API and the pages."""

from collections.abc import Iterable, Mapping

from sigcat.asil import LEVELS
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.datatypes import DATATYPES
from sigcat.catalogue.model.definition import TYPES
from sigcat.catalogue.model.interfaces import CATEGORIES
from sigcat.catalogue.search import SearchIndex, overlay_name
from sigcat.errors import UsageError
from sigcat.limits import PROPOSAL_CHARACTERS
from sigcat.names import did_you_mean

_MOST_LISTED = 12
"""Values of a filter that are listed where none of them was given."""


def checked_filters(given: Mapping[str, str | None], catalogue: Catalogue, index: SearchIndex) -> dict[str, str]:
    """The filters that were given, by facet. Raises UsageError for a value that no node of the catalogue can have."""
    filters = {facet: value for facet, value in given.items() if value is not None}
    for facet, value in filters.items():
        known = dict.fromkeys((*_possible_values(facet, catalogue), *index.values_of(facet)))
        if value not in known:
            listed = f"; there are {', '.join(known)}" if 0 < len(known) <= _MOST_LISTED else ""
            hint = did_you_mean(value[:PROPOSAL_CHARACTERS], known)
            raise UsageError(f"There is no {facet} {value[:100]!r} in this catalogue{listed}. {hint}".rstrip())
    return filters


def _possible_values(facet: str, catalogue: Catalogue) -> Iterable[str]:
    """Values that a node may have, whether or not one has it."""
    possible: Mapping[str, Iterable[str]] = {
        "type": TYPES, "category": CATEGORIES, "datatype": DATATYPES, "asil": LEVELS,
        "deprecated": ("yes", "no"), "unit": (unit.key for unit in catalogue.vocabulary.distinct_units),
        "overlay": (overlay_name(layer.name) for layer in catalogue.overlays),
    }  # fmt: skip
    return possible[facet]
