"""Numbers of a network that are not a value of their signal, such as 65535 for «signal not available»."""

from collections.abc import Callable, Mapping
from itertools import pairwise

from sigcat.catalogue.network.mapping import SignalMapping
from sigcat.names import words

_WORDS = frozenset({"sna", "na", "nan", "invalid", "inval", "error", "err", "fault", "faulty", "failure", "failed", "undefined", "undef",
                    "unavailable", "unavail", "unknown", "notavailable", "notvalid", "notdefined", "reserved"})  # fmt: skip
_PAIRS = frozenset({("n", "a"), *(("not", word) for word in ("available", "avail", "valid", "defined", "known"))})


def means_no_value(name: str) -> bool:
    """Whether a name means a missing value: `SNA`, `Signal not available`, `GEAR_INVALID`."""
    found = [word.lower() for word in words(name)]
    return not _WORDS.isdisjoint(found) or not _PAIRS.isdisjoint(pairwise(found))


def with_markers(
    mapping: SignalMapping, datatype: str, names: Mapping[int, str], is_within: Callable[[int], bool]
) -> SignalMapping:
    """The mapping with those items of a representation set apart that mark a number as not a value.

    A number whose text is a name of the database gets the name's number, as the gear in VSS's page. An item that says what the
    database says, as `value: 65535, text: SNA`, is a marker if there is a formula for numbers, the limits exclude it, or its
    name says so. An item whose text is unknown to the database is a marker, too.
    """
    if not mapping.is_profile or datatype == "string":
        return mapping
    known = frozenset(names.values())
    markers = [
        each for each in mapping.choices
        if each.meant not in known
        or (names.get(each.given) == each.meant
            and (mapping.formula is not None or not is_within(each.given) or means_no_value(each.meant)))
    ]  # fmt: skip
    choices = tuple(each for each in mapping.choices if each not in markers)
    return mapping._replace(choices=choices, markers=frozenset(each.given for each in markers))
