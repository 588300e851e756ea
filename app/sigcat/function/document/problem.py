"""What is wrong with a Function JSON, and where in it, before it is known in which file that stands."""

from typing import NamedTuple

from sigcat.function.document.document import Pointer


class Problem(NamedTuple):
    """One defect. `pointer` leads into the Function JSON; `path` names the interface."""

    rule: str
    pointer: Pointer
    message: str
    fix: str = ""
    path: str = ""
