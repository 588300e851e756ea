"""Publishers and subscriptions of a node, which it creates while it is configured."""

from sigcat.adapter.ros2.plan import ReceivedField


def unnamed(taken: ReceivedField) -> int:
    """The number for the core of a state that has no name."""
    numbers = {number for _, number in taken.numbers}
    return next(number for number in range(256) if number not in numbers)


def duration(milliseconds: float) -> str:
    """A duration of `std::chrono`."""
    if milliseconds == int(milliseconds):
        return f"std::chrono::milliseconds({int(milliseconds)})"
    return f"std::chrono::nanoseconds({round(milliseconds * 10**6)})"
