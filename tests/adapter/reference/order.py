"""The order of calls that are due at the same time (section 9)."""

from collections.abc import Sequence

from tests.adapter.reference.function import Call


def in_order(steps: Sequence[Call]) -> tuple[Call, ...]:
    """Each after its previous ones, then the higher priority, then the order of the file."""
    waiting = sorted(steps, key=lambda step: -step.priority)
    ordered: list[Call] = []
    while waiting:
        names = {step.name for step in waiting}
        free = [step for step in waiting if not names.intersection(step.previous) - {step.name}]
        ordered.append(free[0] if free else waiting[0])
        waiting.remove(ordered[-1])
    return tuple(ordered)
