"""A call while the adapter runs."""

from dataclasses import dataclass, field

from tests.adapter.reference.function import Call
from tests.adapter.reference.outputs import OutputState
from tests.adapter.reference.parts.inputs import InputState
from tests.adapter.reference.parts.schedule import Activations
from tests.adapter.reference.parts.supervision import Alive, Deadline
from tests.adapter.reference.values.value import Value


@dataclass
class CallState:
    """State of a call."""

    call: Call
    is_excluded: bool = False
    """Whether the mode excludes it."""
    has_ended: bool = False
    """Whether it has ended once since the first Start."""
    outputs: dict[str, OutputState] = field(default_factory=dict)
    inputs: tuple[InputState, ...] = ()
    activations: Activations = field(init=False)
    alive: Alive | None = None
    deadline: Deadline | None = None

    def __post_init__(self) -> None:
        self.inputs = tuple(InputState(each) for each in self.call.inputs)
        self.outputs = {each.name: OutputState(each) for each in self.call.outputs}
        self.activations = Activations(self.call.timing)
        self.alive = Alive(self.call.alive) if self.call.alive else None
        self.deadline = Deadline(self.call.deadline) if self.call.deadline else None

    def receive(self, port: str, value: Value, t: int) -> None:
        """A value came."""
        for each in self.inputs:
            if each.input.port == port:
                each.receive(value, t)
        if port in self.call.triggers:
            self.activations.trigger()

    def reject(self, port: str) -> None:
        """A message came that is not accepted."""
        for each in self.inputs:
            if each.input.port == port:
                each.reject()

    def lose(self, port: str) -> None:
        """Values were lost before they came."""
        for each in self.inputs:
            if each.input.port == port:
                each.lose()

    def start(self, t: int) -> None:
        """The first Start."""
        self.activations.start(t)
        self.restart(t)
        if self.alive and not self.is_excluded:
            self.alive.begin(t + self.call.timing.offset)

    def restart(self, t: int) -> None:
        """Restart clocks and windows."""
        for each in self.inputs:
            if each.clock:
                each.clock.restart(t)
        if self.alive and not self.is_excluded:
            self.alive.stop()
            self.alive.begin(t)

    def drop(self, t: int) -> None:
        """Drop due calls up to a time, with the values that they would have taken."""
        self.activations.drop(t)
        for each in self.inputs:
            if each.input.queue and each.input.port in self.call.triggers:
                each.waiting.clear()

    def exclude(self, t: int) -> None:
        """The mode excludes it."""
        self.is_excluded = True
        if self.alive:
            self.alive.stop()
        self.drop(t)
