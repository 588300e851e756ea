"""Names and forms in the generated C++."""

import re

from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import WireType
from sigcat.adapter.ros2.plan import InterfaceType, NodePlan, WorkspacePlan


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


def scope_of(node: NodePlan) -> Scope:
    """The names of constants of the core."""
    return Scope(node.core)


def table(place: str) -> str:
    """The table of texts of an enumeration: `kSpdLimUnitSymbols`."""
    return f"k{place[:1].upper()}{place[1:]}Symbols"


def is_plain(wire: WireType) -> bool:
    """Whether it is one number."""
    return not wire.is_struct and wire.length is None
