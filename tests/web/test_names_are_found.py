"""Every name that the page of a node shows finds the node in a search."""

import pytest

from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.catalogue.search import SearchIndex
from sigcat.function.hosting import FunctionLibrary
from sigcat.function.node_uses import uses_in
from sigcat.web.views.node_view import node_view

EVERY = 11
"""Among so many nodes, one is searched."""


@pytest.fixture(scope="module")
def catalogue():
    return load(shipped_sources()[0])


def test_a_name_of_a_node_finds_it(catalogue):
    index = SearchIndex(catalogue)
    uses = uses_in(FunctionLibrary().files, catalogue)
    nodes = [*list(catalogue.nodes.values())[::EVERY], catalogue.nodes["Vehicle.Powertrain.CombustionEngine.MAP"]]
    lost = [
        (where, name)
        for node in nodes
        for where, name in node_view(catalogue, node, {}, uses).names
        if node not in index.search(name, limit=1000, each_instance=True).nodes
    ]
    assert lost == []


@pytest.mark.parametrize(("text", "path"), [
    ("VehicleSpeed", "Vehicle.Speed"),
    ("ADASABS", "Vehicle.ADAS.ABS"),
    ("start_time", "Vehicle.StartTime"),
    ("WheelSpeedCalculation_RangeError_ErrorSts", "Vehicle.Function.WheelSpeedCalculation.Error.RangeError"),
])  # fmt: skip
def test_it_comes_first(catalogue, text, path):
    assert SearchIndex(catalogue).search(text).nodes[0].path == path
