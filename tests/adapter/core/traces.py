"""Traces: long scripts at random, with values at and beyond limits, and times on, before and after each bound."""

import math
import struct
from collections.abc import Iterator, Sequence
from fractions import Fraction
from random import Random

from tests.adapter.core.script import Line, Script, bits, size
from tests.adapter.core.subject import Item, Leaf, Subject
from tests.adapter.reference.parts.schedule import Timing
from tests.adapter.reference.values.number_format import Number, NumberFormat
from tests.adapter.reference.values.transfer import Element

MS = 10**6
_BITS = {4: (0x7FC01234, 0xFFC00000, 0x80000000, 0x00000001, 0x7F7FFFFF, 0x7F800000, 0xFF800000, 0x807FFFFF),
         8: (0x7FF8000000001234, 0xFFF8000000000000, 1 << 63, 1, 0x7FEFFFFFFFFFFFFF, 0x7FF0000000000000,
             0xFFF0000000000000, 0x47EFFFFFF0000000)}  # fmt: skip
"""NaN, −0.0, denormal, largest and infinite numbers, and what a float just does not hold."""
_USUAL = (0, 1, -1, 0.5, 1.5, 2.5, 3.5, -0.5, -1.5, -2.5, 3, 100, -99.995, 123.45, 250, 1e9, 1e300)


class Tracer:
    """Makes the script of a function."""

    def __init__(self, subject: Subject, seed: int) -> None:
        self._subject, self._random = subject, Random(seed)
        self._tick = subject.plan.clock.tick
        self._leap = 2**29 * self._tick if subject.plan.clock.is_in_ticks else 2**32 * 1000
        self._now = self._started = 0
        self._recent = [0]
        self._durations = _durations(subject, self._tick)
        self._grid = [step.timing for step in subject.function.steps if step.timing.cycle]
        self._spans = sorted(_spans(subject))
        self._written = _written(subject)
        told = {port.name for port in subject.plan.ports if port.tells_of_rejection}
        self._rejectable = {index for index, item in enumerate(subject.ports) if item.c in told}
        lost = {port.name for port in subject.plan.ports if port.tells_of_loss}
        self._losable = {index for index, item in enumerate(subject.ports) if item.c in lost}

    def script(self, lines: int) -> Script:
        """A script of so many lines, or a few more."""
        script = [*self._beginning(self._random.randrange(3))]
        while len(script) < lines:
            script += self._something()
        return script

    def _beginning(self, cycle: int) -> Iterator[Line]:
        for _ in range(self._random.randrange(3)):
            yield from self._store()
        yield ("returns", self._random.choice((0, 0, 0, 3)))
        yield from self._assignments("set")
        yield ("init", int(self._random.random() < 0.8), cycle)
        self._started = self._time()
        yield ("start", self._started)
        if self._subject.ports and self._random.random() < 0.4:
            yield ("receive", len(self._subject.ports) - 1, self._port_value(self._subject.ports[-1]), self._now)

    def _something(self) -> list[Line]:
        kinds = (
            (10, self._drive), (30, self._step), (30, self._reception), (12, self._one_stage), (6, self._supervision),
            (5, self._offer), (5, self._answer), (4, self._set), (6, self._publishing), (3, self._starting),
            (8, self._restart),
        )  # fmt: skip
        (made,) = self._random.choices([kind for _, kind in kinds], [weight for weight, _ in kinds])
        return list(made())

    # -- times ----------------------------------------------------------------------------------------------------

    def _time(self) -> int:
        """A time on a bound, beside it, or anywhere; sometimes one before the last, or one far away."""
        kind = self._random.randrange(100)
        if kind < 45:
            base, span = self._random.choice(self._recent), self._random.choice(self._spans)
            self._now = max(self._now, base + span + self._tick * self._random.choice((-1, 0, 0, 1)))
        elif kind < 75:
            self._now += self._random.choice((0, self._tick, self._whole(MS // 2), MS, 3 * MS, 10 * MS))
        elif kind < 76:
            self._now += self._leap + self._whole(self._random.randrange(100 * MS))
        elif kind < 80:
            return max(self._now - self._random.choice((self._tick, MS)), 0)
        self._recent = [*self._recent[-5:], self._now]
        return self._now

    def _whole(self, span: int) -> int:
        """Whole ticks."""
        return span - span % self._tick

    def _release(self) -> int:
        """The next release of any call, sometimes a little late."""
        self._now = self._upcoming(self._random.choice(self._grid)) + self._random.choice((0, 0, 0, 0, self._tick, MS))
        self._recent = [*self._recent[-5:], self._now]
        return self._now

    def _upcoming(self, timing: Timing) -> int:
        first, cycle = self._started + timing.offset, timing.cycle or MS
        return first if first > self._now else first + ((self._now - first) // cycle + 1) * cycle

    # -- calls ----------------------------------------------------------------------------------------------------

    def _drive(self) -> Iterator[Line]:
        """Everything as it should be for a while: calls are made when they are due."""
        for _ in range(self._random.randrange(20) if self._grid else 0):
            if self._random.random() < 0.5:
                yield from self._reception(self._now)
            t = self._release()
            if self._random.random() < 0.2:
                yield from self._assignments("then")
            for index in range(len(self._subject.calls)):
                yield ("next", t)
                end = t + self._random.choice(self._durations)
                if self._random.random() < 0.1:
                    yield from (("advance", index, t) for _ in range(3))
                    yield ("supervise", end)
                yield ("finish", index, t, end)

    def _step(self) -> Iterator[Line]:
        """Due calls, from their answer to their end."""
        yield ("next", self._time())
        yield from self._assignments("then")
        for index in range(len(self._subject.calls)):
            yield ("finish", index, self._time(), self._time())

    def _one_stage(self) -> Iterator[Line]:
        if self._random.random() < 0.4:
            yield ("next", self._time())
        yield ("advance", self._random.randrange(len(self._subject.calls)), self._time())

    def _assignments(self, word: str) -> Iterator[Line]:
        """Values that the code writes; sometimes also to variables of the adapter."""
        for index, item in enumerate(self._subject.variables):
            elements = self._written.get(item.name)
            if self._random.random() < (0.02 if elements is None else 0.6):
                yield (word, index, self._value(item, elements or ()))

    def _supervision(self) -> Iterator[Line]:
        yield ("supervise", self._time())

    def _publishing(self) -> Iterator[Line]:
        yield ("published",)

    # -- from outside ---------------------------------------------------------------------------------------------

    def _reception(self, t: int | None = None) -> Iterator[Line]:
        """Values of one or more signals; with them often the mode, or whatever else is the last of the list."""
        ports = self._subject.ports
        if not ports:
            return
        some = [self._random.randrange(len(ports)) for _ in range(len(ports) // 8 + 1)]
        for port in [*some, *([len(ports) - 1] if self._random.random() < 0.15 else [])]:
            for _ in range(self._random.choice((1, 1, 1, 2, 4))):
                at = self._time() if t is None else t
                if port in self._rejectable and self._random.random() < 0.4:
                    yield ("reject", port, at)
                elif port in self._losable and self._random.random() < 0.1:
                    yield ("lose", port, at)
                else:
                    yield ("receive", port, self._port_value(ports[port]), at)

    def _port_value(self, item: Item) -> str:
        mode = self._subject.function.mode_in
        if mode and item.name == mode.name:
            return bits(self._random.choice([*mode.numbers, *mode.numbers, *mode.numbers, 99]), item.leaves[0].format)
        if item.transfer is None:
            return bits(self._random.choice((0, 1, 0, 1, 2)), item.leaves[0].format)
        return self._value(item, item.transfer.elements)

    def _offer(self) -> Iterator[Line]:
        if self._subject.offered:
            index = self._random.randrange(len(self._subject.offered))
            yield from self._assignments("then")
            yield ("request", index, self._members(self._subject.offered[index].arguments) or "-")

    def _answer(self) -> Iterator[Line]:
        """Answers to requests that may have been made, some of them twice."""
        for index, method in enumerate(self._subject.used):
            for number in range(self._random.randrange(40)):
                for _ in range(self._random.choice((0, 1, 1, 2))):
                    given = self._members(method.results) or "-"
                    yield ("answer", index, number, int(self._random.random() < 0.8), given, self._now)

    def _members(self, items: Sequence[Item]) -> str:
        return "".join(self._value(item, item.transfer.elements if item.transfer else ()) for item in items)

    def _set(self) -> Iterator[Line]:
        items = [item for item in self._subject.parameters if item.name in self._subject.settable]
        if items:
            yield ("parameters", self._members(items))

    def _store(self) -> Iterator[Line]:
        if self._subject.parameters:
            index = self._random.randrange(len(self._subject.parameters))
            item = self._subject.parameters[index]
            given = self._value(item, item.transfer.elements if item.transfer else ())
            yield ("store", index, "-" if self._random.random() < 0.2 else given)

    # -- restarting -----------------------------------------------------------------------------------------------

    def _starting(self) -> Iterator[Line]:
        """A later Start: at any time, or at the very time of a release after one that was answered."""
        if self._grid and self._random.random() < 0.7:
            t = self._release()
            for index in range(len(self._subject.calls)):
                yield ("next", t)
                yield ("finish", index, t, t)
            self._now = min(self._upcoming(timing) for timing in self._grid)
            yield ("start", self._now)
        else:
            yield ("start", self._time())

    def _restart(self) -> Iterator[Line]:
        """An end of calls that run, perhaps Terminate, perhaps storing, and Init."""
        for index in range(len(self._subject.calls)):
            yield ("finish", index, self._now, self._time())
        for _ in range(self._random.choice((0, 1, 1, 2))):
            yield ("terminate", self._time())
        if self._random.random() < 0.2:
            yield ("start", self._time())
        if self._random.random() < 0.9:
            yield ("keep",)
        self._now, self._recent = self._random.choice(((self._now, self._recent), (0, [0])))
        yield from self._beginning(self._random.randrange(3))

    # -- values ---------------------------------------------------------------------------------------------------

    def _value(self, item: Item, elements: Sequence[Element]) -> str:
        """A value; all of its numbers are usual ones, or one is not."""
        odd = self._random.randrange(len(item.leaves)) if self._random.random() < 0.6 else -1
        known: Sequence[Element | None] = elements or [None] * len(item.leaves)
        return "".join(
            self._number(leaf, known[index % len(known)], is_odd=index == odd) for index, leaf in enumerate(item.leaves)
        )

    def _number(self, leaf: Leaf, element: Element | None, *, is_odd: bool) -> str:
        format_ = leaf.format
        if element is not None and element.names is not None:
            names = list(element.names)
            return bits(self._random.choice([*names, *([names[0] + 1, 77] if is_odd else [])]), format_)
        if format_.is_floating and is_odd and self._random.random() < 0.5:
            return f"{self._random.choice(_BITS[size(format_)]):0{2 * size(format_)}x}"
        if is_odd and element is not None and self._random.random() < 0.7:
            return bits(self._beside_limit(element, format_), format_)
        return bits(self._usual(element, format_), format_)

    def _beside_limit(self, element: Element, format_: NumberFormat) -> Number:
        own = [each for each in (element.least, element.greatest) if each is not None]
        limit = format_.nearest(self._random.choice([*own, *own, *_ends(format_)]))
        step = self._random.choice((-1, 0, 0, 1))
        if not format_.is_floating:
            return _within(int(limit) + step, format_)
        return _beside(float(limit), step, format_)

    def _usual(self, element: Element | None, format_: NumberFormat) -> Number:
        if self._random.random() < 0.15:
            return format_.nearest(Fraction(0))
        low = None if element is None else element.least
        high = None if element is None else element.greatest
        if low is not None and high is not None and self._random.random() < 0.7:
            return format_.nearest(low + (high - low) * Fraction(self._random.randrange(1001), 1000))
        if not format_.is_floating and self._random.random() < 0.3:
            low, high = _ends(format_)
            return self._random.randrange(int(low), int(high) + 1)
        number = self._random.choice(_USUAL) * self._random.choice((1, 1, 0.1, self._random.random()))
        return format_.nearest(Fraction(number))


def _ends(format_: NumberFormat) -> tuple[Fraction, Fraction]:
    return format_.ends


def _within(number: int, format_: NumberFormat) -> int:
    low, high = format_.ends
    return min(max(number, int(low)), int(high))


def _beside(number: float, step: int, format_: NumberFormat) -> float:
    if step == 0 or not math.isfinite(number):
        return number
    if format_.name == "double":
        return math.nextafter(number, math.inf * step)
    (as_bits,) = struct.unpack("i", struct.pack("f", number))
    if number == 0:
        return math.copysign(1.401298464324817e-45, step)
    towards = step if number > 0 else -step
    return float(struct.unpack("f", struct.pack("i", as_bits + towards))[0])


# -- what there is to try -----------------------------------------------------------------------------------------


def _spans(subject: Subject) -> set[int]:
    """All durations of a declaration."""
    found = {0, MS}
    for step in subject.function.steps:
        found |= {step.timing.cycle or MS, step.timing.offset, step.timing.debounce}
        found |= {each.time_out.longest for each in step.inputs if each.time_out}
        found |= {step.alive.window} if step.alive else set()
        found |= {step.deadline.least, step.deadline.most} if step.deadline else set()
    found |= {span for error in subject.function.errors for span in (error.maturation, error.reset)}
    found |= {reaction.time_out.longest for reaction in subject.function.reactions if reaction.time_out}
    return found | {method.time_out for method in subject.function.methods if method.time_out is not None}


def _durations(subject: Subject, tick: int) -> list[int]:
    """Durations of calls: on the limits of a supervision, next to them, or any time."""
    limits = [step.deadline for step in subject.function.steps if step.deadline]
    bounds = [bound + nudge for each in limits for bound in (each.least, each.most) for nudge in (-tick, 0, tick)]
    return [0, 0, MS, 3 * MS, *(bound for bound in bounds if bound >= 0)]


def _written(subject: Subject) -> dict[str, Sequence[Element]]:
    """Variables that the code writes, with what reads them."""
    function = subject.function
    found: dict[str, Sequence[Element]] = {}
    for step in function.steps:
        found |= {output.variable: output.transfer.elements for output in step.outputs}
        queues = [output.queue for output in step.outputs if output.queue]
        found |= {queue.count_variable: (_whole(0, queue.length),) for queue in queues if queue.count_variable}
    found |= {each.variable: each.outgoing.elements for each in function.parameters if each.is_learned}
    found |= {error.variable: (_whole(0, 1),) for error in function.errors if error.variable}
    if function.mode_out:
        codes = function.mode_out.numbers
        found[function.mode_out.variable] = (_whole(min(codes) - 1, max(codes)),)
    for method in function.methods:
        read = method.outputs if method.is_offered else method.inputs
        found |= {argument.variable: argument.transfer.elements for argument in read}
        found |= {method.request_variable: (_whole(0, 1),)} if method.request_variable else {}
    return found


def _whole(low: int, high: int) -> Element:
    """A whole number, usually one of these."""
    format_ = NumberFormat("int32")
    return Element(format_, format_, least=Fraction(low), greatest=Fraction(high))
