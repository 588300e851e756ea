"""Names for AUTOSAR, each derived from a VSS path or an interface name in one place."""

import re
from collections.abc import Iterable, Mapping, Sequence
from hashlib import sha256

from sigcat.names import camel_case
from sigcat.reserved_words import is_reserved

LONGEST_SHORT_NAME = 128
"""Characters of an AUTOSAR short name."""


def short_name(text: str) -> str:
    """An AUTOSAR short name: letters, digits and underscores, a letter first, 128 characters at most, not a reserved word.

    A name that is cut, or that has nothing left, ends in a digest of the whole, so that two long names stay two.
    """
    name = re.sub(r"[^A-Za-z0-9_]+", "_", text).strip("_") if re.search(r"[^A-Za-z0-9_]", text) else text
    if not name.strip("_"):
        return f"N_{_digest(text)}"
    if not ("A" <= name[0] <= "Z" or "a" <= name[0] <= "z"):
        name = f"N_{name.lstrip('_')}"
    if is_reserved(name):
        return f"{name}_Value"
    return name if len(name) <= LONGEST_SHORT_NAME else f"{name[: LONGEST_SHORT_NAME - 9]}_{_digest(text)}"


def event_name(path: str) -> str:
    """Name of an event: the path without its root, `Vehicle.Chassis.Brake.CylP` → `Chassis_Brake_CylP`.

    A leaf directly below the root keeps it, `Vehicle_Mass`, as in the authors' example.
    """
    names = path.split(".")
    return short_name("_".join(names[1:] if len(names) > 2 else names))


def branch_of(path: str) -> str:
    """The first branch below the root, `Vehicle.Chassis`; the root itself for a leaf directly below it."""
    names = path.split(".")
    return ".".join(names[:2] if len(names) > 2 else names[:1])


def service_name(origin: str) -> str:
    """Service of a component or a branch: `Vehicle.Chassis` → `VehicleChassisService`."""
    return short_name(f"{camel_case(origin)}Service")


def distinct(wanted: Mapping[str, str], taken: Iterable[str] = ()) -> dict[str, str]:
    """A name for each key, unlike every other one even where case does not count.

    Of two keys that want the same name, the first in the alphabet has it; the other one's ends in a digest of the key.
    """
    given: dict[str, str] = {}
    used = {name.lower() for name in taken}
    for key in sorted(wanted):
        name = wanted[key]
        if name.lower() in used:
            name = f"{name[: LONGEST_SHORT_NAME - 9]}_{_digest(key)}"
        given[key] = name
        used.add(name.lower())
    return given


def distinct_names(wanted: Sequence[str], taken: Iterable[str] = ()) -> tuple[str, ...]:
    """The names of a list, made distinct: of two equal ones, the first keeps its name."""
    return tuple(distinct({f"{index:06d}": name for index, name in enumerate(wanted)}, taken).values())


def _digest(text: str) -> str:
    return sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:8]
