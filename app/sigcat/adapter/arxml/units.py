"""Units in SI units, and their physical dimensions."""

from collections.abc import Iterable, Mapping

from sigcat.adapter.arxml.paths import DIMENSIONS, UNITS, Paths
from sigcat.adapter.arxml.tree import Package, Tag, reference, tag
from sigcat.integration.autosar_si_units import Dimension, SiUnit, UnitSettings, si_unit
from sigcat.names import camel_case

DIMENSIONLESS = "Dimensionless"


def packages(names: Mapping[str, str], described: Mapping[str, UnitSettings], paths: Paths) -> list[Package]:
    """The packages of units, with their short names, and of their dimensions; some units are described apart."""
    known = {unit: described[unit].si if unit in described else si_unit(unit) for unit in names}
    dimensions = {si.dimension for si in known.values() if si is not None}
    return [
        Package(DIMENSIONS, tuple(map(_dimension, sorted(dimensions, key=dimension_name)))),
        Package(
            UNITS, tuple(tag("UNIT", *_content(unit, known[unit], paths), name=name) for unit, name in names.items())
        ),
    ]


def _content(unit: str, si: SiUnit | None, paths: Paths) -> Iterable[Tag]:
    """Name and symbol of a unit and, where it is linear in SI units, its factor and offset."""
    yield tag("DISPLAY-NAME", text=unit)
    if si is not None:
        yield tag("FACTOR-SI-TO-UNIT", text=float(si.from_si.factor))
        yield tag("OFFSET-SI-TO-UNIT", text=float(si.from_si.offset))
        path = paths.of(DIMENSIONS, dimension_name(si.dimension))
        yield reference("PHYSICAL-DIMENSION-REF", path, "PHYSICAL-DIMENSION")


def _dimension(dimension: Dimension) -> Tag:
    exponents = dimension._asdict().items()
    return tag(
        "PHYSICAL-DIMENSION",
        *(tag(f"{quantity.upper().replace('_', '-')}-EXP", text=number) for quantity, number in exponents if number),
        name=dimension_name(dimension),
    )


def dimension_name(dimension: Dimension) -> str:
    """Name of a physical dimension: `Length_per_Time2` for an acceleration."""
    exponents = dimension._asdict().items()
    above = [_power(quantity, number) for quantity, number in exponents if number > 0]
    below = [_power(quantity, -number) for quantity, number in exponents if number < 0]
    return "_".join([*(above or ["One"]), *(["per", *below] if below else [])]) if above or below else DIMENSIONLESS


def _power(quantity: str, number: int) -> str:
    return camel_case(quantity) + (str(number) if number != 1 else "")
