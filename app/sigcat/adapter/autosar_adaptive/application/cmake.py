"""CMake files of the applications."""

from collections.abc import Sequence

from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan, ExecutablePlan
from sigcat.adapter.templates import rendered

_ROOM = "adapter/autosar_adaptive/application"


def root_cmake(application: ApplicationPlan, *, bench: bool) -> str:
    """CMakeLists.txt of all."""
    return _project(application.namespace[-1], application.components, application.executables, bench=bench)


def player_cmake() -> str:
    """CMakeLists.txt of the player alone."""
    return _project("player", (), (), bench=True)


def _project(
    name: str, components: Sequence[ComponentPlan], executables: Sequence[ExecutablePlan], *, bench: bool
) -> str:
    """Without `bench` it does not know of any, whatever else is in its folder."""
    template = f"{_ROOM}/CMakeLists.txt.j2"
    return rendered(template, name=name, components=components, executables=executables, bench=bench)


def executable_cmake(executable: ExecutablePlan) -> str:
    """CMakeLists.txt of an executable."""
    return rendered(f"{_ROOM}/executable_CMakeLists.txt.j2", name=executable.name, components=executable.components)
