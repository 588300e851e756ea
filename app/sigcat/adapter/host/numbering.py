"""Numbers of calls and of kept values in the driver's messages."""

from typing import NamedTuple

from sigcat.adapter.core.plan import Call
from sigcat.adapter.host.connections import Connections, Member, handed_over
from sigcat.adapter.host.kept import Kept, kept_of
from sigcat.adapter.host.shapes import packing


class Numbers(NamedTuple):
    """Numbers of calls and stored values, function by function."""

    calls: tuple[Call | None, ...]
    """Steps, first Init and first Terminate of each function; None where it has none."""
    kept: tuple[Kept, ...]
    counts: tuple[int, ...]
    """Number of entries that each function has in `calls`."""

    def first_call(self, member: int) -> int:
        """The number of the first step of a function."""
        return sum(self.counts[:member])

    def owner(self, call: int) -> int:
        """The function that a call belongs to."""
        return next(index for index in range(len(self.counts)) if call < self.first_call(index + 1))


def numbers_of(connections: Connections) -> Numbers:
    """The numbers of a set of functions."""
    calls = [_calls(member) for member in connections.members]
    each = tuple(call for listed in calls for call in listed)
    return Numbers(each, kept_of(connections.members), tuple(map(len, calls)))


def _calls(member: Member) -> tuple[Call | None, ...]:
    plan = member.plan
    return (*plan.steps, *(next(iter(outer), None) for outer in (plan.inits, plan.terminates)))


def bytes_of_largest(connections: Connections, numbers: Numbers) -> int:
    """Bytes of the largest value that is sent or kept, or handed over with a request."""
    shapes = [*(each.shape for each in connections.exits), *(each.shape for each in numbers.kept)]
    shapes += [shape for member in connections.members for shape in handed_over(member)]
    return max((packing(shape).struct.size for shape in shapes), default=8)
