"""Components of a set under the names that AUTOSAR takes, and every interface of them: alike on both its platforms."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.methods import MethodInterface
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable as Call
from sigcat.function.function_json.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.application import Part
from sigcat.integration.autosar_names import distinct, short_name

Interface = Signal | DataQueue | MethodInterface | ErrorInterface | SafetyReaction | ModeInterface


class Item(NamedTuple):
    """An interface of a function at the call that has it; a mode interface belongs to no call."""

    part: Part
    call: Call | None
    interface: Interface

    @property
    def where(self) -> str:
        """For findings: `CoreAcc, CoreAcc_Step`."""
        return self.part.function_name + (f", {self.call.name}" if self.call else "")


def named_parts(functions: Sequence[FunctionJson]) -> tuple[Part, ...]:
    """Every component under its own short name. Two components of one name have their function's name too."""
    pairs = [(function, component) for function in functions for component in function.components]
    names = [short_name(component.name) for _, component in pairs]
    lowered = [name.lower() for name in names]
    wanted = {
        f"{index:06d}": name
        if lowered.count(name.lower()) == 1
        else short_name(f"{function.info.function_name}_{component.name}")
        for index, ((function, component), name) in enumerate(zip(pairs, names, strict=True))
    }
    given = distinct(wanted)
    return tuple(Part(given[f"{index:06d}"], function, component) for index, (function, component) in enumerate(pairs))


def items(parts: Sequence[Part]) -> Iterator[Item]:
    """Every interface of every call, in the order of the documents, and the mode interfaces of each function.

    Parameters are not among them: they stay inside their component.
    """
    for part in parts:
        for call in part.component.runnables:
            for contract in call.contracts or ():
                for listed in (
                    contract.signals, contract.queues, contract.methods, contract.errors, contract.safety_reactions
                ):  # fmt: skip
                    yield from (Item(part, call, interface) for interface in listed or ())
        if part.is_first:
            yield from (Item(part, None, interface) for interface in part.function.mode_interfaces or ())
