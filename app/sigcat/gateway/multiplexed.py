"""What a frame holds whose multiplexer has a value that the database does not define: all that does not hang on it."""

from collections.abc import Mapping, Sequence
from typing import Any


def defined_parts(message: Any, data: bytes) -> tuple[Mapping[str, float], Sequence[str]]:
    """The numbers of a frame as they were transmitted, and what is undefined in it. Raises what cantools does."""
    from cantools.database.utils import decode_data

    found: dict[str, float] = {}
    undefined: list[str] = []
    waiting = [message._codecs]  # noqa: SLF001 — message.decode goes the same way, and gives up where it ends
    while waiting:
        part = waiting.pop()
        found |= decode_data(data, message.length, part["signals"], part["formats"], False, False, True, False)  # type: ignore[arg-type]
        for name, parts in part["multiplexers"].items():
            number = found.get(name)
            if number is None:
                continue  # beyond the end of a short frame
            if number in parts:
                waiting.append(parts[number])
            else:
                known = ", ".join(map(str, sorted(parts)))
                undefined.append(
                    f"multiplexer {name} is {number}; {known} {'is' if len(parts) == 1 else 'are'} defined"
                )
    return found, undefined
