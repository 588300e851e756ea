"""Units in SI units, and their physical dimensions."""

from collections.abc import Mapping

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
        Package(UNITS, tuple(_unit(name, unit, known[unit], paths) for unit, name in names.items())),
    ]


def _unit(name: str, unit: str, si: SiUnit | None, paths: Paths) -> Tag:
    """A unit and, where it is linear in SI units, its factor and offset."""
    if si is None:
        return tag("UNIT", {"DISPLAY-NAME": unit}, name=name)
    path = paths.of(DIMENSIONS, dimension_name(si.dimension))
    factors = {"FACTOR-SI-TO-UNIT": float(si.from_si.factor), "OFFSET-SI-TO-UNIT": float(si.from_si.offset)}
    dimension = reference("PHYSICAL-DIMENSION-REF", path, "PHYSICAL-DIMENSION")
    return tag("UNIT", {"DISPLAY-NAME": unit, **factors}, dimension, name=name)


def _dimension(dimension: Dimension) -> Tag:
    exponents = {f"{key.upper().replace('_', '-')}-EXP": number or None for key, number in dimension._asdict().items()}
    return tag("PHYSICAL-DIMENSION", exponents, name=dimension_name(dimension))


def dimension_name(dimension: Dimension) -> str:
    """Name of a physical dimension: `Length_per_Time2` for an acceleration."""
    exponents = dimension._asdict().items()
    above = [_power(quantity, number) for quantity, number in exponents if number > 0]
    below = [_power(quantity, -number) for quantity, number in exponents if number < 0]
    return "_".join([*(above or ["One"]), *(["per", *below] if below else [])]) if above or below else DIMENSIONLESS


def _power(quantity: str, number: int) -> str:
    return camel_case(quantity) + (str(number) if number != 1 else "")
