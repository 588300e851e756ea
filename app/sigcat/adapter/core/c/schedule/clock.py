"""Times that an adapter remembers, and that a clock which wraps around would make young again (section 1)."""

from collections.abc import Iterator

from sigcat.adapter.core.plan import Call, CorePlan


def kept_times(plan: CorePlan) -> list[str]:
    """Members that an age is computed from: `Step.begun`."""
    return [
        *(f"received.{port.name}.reception.time" for port in plan.ports if port.is_timed),
        *(time for call in plan.steps for time in _of_call(call, plan)),
        *(f"error.{each.named.name}.since" for each in plan.errors if each.call),
        *(f"reaction.{each.named.name}.reception.time" for each in plan.reactions if each.time_out is not None),
        *(f"method.{each.named.name}.since" for each in plan.requests if each.time_out is not None),
    ]


def _of_call(call: Call, plan: CorePlan) -> Iterator[str]:
    if any(item.time_out for item in call.inputs) or plan.timed_reactions(call):
        yield f"{call.name}.entered"
    if call.debounce or call.deadline:
        yield f"{call.name}.begun"


def cyclic_calls(plan: CorePlan) -> list[str]:
    """Calls with releases, which may be missed for long."""
    return [call.name for call in plan.steps if call.cycle is not None]
