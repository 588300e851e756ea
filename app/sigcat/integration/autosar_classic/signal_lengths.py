"""Length of a bus signal that is enough for every value of its data element."""

import math
from collections.abc import Mapping
from typing import NamedTuple

from sigcat.integration.autosar_classic.datatypes.platform_types import FLOATS, WHOLE_NUMBERS
from sigcat.integration.autosar_classic.datatypes.used_types import element_types
from sigcat.integration.autosar_classic.model import (
    ApplicationType,
    ClassicIntegration,
    DataConstraint,
    ImplementationType,
)


class Need(NamedTuple):
    """Bits that the values of a data element need."""

    bits: int
    has_floats: bool
    """Floats may travel as scaled numbers, which are shorter; the scale is that of the CAN database."""

    def fits(self, length: int | None, *, has_database: bool) -> bool:
        """Whether a signal of this length carries all of them; of one without, a database has the length."""
        return length is None or length >= self.bits or (self.has_floats and has_database)

    @property
    def advice(self) -> str:
        """Advice for a signal that is too short."""
        if self.has_floats:
            return "Name the `database` that scales it, or correct the length."
        return "Correct the length, or leave it out where a database has it."


def needs_of(model: ClassicIntegration) -> Mapping[tuple[str, str], Need]:
    """Needs of data elements, by interface and name; those of types that refer to nothing are left out."""
    types = _Types(model)
    found = {key: types.need(name) for key, name in element_types(model).items()}
    return {key: need for key, need in found.items() if need is not None}


class _Types:
    """The datatypes of a document by name."""

    def __init__(self, model: ClassicIntegration) -> None:
        self._implementation = {each.name: each for each in model.implementation_types}
        self._application = {each.name: each for each in model.application_types}
        self._constraints = {each.name: each for each in model.constraints}
        self._methods = {each.name: each for each in model.compu_methods}

    def need(self, name: str) -> Need | None:
        """Return the need of a type, by its name."""
        meant = self._application.get(name)
        return self._of(self._implementation.get(meant.implementation if meant else name), meant, depth=0)

    def _of(self, each: ImplementationType | None, meant: ApplicationType | None, depth: int) -> Need | None:
        if each is None or depth > len(self._implementation):
            return None
        if each.category == "ARRAY":
            element = self._of(self._implementation.get(each.element or ""), None, depth + 1)
            return element and Need(_bytes(element.bits) * (each.length or 0), element.has_floats)
        if each.category == "STRUCTURE":
            members = [self._of(self._implementation.get(one.type), None, depth + 1) for one in each.members or ()]
            whole = [one for one in members if one is not None]
            return Need(sum(_bytes(one.bits) for one in whole), any(one.has_floats for one in whole))
        return self._of_number(each, meant)

    def _of_number(self, each: ImplementationType, meant: ApplicationType | None) -> Need | None:
        base = self._base(each)
        if base in FLOATS:
            return Need(int(base.removeprefix("float")), has_floats=True)
        method = self._methods.get((meant and meant.compu_method) or each.compu_method or "")
        if method is not None and method.symbols:
            numbers = [symbol.value for symbol in method.symbols]
            return Need(_bits(min(numbers), max(numbers)), has_floats=False)
        limits = WHOLE_NUMBERS.get(base)
        if limits is None:
            return None
        constraint = self._constraints.get((meant and meant.constraint) or "")
        return Need(_bits(*_narrowed(limits, constraint)), has_floats=False)

    def _base(self, each: ImplementationType) -> str:
        """Platform type of a name."""
        for _ in self._implementation:
            if each.base is None or each.base not in self._implementation or each.base == each.name:
                break
            each = self._implementation[each.base]
        return each.base or each.name


def _narrowed(limits: tuple[int, int], constraint: DataConstraint | None) -> tuple[int, int]:
    low, high = limits
    if constraint is not None and constraint.min is not None:
        low = max(low, math.floor(constraint.min))
    if constraint is not None and constraint.max is not None:
        high = min(high, math.ceil(constraint.max))
    return (low, high) if low <= high else limits


def _bits(low: int, high: int) -> int:
    """Return the length of an unsigned number, or of one in two's complement."""
    if low >= 0:
        return max(high.bit_length(), 1)
    return max((-low - 1).bit_length(), max(high, 0).bit_length()) + 1


def _bytes(bits: int) -> int:
    """Bits of whole bytes: so are the elements of arrays and structures laid out."""
    return -(-bits // 8) * 8
