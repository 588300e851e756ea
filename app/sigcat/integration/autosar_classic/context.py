"""Common input of every step of `derive`, and the calls of components under the names of their runnables."""

from typing import NamedTuple

from sigcat.function.exchange import Part
from sigcat.function.function_json.runnable import Runnable as Call
from sigcat.integration.autosar_classic.datatypes.classic_types import TypeTable
from sigcat.integration.autosar_classic.deployment.settings import AutosarClassicSettings
from sigcat.integration.autosar_context import AutosarContext
from sigcat.integration.autosar_names import distinct, short_name

OF_ADAPTER = ("Init", "Receive", "Supervise", "JudgeWindows", "Terminate", "Core", "Calls", "Stored")
"""Runnables, areas and memory of a component, whatever the names of its steps: all of them have one namespace."""
OF_BASE_SOFTWARE = (
    "Clock", "Ignition", "EcuMode", "StoredBlock", "Parameters", "AdapterClock", "AdapterIgnition", "DiagnosticMonitor",
    "NvMService", "WdgM_LocalSupervision", "EcuM_CurrentMode",
)  # fmt: skip
"""Ports and interfaces that every component or set has."""
INIT, STEP, TERMINATE = "Init", "Step", "Terminate"


class NamedCall(NamedTuple):
    """A call of a component, and the name of its runnable."""

    name: str
    """Last part of its name: `Step`."""
    role: str
    """Init, Step or Terminate."""
    call: Call


Context = AutosarContext[AutosarClassicSettings, TypeTable]
"""Input of one derivation, and the findings on its way."""


def role_of(call: Call) -> str:
    """Return the role of a call for the adapter, however the document spells it."""
    text = call.run_type.strip().lower()
    if text.startswith("init"):
        return INIT
    return TERMINATE if text.startswith(("shut", "term")) else STEP


def named_calls(part: Part) -> tuple[NamedCall, ...]:
    """The calls of a component under names that no runnable of the adapter has."""
    prefix = f"{part.function_name}_"
    calls = {
        f"{index:06d}": NamedCall(short_name(call.name.removeprefix(prefix)), role_of(call), call)
        for index, call in enumerate(part.component.runnables)
    }
    steps = distinct({key: each.name for key, each in calls.items() if each.role == STEP}, OF_ADAPTER)
    return tuple(each._replace(name=steps.get(key, each.name)) for key, each in calls.items())
