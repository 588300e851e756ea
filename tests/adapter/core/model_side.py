"""A script, done by the adapter in Python: it prints what the program prints."""

import copy
import math
from collections.abc import Iterator

from sigcat.adapter.core.plan import GLOBALS
from tests.adapter.core.script import Line, Script, bits, text, value
from tests.adapter.core.subject import Item, Subject
from tests.adapter.reference.adapter import Adapter
from tests.adapter.reference.parts.errors import Counts, is_confirmed
from tests.adapter.reference.parts.methods import Reply
from tests.adapter.reference.running import Stored, Variables
from tests.adapter.reference.values.value import Value, numbers_of

FURTHEST = 2**29
"""Ticks until the next time of a core that counts them, at most."""
_STAGES = ["NOT_TESTED", "PASSED", "PREFAILED", "FAILED", "HEALING"]
_REPLIES = [Reply.OK, Reply.EXCLUDED, Reply.BAD_ARGUMENT]


def run(subject: Subject, script: Script) -> list[str]:
    """Return the output of a script: for each line the inputs and answers of the calls, and then the state."""
    return [line for each in ModelSide(subject).run(script) for line in each]


class ModelSide:
    """An adapter with code that does what a script says."""

    def __init__(self, subject: Subject) -> None:
        self._subject = subject
        self._variables: Variables = {item.name: numbers_zero(item) for item in subject.variables}
        follows_clock = subject.plan.clock.is_in_ticks
        self._adapter = Adapter(subject.function, self._work, self._variables, follows_clock=follows_clock)
        self._kept = Stored()
        self._stages = [0] * len(subject.calls)
        self._pending: list[tuple[int, str]] = []
        self._result = 0
        self._printed: list[str] = []
        self._texts: dict[str, tuple[Value | None, str]] = {}
        """The values shown last, and their form: most values stay from one line to the next."""

    def run(self, script: Script) -> Iterator[list[str]]:
        """Output of each line."""
        for line in script:
            self._printed = []
            self._execute(line)
            yield [*self._printed, self._state()]

    def _work(self, symbol: str, variables: Variables) -> int | None:
        self._printed.append(f"code {symbol}{self._seen()}")
        for index, given in self._pending:
            self._assign(index, given)
        self._pending = []
        is_init = any(call.symbol == symbol and call.success is not None for call in self._subject.function.calls)
        return self._result if is_init else None

    def _assign(self, index: int, given: str) -> None:
        item = self._subject.variables[index]
        self._variables[item.name] = value(given, item.leaves, is_single=item.is_single)

    # -- lines ----------------------------------------------------------------------------------------------------

    def _execute(self, line: Line) -> None:
        word, *rest = line
        if word in ("init", "terminate", "request") and any(self._stages):
            return
        getattr(self, f"_{word}")(*rest)

    def _receive(self, port: int, given: str, t: int) -> None:
        item = self._subject.ports[port]
        self._adapter.receive(item.name, value(given, item.leaves, is_single=item.is_single), t)

    def _reject(self, port: int, t: int) -> None:
        self._adapter.reject(self._subject.ports[port].name, t)

    def _lose(self, port: int, t: int) -> None:
        self._adapter.lose(self._subject.ports[port].name, t)

    def _next(self, t: int) -> None:
        call = self._adapter.next_call(t)
        names = [name for name, _ in self._subject.calls]
        index = -1 if call is None else names.index(call)
        self._printed.append(f"call={index + 1}")
        if call is not None:
            self._stages[index] = 1

    def _advance(self, index: int, t: int) -> None:
        name, stage = self._subject.calls[index][0], self._stages[index]
        self._stages[index] = (stage + 1) % 5 if stage else 0
        if stage == 1:
            self._adapter.set_input(name, t)
        elif stage == 2:
            self._adapter.begin(name, t)
        elif stage == 3:
            self._adapter.run(name)
        elif stage == 4:
            self._adapter.get_output(name, t)

    def _finish(self, index: int, begin: int, end: int) -> None:
        while self._stages[index]:
            self._advance(index, end if self._stages[index] == 4 else begin)

    def _set(self, index: int, given: str) -> None:
        self._assign(index, given)

    def _then(self, index: int, given: str) -> None:
        self._pending.append((index, given))

    def _returns(self, result: int) -> None:
        self._result = result

    def _supervise(self, t: int) -> None:
        self._adapter.supervise(t)

    def _published(self) -> None:
        self._adapter.published()

    def _start(self, t: int) -> None:
        self._adapter.start(t)

    def _terminate(self, t: int) -> None:
        self._adapter.terminate(t)

    def _keep(self) -> None:
        self._kept = copy.deepcopy(self._adapter.stored)

    def _store(self, index: int, given: str) -> None:
        item = self._subject.parameters[index]
        self._kept.parameters.pop(item.name, None)
        if given != "-":
            self._kept.parameters[item.name] = value(given, item.leaves, is_single=item.is_single)

    def _parameters(self, given: str) -> None:
        values: dict[str, Value] = {}
        for item in (each for each in self._subject.parameters if each.name in self._subject.settable):
            length = len(text(numbers_zero(item), item.leaves))
            values[item.name] = value(given[:length], item.leaves, is_single=item.is_single)
            given = given[length:]
        if values:
            self._printed.append(f"set={int(self._adapter.set_parameters(values))}")

    def _init(self, is_kept: int, cycle: int) -> None:
        if self._subject.signature != GLOBALS:
            self._variables.update({item.name: numbers_zero(item) for item in self._subject.variables})
        good = self._adapter.init(copy.deepcopy(self._kept) if is_kept else None, cycle)
        self._printed.append(f"good={int(good)}")

    def _request(self, index: int, given: str) -> None:
        method = self._subject.offered[index]
        reply, results = self._adapter.method(method.name, tuple(_values(method.arguments, given)))
        pairs = zip(method.results, results, strict=False)
        shown = "".join(f" {item.name}={text(each, item.leaves)}" for item, each in pairs)
        self._printed.append(f"reply={_REPLIES.index(reply)}{shown}")

    def _answer(self, index: int, number: int, is_ok: int, given: str, t: int) -> None:
        method = self._subject.used[index]
        results = tuple(_values(method.results, given))
        self._adapter.answer(method.name, number, results, t, is_ok=bool(is_ok))

    # -- what can be seen -----------------------------------------------------------------------------------------

    def _seen(self) -> str:
        items = self._subject.variables
        return "".join(f" {item.name}={self._shown(item.name, self._variables[item.name], item)}" for item in items)

    def _shown(self, label: str, given: Value | None, item: Item, *, is_sent: bool = False) -> str:
        known = self._texts.get(label)
        if known is None or known[0] is not given:
            known = given, _all_sent(given, item) if is_sent or given is None else _all_seen(given, item)
            self._texts[label] = known
        return known[1]

    def _state(self) -> str:
        adapter = self._adapter
        parts = [f"now={adapter.running.now} next={self._next_time()}{self._seen()}"]
        parts += [self._sent(item, f"out.{item.name}", adapter.out.get(item.name)) for item in self._subject.outs]
        parts += [self._error(name) for name, _ in self._subject.errors]
        for name, _ in self._subject.calls:
            counts = adapter.running.calls[name].activations
            parts.append(f"{name}:{counts.missed},{counts.dropped}")
        stored = adapter.stored.parameters
        parts += [
            f"stored.{item.name}={_all_seen(stored[item.name], item)}"
            for item in self._subject.parameters
            if item.name in stored
        ]
        parts += [part for method in self._subject.used for part in self._request_of(method.name, method.arguments)]
        return " ".join(parts)

    def _next_time(self) -> int:
        """The next time; in ticks, which have no order, it is neither over nor far away."""
        found, now, clock = self._adapter.next_time(), self._adapter.running.now, self._subject.plan.clock
        return min(max(found, now), now + FURTHEST * clock.tick) if clock.is_in_ticks else found

    def _sent(self, item: Item, label: str, given: Value | None) -> str:
        return f"{label}={self._shown(label, given, item, is_sent=True)}" + (
            "!" if item.name in self._adapter.publish else ""
        )

    def _error(self, name: str) -> str:
        running = self._adapter.running
        counts = self._adapter.stored.errors.get(name, Counts())
        error = next(each for each in self._subject.function.errors if each.name == name)
        stage = _STAGES.index(running.diagnosis.states[name].stage.value)
        return f"{name}:{stage},{counts.occurrences},{counts.ignitions},{int(is_confirmed(counts, error))}"

    def _request_of(self, name: str, arguments: tuple[Item, ...]) -> Iterator[str]:
        slot = self._adapter.running.slots[name]
        shown = f"{name}:{slot.number}"
        given = slot.arguments or tuple(numbers_zero(item) for item in arguments)
        for item, each in zip(arguments, given, strict=True):
            shown += f" {name}.{item.name}={text(each, item.leaves)}"
        yield shown + ("!" if name in self._adapter.publish else "")


def _all_seen(given: Value, item: Item) -> str:
    """Bits, but one NaN is as good as another."""
    numbers = zip(numbers_of(given), item.leaves, strict=True)
    return "".join("nan" if math.isnan(each) else bits(each, leaf.format) for each, leaf in numbers)


def _all_sent(given: Value | None, item: Item) -> str:
    """Bits; of a queue, how many values and then all of them."""
    if not item.length:
        return text(numbers_zero(item) if given is None else given, item.leaves)
    numbers = () if given is None else numbers_of(given)
    count = len(numbers) // len(item.leaves)
    return f"{count}:{text(numbers, item.leaves * count)}"


def numbers_zero(item: Item) -> Value:
    """A value of zeros."""
    return 0 if item.is_single else tuple(0 for _ in item.leaves)


def _values(items: tuple[Item, ...], given: str) -> Iterator[Value]:
    for item in items:
        length = len(text(numbers_zero(item), item.leaves))
        yield value(given[:length], item.leaves, is_single=item.is_single)
        given = given[length:]
