"""The functions that sigcat ships, built against a catalogue: what the pages show without anything being posted."""

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.interfaces import FUNCTION_BRANCH
from sigcat.data import EXAMPLES
from sigcat.errors import NotFound
from sigcat.findings import Finding
from sigcat.function.function_file import checked_file
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.role import PROVIDER
from sigcat.function.sets.wiring import calls_of, data_of
from sigcat.names import nearest

FILE = "function.yaml"


class ShippedFunction(NamedTuple):
    """A function with its declaration. `resolved` is None if the declaration does not fit the catalogue."""

    id: str
    text: str
    resolved: ResolvedFunction | None
    findings: tuple[Finding, ...]

    @property
    def function(self) -> FunctionJson | None:
        """The function as it is written."""
        return self.resolved.function if self.resolved else None

    @property
    def name(self) -> str:
        """Name of the function; its id if it could not be built."""
        return self.function.info.function_name if self.function else self.id


class NodeUse(NamedTuple):
    """That a function uses a node."""

    function_id: str
    function: str
    verb: str
    """consumes, provides, is set by, reports, reacts to, receives, sends, runs"""
    call: str
    name: str
    """Name inside the function, where it has one of its own."""
    component: str
    """The component whose call it is; empty for a mode, which concerns the whole function."""


@lru_cache(maxsize=8)
def shipped_functions(catalogue: Catalogue) -> tuple[ShippedFunction, ...]:
    """Every shipped function, built against a catalogue."""
    files = sorted(EXAMPLES.glob(f"*/{FILE}"))
    return tuple(built(file.parent.name, file.read_text("utf-8"), catalogue) for file in files)


def built(function_id: str, text: str, catalogue: Catalogue) -> ShippedFunction:
    """A function from the text of its declaration."""
    checked = checked_file(text.encode("utf-8", "replace"), FILE, catalogue)
    return ShippedFunction(function_id, text, checked.sound, checked.findings)


def shipped_function(catalogue: Catalogue, function_id: str) -> ShippedFunction:
    """A shipped function by its id. Raises NotFound with the nearest ids."""
    known = {each.id: each for each in shipped_functions(catalogue)}
    if function_id not in known:
        raise NotFound(f"There is no function {function_id!r}.", nearest(function_id[:100], known))
    return known[function_id]


@lru_cache(maxsize=8)
def node_uses(catalogue: Catalogue) -> Mapping[str, Sequence[NodeUse]]:
    """Which shipped functions use a node, by its path.

    Without a branch of functions none can be built, and working out what each name may have meant takes its time.
    """
    found: dict[str, list[NodeUse]] = {}
    has_functions = any(child.name == FUNCTION_BRANCH for root in catalogue.roots for child in root.children)
    for each in shipped_functions(catalogue) if has_functions else ():
        if each.function is not None:
            for path, use in _uses_of(each.id, each.function):
                if path:
                    found.setdefault(path, []).append(use)
    return found


def _uses_of(function_id: str, function: FunctionJson) -> list[tuple[str | None, NodeUse]]:
    name = function.info.function_name
    made: list[tuple[str | None, NodeUse]] = []
    components = {call.name: component.name for component in function.components for call in component.runnables}

    def add(path: str | None, verb: str, call: str = "", own: str = "") -> None:
        made.append((path, NodeUse(function_id, name, verb, call, own, components.get(call, ""))))

    for call in calls_of(function):
        add(call.vss_path, "runs")
        for contract in call.contracts or ():
            for signal in data_of(contract):
                add(signal.vss_path, "provides" if signal.role == PROVIDER else "consumes", call.name, signal.name)
            for parameter in contract.parameters or ():
                add(parameter.vss_path, "is set by", call.name, parameter.name)
            for error in contract.errors or ():
                add(error.vss_path, "reports", call.name)
            for reaction in contract.safety_reactions or ():
                add(reaction.vss_path, "reacts to", call.name)
    for mode in function.mode_interfaces or ():
        add(mode.vss_path, "sends" if mode.direction == "Out" else "receives")
    return made
