"""Positions of the keys of a TOML file: tomllib does not report them."""

import re
from collections.abc import Iterator, Mapping

from sigcat.text_lines import lines_of

_HEADER = re.compile(r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]")
_KEY = re.compile(r"\s*((?:\"[^\"]*\"|'[^']*'|[A-Za-z0-9_.-])+)\s*=")
_QUOTES = str.maketrans("", "", "\"'")


Position = tuple[int, int]
"""Line and column, from 1; column 0 where only the line is known."""


class Lines:
    """The lines and columns of the keys of a TOML file."""

    def __init__(self, text: str) -> None:
        self._positions: dict[tuple[str, int, str], Position] = {}
        self._texts = lines_of(text)
        table, number = "", 0
        seen: dict[str, int] = {}
        arrays: dict[str, int] = {}
        for line, content in enumerate(self._texts, 1):
            if header := _HEADER.match(content):
                table = header[2].translate(_QUOTES)
                number = seen[table] = seen.get(table, -1) + 1
                self._positions.setdefault((table, number, ""), (line, header.start(1) + 1))
                self._positions.setdefault(("", 0, table.partition(".")[0]), (line, header.start(2) + 1))
                if header[1] == "[[":
                    arrays = {name: index for name, index in arrays.items() if not name.startswith(f"{table}.")}
                    arrays[table] = arrays.get(table, -1) + 1
                for address, rest in _addresses(table, arrays):
                    self._positions.setdefault((address, 0, rest), (line, header.start(1) + 1))
            elif key := _KEY.match(content):
                name = key[1].translate(_QUOTES)
                self._positions.setdefault((table, number, name), (line, key.start(1) + 1))
                for address, rest in _addresses(table, arrays):
                    self._positions.setdefault(
                        (address, 0, f"{rest}.{name}" if rest else name), (line, key.start(1) + 1)
                    )

    def line(self, table: str, number: int = 0, key: str = "") -> int:
        """Line of a key of the table that is the `number`th of its name; of its header without a key."""
        return self.position(table, number, key)[0]

    def has(self, table: str, key: str) -> bool:
        """Whether the first table of this name has a key."""
        return (table, 0, key) in self._positions

    def position(self, table: str, number: int = 0, key: str = "", value: str = "") -> Position:
        """Position of a key, or of a text in its value; of the header of its table without one."""
        at_key = self._positions.get((table, number, key))
        if at_key and value and (at_value := self._position_of(value, at_key)):
            return at_value
        return at_key or self._positions.get((table, number, "")) or (1, 0)

    def has_value(self, table: str, key: str, value: str) -> bool:
        """Whether a key of a table has a text in its value."""
        at_key = self._positions.get((table, 0, key))
        return at_key is not None and self._position_of(value, at_key) is not None

    def _position_of(self, value: str, at_key: Position) -> Position | None:
        """Position of a text in quotation marks behind a key, before the next one."""
        for line in range(at_key[0], len(self._texts) + 1):
            text = self._texts[line - 1]
            if line > at_key[0] and (_HEADER.match(text) or _KEY.match(text)):
                break
            start = at_key[1] if line == at_key[0] else 0
            found = [at for quote in "\"'" if (at := text.find(f"{quote}{value}{quote}", start)) >= 0]
            if found:
                return line, min(found) + 2
        return None

    def position_below(self, table: str, key: str) -> Position:
        """Position of a key such as `severity.V101`, however the tables around it are written; of the nearest that is there."""
        while True:
            parts = key.split(".")
            for split in range(len(parts)):
                header = ".".join((table, *parts[:split]))
                if found := self._positions.get((header, 0, ".".join(parts[split:]))):
                    return found
            if found := self._positions.get((f"{table}.{key}", 0, "")):
                return found
            if len(parts) == 1:
                return self.position(table)
            key = ".".join(parts[:-1])


def _addresses(table: str, arrays: Mapping[str, int]) -> Iterator[tuple[str, str]]:
    """Yield each table of an array that a header is in, such as `vehicle[1].state[0]`, and the rest of the header."""
    parts = table.split(".")
    address = ""
    for end, part in enumerate(parts, 1):
        index = arrays.get(".".join(parts[:end]))
        address += f".{part}" if address else part
        if index is not None:
            address += f"[{index}]"
            yield address, ".".join(parts[end:])
