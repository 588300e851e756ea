"""Problems of an Integration JSON or of a deployment, each with its place."""

from typing import NamedTuple

from sigcat.function.document.document import Pointer


class Problem(NamedTuple):
    """A reason why a platform cannot be generated, and its place."""

    pointer: Pointer
    message: str
    fix: str = ""
