"""Information of the middleware about a message, besides its values."""

from inspect import Parameter, Signature
from typing import Any, Callable, Optional


def with_sequence_number(take: Callable[[Any, Optional[int]], None]) -> Callable[..., None]:
    """Answer a callback of a subscription which tells how many messages the publisher has sent."""
    def callback(*given: Any) -> None:
        message, info = given[0] if len(given) == 1 else given  # events have both as one
        take(message, info['publication_sequence_number'])

    both = (Parameter(name, Parameter.POSITIONAL_ONLY) for name in ('message', 'info'))
    callback.__signature__ = Signature(list(both))  # type: ignore[attr-defined]
    return callback
