"""Texts of files and people on a terminal, which they must not control."""


def printable(text: str) -> str:
    r"""Return the text in one line: control characters, ends of lines and marks of direction as escapes, such as `\x1b`."""
    return text if text.isprintable() else "".join(c if c.isprintable() else _escape(c) for c in text)


def printable_lines(text: str) -> str:
    """Return the text with its lines, each of which is printable."""
    return "\n".join(map(printable, text.split("\n")))


def _escape(character: str) -> str:
    return character.encode("unicode_escape").decode("ascii")
