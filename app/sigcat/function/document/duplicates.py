"""The finding of a key that is given twice, in YAML as in JSON."""

from sigcat import codes
from sigcat.findings import Finding, first_at
from sigcat.function.document.document import Position


def duplicate_key(key: str, name: str, position: Position, first: Position, pointer: str = "") -> Finding:
    """The finding at the second of two keys."""
    message = f"Key {key!r} is given twice, {first_at(name, first.line)}; only the last one counts."
    fix = "Remove one of the two; for another item of a list, write `- ` before the first key of the item."
    return codes.DUPLICATE_KEY.finding(message, name, *position, pointer=pointer, fix=fix)
