"""The adapter of a function: the functions of the table in docs/reference/adapter.md, by the same names."""

from collections.abc import Mapping

from tests.adapter.reference import life, receiving, scheduling, stepping
from tests.adapter.reference.function import Function
from tests.adapter.reference.parts.methods import Answer, Reply
from tests.adapter.reference.running import Code, Running, Stored, Variables
from tests.adapter.reference.values.value import Value


class Adapter:
    """An adapter. Times are in ns; what is received and sent is in the catalogue's unit and datatype."""

    def __init__(self, function: Function, code: Code, variables: Variables, *, follows_clock: bool = False) -> None:
        self.function, self._code, self._variables = function, code, variables
        self._follows_clock = follows_clock
        self.running = Running(function, code, variables, Stored(), follows_clock=follows_clock)
        """All that it knows: for tests, and for who wants to see inside."""

    @property
    def out(self) -> Mapping[str, Value]:
        """Sent values, by the names of interfaces."""
        return self.running.out

    @property
    def publish(self) -> frozenset[str]:
        """Names of the values to send, including requests of methods."""
        return frozenset(self.running.publish)

    @property
    def stored(self) -> Stored:
        """Values that the platform stores."""
        return self.running.stored

    def init(self, stored: Stored | None = None, ignition_cycle: int = 0) -> bool:
        """Initialize, also again; return whether this was successful."""
        kept = life.in_cycle(stored, ignition_cycle)
        self.running = Running(self.function, self._code, self._variables, kept, follows_clock=self._follows_clock)
        return life.init(self.running)

    def start(self, t: int) -> None:
        """The platform lets the function run."""
        life.start(self.running, t)

    def terminate(self, t: int) -> None:
        """End; nothing the second time."""
        life.terminate(self.running, t)

    def receive(self, port: str, value: Value, t: int) -> None:
        """A signal, an error of others, a reaction or a mode has come."""
        receiving.receive(self.running, port, value, t)

    def reject(self, port: str, t: int) -> None:
        """A message of a signal has come that is not accepted."""
        receiving.reject(self.running, port, t)

    def lose(self, port: str, t: int) -> None:
        """The platform has lost values of a queue."""
        receiving.lose(self.running, port, t)

    def next_call(self, t: int) -> str | None:
        """The call that is due; None if none is."""
        return scheduling.next_call(self.running, t)

    def next_time(self) -> int:
        """When to ask again."""
        return scheduling.next_time(self.running)

    def set_input(self, call: str, t: int) -> None:
        """Take the snapshot of a call that was due."""
        stepping.set_input(self.running, call, t)

    def begin(self, call: str, t: int) -> None:
        """Right before the call."""
        stepping.begin(self.running, call, t)

    def run(self, call: str) -> None:
        """The call itself."""
        self.running.execute(self.running.calls[call].call)

    def get_output(self, call: str, t: int) -> None:
        """The call has ended."""
        stepping.get_output(self.running, call, t)

    def supervise(self, t: int) -> None:
        """Look after calls that hang or never come."""
        stepping.supervise(self.running, t)

    def published(self) -> None:
        """Note that new values have been sent."""
        self.running.publish.clear()

    def method(self, name: str, arguments: tuple[Value, ...] = ()) -> tuple[Reply, tuple[Value, ...]]:
        """A request to the function: what became of it, and the results."""
        return receiving.method(self.running, name, arguments)

    def answer(self, name: str, number: int, results: tuple[Value, ...], t: int, *, is_ok: bool = True) -> None:
        """An answer to a request of the function."""
        self.running.tick(t)
        self.running.slots[name].receive(number, Answer(is_ok, results))

    def set_parameters(self, values: Mapping[str, Value]) -> bool:
        """Take new values of parameters, all or none."""
        return receiving.set_parameters(self.running, values)
