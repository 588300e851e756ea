"""A function's adapter, driven as a platform would."""

from collections import defaultdict
from collections.abc import Callable
from typing import Any

from sigcat.function.function_json.model import FunctionJson
from tests.adapter.reference.adapter import Adapter
from tests.adapter.reference.parts.errors import Stage
from tests.adapter.reference.reading.read import read
from tests.adapter.reference.running import Variables
from tests.adapter.reference.values.value import Value

MS = 10**6


class Driven:
    """An adapter, and code that does what a test says. Times of its methods are in ms."""

    def __init__(self, document: FunctionJson, **code: Callable[[Variables], int | None] | None) -> None:
        self.variables: dict[str, Value] = defaultdict(int)
        self.called: list[str] = []
        self.seen: list[dict[str, Value]] = []
        """Return the variables in each call of a step."""
        self._code = code
        self.adapter = Adapter(read(document), self._call, self.variables)

    def _call(self, symbol: str, variables: Variables) -> int | None:
        self.called.append(symbol)
        self.seen.append(dict(variables))
        does = self._code.get(symbol)
        return does(variables) if does else None

    def start(self, t: float = 0, **init: Any) -> "Driven":
        """Init and Start."""
        assert self.adapter.init(**init)
        self.adapter.start(_ns(t))
        return self

    def receive(self, port: str, value: Value, t: float) -> None:
        """A value comes."""
        self.adapter.receive(port, value, _ns(t))

    def step(self, t: float, until: float | None = None) -> str | None:
        """Make the call that is due, if one is; it ends at once, or at another time."""
        call = self.adapter.next_call(_ns(t))
        if call is not None:
            self.make(call, t, until)
        return call

    def due(self, t: float) -> str:
        """The call that is due."""
        call = self.adapter.next_call(_ns(t))
        assert call is not None
        return call

    def make(self, call: str, t: float, until: float | None = None) -> None:
        """Make a call that was answered."""
        self.adapter.set_input(call, _ns(t))
        self.adapter.begin(call, _ns(t))
        self.adapter.run(call)
        self.adapter.get_output(call, _ns(t if until is None else until))

    def steps(self, *times: float) -> None:
        """Make a call at each of these times."""
        for t in times:
            assert self.step(t) is not None, t

    def stage(self, error: str) -> Stage:
        """The state of an error."""
        return self.adapter.running.diagnosis.states[error].stage

    def published(self) -> set[str]:
        """Return the values to send; they count as sent."""
        names = set(self.adapter.publish)
        self.adapter.published()
        return names


def _ns(t: float) -> int:
    return round(t * MS)
