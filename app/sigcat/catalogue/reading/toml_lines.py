"""Positions of the keys of a TOML file: tomllib does not report them."""

import re

_HEADER = re.compile(r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]")
_KEY = re.compile(r"\s*((?:\"[^\"]*\"|'[^']*'|[A-Za-z0-9_.-])+)\s*=")
_QUOTES = str.maketrans("", "", "\"'")


class Lines:
    """The lines of the keys of a TOML file."""

    def __init__(self, text: str) -> None:
        self._lines: dict[tuple[str, int, str], int] = {}
        table, number = "", 0
        seen: dict[str, int] = {}
        for line, content in enumerate(text.splitlines(), 1):
            if header := _HEADER.match(content):
                table = header[2].translate(_QUOTES)
                number = seen[table] = seen.get(table, -1) + 1
                self._lines.setdefault((table, number, ""), line)
                self._lines.setdefault(("", 0, table.partition(".")[0]), line)
            elif key := _KEY.match(content):
                self._lines.setdefault((table, number, key[1].translate(_QUOTES)), line)

    def line(self, table: str, number: int = 0, key: str = "") -> int:
        """Line, from 1, of a key of the table that is the `number`th of its name; of its header without a key."""
        return self._lines.get((table, number, key)) or self._lines.get((table, number, "")) or 1

    def line_below(self, table: str, key: str) -> int:
        """Line of a key such as `severity.V101`, however the tables around it are written; of the nearest that is there."""
        while True:
            parts = key.split(".")
            for split in range(len(parts)):
                header = ".".join((table, *parts[:split]))
                if found := self._lines.get((header, 0, ".".join(parts[split:]))):
                    return found
            if found := self._lines.get((f"{table}.{key}", 0, "")):
                return found
            if len(parts) == 1:
                return self.line(table)
            key = ".".join(parts[:-1])
