"""Comparison of the values that two platforms sent: every bit of every value, or aligned by time.

In lock step both have the same times: the values sent at a time under a name are equal, or differ. In free run each
call begins when its platform gets to it. A value is then a little early or late, and its call may have seen an input
that the other call has not: values are aligned in their order, and each difference is explained.
"""

import json
import math
import struct
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.comparison.report.model import Aligned, Difference, Kind, Output

Sent = Mapping[str, Sequence[tuple[int, str]]]
"""Values that were sent, by name: times in ns and values as text."""


class Behaviour(NamedTuple):
    """All names."""

    outputs: tuple[Output, ...]

    @property
    def values(self) -> int:
        """Number of values that were compared."""
        return sum(each.values for each in self.outputs)

    @property
    def wrong(self) -> int:
        """Number of values that are not equal."""
        return sum(each.wrong for each in self.outputs)

    @property
    def is_equal(self) -> bool:
        """Whether something was compared, and every bit is the same."""
        return bool(self.values) and not self.wrong


def in_lock_step(expected: Sent, found: Sent, ignored: Iterable[str] = (), fields: Iterable[str] = ()) -> Behaviour:
    """Each time of each name, but of those that a platform does not carry. The first value of a field may be there earlier."""
    names, with_value = sorted({*expected, *found} - set(ignored)), set(fields)
    return Behaviour(
        tuple(_output(name, expected.get(name, ()), found.get(name, ()), name in with_value) for name in names)
    )


def _output(name: str, expected: Sequence[tuple[int, str]], found: Sequence[tuple[int, str]], is_field: bool) -> Output:
    if is_field and _is_early(expected, found):
        later = _output(name, expected, [expected[0], *found[1:]], False)
        return later.model_copy(update={"early": 1})
    if is_field and _is_beginning(expected, found):
        later = _output(name, expected, found[1:], False)
        return later.model_copy(update={"early": 1})
    if list(expected) == list(found):
        return Output(name=name, values=len(expected), wrong=0)
    differences = list(_differences(expected, found))
    values = sum(max(len(a), len(b)) for _, a, b in _at_each_time(expected, found))
    return Output(name=name, values=values, wrong=len(differences), first=next(iter(differences), None))


def _is_early(expected: Sequence[tuple[int, str]], found: Sequence[tuple[int, str]]) -> bool:
    """Whether the first value is the same, and was there before its time."""
    return bool(expected and found) and found[0][0] < expected[0][0] and found[0][1] == expected[0][1]


def _is_beginning(expected: Sequence[tuple[int, str]], found: Sequence[tuple[int, str]]) -> bool:
    """Whether the first value is that of a field before its first verdict: a protected field is sent from the beginning."""
    return bool(found) and (not expected or (found[0][0] <= expected[0][0] and found[0][1] != expected[0][1]))


def _differences(expected: Sequence[tuple[int, str]], found: Sequence[tuple[int, str]]) -> Iterator[Difference]:
    """In order of time. At one time there may be several values, in their order."""
    for time, a, b in _at_each_time(expected, found):
        yield from (_difference(time, "other", x, y) for x, y in zip(a, b, strict=False) if bits_of(x) != bits_of(y))
        yield from (_difference(time, "missing", x, "") for x in a[len(b) :])
        yield from (_difference(time, "extra", "", y) for y in b[len(a) :])


def _at_each_time(
    expected: Sequence[tuple[int, str]], found: Sequence[tuple[int, str]]
) -> Iterator[tuple[int, list[str], list[str]]]:
    ours, theirs = _by_time(expected), _by_time(found)
    yield from ((time, ours.get(time, []), theirs.get(time, [])) for time in sorted({*ours, *theirs}))


def _difference(time: int, kind: Kind, expected: str, found: str) -> Difference:
    return Difference(time=time, kind=kind, expected=expected, found=found)


def _by_time(values: Iterable[tuple[int, str]]) -> dict[int, list[str]]:
    found: dict[int, list[str]] = {}
    for time, value in values:
        found.setdefault(time, []).append(value)
    return found


def bits_of(text: str) -> object:
    """Return what equal values have in common, however they are spelled: the bits of a number, else the text."""
    try:
        value = json.loads(_SPELLED.get(text, text))
    except ValueError:
        return text
    return _bits(value)


_SPELLED = {"nan": "NaN", "inf": "Infinity", "-inf": "-Infinity"}


def _bits(value: object) -> object:
    if isinstance(value, list):
        return tuple(_bits(each) for each in value)
    if isinstance(value, bool) or not isinstance(value, int | float):
        return value if not isinstance(value, dict) else tuple((name, _bits(each)) for name, each in value.items())
    if isinstance(value, int) and abs(value) > 2**53:
        return value
    return struct.pack("<d", math.nan if math.isnan(value) else value)


# -- points of an importer ----------------------------------------------------------------------------------------


def at_points(expected: Sent, found: Sent, points: Sequence[int]) -> tuple[Sent, Sent]:
    """Both as seen at points of time: what was sent before each, where one of both has changed.

    `found` has the changes of a platform whose outputs have values from the beginning. They count from the first one of `expected` on.
    """
    names = expected.keys() & found.keys()
    seen = {name: list(_at_points(expected[name], found[name], points)) for name in names}
    ours = {name: [(time, value) for time, value, _ in each] for name, each in seen.items()}
    theirs = {name: [(time, value) for time, _, value in each] for name, each in seen.items()}
    return {**expected, **ours}, theirs


def _at_points(
    expected: Sequence[tuple[int, str]], found: Sequence[tuple[int, str]], points: Sequence[int]
) -> Iterator[tuple[int, str, str]]:
    ours, theirs = [time for time, _ in expected], [time for time, _ in found]
    before: tuple[str, str] | None = None
    for point in points:
        index, other = bisect_left(ours, point), bisect_right(theirs, point)
        both = (expected[index - 1][1], found[other - 1][1] if other else "") if index else before
        if both is not None and both != before:
            yield point, *both
        before = both


# -- free run -----------------------------------------------------------------------------------------------------


def in_free_run(expected: Sent, found: Sent, cycle: int, ignored: Iterable[str] = ()) -> tuple[Aligned, ...]:
    """Each name that both have sent, aligned by its times; a value may be two `cycle`s, in ns, from its place."""
    names = sorted(({*expected} & {*found}) - set(ignored))
    return tuple(_aligned(name, expected[name], found[name], cycle) for name in names)


def _aligned(name: str, expected: Sequence[tuple[int, str]], found: Sequence[tuple[int, str]], cycle: int) -> Aligned:
    ours, theirs = [bits_of(value) for _, value in expected], [bits_of(value) for _, value in found]
    late: list[int] = []
    shifted = other = at = 0
    for index, (time, _) in enumerate(found):
        while at + 1 < len(expected) and abs(expected[at + 1][0] - time) <= abs(expected[at][0] - time):
            at += 1
        if ours and ours[at] == theirs[index]:
            late.append(time - expected[at][0])
        elif theirs[index] in _near(expected, ours, at, time, cycle):
            shifted += 1
        else:
            other += 1
    late.sort()
    p50, worst = (late[len(late) // 2], max(late, key=abs)) if late else (0, 0)
    return Aligned(
        name=name, values=len(found), same=len(late), shifted=shifted, other=other, lost=len(expected) - len(found),
        p50_late=p50, worst_late=worst,
    )  # fmt: skip


def _near(
    expected: Sequence[tuple[int, str]], ours: Sequence[object], at: int, time: int, cycle: int
) -> Iterator[object]:
    """Yield values sent within two cycles before or after a time, at most two values away from the nearest."""
    for index in range(max(0, at - 2), min(len(expected), at + 3)):
        if abs(expected[index][0] - time) <= 2 * cycle:
            yield ours[index]


# -- changes ------------------------------------------------------------------------------------------------------


class Change(NamedTuple):
    """A status that became another one, at a time in ns."""

    time: int
    name: str
    value: str


def changes(sent: Sent, names: Iterable[str]) -> tuple[Change, ...]:
    """Return changes of errors, safety reactions and modes, in order of time: the visible effects of a fault."""
    found: list[Change] = []
    for name in names:
        before: str | None = None
        for time, value in sent.get(name, ()):
            if value != before:
                found.append(Change(time, name, value))
            before = value
    return tuple(sorted(found))
