"""What processes took of a machine, beside what others took for the same."""

from typing import NamedTuple


class Load(NamedTuple):
    """A process, while so many seconds of a drive were played to it."""

    process: str
    cpu: float
    """Seconds of processor time."""
    drive: float
    """Seconds of the drive."""
    peak: int
    """Bytes of memory that it had at most."""
    size: int
    """Bytes of its executable, with the libraries that were generated for it."""

    @property
    def share(self) -> float:
        """Of one core, as if the drive had been played in real time."""
        return self.cpu / self.drive if self.drive else 0.0


class Overhead(NamedTuple):
    """How much more than by hand, as a share: 0.1 is 10 %."""

    cpu: float
    memory: float


def overhead(generated: Load, by_hand: Load) -> Overhead:
    """Of what was generated, over what was written by hand."""
    return Overhead(_more(generated.cpu, by_hand.cpu), _more(generated.peak, by_hand.peak))


def _more(figure: float, reference: float) -> float:
    return figure / reference - 1 if reference else 0.0
