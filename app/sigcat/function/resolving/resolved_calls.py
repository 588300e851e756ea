"""Calls of a function: init, steps and terminate, with supervision and allocation, as the catalogue declares them."""

from collections.abc import Mapping
from typing import Any

from sigcat.catalogue.model.interfaces import interface_name
from sigcat.function.declaration.declaration import RunnableItem
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.document.text import Text, optional
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.function_json.runnable import Runnable, Watchdog, WatchdogLimits
from sigcat.function.resolving.code import checkpoint
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.contracts import contract
from sigcat.function.resolving.interfaces import Attributes, error_name, interface_node
from sigcat.function.resolving.part import Part, written
from sigcat.function.resolving.values.numbers import plain_text

_ON_THE_WIRE = {"NonPreemptive": "Non-Preemptive"}
"""Spelling of the published documents where it differs from that of the attributes."""


def call(item: RunnableItem, at: Pointer, context: Context) -> Part[Runnable]:
    """A call. One that could not be resolved takes the errors with it that it would have declared."""
    node = interface_node(item.interface, "scheduling", at, context, own=True)
    made = contract(item, at, context)
    origin = Origin(at, {**written(item, at), "funcContractList": Origin(at, {0: made.origin})})
    if node is None:
        errors = made.value.errors if made.value and made.value.errors else ()
        lost = (Subject("scheduling", item.interface), *(Subject("error", error.name) for error in errors))
        return Part(None, origin, (*made.missing, *lost))
    attributes = Attributes(node, at, context)
    scheduling = attributes.text("scheduling") or ""
    supervision = attributes.texts("supervisionType")
    runnable = Runnable(
        name=interface_name(node.path),
        description=attributes.description,
        run_type=attributes.text("runType") or "",
        cycle_time=attributes.number("cycleTime"),
        stack_size=plain_text(attributes.number("stackSize")),
        previous_runnable=", ".join(attributes.texts("previousRunnable")) or None,
        execution_offset=plain_text(attributes.number("executionOffset")),
        parallel_processing=item.parallel,
        asil_level=attributes.asil,
        watchdog=_watchdog(attributes),
        scheduling=_ON_THE_WIRE.get(scheduling, scheduling),
        debounce_delay=plain_text(attributes.number("debounceTime")),
        priority=plain_text(attributes.number("priority")) or "",
        events=", ".join(item.events) or None,
        contracts=(made.value,) if made.value else None,
        supervision_types=tuple(kind for kind in supervision if kind != "None") or None,
        vss_path=node.path,
        symbol=item.symbol,
        arguments=tuple(item.arguments) or None,
        success_value=item.success,
        pre_processing=tuple(item.before) or None,
        post_processing=tuple(item.after) or None,
        checkpoint=checkpoint(item.checkpoint, context),
        overrun_error=error_name(item.overrun_error, (*at, "overrunError"), context),
    )
    return Part(runnable, origin, made.missing)


def _watchdog(attributes: Attributes) -> Watchdog | None:
    alive = attributes.mapping("aliveSupervision")
    deadline = attributes.mapping("deadlineSupervision")
    logical = attributes.mapping("logicalSupervision")
    if alive is None and deadline is None and logical is None:
        return None
    return Watchdog(
        alive=_limits(alive, "minIndications", "maxIndications", "referenceIndications"),
        deadline=_limits(deadline, "minDuration", "maxDuration", ""),
        logical=Text(str((logical or {}).get("description") or "")) if logical is not None else None,
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
        description=optional(_optional_text(values.get("description"))),
    )


def _number(value: Any) -> float:
    return value if isinstance(value, int | float) and not isinstance(value, bool) else 0


def _optional_text(value: Any) -> str | None:
    return value if isinstance(value, str) else None
