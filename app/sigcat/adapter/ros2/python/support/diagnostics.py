"""What a node tells people and aggregators on /diagnostics. No function listens to it."""

from typing import Dict, Iterable, List, Optional, Tuple

from builtin_interfaces.msg import Time
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue

from .core import Call, CallCounts, Error, ErrorStatus, FAILED, HEALING, NOT_TESTED, PREFAILED

STATES = ('NOT_TESTED', 'PASSED', 'PREFAILED', 'FAILED', 'HEALING')
EVENTS = ('lost', 'skipped', 'deadline missed', 'liveliness lost', 'incompatible QoS')
"""What may become of messages and of a topic's quality of service."""


class TopicCounts:
    """What has happened on a topic."""

    def __init__(self, name: str) -> None:
        """Begin with nothing."""
        self.name = name
        self.messages = 0
        self.events = dict.fromkeys(EVENTS, 0)
        self._rate = 0.0
        self._told_messages = 0
        self._told_events = 0
        self._sequence_number = 0

    def skipped_before(self, sequence_number: Optional[int]) -> int:
        """
        Answer how many messages of the publisher were not taken before this one.

        A queue of the middleware that is full drops the oldest without an event.
        """
        last, self._sequence_number = self._sequence_number, sequence_number or 0
        return max(self._sequence_number - last - 1, 0) if last else 0

    def tick(self, seconds: float) -> None:
        """Note that so much time has passed."""
        self._rate = (self.messages - self._told_messages) / seconds
        self._told_messages = self.messages

    def status(self, node: str) -> DiagnosticStatus:
        """Answer what is to be told of it."""
        events = sum(self.events.values())
        is_worse, self._told_events = events != self._told_events, events
        level = DiagnosticStatus.WARN if is_worse else DiagnosticStatus.OK
        message = 'Messages or promises were lost.' if is_worse else ''
        values = {'messages': str(self.messages), 'rate [Hz]': f'{self._rate:.6f}'}
        values.update((name, str(total)) for name, total in self.events.items())
        return _status(node, self.name, (level, message, values))


class CallTimes:
    """How often a call ran, and how long it took."""

    def __init__(self) -> None:
        """Begin with nothing."""
        self.steps = 0
        self.told_missed = 0
        self._last = {'t_adapter': 0, 't_logic': 0}
        self._longest = {'t_adapter': 0, 't_logic': 0}

    def add(self, adapter: int, logic: int) -> None:
        """Note one step, in nanoseconds."""
        self.steps += 1
        self._last = {'t_adapter': adapter, 't_logic': logic}
        self._longest = {name: max(self._longest[name], t) for name, t in self._last.items()}

    def values(self) -> Dict[str, str]:
        """Answer all of it, times in microseconds."""
        found = {'steps': str(self.steps)}
        for name, t in self._last.items():
            found[f'{name} [us]'] = f'{t / 1000:.6f}'
            found[f'longest {name} [us]'] = f'{self._longest[name] / 1000:.6f}'
        return found


def error_status(node: str, error: Error, status: ErrorStatus) -> DiagnosticStatus:
    """Answer the status of an error."""
    level = DiagnosticStatus.OK
    if status.state == NOT_TESTED:
        level = DiagnosticStatus.STALE
    elif status.state == PREFAILED:
        level = DiagnosticStatus.WARN
    elif status.state in (FAILED, HEALING):
        level = DiagnosticStatus.WARN if error.is_mild else DiagnosticStatus.ERROR
    state = STATES[status.state]
    message = error.description if status.state in (FAILED, HEALING) else state
    values = {
        'state': state,
        'confirmed': 'true' if status.is_confirmed else 'false',
        'occurrences': str(status.occurrences),
        'ignition cycles': str(status.ignition_cycles),
    }
    return _status(node, error.interface, (level, message, values))


def call_status(node: str, call: Call, counts: CallCounts, times: CallTimes) -> DiagnosticStatus:
    """Answer the status of a call."""
    is_late, times.told_missed = counts.missed != times.told_missed, counts.missed
    level = DiagnosticStatus.WARN if is_late else DiagnosticStatus.OK
    message = 'Releases were missed.' if is_late else ''
    values = times.values()
    values.update({'missed': str(counts.missed), 'dropped': str(counts.dropped)})
    return _status(node, call.interface, (level, message, values))


def scheduling_status(node: str, problem: str) -> DiagnosticStatus:
    """Answer the status of the thread that runs the calls."""
    level = DiagnosticStatus.WARN if problem else DiagnosticStatus.OK
    return _status(node, 'scheduling', (level, problem, {}))


def diagnostic_array(stamp: Time, statuses: Iterable[DiagnosticStatus]) -> DiagnosticArray:
    """Answer the message."""
    message = DiagnosticArray()
    message.header.stamp = stamp
    message.status = list(statuses)
    return message


def _status(
    node: str, what: str, told: Tuple[bytes, str, Dict[str, str]]
) -> DiagnosticStatus:
    level, message, values = told
    pairs: List[KeyValue] = [KeyValue(key=key, value=value) for key, value in values.items()]
    return DiagnosticStatus(
        level=level, name=f'{node}: {what}', message=message, hardware_id=node, values=pairs
    )
