"""An adapter while it runs: all that it knows."""

from collections.abc import Callable, Iterable, MutableMapping
from dataclasses import dataclass, field

from tests.adapter.reference.call_state import CallState
from tests.adapter.reference.causes import Cause, cause_of_parameter, causes_of_call, causes_of_graph, causes_of_mode
from tests.adapter.reference.diagnosis import Diagnosis
from tests.adapter.reference.function import Call, Function
from tests.adapter.reference.parts.errors import Counts, Error
from tests.adapter.reference.parts.methods import Slot
from tests.adapter.reference.parts.modes import Mode
from tests.adapter.reference.parts.parameters import ParameterState
from tests.adapter.reference.parts.supervision import Graph
from tests.adapter.reference.values.value import Value

Variables = MutableMapping[str, Value]
"""Variables of the code, by their expressions in C."""
Code = Callable[[str, Variables], int | None]
"""The code of the function: does what the C function of a name does to the variables, and gives its result."""


@dataclass
class Stored:
    """Values that stay after a run."""

    ignition_cycle: int | None = None
    parameters: dict[str, Value] = field(default_factory=dict)
    """In the catalogue's unit and datatype."""
    errors: dict[str, Counts] = field(default_factory=dict)


@dataclass
class Running:
    """A run, from an Init to the next one."""

    function: Function
    code: Code
    variables: Variables
    stored: Stored
    now: int = 0
    is_good: bool = False
    """Whether Init was good and Terminate has not been called."""
    has_started: bool = False
    follows_clock: bool = False
    """Whether it takes times before the start too: ticks wrap around."""
    out: dict[str, Value] = field(default_factory=dict)
    publish: set[str] = field(default_factory=set)
    mode_out: int | None = None
    """Return the sent value of the mode that the function is in; None while it has no name."""

    def __post_init__(self) -> None:
        self.mode = Mode(self.function.mode_in)
        self.graph = Graph(self.function.checkpoints)
        self.calls = {call.name: CallState(call) for call in self.function.calls}
        self.parameters = {each.name: ParameterState(each) for each in self.function.parameters}
        self.slots = {each.name: Slot(each) for each in self.function.methods if not each.is_offered}
        self.diagnosis = Diagnosis(self.function, self.stored.errors, self._causes(), self.is_reset)
        for call in self.steps:
            call.is_excluded = self.mode.current in call.call.excluding_modes

    @property
    def steps(self) -> list[CallState]:
        """The steps, in the order of the file."""
        return [self.calls[call.name] for call in self.function.steps]

    def _causes(self) -> dict[str, list[Cause]]:
        causes = [cause for call in self.steps for cause in causes_of_call(call)]
        causes += [*causes_of_mode(self.mode), *causes_of_graph(self.graph)]
        causes += [cause_of_parameter(each) for each in self.parameters.values()]
        by_error: dict[str, list[Cause]] = {}
        for cause in causes:
            if cause.error is not None:
                by_error.setdefault(cause.error, []).append(cause)
        return by_error

    def tick(self, t: int) -> int:
        """The time that counts: it does not go back."""
        self.now = max(self.now, t)
        return self.now

    def close_windows(self, t: int) -> None:
        """Close the windows of supervision that are over."""
        for call in self.steps:
            if call.alive:
                call.alive.close(t)

    def write(self, variable: str | None, value: Value) -> None:
        """Write a variable of the code, if there is one."""
        if variable is not None:
            self.variables[variable] = value

    def execute(self, call: Call) -> int | None:
        """Call the code, with its pre- and post-processing."""
        for name in call.before:
            self.code(name, self.variables)
        result = self.code(call.symbol, self.variables)
        for name in call.after:
            self.code(name, self.variables)
        return result

    def evaluate(self, errors: Iterable[Error], t: int) -> None:
        """Evaluate errors, and send what changes."""
        for error in list(errors):
            before = self.diagnosis.sent.get(error.name)
            self.diagnosis.evaluate(error, t)
            now = self.diagnosis.sent.get(error.name)
            if now is not None and now != before:
                self.out[error.name] = now
                self.publish.add(error.name)

    def is_reset(self, error: Error) -> bool:
        """Whether the input that an error waits for is set; true if it waits for none."""
        if error.reset_input is None:
            return True
        owner = self.function.owner(error.name)
        calls = [*([self.calls[owner.name]] if owner else []), *self.steps]
        inputs = (each for call in calls for each in call.inputs if error.reset_input in each.input.names)
        found = next(inputs, None)
        return found is not None and found.is_set
