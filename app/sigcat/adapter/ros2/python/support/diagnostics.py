"""Diagnostics on /diagnostics, for people and aggregators. No function subscribes to it."""

from time import monotonic, monotonic_ns
from typing import Callable, Dict, Iterable, List, Optional, Tuple

from builtin_interfaces.msg import Time
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue

from .core import Call, CallCounts, Error, ErrorStatus, FAILED, HEALING, PREFAILED

STATES = ('NOT_TESTED', 'PASSED', 'PREFAILED', 'FAILED', 'HEALING')
EVENTS = ('lost', 'skipped', 'deadline missed', 'liveliness lost', 'incompatible QoS')
"""Events of messages and of a topic's quality of service."""


class Recent:
    """
    Whether a count has grown lately, that is, within the last second or two.

    A level holds that long, however often statuses are sent.
    """

    def __init__(self) -> None:
        """Begin with nothing."""
        self._before = 0
        self._last = 0
        self._begin = monotonic()

    def grows(self, count: int) -> bool:
        """Answer whether the count has grown."""
        if monotonic() - self._begin >= 0.9:
            self._before, self._last, self._begin = self._last, count, monotonic()
        return count != self._before

    def forget(self, count: int) -> None:
        """Note that what has been counted so far does not matter."""
        self._before = self._last = count


class MissedDeadlines:
    """
    Count of deadlines that pass without a message, from the first message on.

    The middleware has an event for it, but taking that event can wait forever in rmw_fastrtps.
    """

    def __init__(self, deadline: int) -> None:
        """Begin with no message; they have to come in so many nanoseconds, 0: at any time."""
        self._deadline = deadline
        self._last: Optional[Tuple[int, int]] = None
        """Deadlines missed before the last message, and its time."""

    def add_message(self) -> None:
        """Note that a message has come, or gone."""
        self._last = (self.count(), monotonic_ns())

    def count(self) -> int:
        """Answer how many deadlines have been missed."""
        if not self._deadline or self._last is None:
            return 0
        before, last = self._last
        return before + (monotonic_ns() - last) // self._deadline


class TopicCounts:
    """Counts of messages and events of a topic."""

    def __init__(self, name: str, deadline: int) -> None:
        """Begin with nothing; messages have to come in `deadline` nanoseconds, 0: at any time."""
        self.name = name
        self.messages = 0
        self.events = dict.fromkeys(EVENTS, 0)
        self._rate = 0.0
        self._told_messages = 0
        self._missed_deadlines = MissedDeadlines(deadline)
        self.has_stranger: Callable[[], bool] = lambda: False
        """Whether another end of the topic is there that is not connected with this one."""
        self._losses = Recent()
        self._promises = Recent()
        self._sequence_number = 0

    def add_message(self) -> None:
        """Note that a message has come, or gone."""
        self.messages += 1
        self._missed_deadlines.add_message()

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

    def status(self, node: str, *, has_calls: bool) -> DiagnosticStatus:
        """Answer its status. Deadlines are missed as they should be while no call runs."""
        self.events['deadline missed'] = self._missed_deadlines.count()
        message = self._problem(has_calls=has_calls)
        level = DiagnosticStatus.WARN if message else DiagnosticStatus.OK
        values = {'messages': str(self.messages), 'rate [Hz]': f'{self._rate:.6f}'}
        values.update((name, str(total)) for name, total in self.events.items())
        return _status(node, self.name, (level, message, values))

    def _problem(self, *, has_calls: bool) -> str:
        """Answer the present problems."""
        found = []
        if self.events['incompatible QoS'] and self.has_stranger():
            found.append('An end of the topic has a quality of service that does not fit.')
        if self._losses.grows(self.events['lost'] + self.events['skipped']):
            found.append('Messages are lost.')
        missed = self.events['deadline missed'] + self.events['liveliness lost']
        if not has_calls:
            self._promises.forget(missed)
        elif self._promises.grows(missed):
            found.append('Messages are late.')
        return ' '.join(found)


class CallTimes:
    """Number and durations of the runs of a call."""

    def __init__(self) -> None:
        """Begin with nothing."""
        self.steps = 0
        self.missed = Recent()
        self._steps = Recent()
        self._dropped = Recent()
        self._last = {'t_adapter': 0, 't_logic': 0}
        self._longest = {'t_adapter': 0, 't_logic': 0}

    def add(self, adapter: int, logic: int) -> None:
        """Note one step, in nanoseconds."""
        self.steps += 1
        self._last = {'t_adapter': adapter, 't_logic': logic}
        self._longest = {name: max(self._longest[name], t) for name, t in self._last.items()}

    def is_excluded(self, dropped: int) -> bool:
        """Answer whether the mode excludes the call."""
        has_run = self._steps.grows(self.steps)
        return self._dropped.grows(dropped) and not has_run

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
    if status.state == PREFAILED:
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
    is_late = times.missed.grows(counts.missed)
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
