"""Functions that use a node, or one below it: for the tree, a search and the page of a node."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

from sigcat.catalogue.hosting.variants import expanded_of
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import calls_of, data_of
from sigcat.function.hosted_files import HostedFiles
from sigcat.function.hosting import buildable, functions_over
from sigcat.names import parent_path


class NodeUse(NamedTuple):
    """Use of a node by a function."""

    function_id: str
    function: str
    path: str
    """The node; of a definition that is shown for its instances, the instance."""
    verb: str
    """consumes, provides, is set by, reports, reacts to, receives, sends, runs"""
    call: str
    name: str
    """Name inside the function, if it differs."""
    component: str
    """The component whose call it is; empty for a mode, which concerns the whole function."""


class UseBelow(NamedTuple):
    """Uses of nodes below a branch by a function."""

    function_id: str
    function: str
    counts: tuple[tuple[str, int], ...]
    """Number of nodes for each verb."""


class Uses(NamedTuple):
    """Functions that use the nodes of a catalogue."""

    of_node: Mapping[str, Sequence[NodeUse]]
    """By the path that the catalogue shows: of folded instances, that of their definition."""
    below: Mapping[str, Sequence[UseBelow]]
    """By the paths of all branches above what is used."""
    functions: Mapping[str, tuple[str, ...]]
    """Names of functions that use a node or one below it."""
    definitions: Mapping[str, tuple[str, ...]]
    """The same by the path of the definition, for all of its instances together."""

    def of_hit(self, node: Node, instances: int) -> tuple[str, ...]:
        """Names of functions that use what a search found: a node, or the instances for which it stands."""
        return self.definitions.get(node.template, ()) if instances > 1 else self.functions.get(node.path, ())


@lru_cache(maxsize=16)
def uses_in(files: HostedFiles, catalogue: Catalogue) -> Uses:
    """The uses of a catalogue's nodes by the functions of a service."""
    of_node: dict[str, list[NodeUse]] = {}
    above: dict[str, list[NodeUse]] = {}
    for shown, use in _shown(_uses(files, expanded_of(catalogue)), catalogue):
        of_node.setdefault(shown, []).append(use)
        for branch in _branches_above(shown):
            above.setdefault(branch, []).append(use)
    below = {branch: _by_function(uses) for branch, uses in above.items()}
    everywhere = {path: [*of_node.get(path, ()), *above.get(path, ())] for path in (*above, *of_node)}
    names = {path: tuple(dict.fromkeys(use.function for use in uses)) for path, uses in everywhere.items()}
    return Uses(of_node, below, names, _by_definition(names, catalogue))


@lru_cache(maxsize=16)
def _uses(files: HostedFiles, catalogue: Catalogue) -> tuple[NodeUse, ...]:
    built = functions_over(buildable(files, catalogue), catalogue)
    return tuple(use for each in built if each.function for use in uses_of(each.id, each.function))


def _shown(uses: Iterable[NodeUse], catalogue: Catalogue) -> Iterator[tuple[str, NodeUse]]:
    """Each use with the path that the catalogue shows for its node, if it has it."""
    nodes, expanded = catalogue.nodes, expanded_of(catalogue).nodes
    for use in uses:
        path = use.path if use.path in nodes or use.path not in expanded else expanded[use.path].template
        if path in nodes:
            yield path, use


def _by_definition(names: Mapping[str, tuple[str, ...]], catalogue: Catalogue) -> Mapping[str, tuple[str, ...]]:
    found: dict[str, dict[str, None]] = {}
    for path, functions in names.items():
        found.setdefault(catalogue.nodes[path].template, {}).update(dict.fromkeys(functions))
    return {path: tuple(functions) for path, functions in found.items()}


def _branches_above(path: str) -> Iterator[str]:
    while path := parent_path(path):
        yield path


def _by_function(uses: Sequence[NodeUse]) -> tuple[UseBelow, ...]:
    counts: dict[tuple[str, str], Counter[str]] = {}
    for function_id, function, verb, _ in dict.fromkeys((u.function_id, u.function, u.verb, u.path) for u in uses):
        counts.setdefault((function_id, function), Counter())[verb] += 1
    return tuple(UseBelow(*function, tuple(verbs.items())) for function, verbs in counts.items())


def uses_of(function_id: str, function: FunctionJson) -> Iterator[NodeUse]:
    """The nodes that a function uses, in the order of its calls."""
    components = {call.name: component.name for component in function.components for call in component.runnables}
    for path, verb, call, own in _used(function):
        if path:
            name = function.info.function_name
            yield NodeUse(function_id, name, path, verb, call, own, components.get(call, ""))


def _used(function: FunctionJson) -> Iterator[tuple[str | None, str, str, str]]:
    """Path, verb, call and own name of everything that a function uses."""
    for call in calls_of(function):
        yield call.vss_path, "runs", "", ""
        for contract in call.contracts or ():
            for signal in data_of(contract):
                yield signal.vss_path, "provides" if signal.role == PROVIDER else "consumes", call.name, signal.name
            for parameter in contract.parameters or ():
                yield parameter.vss_path, "is set by", call.name, parameter.name
            for error in contract.errors or ():
                yield error.vss_path, "reports", call.name, ""
            for reaction in contract.safety_reactions or ():
                yield reaction.vss_path, "reacts to", call.name, ""
    for mode in function.mode_interfaces or ():
        yield mode.vss_path, "sends" if mode.direction == "Out" else "receives", "", ""
