"""Signals of a basket in a catalogue: its entries with their signals, and files made of them."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from sigcat.adapter.templates import rendered
from sigcat.api.answers.negotiation import csv_text
from sigcat.api.routes.catalogues import row_of
from sigcat.catalogue.hosting.variants import expanded_of, instances_of
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.interfaces import category_of
from sigcat.errors import UsageError
from sigcat.function.extension.overlay import statement_text
from sigcat.integration.ros2.names import field_name
from sigcat.limits import BASKET_SIGNALS, PROPOSAL_CHARACTERS
from sigcat.names import is_well_formed, nearest, parent_path

CSV_FIELDS = ("path", "type", "datatype", "unit", "min", "max", "allowed", "default", "description")
_PATH_NAMES = 100
_OVERLAY_HEAD = """\
# Chosen signals with all that the catalogue says about them. Change what you need, and delete the rest.
"""


class Entry(NamedTuple):
    """A chosen path. Without a node, `near` are paths that may have been meant."""

    path: str
    node: Node | None
    signals: tuple[Node, ...]
    near: tuple[str, ...] = ()

    @property
    def is_one(self) -> bool:
        """Whether the path is that of a single signal."""
        return self.node is not None and self.node.is_leaf and len(self.signals) == 1


class ChosenSignals(NamedTuple):
    """A basket in a catalogue."""

    entries: tuple[Entry, ...]
    signals: tuple[Node, ...]
    """Signals of all entries, each once."""
    types: tuple[tuple[str, int], ...]
    """Number of signals of each type."""


def chosen_signals(shown: Catalogue, paths: Iterable[str]) -> ChosenSignals:
    """Return the nodes of the paths of a basket, or definitions of instances for all of them."""
    catalogue = expanded_of(shown)
    entries = tuple(_entry(catalogue, path) for path in paths)
    signals = tuple({node.path: node for entry in entries for node in entry.signals}.values())
    return ChosenSignals(entries, signals, tuple(Counter(node.type for node in signals).most_common()))


def _entry(catalogue: Catalogue, path: str) -> Entry:
    node = catalogue.get(path)
    nodes = (node,) if node is not None else tuple(instances_of(catalogue, path))
    if not nodes:
        return Entry(path, None, (), tuple(nearest(path[:PROPOSAL_CHARACTERS], catalogue.nodes, limit=3)))
    signals = {each.path: each for top in nodes for each in top.walk() if each.is_leaf}
    return Entry(path, nodes[0], tuple(signals.values()))


# -- files --------------------------------------------------------------------------------------------------------


def signals_csv(chosen: ChosenSignals) -> str:
    """A table of the signals."""
    rows = [dict(zip(CSV_FIELDS, row_of(node, CSV_FIELDS), strict=True)) for node in chosen.signals]
    return csv_text(rows) if rows else ",".join(CSV_FIELDS) + "\n"


def signals_overlay(catalogue: Catalogue, chosen: ChosenSignals) -> str:
    """An overlay to edit. Branches above that other overlays add are in it, so that it also fits the tree without them."""
    _refuse_many(chosen)
    catalogue = expanded_of(catalogue)
    root = catalogue.roots[0].path if catalogue.roots else ""
    statements = dict(_statements(catalogue, [node for node in chosen.signals if node.path.startswith(f"{root}.")]))
    branches = {path: values for each in statements for path, values in _own_branches(catalogue, each)}
    texts = [statement_text(path, values) for path, values in {**branches, **statements}.items()]
    return "\n".join((_OVERLAY_HEAD, *texts))


def _statements(catalogue: Catalogue, signals: Sequence[Node]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Yield a statement for each definition of which all instances are chosen, and for each other signal."""
    chosen = Counter(node.template for node in signals)
    for node in signals:
        is_whole = node.template != node.path and chosen[node.template] == len(instances_of(catalogue, node.template))
        yield (node.template if is_whole else node.path), node.values


def _own_branches(catalogue: Catalogue, path: str) -> list[tuple[str, Mapping[str, Any]]]:
    """Return the branches above a node that an overlay adds, the topmost first."""
    found = []
    while path := parent_path(path):
        definition = catalogue.definitions.get(path)
        if definition is not None and definition.statements and definition.statements[0].file.overlay:
            found.append((path, definition.values))
    return found[::-1]


class StartedSignal(NamedTuple):
    """A signal of a function to start from."""

    path: str
    role: str
    name: str
    """Name in the function, where several signals have the same last name; empty otherwise."""
    variable: str
    about: str
    """Type, datatype and unit, for a comment."""


def signals_function(chosen: ChosenSignals, name: str = "NewFunction") -> str:
    """A function.yaml that consumes the chosen sensors and attributes, and provides the chosen actuators."""
    _refuse_many(chosen)
    data = [node for node in chosen.signals if _is_data(node)]
    others = tuple(node.path for node in chosen.signals if not _is_data(node))
    names = Counter(field_name(node.name).text for node in data)
    signals = tuple(_started(node, names, name) for node in data)
    return rendered(
        "web/views/started_function.yaml.j2",
        name=name,
        signals=signals,
        left_out=others,  # paths that are not data: interfaces of other functions
    )


def _is_data(node: Node) -> bool:
    return category_of(node.path) == "data" and is_well_formed(node.path, _PATH_NAMES)


def _started(node: Node, names: Mapping[str, int], function: str) -> StartedSignal:
    last, below = field_name(node.name).text, node.path.partition(".")[2]
    is_unique = names[last] == 1
    variable = last if is_unique else field_name(below).text
    is_provided = node.type == "actuator"
    about = " ".join(str(each) for each in (node.type, node.values.get("datatype"), node.values.get("unit")) if each)
    side = "out" if is_provided else "in"
    name = "" if is_unique else below.replace(".", "")
    role = "provided" if is_provided else "consumed"
    return StartedSignal(node.path, role, name, f"{function}_{side}.{variable}", about)


def _refuse_many(chosen: ChosenSignals) -> None:
    """Raises UsageError for more signals than one edits by hand."""
    if len(chosen.signals) > BASKET_SIGNALS:
        raise UsageError(f"The basket must have at most {BASKET_SIGNALS:,} signals, not {len(chosen.signals):,}.")
