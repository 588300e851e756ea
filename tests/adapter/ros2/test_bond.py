"""Bonds: with `bond` in the deployment, nodes send heartbeats to the lifecycle manager of Nav2 while they are active."""

import importlib
import json
import sys
from types import ModuleType

import pytest

from sigcat.adapter.ros2.python.generate import SUPPORT
from tests.adapter.autosar_adaptive.application.generated import FULL
from tests.adapter.ros2 import generated

BONDED = {"ros2": {"bond": True}}


def document(deployment=None):
    return generated.integration(FULL / "function.yaml", deployment=deployment)


def test_without_the_setting_nothing_of_a_bond_is_generated():
    assert [name for name, text in generated.full().items() if "bond." in name or "bondcpp" in text] == []
    (package,) = json.loads(document())["NodePackageList"]
    assert "Bond" not in package
    assert "bondcpp" not in package["Dependencies"]


def test_a_node_has_a_bond_while_its_calls_run():
    made = generated.files(document(BONDED))
    source = made["full/src/full_node.cpp"]
    begin, _, end = source.partition("start_calls();\n  bond_ = bond_with_manager(")
    assert begin
    assert "::stop_calls()\n{\n  bond_.reset();" in end
    assert "std::shared_ptr<void> bond_;" in made["full/include/full/full_node.hpp"]
    assert "class FullNode(BondedNode):" in made["full_py/full_py/full_node.py"]
    assert "full_py/full_py/support/bond.py" in made


def test_a_package_is_built_without_bonds_where_there_is_no_bondcpp():
    made = generated.files(document(BONDED))
    cmake = made["full/CMakeLists.txt"]
    assert "find_package(bondcpp QUIET)" in cmake
    assert "if(bondcpp_FOUND)\n  target_compile_definitions(full_support PRIVATE HAS_BONDCPP)" in cmake
    assert made["full/src/bond.cpp"].count("#ifdef HAS_BONDCPP") == 2
    assert "<depend>bondcpp</depend>" in made["full/package.xml"]


def test_the_manager_waits_for_bonds_of_nodes_that_were_built_with_them():
    launch = generated.files(document(BONDED))["full/launch/full_container.launch.py"]
    compile(launch, "launch", "exec")
    assert "return '4.0' if PACKAGE in get_resources('sigcat_bonds') else '0.0'" in launch
    assert "'bond_timeout': ParameterValue(LaunchConfiguration('bond_timeout'), value_type=float)" in launch


@pytest.mark.parametrize(("release", "is_there"), [("jazzy", True), ("humble", False)])
def test_the_python_package_depends_on_bondpy_where_a_release_has_it(release, is_there):
    made = generated.files(document(BONDED), release)
    assert ("<exec_depend>bondpy</exec_depend>" in made["full_py/package.xml"]) == is_there


class Node:
    """A node without ROS 2: what it does, in order."""

    def __init__(self):
        self.done = []

    def get_name(self):
        return "full"

    def _start_calls(self):
        self.done.append("calls")

    def _stop(self):
        self.done.append("no calls")

    def destroy_subscription(self, subscription):
        self.done.append(f"no {subscription}")

    def destroy_publisher(self, publisher):
        self.done.append(f"no {publisher}")


class Bond:
    """A bond that notes its beginning and its end in the node."""

    sub, pub = "subscription", "publisher"
    heartbeat_period = 0.0

    def __init__(self, node, topic, name):
        self.node, self.names = node, (topic, name)

    def start(self):
        self.node.done.append((*self.names, self.heartbeat_period))

    def shutdown(self):
        self.node.done.append("no bond")


def bonded_node(monkeypatch, bondpy):
    """The class of the shipped module, over a node and a bondpy that need no ROS 2."""
    monkeypatch.setitem(sys.modules, "bondpy", ModuleType("bondpy"))
    monkeypatch.setitem(sys.modules, "bondpy.bondpy", bondpy)
    support, base = ModuleType("support"), ModuleType("support.function_node")
    support.__path__ = [str(SUPPORT)]
    monkeypatch.setattr(base, "FunctionNode", Node, raising=False)
    monkeypatch.setitem(sys.modules, "support", support)
    monkeypatch.setitem(sys.modules, "support.function_node", base)
    module = importlib.import_module("support.bond")
    del sys.modules["support.bond"]
    return module.BondedNode()


def test_a_node_in_python_has_a_bond_while_its_calls_run(monkeypatch):
    bondpy = ModuleType("bondpy.bondpy")
    monkeypatch.setattr(bondpy, "Bond", Bond, raising=False)
    node = bonded_node(monkeypatch, bondpy)
    node._start_calls()
    node._stop()
    node._stop()
    end = ["no bond", "no subscription", "no publisher", "no calls", "no calls"]
    assert node.done == ["calls", ("bond", "full", 0.1), *end]


def test_a_node_in_python_runs_without_bondpy(monkeypatch):
    node = bonded_node(monkeypatch, None)
    node._start_calls()
    node._stop()
    assert node.done == ["calls", "no calls"]
