"""Interface categories and interface names, derived from paths.

VSS covers data and parameters. The other interfaces of a function are in the tree below the function's own branch,
`Vehicle.Function.<FunctionName>`, in the branches `Error`, `SafetyReaction`, `Mode` and `Scheduling`; their names
follow the glossary of the method's paper.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import Literal, get_args

Category = Literal["data", "error", "safety_reaction", "mode", "scheduling"]

CATEGORIES: tuple[Category, ...] = get_args(Category)
FUNCTION_BRANCH = "Function"
BRANCHES: Mapping[str, Category] = {
    "Error": "error",
    "SafetyReaction": "safety_reaction",
    "Mode": "mode",
    "Scheduling": "scheduling",
}
"""Categories by the name of the branch below a function's branch."""


def category_of(path: str) -> Category | None:
    """Category of the interface at a path; None for the branches that only group a function's interfaces.

    Everything else is data: whether it is a leaf, and whether of type attribute and so a parameter, the node says.
    """
    if FUNCTION_BRANCH not in path:
        return "data"  # nearly every path of a tree: it need not be taken apart
    names = path.split(".")
    if len(names) < 2 or names[1] != FUNCTION_BRANCH:
        return "data"
    if len(names) < 4:
        return None
    category = BRANCHES.get(names[3], "data")
    return None if len(names) == 4 and category != "data" else category


def function_of(path: str) -> str:
    """Name of the function whose branch a path is in; empty outside of them."""
    names = path.split(".")
    return names[2] if len(names) > 2 and names[1] == FUNCTION_BRANCH else ""


def interface_name(path: str) -> str:
    """Name of the interface at a path: `….Error.RangeError` → `WheelSpeedCalculation_RangeError_ErrorSts`.

    The name of a data interface is its path.
    """
    category = category_of(path)
    if category in (None, "data"):
        return path
    names = path.split(".")
    function, own = names[2], "_".join(names[4:])
    if category == "error":
        return f"{function}_{own}_ErrorSts"
    if category == "safety_reaction":
        return f"{own}_SftyCondSts"
    return f"{function}_Mode_{own}" if category == "mode" else f"{function}_{own}"


def by_interface_name(paths: Iterable[str]) -> dict[str, str]:
    """Paths of error, safety reaction, mode and scheduling interfaces by interface name; the first one counts."""
    named: dict[str, str] = {}
    for path in interface_paths(paths):
        named.setdefault(interface_name(path), path)
    return named


def interface_paths(paths: Iterable[str]) -> Iterator[str]:
    """Those of error, safety reaction, mode and scheduling interfaces."""
    return (path for path in paths if FUNCTION_BRANCH in path and interface_name(path) != path)
