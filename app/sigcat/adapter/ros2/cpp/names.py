"""Names and forms in the generated C++."""

import re

from sigcat.adapter.ros2.plan import InterfaceType, WorkspacePlan


def guard(workspace: WorkspacePlan, stem: str) -> str:
    """The include guard of a header of the package."""
    return f"{workspace.name.upper()}__{stem.upper()}_HPP_"


def header_of(interface: InterfaceType) -> str:
    """The header that rosidl makes of a message: `ADASMap` → `pkg/msg/adas_map.hpp`, by its own rule."""
    spread = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", interface.name)
    spread = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", spread)
    return f"{interface.package}/{interface.kind}/{spread.lower()}.hpp"


def table(place: str) -> str:
    """The table of texts of an enumeration: `kSpdLimUnitSymbols`."""
    return f"k{place[:1].upper()}{place[1:]}Symbols"
