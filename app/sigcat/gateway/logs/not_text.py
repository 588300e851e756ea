"""Files that are not text, in place of a log that is: recognized by their first bytes."""

from pathlib import Path

from sigcat.gateway.logs.problems import NoLog

_TEXT = bytes({*range(32, 127)} | {*b"\t\n\r\f\x1b"})
_MOST_OTHERS = 0.2
"""Share of the first bytes other than ASCII in a log with comments, or with a few damaged lines."""
_KNOWN = (
    (b"\x1f\x8b", "it is packed with gzip", ".gz"),
    (b"LOGG", "it is a BLF log", ".blf"),
    (b"MDF ", "it is a log in MDF", ".mf4"),
    (b"SQLite format 3", "it is a database of SQLite", ".db"),
)
"""First bytes, the kind of file, and the ending that its name needs."""
_MARKS_OF_UTF_16 = (b"\xff\xfe", b"\xfe\xff")


def refuse_bytes(path: Path, start: bytes) -> None:
    """Raise NoLog if the first bytes of a file are not those of a log that is text."""
    for mark, kind, ending in _KNOWN:
        if start.startswith(mark):
            name = f"{path.name}{ending}" if ending == ".gz" else f"{path.stem}{ending}"
            raise NoLog(kind, f"Name it {name}.")
    if start.startswith(_MARKS_OF_UTF_16):
        raise NoLog("it is a text in UTF-16", "Save it as UTF-8.")
    first_line = start.partition(b"\n")[0]
    if first_line.translate(None, _TEXT) and len(start.translate(None, _TEXT)) > _MOST_OTHERS * len(start):
        raise NoLog("it is not a text")
