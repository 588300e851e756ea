"""Values of the RTE to values of the core, and back: number by number, since their datatypes are not the same to C."""

from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.plan import RteType
from sigcat.adapter.core.c.lines import Lines, block, joined, lines
from sigcat.adapter.core.plan import CorePlan, WireType


class Copy(NamedTuple):
    """Direction of values."""

    core: CorePlan
    to_core: bool

    def of(self, target: str, source: str, type_: RteType, c: str, depth: int = 0) -> Lines:
        """Statements that copy a value; `c` is the core's name of it, of an array that of its elements."""
        if type_.element is not None:
            i = "ijklmn"[depth]
            each = self.of(f"{target}[{i}]", f"{source}[{i}]", type_.element, c, depth + 1)
            return block(f"for (uint32 {i} = 0U; {i} < {type_.length}U; {i}++)", [each])
        if type_.members:
            fields = next(struct.fields for struct in self.core.structs if struct.name == c)
            return joined(
                self.of(*self._ends(target, source, name, field.name), inner, field.c, depth)
                for (name, inner), field in zip(type_.members, fields, strict=True)
            )
        return lines(f"{target} = {self.number(source, type_)};")

    def number(self, source: str, type_: RteType) -> str:
        """A number of the other side."""
        if type_.base != "boolean":
            return source
        return f"({source} != FALSE)" if self.to_core else f"({source} ? TRUE : FALSE)"

    def _ends(self, target: str, source: str, rte: str, core: str) -> tuple[str, str]:
        own, other = (core, rte) if self.to_core else (rte, core)
        return f"{target}.{own}", f"{source}.{other}"


def core_declared(wire: WireType, name: str) -> str:
    """A variable that holds a value as the core takes it."""
    return f"{wire.c} {name}{f'[{wire.length}]' if wire.length is not None else ''};"


def by_address(type_: RteType, name: str) -> str:
    """Argument for a value to write: an array is an address already."""
    return name if type_.is_array else f"&{name}"


def by_value(type_: RteType, name: str) -> str:
    """Argument for a value to read: structs by their address."""
    return f"&{name}" if type_.is_struct else name
