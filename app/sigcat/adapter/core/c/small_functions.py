"""The small functions of C that conversions and errors need. A source has those that it uses."""

from sigcat.adapter.core.c.clocks import added, earlier, judge, later, now
from sigcat.adapter.core.c.lines import Lines, code_of
from sigcat.adapter.core.c.number_functions import (
    beyond_float,
    from_signed,
    from_unsigned,
    is_set,
    put,
    quiet,
    rounded,
    scaled,
    to_float,
    to_integer,
)
from sigcat.adapter.core.c.verdicts import has_failed, suspend, worse
from sigcat.adapter.core.numbers import number_type
from sigcat.catalogue.model.datatypes import INTEGER_RANGES


def used_functions(text: str, prefix: str, macro: str) -> list[Lines]:
    """Those that a text calls, and those that they call, each before its first use."""
    table = _every_function(prefix, macro)
    wanted: dict[str, None] = {}
    for name in reversed(table):
        callers = [text, *(code_of(table[known]) for known in wanted)]
        if any(f"{prefix}_{name}(" in each for each in callers):
            wanted[name] = None
    return [table[name] for name in table if name in wanted]


def _every_function(prefix: str, macro: str) -> dict[str, Lines]:
    """All by name, each after those that it calls."""
    integers = [found for name in INTEGER_RANGES if (found := number_type(name))]
    return {
        "Put": put(prefix),
        "IsSet": is_set(prefix),
        "Now": now(prefix),
        "Earlier": earlier(prefix),
        "Added": added(prefix),
        "Worse": worse(prefix),
        "HasFailed": has_failed(prefix, macro),
        "Suspend": suspend(prefix, macro),
        "Later": later(prefix),
        "Judge": judge(prefix, macro),
        "Scaled": scaled(prefix),
        "QuietFloat": quiet("QuietFloat", "float", prefix),
        "QuietDouble": quiet("QuietDouble", "double", prefix),
        "BeyondFloat": beyond_float(prefix),
        "ToFloat": to_float(prefix),
        "RoundedToEven": rounded(prefix),
        **{f"To{each.name.capitalize()}": to_integer(each, prefix) for each in integers},
        **{f"Int64To{each.name.capitalize()}": from_signed(each, prefix) for each in integers},
        **{f"Uint64To{each.name.capitalize()}": from_unsigned(each, prefix) for each in integers},
    }
