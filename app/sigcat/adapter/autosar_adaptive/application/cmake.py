"""CMake files of the applications."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ComponentPlan, ExecutablePlan
from sigcat.adapter.templates import rendered

_ROOM = "adapter/autosar_adaptive/application"


class _Project(NamedTuple):
    """Plan of CMakeLists.txt of all. Without `bench` it does not know of any, whatever else is in its folder."""

    name: str
    components: Sequence[ComponentPlan]
    executables: Sequence[ExecutablePlan]
    bench: bool


def root_cmake(application: ApplicationPlan, *, bench: bool) -> str:
    """CMakeLists.txt of all."""
    plan = _Project(application.namespace[-1], application.components, application.executables, bench)
    return rendered(f"{_ROOM}/CMakeLists.txt.j2", plan)


def player_cmake() -> str:
    """CMakeLists.txt of the player alone."""
    return rendered(f"{_ROOM}/CMakeLists.txt.j2", _Project("player", (), (), bench=True))


def executable_cmake(executable: ExecutablePlan) -> str:
    """CMakeLists.txt of an executable."""
    return rendered(f"{_ROOM}/executable_CMakeLists.txt.j2", executable)
