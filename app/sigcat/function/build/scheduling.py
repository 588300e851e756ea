"""Calls of a function: init, steps and terminate, with supervision and allocation, as the catalogue declares them."""

from collections.abc import Mapping
from typing import Any

from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.interfaces import interface_name
from sigcat.function.build.contracts import contract
from sigcat.function.build.references import interface_node, mapping_of, number_of, text_of, texts_of
from sigcat.function.build.work import Work
from sigcat.function.declaration.declaration import RunnableItem
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.model import Runnable, Watchdog, WatchdogLimits

_ON_THE_WIRE = {"NonPreemptive": "Non-Preemptive"}
"""Spelling of the published documents where it differs from that of the attributes."""


def runnable(item: RunnableItem, at: Pointer, target: Pointer, work: Work) -> Runnable | None:
    """A call, resolved. `target` is its place in the Function JSON."""
    node = interface_node(item.interface, "scheduling", at, work, own=True)
    contract_target = (*target, "funcContractList", 0)
    work.trace[target] = work.trace[contract_target] = at
    made = contract(item, at, contract_target, work)
    if node is None:
        return None
    scheduling = text_of(node, "scheduling") or ""
    supervision = texts_of(node, "supervisionType", at, work)
    return Runnable(
        name=interface_name(node.path),
        description=str(node.values.get("description") or ""),
        run_type=text_of(node, "runType") or "",
        cycle_time=_whole(node, "cycleTime", at, work),
        stack_size=_text(number_of(node, "stackSize", at, work)),
        previous_runnable=", ".join(texts_of(node, "previousRunnable", at, work)) or None,
        execution_offset=_text(number_of(node, "executionOffset", at, work)),
        parallel_processing=item.parallel,
        asil_level=text_of(node, "ASILlevel"),
        watchdog=_watchdog(node, at, work),
        scheduling=_ON_THE_WIRE.get(scheduling, scheduling),
        debounce_delay=_text(number_of(node, "debounceTime", at, work)),
        priority=_text(number_of(node, "priority", at, work)) or "",
        events=", ".join(item.events) or None,
        contracts=(made,) if made else None,
        supervision_types=tuple(kind for kind in supervision if kind != "None") or None,
        vss_path=node.path,
    )


def _watchdog(node: Node, at: Pointer, work: Work) -> Watchdog | None:
    alive, deadline, logical = (
        mapping_of(node, f"{kind}Supervision", at, work) for kind in ("alive", "deadline", "logical")
    )
    if alive is None and deadline is None and logical is None:
        return None
    return Watchdog(
        alive=_limits(alive, "minIndications", "maxIndications", "referenceIndications"),
        deadline=_limits(deadline, "minDuration", "maxDuration", ""),
        logical=str((logical or {}).get("description") or "") if logical is not None else None,
        logical_error=_optional_text((logical or {}).get("error")),
    )


def _limits(values: Mapping[str, Any] | None, low: str, high: str, reference: str) -> WatchdogLimits | None:
    if values is None:
        return None
    return WatchdogLimits(
        min=_number(values.get(low)),
        max=_number(values.get(high)),
        reference=_number(values.get(reference)),
        error_name=str(values.get("error") or ""),
        description=_optional_text(values.get("description")),
    )


def _number(value: Any) -> float:
    return value if isinstance(value, int | float) and not isinstance(value, bool) else 0


def _optional_text(value: Any) -> str | None:
    return value if isinstance(value, str) else None


def _whole(node: Node, name: str, at: Pointer, work: Work) -> int | None:
    """A number that the wire format has as a whole one only."""
    value = number_of(node, name, at, work)
    if value is None or value == int(value):
        return None if value is None else int(value)
    message = f"`{name}` of {node.path!r} is {value}: Function JSON has whole numbers only."
    work.report("F004", at, message, path=node.path)
    return None


def _text(value: float | None) -> str | None:
    return None if value is None else str(int(value) if value == int(value) else value)
