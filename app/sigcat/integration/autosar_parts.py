"""Components of a set under the names that AUTOSAR takes: alike on both its platforms."""

from collections.abc import Iterator, Sequence

from sigcat.function.exchange import Part, Side, parts_of
from sigcat.function.function_json.interfaces.data_interfaces import ParameterInterface
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable
from sigcat.integration.autosar_names import distinct_names, short_name


def parameter_uses(part: Part) -> Iterator[tuple[Runnable, ParameterInterface]]:
    """Every parameter of a component with the call that uses it."""
    for call in part.component.runnables:
        yield from ((call, each) for contract in call.contracts or () for each in contract.parameters or ())


def named_parts(functions: Sequence[FunctionJson]) -> tuple[Part, ...]:
    """Every component under its own short name. Two components of one name have their function's name too."""
    parts = parts_of(functions)
    names = [short_name(part.name) for part in parts]
    lowered = [name.lower() for name in names]
    wanted = [
        name if lowered.count(name.lower()) == 1 else short_name(f"{part.function_name}_{part.name}")
        for part, name in zip(parts, names, strict=True)
    ]
    return tuple(part._replace(name=name) for part, name in zip(parts, distinct_names(wanted), strict=True))


def several_providers(identity: str, providers: Sequence[Side]) -> str:
    """Message about an element that several components provide."""
    names = [each.part.name for each in providers]
    return f"{identity} must have one provider, not {', '.join(names)}. Consumers are connected to {names[0]}."
