"""Check a set of functions against vehicles: a signal that a call needs may not be in all of them."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache

from sigcat import codes
from sigcat.catalogue.hosting.vehicles import Composed
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors
from sigcat.function.node_uses import NodeUse, uses_of
from sigcat.function.sets.check_set import check_functions, read_set

_FIX = "Add it to the vehicle, or do not check this function for the vehicle."
_MOST_CALLS = 3
"""Calls that a message names."""


def findings_in_vehicles(
    files: Sequence[tuple[bytes, str]], base: Catalogue, known: Sequence[Finding], vehicles: Iterable[Composed]
) -> Iterator[Finding]:
    """Yield the findings of functions in each vehicle that are not `known`, which are those over `base`.

    Raises InputRefused for a vehicle with errors.
    """
    before = frozenset(known)
    uses = cache(lambda: _uses_by_path(files, base))
    lacking: dict[Finding, list[str]] = {}
    for vehicle, catalogue, _ in vehicles:
        if has_errors(catalogue.findings):
            raise InputRefused(f"{vehicle.label} has errors; no function was checked in it", catalogue.findings)
        for finding in check_functions(files, catalogue, is_whole=len(files) > 1):
            if finding.rule == codes.OPTIONAL_SIGNAL_ABSENT.id:
                lacking.setdefault(finding, []).append(vehicle.name)
            elif finding not in before:
                yield _with_vehicle(finding, vehicle.name, base, uses)
    yield from (_lacked(finding, names) for finding, names in lacking.items())


def _lacked(finding: Finding, vehicles: Sequence[str]) -> Finding:
    """Return the note about an optional signal with all vehicles that do not have it."""
    *others, last = map(repr, vehicles)
    which = f"Vehicles {', '.join(others)} and {last} have" if others else f"Vehicle {last} has"
    return finding._replace(message=f"{which} no {finding.path!r}. It is optional: the function runs without it.")


def _uses_by_path(files: Sequence[tuple[bytes, str]], base: Catalogue) -> Mapping[str, Sequence[NodeUse]]:
    members, _ = read_set(files, base)
    found: dict[str, list[NodeUse]] = {}
    for member in members:
        if member.resolved is not None:
            for use in uses_of(member.document.name, member.resolved.function):
                found.setdefault(use.path, []).append(use)
    return found


def _with_vehicle(
    finding: Finding, vehicle: str, base: Catalogue, uses: Callable[[], Mapping[str, Sequence[NodeUse]]]
) -> Finding:
    """Return the finding with the vehicle, and of a signal that it does not have, with the calls that need it."""
    is_absent = finding.rule == codes.SIGNAL_UNKNOWN.id and base.get(finding.path) is not None
    if not is_absent:
        return finding._replace(message=f"In vehicle {vehicle!r}: {finding.message}")
    needing = [use for use in uses().get(finding.path, ()) if use.function_id == finding.file]
    calls = " and ".join(dict.fromkeys(f"{use.call} {use.verb}" for use in needing[:_MOST_CALLS]))
    which = f", which {calls}" if calls else ""
    return finding._replace(message=f"Vehicle {vehicle!r} has no {finding.path!r}{which}.", fix=_FIX)
