"""Information of the middleware about a message: rclpy of Humble passes none on."""

from typing import Any, Callable, Optional


def with_sequence_number(take: Callable[[Any, Optional[int]], None]) -> Callable[..., None]:
    """Answer a callback of a subscription."""
    def callback(message: Any) -> None:
        take(message, None)

    return callback
