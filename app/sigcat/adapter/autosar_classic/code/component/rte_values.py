"""Values of the RTE to values of the core, and back: number by number, since their datatypes are not the same to C."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.names import core_object
from sigcat.adapter.autosar_classic.code.plan import RteType, SwcPlan
from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.adapter.core.plan import CorePlan


class CopyRow(NamedTuple):
    """A line of statements that copy a value: an assignment, the head of a loop over an array, or its end."""

    depth: int
    """Loops around it."""
    target: str = ""
    number: str = ""
    """Value that the target of an assignment gets."""
    counter: str = ""
    """Variable of a loop."""
    length: int | None = None


class Copy(NamedTuple):
    """Direction of values."""

    core: CorePlan
    to_core: bool

    def of(self, target: str, source: str, type_: RteType, c: str, depth: int = 0) -> Iterator[CopyRow]:
        """Statements that copy a value; `c` is the core's name of it, of an array that of its elements."""
        if type_.element is not None:
            i = "ijklmn"[depth]
            yield CopyRow(depth, counter=i, length=type_.length)
            yield from self.of(f"{target}[{i}]", f"{source}[{i}]", type_.element, c, depth + 1)
            yield CopyRow(depth)
        elif type_.members:
            fields = next(struct.fields for struct in self.core.structs if struct.name == c)
            for (name, inner), field in zip(type_.members, fields, strict=True):
                yield from self.of(*self._ends(target, source, name, field.name), inner, field.c, depth)
        else:
            yield CopyRow(depth, target, self.number(source, type_))

    def number(self, source: str, type_: RteType) -> str:
        """A number of the other side."""
        if type_.base != "boolean":
            return source
        return f"({source} != FALSE)" if self.to_core else f"({source} ? TRUE : FALSE)"

    def _ends(self, target: str, source: str, rte: str, core: str) -> tuple[str, str]:
        own, other = (core, rte) if self.to_core else (rte, core)
        return f"{target}.{own}", f"{source}.{other}"


def component_lines(template: str, swc: SwcPlan, /, **names: Any) -> Lines:
    """Lines of a part of a component, whose values are copied to its core and from it."""
    return c_lines(
        f"code/component/{template}",
        swc=swc,
        core=core_object(swc),
        macro=Scope(swc.core).macro,
        to_core=Copy(swc.core, to_core=True),
        from_core=Copy(swc.core, to_core=False),
        **names,
    )
