"""A CAN database is read with cantools: its messages, and what each of their signals can hold."""

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.network.signal_limits import limited, names, physical, step
from sigcat.errors import UsageError
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS
from sigcat.real_path import real_path

NEEDED = "CAN needs the extra `can`: run `pip install 'sigcat[can]'`"
FORMS = ("dbc", "kcd", "sym", "arxml")
"""Endings of the files that cantools reads."""

_MESSAGE_BYTES, _SIGNAL_BITS = 1_785, 14_280
"""Longest message on CAN, one of several frames by the transport protocol of J1939."""
_PDU_BITS = 65_536
"""An ARXML may have PDUs of other buses, too."""
_SIZES: Mapping[str, Sequence[tuple[str, int]]] = {
    "dbc": ((r"^\s*BO_\s+\d+\s+\w+\s*:\s*(\d+)", _MESSAGE_BYTES), (r"^\s*SG_\s[^:]*:\s*(\d+)\|(\d+)@", _SIGNAL_BITS)),
    "kcd": ((r"\b(?:length|offset)=[\"'](\d+)[\"']", _SIGNAL_BITS),),
    "sym": ((r"\bLen\s*=\s*(\d+)", _MESSAGE_BYTES), (r"\b(?:un)?signed\s+(\d+)", _SIGNAL_BITS)),
    "arxml": ((r"<(?:LENGTH|FRAME-LENGTH|START-POSITION)>\s*(\d+)", _PDU_BITS),),
}
"""Sizes in a text, in bytes and bits, by form, and the largest of each. cantools lays out every bit of larger ones."""


class CanSignal(NamedTuple):
    """A signal of a message."""

    name: str
    message: str
    minimum: float | None
    """The least number in its unit; None if the database does not say."""
    maximum: float | None
    raw_minimum: float
    """The least number in its unit that its bits can hold."""
    raw_maximum: float
    names: Mapping[int, str]
    """Names of raw numbers."""
    excluded: frozenset[int]
    """Raw numbers that have names and are outside of the stated limits."""
    unit: str
    step: float
    """From one number to the next, in its unit; 0 for floats."""
    length: int
    """In bits."""
    byte_order: str
    """big_endian or little_endian."""

    @property
    def has_limits(self) -> bool:
        """Whether the database states limits."""
        return self.minimum is not None or self.maximum is not None

    @property
    def least(self) -> float:
        """The least number that comes, as far as is known."""
        return self.raw_minimum if self.minimum is None else max(self.minimum, self.raw_minimum)

    @property
    def greatest(self) -> float:
        """The greatest number that comes, as far as is known."""
        return self.raw_maximum if self.maximum is None else min(self.maximum, self.raw_maximum)


class CanDatabase(NamedTuple):
    """Messages and signals of a bus."""

    files: tuple[str, ...]
    messages: tuple[Any, ...]
    """As cantools has them; what reads frames takes these."""
    signals: Mapping[str, tuple[CanSignal, ...]]
    """By their names: several messages may have one of a name."""
    findings: tuple[Finding, ...]
    """Why it cannot be used, and warnings."""
    channels: tuple[str, ...] = ()
    """The channel of each message, where several buses have their own databases; empty: whichever one."""


def read_can_database(paths: Sequence[Path]) -> CanDatabase:
    """One database of the files of several. Raises UsageError without cantools; files that are none have a finding."""
    messages: list[Any] = []
    findings: list[Finding] = []
    known: dict[tuple[int, bool], tuple[Any, Path]] = {}
    for path in {real_path(path): path for path in paths}.values():
        try:
            for message in _messages(path):
                other, file = known.setdefault((message.frame_id, message.is_extended_frame), (message, path))
                if other is message:
                    messages.append(message)
                    findings += [*_wrong_factors(message, path), *_doubts(message, path)]
                elif not _is_same(message, other):
                    findings.append(_contradicts(message, path, other, file))
        except _Unreadable as error:
            findings.append(codes.CAN_DATABASE_UNREADABLE.finding(str(error), str(path), error.line))
    signals: dict[str, list[CanSignal]] = {}
    for each in (found for message in messages for found in _signals(message)):
        signals.setdefault(each.name, []).append(each)
    return CanDatabase(
        tuple(map(str, paths)), tuple(messages), {name: tuple(each) for name, each in signals.items()}, tuple(findings)
    )


def of_channels(databases: Mapping[str, CanDatabase]) -> CanDatabase:
    """One database of those of several channels; an empty name is for all channels."""
    signals: dict[str, tuple[CanSignal, ...]] = {}
    for database in databases.values():
        for name, found in database.signals.items():
            signals[name] = signals.get(name, ()) + found
    return CanDatabase(
        tuple(file for each in databases.values() for file in each.files),
        tuple(message for each in databases.values() for message in each.messages),
        signals,
        tuple(finding for each in databases.values() for finding in each.findings),
        tuple(channel for channel, each in databases.items() for _ in each.messages),
    )


def _is_same(message: Any, other: Any) -> bool:
    """Whether two databases say the same of a message: frames of it mean the same by both."""
    return (message.name, message.length, _layout(message)) == (other.name, other.length, _layout(other))


def _layout(message: Any) -> Sequence[Any]:
    return sorted(
        (
            each.name, each.start, each.length, each.byte_order, each.is_signed, each.conversion.is_float,
            each.conversion.scale, each.conversion.offset, repr(each.minimum), repr(each.maximum),
            repr(each.multiplexer_ids), repr(each.multiplexer_signal),
            sorted((number, str(name)) for number, name in (each.conversion.choices or {}).items()),
        )
        for each in message.signals
    )  # fmt: skip


def _contradicts(message: Any, path: Path, other: Any, file: Path) -> Finding:
    """Report two messages of one identifier: frames would be decoded as one of them alone."""
    where = "this database" if file == path else str(file)
    text = f"{message.name} has the identifier {message.frame_id:X}, which {other.name} has in {where}."
    fix = "Frames are of one of them: name the databases of one bus at a time, with --channel if the log has several."
    return codes.CAN_DATABASE_UNREADABLE.finding(text, str(path), fix=fix)


def _wrong_factors(message: Any, path: Path) -> Iterator[Finding]:
    """Signals with a factor of 0, of which every number is the same."""
    for signal in message.signals:
        if signal.conversion.scale == 0:
            text = f"The factor of {message.name}.{signal.name} must not be 0."
            yield codes.CAN_DATABASE_UNREADABLE.finding(
                text, str(path), _line(path, message.name, signal.name), fix="Write the factor of one step, such as 1."
            )


def _line(path: Path, message: str, signal: str) -> int:
    """The line of a signal in a DBC; 0 in other forms."""
    own = False
    for number, line in enumerate(path.read_text(encoding="cp1252", errors="replace").splitlines(), 1):
        words = line.replace(":", " ").split()
        if words[:1] == ["BO_"]:
            own = words[2:3] == [message]
        elif own and words[:2] == ["SG_", signal]:
            return number
    return 0


def _doubts(message: Any, path: Path) -> Iterator[Finding]:
    """Two signals that share bits, which cannot both be what they say, or one that ends beyond its message."""
    try:
        message.refresh(strict=True)
    except Exception as error:  # noqa: BLE001 — of cantools, with the names of both
        message.refresh(strict=False)
        fix = "Correct where they start: at least one of them has wrong values."
        yield codes.CAN_SIGNALS_OVERLAP.finding(str(error)[:200], str(path), fix=fix)


class _Unreadable(Exception):
    def __init__(self, message: str, line: int = 0) -> None:
        super().__init__(message)
        self.line = line


def _messages(path: Path) -> Sequence[Any]:
    import logging

    try:
        from cantools import database
    except ImportError:
        raise UsageError(NEEDED) from None
    logging.getLogger("cantools").setLevel(logging.CRITICAL)  # its warnings do not concern the mapping
    if path.stat().st_size > DEFAULT_LIMITS.file_bytes:
        raise _Unreadable(f"The file must have at most {DEFAULT_LIMITS.file_bytes:,} bytes.")
    form = path.suffix.lower()[1:]
    if form not in FORMS:
        raise _Unreadable(f"The name of a CAN database must end in {', '.join(f'.{each}' for each in FORMS)}.")
    try:
        data = path.read_bytes()
        if not data.strip():
            raise _Unreadable("The file must be a CAN database, and it is empty.")
        _refuse_large(data.decode("latin-1"), form)
        found = database.load_file(str(path), form, strict=False)
    except _Unreadable:
        raise
    except OSError as error:
        raise _Unreadable(f"The file cannot be read: {error.strerror}.") from None
    except Exception as error:  # noqa: BLE001 — it raises whatever its parsers meet
        raise _unreadable(getattr(error, f"e_{form}", None) or error) from None
    if not hasattr(found, "messages"):
        raise _Unreadable("The file must be a CAN database, and it is one of diagnostics.")
    if not found.messages:
        raise _Unreadable("The CAN database must have messages, and has none.")
    return tuple(found.messages)


def _refuse_large(text: str, form: str) -> None:
    """Raise _Unreadable at the first size beyond its limit."""
    for pattern, most in _SIZES[form]:
        for match in re.finditer(pattern, text, re.MULTILINE):
            size = next((each for each in match.groups() if each and (len(each) > 9 or int(each) > most)), None)
            if size is not None:
                line = text.count("\n", 0, match.end()) + 1
                raise _Unreadable(
                    f"A message or signal must have a size or a start of at most {most:,}, not {size[:40]}.", line
                )


def _unreadable(error: Exception) -> _Unreadable:
    """Return the error of cantools, with the line, if it has one."""
    first = str(error).partition("\n")[0]
    line = re.search(r" at line (\d+), column \d+", first)
    said = first.replace(line[0], "") if line else first
    if ">>!<<" in said:  # the place, marked within the text of the line
        said = f"nothing begins like {said.partition('>>!<<')[2].strip().rstrip(chr(34))[:40]!r}"
    return _Unreadable(f"The file must be a CAN database: {said[:200].rstrip('.')}.", int(line[1]) if line else 0)


def _signals(message: Any) -> Iterator[CanSignal]:
    for signal in message.signals:
        least, greatest = sorted(physical(signal, raw) for raw in _raw_range(signal))
        known = names(signal)
        excluded = frozenset(raw for raw in known if limited(signal, physical(signal, raw)) is None)
        yield CanSignal(
            signal.name, message.name, signal.minimum, signal.maximum, least, greatest, known, excluded,
            signal.unit or "", step(signal), signal.length, str(signal.byte_order),
        )  # fmt: skip


def _raw_range(signal: Any) -> tuple[float, float]:
    if signal.conversion.is_float:
        return -LARGEST[signal.length], LARGEST[signal.length]
    if signal.is_signed:
        return -(2 ** (signal.length - 1)), 2 ** (signal.length - 1) - 1
    return 0, 2**signal.length - 1


LARGEST: Mapping[int, float] = {16: 65504.0, 32: 3.4028234663852886e38, 64: 1.7976931348623157e308}
"""Numbers that floats of so many bits hold, at most."""
