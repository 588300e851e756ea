"""Form of a value in the code of a function, beside its facts in the catalogue."""

from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Node
from sigcat.findings import RuleCode
from sigcat.function.declaration.declaration import DataItem, ParameterItem
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.function_json.conversion import Linear
from sigcat.function.function_json.datatypes.type_list import Symbols

Item = DataItem | ParameterItem


class CodeValue(NamedTuple):
    """A value in the code."""

    item: Item
    at: Pointer
    """Pointer of the item in the declaration."""
    node: Node
    datatype: str
    """VSS name of the code's datatype."""
    unit: str | None
    symbols: Symbols | None
    """Names and numbers of an enumeration, as the code has them."""
    to_code: Linear
    """From the catalogue's unit to the code's."""
    scale: Linear
    """From the stored value to the physical one."""
    has_fit_unit: bool = True
    """Whether the code's unit is known and is one that the catalogue's converts to."""

    @property
    def own_datatype(self) -> str:
        """Datatype of the catalogue."""
        return str(self.node.values["datatype"])

    def first_written(self, *keys: str) -> Pointer:
        """The first of these keys that the author wrote, or else the item."""
        key = next((key for key in keys if getattr(self.item, key, None) is not None), None)
        return (*self.at, key) if key else self.at

    def problem(self, rule: RuleCode, at: Pointer, message: str, fix: str = "") -> Problem:
        """A problem of the value."""
        return Problem(rule, at, message, fix, Subject("data", self.item.path))
