"""SOME/IP ids by rule: each is a digest of the name that it belongs to, so that no other name changes it.

Ranges are those of the SOME/IP protocol specification (PRS_SOMEIPProtocol, AUTOSAR R23-11): methods have the highest
bit clear, events have it set; 0 and the values at the upper end are reserved.
"""

from collections.abc import Iterable, Mapping
from hashlib import sha256
from typing import NamedTuple


class Span(NamedTuple):
    """The ids of one kind, both ends included."""

    first: int
    last: int


SERVICES = Span(0x0100, 0xFEFF)
INSTANCES = Span(0x0001, 0xFEFF)
METHODS = Span(0x0001, 0x7FFF)
EVENTS = Span(0x8001, 0xFFFE)
EVENT_GROUPS = Span(0x0001, 0xFEFF)
RULED_INSTANCES = Span(0x0001, 0x00FF)
"""Instances that the rule gives: vsomeip protects by profile 4 only instances up to 255."""
RULED_DATA_IDS = Span(0x0001, 0xFFFE)
"""Data ids of end-to-end protection that the rule gives: 16 bits, which all profiles have."""
_WITH_32_BITS = (4, 7)
LARGEST_ID = 0xFFFFFFFF
"""Largest id of any kind: a data id of profile 4 or 7."""
INSTANCE, DATA_ID = ":instance", ":dataId"
"""Suffixes of instances and data ids in the keys of a deployment or an id catalogue."""


def largest_id(key: str) -> int:
    """Largest id that a key of a deployment or an id catalogue may have."""
    return LARGEST_ID if key.endswith(DATA_ID) else 0xFFFE


def data_ids(profile: int) -> Span:
    """Data ids of a profile: 32 bits with profiles 4 and 7, 16 bits with 5 and 6 (PRS_E2EProtocol, AUTOSAR R23-11)."""
    return Span(0, LARGEST_ID if profile in _WITH_32_BITS else 0xFFFF)


class Collision(NamedTuple):
    """Two names that ask for the same id. The one that comes later in the alphabet has moved on."""

    name: str
    kept_by: str
    id: int


class Assigned(NamedTuple):
    """Ids by name, and which of them depend on another name being there."""

    ids: dict[str, int]
    collisions: tuple[Collision, ...]


def ruled_part(number: int) -> int:
    """The part of an id that the rule chooses: of a data id of profile 4, all but the instance."""
    return number & 0xFFFF


def assign(
    names: Iterable[str],
    span: Span,
    fixed: Mapping[str, int] | None = None,
    scope: str = "",
    reserved: Mapping[int, str] | None = None,
) -> Assigned:
    """An id for each name, unique among them.

    What is fixed comes first, and none gets what is reserved for a name that is not among them. Of two names that ask for the same id, the first in the alphabet has it; the other one
    takes the next that its own digest proposes.
    """
    ordered = sorted(set(names))
    ids = {name: fixed[name] for name in ordered if fixed and name in fixed}
    taken = {**(reserved or {}), **{ruled_part(number): name for name, number in ids.items()}}
    collisions = []
    for name in ordered:
        if name in ids:
            continue
        number, other = _free(f"{scope}.{name}", span, taken)
        if other:
            collisions.append(Collision(name, other, number))
        ids[name] = number
        taken[number] = name
    return Assigned(ids, tuple(collisions))


def _free(key: str, span: Span, taken: Mapping[int, str]) -> tuple[int, str]:
    """The first free id in the order that the key proposes, and the name that stood in its way, if one did."""
    size = span.last - span.first + 1
    if len(taken) >= size:
        raise OverflowError(f"{size} ids are not enough")
    digest = int.from_bytes(sha256(key.encode()).digest()[:8], "big")
    start, met = digest % size, ""
    for step in range(size):
        number = span.first + (start + step) % size
        if number not in taken:
            return number, met
        met = met or taken[number]
    raise OverflowError(f"{size} ids are not enough")
