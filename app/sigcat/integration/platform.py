"""What a platform brings: its section of the deployment file, its Integration JSON, and the schema of that."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from sigcat.findings import Finding
    from sigcat.function.declaration.form import DeclarationModel
    from sigcat.function.function_json.model import FunctionJson
    from sigcat.integration.deployment import Deployment
    from sigcat.integration.report import Entry


class Integrated(NamedTuple):
    """An Integration JSON, the findings about it, and where each field of each interface went."""

    document: bytes
    findings: "tuple[Finding, ...]"
    report: "tuple[Entry, ...]"


class Platform(NamedTuple):
    """One platform. Its functions import what they need when they are called, so that names and titles cost nothing."""

    name: str
    """In commands, addresses and file names: `ros2`."""
    title: str
    """In sentences: `ROS 2`."""
    settings: "Callable[[], type[DeclarationModel]]"
    """The model of its section of the deployment file."""
    derive: "Callable[[Sequence[FunctionJson], Deployment, Any], Integrated]"
    """The Integration JSON of a set of functions, with what the deployment says for all platforms and for this one."""
    schema: Callable[[], dict[str, Any]]
    """JSON Schema of its Integration JSON."""

    @property
    def section(self) -> str:
        """Name of its section among the fields of a deployment."""
        return self.name.replace("-", "_")
