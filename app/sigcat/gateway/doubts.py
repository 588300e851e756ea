"""Doubts of a run of the gateway: whether the log is of the bus of the database, and what was skipped."""

from collections import Counter
from collections.abc import Collection, Iterator

from sigcat import codes
from sigcat.findings import Finding
from sigcat.gateway.counts import Counts
from sigcat.gateway.translation import Translation

_MOST = 20
"""Names that one finding lists."""


def doubts(translation: Translation, name: str, found: Collection[Finding]) -> Iterator[Finding]:
    """Doubts that the trace is complete; `name` is the log in findings, `found` those about its form."""
    counts = translation.counts
    is_refused = any(each.rule == codes.LOG_MALFORMED.id and each.severity == "error" for each in found)
    if not (counts.sent or (is_refused and not counts.frames)):
        yield _nothing(translation, name)
    if translation.channel is None:
        yield from _merged(counts, name)
    yield from _of_frames(counts, name)
    yield from _of_values(translation, name)
    if counts.late:
        message = (
            f"{_frames(counts.late, 'has', 'have')} a time before that of the frame above: it counts as of that time."
        )
        yield codes.LOG_TIME_GOES_BACK.graded("info").finding(message, name)


def _nothing(translation: Translation, name: str) -> Finding:
    """Why no signal has a value. Then no trace is written."""
    counts = translation.counts
    fix = "Name the database and the channel of this bus."
    if not counts.frames:
        fix = f"Look whether {name} is a log in the form that its name says."
        return codes.LOG_OF_ANOTHER_BUS.finding("No readable frame found: no trace is written.", name, fix=fix)
    if sum(counts.others.values()) + counts.passed.total() == counts.frames and counts.others:
        message = f"No frame is of channel {translation.channel}: there are {_listed(counts.others)}."
        return codes.LOG_OF_ANOTHER_BUS.finding(message, name, fix="Name one of these.")
    if counts.decoded:
        message = "No mapped signal has a value that it can take: no trace is written."
        return codes.LOG_OF_ANOTHER_BUS.finding(message, name, fix=_unfit_fix(counts))
    why = f"the database has none of its identifiers, such as {_most_frequent(counts.unknown)}."
    message = f"No frame of the log has a mapped signal: {why if counts.unknown else 'its messages are others.'}"
    return codes.LOG_OF_ANOTHER_BUS.finding(message, name, fix=fix)


def _unfit_fix(counts: Counts) -> str:
    """The advice where frames were decoded and no value is left."""
    if not counts.unfit:
        return "The frames have none of the parts or bytes that the mapped signals are in."
    (path, why), count = counts.unfit.most_common(1)[0]
    return f"Most often, values of {path} are {why} ({count:,}). Check limits and factors of the database, and the mappings."


def _most_frequent(unknown: "Counter[str]") -> str:
    return ", ".join(f"{identifier} ({count:,})" for identifier, count in unknown.most_common(5))


def _merged(counts: Counts, name: str) -> Iterator[Finding]:
    """Messages of several channels, which may be of several buses."""
    by_channels: dict[tuple[str, ...], list[str]] = {}
    for message, channels in counts.channels.items():
        if len(channels) > 1:
            by_channels.setdefault(tuple(sorted(channels)), []).append(message)
    for names, messages in by_channels.items():
        message = f"Frames of {_listed(messages)} come on the channels {_listed(names)}; their values are merged."
        fix = "Name one with --channel."
        yield codes.LOG_OF_ANOTHER_BUS.graded("warning").finding(message, name, fix=fix)  # it may be meant


def _of_frames(counts: Counts, name: str) -> Iterator[Finding]:
    for (message_name, undefined), count in counts.undefined.items():
        message = f"{_frames(count)} of {message_name}: {undefined}. What does not hang on it was taken."
        yield codes.FRAME_UNFIT.finding(message, name)
    for message_name, count in counts.short.items():
        message = f"{_frames(count, 'is', 'are')} shorter than {message_name}; the signals that are whole were taken."
        yield codes.FRAME_UNFIT.finding(message, name)


def _of_values(translation: Translation, name: str) -> Iterator[Finding]:
    """Values that were left out: a warning for a signal that has none left. And the signals that never came."""
    counts = translation.counts
    lost: Counter[str] = Counter()
    for (path, _), count in counts.unfit.items():
        lost[path] += count
    for (path, why), count in counts.unfit.items():
        came = counts.came[path]
        # some are left out by design, to say «invalid»
        rule = codes.FRAME_UNFIT if lost[path] == came else codes.FRAME_UNFIT.graded("info")
        yield rule.finding(f"{path}: {count:,} of {came:,} values left out, {why}.", name)
    missing = [each.path for each in translation.mapped if each.path not in counts.came]
    if missing and counts.sent:
        message = f"{len(missing):,} of {len(translation.mapped):,} mapped signals never came: {_listed(missing)}."
        yield codes.FRAME_UNFIT.graded("info").finding(message, name)  # a log may be shorter than a cycle


def _frames(count: int, one: str = "", several: str = "") -> str:
    return f"{count:,} {'frame' if count == 1 else 'frames'} {one if count == 1 else several}".rstrip()


def _listed(names: "Counter[str] | list[str] | tuple[str, ...]") -> str:
    shown = sorted(names)[:_MOST]
    more = len(names) - len(shown)
    return ", ".join(shown) + (f" and {more:,} more" if more else "")
