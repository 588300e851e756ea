"""Components of a set under the names that AUTOSAR takes: alike on both its platforms."""

from collections.abc import Sequence

from sigcat.function.exchange import Part, parts_of
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_names import distinct, short_name


def named_parts(functions: Sequence[FunctionJson]) -> tuple[Part, ...]:
    """Every component under its own short name. Two components of one name have their function's name too."""
    parts = parts_of(functions)
    names = [short_name(part.name) for part in parts]
    lowered = [name.lower() for name in names]
    wanted = {
        f"{index:06d}": name if lowered.count(name.lower()) == 1 else short_name(f"{part.function_name}_{part.name}")
        for index, (part, name) in enumerate(zip(parts, names, strict=True))
    }
    given = distinct(wanted)
    return tuple(part._replace(name=given[f"{index:06d}"]) for index, part in enumerate(parts))
