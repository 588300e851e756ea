"""Elements that say what the number of a value means: compu methods, data constraints, units."""

from collections.abc import Iterable, Sequence

from sigcat.adapter.arxml.paths import COMPU_METHODS, CONSTRAINTS, UNITS, Paths
from sigcat.adapter.arxml.tree import Child, Tag, listed, reference, tag


def references_of_number(
    paths: Paths, method: str | None = None, constraint: str | None = None, unit: str | None = None
) -> list[Tag]:
    """References to the elements of these names that say how to read a number."""
    named = ((COMPU_METHODS, "COMPU-METHOD", method), (CONSTRAINTS, "DATA-CONSTR", constraint), (UNITS, "UNIT", unit))
    return [reference(f"{kind}-REF", paths.of(package, name), kind) for package, kind, name in named if name]


def compu_method(name: str, category: str, scales: Iterable[Tag], unit: Sequence[Tag] = ()) -> Tag:
    """A compu method, with its scales and the reference to its unit if it has any."""
    found = listed("COMPU-SCALES", scales)
    content = tag("COMPU-INTERNAL-TO-PHYS", found) if found else None
    return tag("COMPU-METHOD", {"CATEGORY": category}, *unit, content, name=name)


def text_scale(symbol: str, *limits: Child) -> Tag:
    """The text of a number; `limits` are the number."""
    return tag("COMPU-SCALE", {"SYMBOL": symbol}, *limits, tag("COMPU-CONST", {"VT": symbol}))


def linear_scale(offset: str, factor: str, denominator: str) -> Tag:
    """Value = (offset + factor × number) ÷ denominator."""
    numerator = tag("COMPU-NUMERATOR", tag("V", text=offset), tag("V", text=factor))
    return tag("COMPU-SCALE", tag("COMPU-RATIONAL-COEFFS", numerator, tag("COMPU-DENOMINATOR", {"V": denominator})))


def limit(tag_name: str, value: float | None) -> Tag | None:
    """A limit that is itself allowed; None without a value."""
    return None if value is None else Tag(tag_name, (), str(value), None, (("INTERVAL-TYPE", "CLOSED"),))


def constraint(name: str, low: float | None, high: float | None) -> Tag:
    """The data constraint of a value between limits, of which one may be missing."""
    rule = tag("PHYS-CONSTRS", limit("LOWER-LIMIT", low), limit("UPPER-LIMIT", high))
    return tag("DATA-CONSTR", tag("DATA-CONSTR-RULES", tag("DATA-CONSTR-RULE", rule)), name=name)
