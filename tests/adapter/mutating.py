"""Documents with small mistakes: a seeded change or two, driven by the structure of the document alone."""

import copy
import json
import random
from collections.abc import Iterator
from typing import Any

_TEXTS = (
    "",
    " ",
    "0",
    "--5",
    "+-5",
    "²",
    "1e400",
    "Init",
    "a b",
    "x" * 200,
    "int",
    "é",
    "*/",
    '"',
    "\\",
    "%d",
    "Vehicle.Speed",
)
_NUMBERS = (0, 1, -1, 0.5, 1e-9, 2.5, 255, 65536, 2**31, 2**63, 2**64, 1e308)
_SLOT = tuple[Any, Any]
"""A list or mapping, and an index or key of it."""


def mutated(document: Any, seed: int) -> Any:
    """A copy of a document with one to three changes."""
    chance = random.Random(seed)
    changed = copy.deepcopy(document)
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        slots = list(_slots(changed))
        if slots:
            _change(*chance.choice(slots), slots, chance)
    return changed


def _slots(value: Any) -> Iterator[_SLOT]:
    pairs = (
        list(value.items()) if isinstance(value, dict) else list(enumerate(value)) if isinstance(value, list) else []
    )
    for key, item in pairs:
        yield value, key
        yield from _slots(item)


def _change(holder: Any, key: Any, slots: list[_SLOT], chance: random.Random) -> None:
    kind = chance.randrange(5)
    if kind == 0:
        del holder[key]
    elif kind == 1 and isinstance(holder, list):
        holder.insert(key, copy.deepcopy(holder[key]))
    elif kind == 2:
        holder[key] = None
    elif kind == 3:  # what is in another place of this kind
        values = [other[at] for other, at in slots if type(other[at]) is type(holder[key])]
        holder[key] = copy.deepcopy(chance.choice(values))
    else:
        holder[key] = _other(holder[key], chance)


def _other(value: Any, chance: random.Random) -> Any:
    if isinstance(value, bool):
        return not value
    if isinstance(value, str):
        return chance.choice(_TEXTS)
    if isinstance(value, int | float):
        return chance.choice(_NUMBERS)
    return type(value)() if isinstance(value, list | dict) else chance.choice((0, "", [], {}))


def difference(before: Any, after: Any, at: str = "") -> list[str]:
    """Description of the change, for the message of a failure."""
    if type(before) is type(after) and isinstance(before, dict):
        keys = [*before, *(key for key in after if key not in before)]
        return [line for key in keys for line in difference(before.get(key), after.get(key), f"{at}/{key}")]
    if isinstance(before, list) and isinstance(after, list) and len(before) == len(after):
        pairs = enumerate(zip(before, after, strict=True))
        return [line for index, (old, new) in pairs for line in difference(old, new, f"{at}/{index}")]
    if before == after and type(before) is type(after):
        return []
    return [f"{at}: {json.dumps(before)[:300]} -> {json.dumps(after)[:300]}"]
