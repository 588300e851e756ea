"""A function with everything that its adapter has to do."""

from collections.abc import Mapping
from dataclasses import dataclass

from tests.adapter.reference.parts.errors import Error
from tests.adapter.reference.parts.inputs import Input, Queue
from tests.adapter.reference.parts.methods import Method
from tests.adapter.reference.parts.modes import ModeIn, ModeOut
from tests.adapter.reference.parts.parameters import Parameter
from tests.adapter.reference.parts.reactions import Reaction
from tests.adapter.reference.parts.schedule import Timing
from tests.adapter.reference.parts.supervision import AliveLimits, Checkpoint, DeadlineLimits
from tests.adapter.reference.values.transfer import Transfer


@dataclass(frozen=True)
class Output:
    """A signal or queue that a call provides."""

    name: str
    variable: str
    transfer: Transfer
    range_error: str | None = None
    queue: Queue | None = None

    @property
    def places(self) -> int:
        """Number of values that the variable has room for."""
        return self.queue.length if self.queue and self.queue.count_variable else 1


@dataclass(frozen=True)
class Call:
    """A call of the function."""

    name: str
    symbol: str
    run_type: str
    timing: Timing
    before: tuple[str, ...] = ()
    """Functions of the project that run before it."""
    after: tuple[str, ...] = ()
    success: int | None = None
    priority: int = 0
    previous: tuple[str, ...] = ()
    is_alone: bool = False
    """Whether nothing runs at the same time."""
    triggers: frozenset[str] = frozenset()
    """Ports that trigger it."""
    excluding_modes: frozenset[str] = frozenset()
    inputs: tuple[Input, ...] = ()
    outputs: tuple[Output, ...] = ()
    overrun_error: str | None = None
    errors: tuple[str, ...] = ()
    """Errors that it lists."""
    alive: AliveLimits | None = None
    deadline: DeadlineLimits | None = None


@dataclass(frozen=True)
class Function:
    """A function."""

    name: str
    init: tuple[Call, ...]
    steps: tuple[Call, ...]
    """In the order of the file."""
    terminate: tuple[Call, ...]
    ports: Mapping[str, str]
    """Names under which signals are received, by path or name."""
    checkpoints: Mapping[str, Checkpoint]
    errors: tuple[Error, ...]
    """Each after those that it depends on."""
    reactions: tuple[Reaction, ...]
    mode_in: ModeIn | None
    mode_out: ModeOut | None
    methods: tuple[Method, ...]
    parameters: tuple[Parameter, ...]

    @property
    def calls(self) -> tuple[Call, ...]:
        """All calls."""
        return (*self.init, *self.steps, *self.terminate)

    def owner(self, error: str) -> Call | None:
        """The first step that lists an error."""
        return next((step for step in self.steps if error in step.errors), None)
