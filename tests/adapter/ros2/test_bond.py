"""Bonds: with `bond` in the deployment, nodes send heartbeats to the lifecycle manager of Nav2 while they are active."""

import importlib
import json
import subprocess
import sys
from types import ModuleType

import pytest

from sigcat.adapter.ros2.python.python_files import SUPPORT
from sigcat.adapter.toolchain import toolchain
from tests.adapter.autosar_adaptive.application.generated import FULL
from tests.adapter.ros2 import generated
from tests.needs import c_compiler

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


HEADERS = {
    "bondcpp/bond.hpp": """
#include <cstdio>
#include <memory>
#include "rclcpp_lifecycle/lifecycle_node.hpp"
namespace bond {
namespace msg { struct Constants { static inline const std::string DISABLE_HEARTBEAT_TIMEOUT_PARAM = "disabled"; }; }
struct Bond {
  Bond(const char *, const char * name, rclcpp_lifecycle::LifecycleNode::SharedPtr) { std::printf("bond %s\\n", name); }
  ~Bond() { std::puts("gone"); }
  void setHeartbeatPeriod(double) {}
  void setHeartbeatTimeout(double) {}
  void start() {}
  void breakBond() { std::puts("broken"); }
};
}
""",
    "rclcpp_lifecycle/lifecycle_node.hpp": """
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
struct Context {
  std::map<int, std::function<void()>> callbacks;
  int add_pre_shutdown_callback(std::function<void()> callback) { callbacks[1] = callback; return 1; }
  bool remove_pre_shutdown_callback(int handle) { return callbacks.erase(handle) > 0; }
};
namespace rclcpp_lifecycle {
struct LifecycleNode {
  using SharedPtr = std::shared_ptr<LifecycleNode>;
  std::shared_ptr<Context> context = std::make_shared<Context>();
  LifecycleNode * get_node_base_interface() { return this; }
  std::shared_ptr<Context> get_context() { return context; }
  bool has_parameter(const std::string &) { return false; }
  void declare_parameter(const std::string &, bool) {}
  const char * get_name() { return "full"; }
};
}
""",
}
"""The parts of bondcpp and rclcpp that the source of bonds uses."""

PROGRAM = """
#include <cstdio>
#include "full/bond.hpp"
int main() {
  const auto node = std::make_shared<rclcpp_lifecycle::LifecycleNode>();
  auto bond = full::bond_with_manager(node);
  node->context->callbacks.at(1)();
  bond.reset();
  std::printf("%zu\\n", node->context->callbacks.size());
}
"""


@c_compiler
def test_a_node_in_cpp_breaks_its_bond_before_its_context_ends(tmp_path):
    made = generated.files(document(BONDED))
    headers = {**HEADERS, "full/bond.hpp": made["full/include/full/bond.hpp"]}
    sources = {"bond.cpp": made["full/src/bond.cpp"], "main.cpp": PROGRAM}
    generated.write({**headers, **sources}, tmp_path)
    command = [*toolchain().cpp, "-std=c++17", "-DHAS_BONDCPP", f"-I{tmp_path}", *(tmp_path / each for each in sources)]
    subprocess.run([*command, "-o", tmp_path / "program"], check=True)
    done = subprocess.run([tmp_path / "program"], check=True, capture_output=True, text=True)
    assert done.stdout.split("\n") == ["bond full", "broken", "gone", "0", ""]


@pytest.mark.parametrize(("release", "is_there"), [("jazzy", True), ("humble", False)])
def test_the_python_package_depends_on_bondpy_where_a_release_has_it(release, is_there):
    made = generated.files(document(BONDED), release)
    assert ("<exec_depend>bondpy</exec_depend>" in made["full_py/package.xml"]) == is_there


class Node:
    """A node without ROS 2: what it does, in order."""

    def __init__(self):
        self.done = []
        self.context = self
        self.is_ok = True

    def ok(self):
        return self.is_ok

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
    is_shutdown = False

    def __init__(self, node, topic, name):
        self.node, self.names = node, (topic, name)

    def start(self):
        self.node.done.append((*self.names, self.heartbeat_period))

    def shutdown(self):
        self.node.done.append("no bond")

    def break_bond(self):
        self.node.done.append("broken")

    def wait_until_broken(self, timeout):
        self.node.done.append(timeout)


def bonded_node(monkeypatch, bondpy):
    """The class of the shipped module, over a node and a bondpy that need no ROS 2."""
    for name in ("bondpy", "rclpy", "rclpy.duration"):
        monkeypatch.setitem(sys.modules, name, ModuleType(name))
    monkeypatch.setattr(sys.modules["rclpy.duration"], "Duration", lambda seconds: seconds, raising=False)
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


def test_a_node_in_python_breaks_its_bond_before_its_context_ends(monkeypatch):
    bondpy = ModuleType("bondpy.bondpy")
    monkeypatch.setattr(bondpy, "Bond", Bond, raising=False)
    node = bonded_node(monkeypatch, bondpy)
    node.prepare_end()
    node._start_calls()
    bond = node._bond
    node.prepare_end()
    node.is_ok = False
    node._stop()
    assert node.done == ["calls", ("bond", "full", 0.1), "broken", 0.1, "no calls"]
    assert bond.is_shutdown


def test_a_node_in_python_ends_without_a_message_if_its_context_has_ended(monkeypatch):
    bondpy = ModuleType("bondpy.bondpy")
    monkeypatch.setattr(bondpy, "Bond", Bond, raising=False)
    node = bonded_node(monkeypatch, bondpy)
    node._start_calls()
    bond, node.is_ok = node._bond, False
    node._stop()
    assert node.done == ["calls", ("bond", "full", 0.1), "no calls"]
    assert bond.is_shutdown


def test_a_node_in_python_runs_without_bondpy(monkeypatch):
    node = bonded_node(monkeypatch, None)
    node._start_calls()
    node._stop()
    assert node.done == ["calls", "no calls"]
