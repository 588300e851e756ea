"""Processor time and memory of processes, and the overhead of one over another."""

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
        """Share of one core, as if the drive had been played in real time."""
        return self.cpu / self.drive if self.drive else 0.0


class Overhead(NamedTuple):
    """Additional processor time and memory over code written by hand, as a share: 0.1 is 10 %."""

    cpu: float
    memory: float


def overhead(generated: Load, by_hand: Load) -> Overhead:
    """Return the overhead of generated code over code written by hand."""
    return Overhead(_more(generated.cpu, by_hand.cpu), _more(generated.peak, by_hand.peak))


def _more(figure: float, reference: float) -> float:
    return figure / reference - 1 if reference else 0.0
