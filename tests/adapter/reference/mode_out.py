"""The mode that the function reports (section 8)."""

from tests.adapter.reference.running import Running
from tests.adapter.reference.values.value import numbers_of


def read_mode_out(running: Running) -> None:
    """Read it, and send it if it has changed and has a name."""
    declared = running.function.mode_out
    if declared is None:
        return
    sent = declared.numbers.get(int(numbers_of(running.variables[declared.variable])[0]))
    if sent is None or sent == running.mode_out:
        return
    running.mode_out = running.out[declared.name] = sent
    if running.has_started:
        running.publish.add(declared.name)
