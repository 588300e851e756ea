"""Names and forms in the generated C++."""

import re

from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Call, WireType
from sigcat.adapter.ros2.plan import InterfaceType, NodePlan, WorkspacePlan
from sigcat.names import snake_case

CORE = "&core_->adapter"
"""The core, as its functions take it."""


def guard(workspace: WorkspacePlan, stem: str) -> str:
    """The include guard of a header of the package."""
    return f"{workspace.name.upper()}__{stem.upper()}_HPP_"


def header_of(interface: InterfaceType) -> str:
    """The header that rosidl makes of a message: `ADASMap` → `pkg/msg/adas_map.hpp`, by its own rule."""
    spread = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", interface.name)
    spread = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", spread)
    return f"{interface.package}/{interface.kind}/{spread.lower()}.hpp"


def short(interface: InterfaceType, node: NodePlan) -> str:
    """The class of a message in the namespace of the package: `msg::Speed`, or `geometry_msgs::msg::Twist`."""
    return f"{interface.kind}::{interface.name}" if node.is_own(interface) else interface.cpp


def bridge_source(node: NodePlan) -> str:
    """File of the core's interface for Python."""
    return f"{node.core.function}_bridge.{node.core.code.ending}"


def core_function(node: NodePlan, name: str) -> str:
    """A function of the core: `CoreAcc_Adapter_Start`."""
    return f"{node.core.type_name}_{name}"


def scope_of(node: NodePlan) -> Scope:
    """The names of constants of the core."""
    return Scope(node.core)


def _call_name(node: NodePlan, call: Call) -> str:
    """A call in snake_case, unless another one has the same."""
    names = [snake_case(step.name) for step in node.steps]
    name = snake_case(call.name)
    return name if name and names.count(name) == 1 else call.name


def run_name(node: NodePlan, call: Call) -> str:
    """The member function that runs a call: `run_step`."""
    return f"run_{_call_name(node, call)}"


def times_name(node: NodePlan, call: Call) -> str:
    """The member that has its times: `step_times_`."""
    return f"{_call_name(node, call)}_times_"


def table(place: str) -> str:
    """The table of texts of an enumeration: `kSpdLimUnitSymbols`."""
    return f"k{place[:1].upper()}{place[1:]}Symbols"


def is_plain(wire: WireType) -> bool:
    """Whether it is one number."""
    return not wire.is_struct and wire.length is None


def report_name(node: NodePlan, call: Call) -> str:
    """The local variable with the reported counts of a call."""
    return f"{_call_name(node, call)}_report"
