"""How parts of the test RTE are called."""

from sigcat.adapter.autosar_classic.code.api import Call
from sigcat.adapter.autosar_classic.code.plan import DataEnd, SwcPlan
from sigcat.integration.autosar_classic.model import Port, Runnable


def data(end: DataEnd, swc: SwcPlan) -> str:
    """What is received last."""
    return f"data_{swc.name}_{end.name}"


def deliver(end: DataEnd, swc: SwcPlan) -> str:
    """What puts a value there."""
    return f"TestRte_Deliver_{swc.name}_{end.name}"


def deliver_checked(end: DataEnd, swc: SwcPlan) -> str:
    """What puts a value there with a code of its end-to-end protection."""
    return f"TestRte_DeliverChecked_{swc.name}_{end.name}"


def implicit(call: Call, swc: SwcPlan) -> str:
    """The copy for a runnable."""
    return f"copy_{swc.name}_{call.runnable}_{call.port}_{call.element}"


def mode_of(port: Port, swc: SwcPlan) -> str:
    return f"mode_{swc.name}_{port.name}"


def switch_to(port: Port, swc: SwcPlan) -> str:
    return f"TestRte_SwitchTo_{swc.name}_{port.name}"


def own(what: str, name: str, swc: SwcPlan) -> str:
    return f"TestRte_{what}_{swc.name}_{name}"


def shape_name(name: str, swc: SwcPlan) -> str:
    return f"TestRte_Shape_{swc.name}_{name}"


def run(each: Runnable, swc: SwcPlan) -> str:
    """What the operating system starts."""
    return f"TestRte_Run_{swc.name}_{each.name}"
