"""Filters through which values of documents reach generated files: one for each place that a file has for text.

Each takes any text and returns text that is harmless in its place: it does not end the place, and begins nothing else in it. Invisible
characters, and those that change the reading direction, become an escape or their number: `[U+202E]`.
"""

import json
import re
import textwrap
from xml.sax.saxutils import escape

from sigcat.function.document.text import Text

AnyText = Text | str


def comment(value: AnyText) -> str:
    """Text within a comment of C, C++, CMake, Python or YAML, on one line."""
    text = _one_line(value).replace("*/", "* /").replace("/*", "/ *").replace("??/", "?? /")
    return _ENCODING.sub(r"coding \1", _CONTINUED.sub(_number, text))


_CONTINUED = re.compile(r"\\(?= |$)")
"""A backslash at the end of a word, which continues the comment if the line ends there."""
_ENCODING = re.compile(r"coding([:=])")
"""The encoding of a file of Python, where it is on one of its first lines."""


def block_comment(value: AnyText) -> str:
    """A comment of C: `/* … */`; nothing without a text."""
    text = comment(value)
    return f"/* {text} */" if text else ""


def comment_rows(value: AnyText, mark: str, width: int) -> list[str]:
    """A comment of lines that begin with a mark and are at most so wide, if their words are."""
    rows = textwrap.wrap(comment(value), width - len(mark) - 1, break_long_words=False, break_on_hyphens=False)
    return [f"{mark} {row}" for row in rows]


def ros_comment_rows(value: AnyText, unit: str | None, width: int) -> list[str]:
    """A comment of a ROS message. rosidl takes text in brackets for the unit, and writes comments into code of C."""
    text, known = (comment(each).translate(_NOT_IN_ROS) for each in (value, unit or ""))
    return comment_rows(f"{text} [{known}]" if known else text, "#", width)


_NOT_IN_ROS = str.maketrans("[]\\", "()/")


def ros_string(value: AnyText) -> str:
    """A constant of a ROS message that is text."""
    text = _one_line(value).replace("\\", "[U+005C]").replace('"', r"\"")
    return f'"{text}"'


def ros_number(value: AnyText) -> str:
    """A constant of a ROS message that is a whole number."""
    return str(int(_raw(value)))


def c_string(value: AnyText) -> str:
    """A string literal of C and C++. It has no quotation mark inside and begins no comment, so that lines can be broken."""
    text = "".join(map(_c_character, _storable(value))).replace("/*", r"/\052")
    return f'"{text}"'


def c_strings(value: AnyText, width: int) -> list[str]:
    """A string literal of C++, in pieces that are about so wide at most."""
    text = _storable(value)
    if len(c_string(text)) <= width:
        return [c_string(text)]
    return [c_string(row) for row in textwrap.wrap(text, width - 4, drop_whitespace=False, break_on_hyphens=False)]


def c_header(value: AnyText) -> str:
    """The name of a header after `#include`: it has no escapes."""
    return f'"{_one_line(value).replace(chr(34), "[U+0022]")}"'


def c_format(value: AnyText) -> str:
    """A string literal that a function such as `printf` takes as its format, with nothing to fill in."""
    return c_string(value).replace("%", "%%")


def _c_character(letter: str) -> str:
    if letter.isascii() and letter.isprintable() and letter not in '"\\?':
        return letter
    return "".join(f"\\{byte:03o}" for byte in letter.encode())


def cmake_argument(value: AnyText) -> str:
    """Text within a quoted argument of CMake that refers to no variable, has no list and no generator expression."""
    return _CMAKE.sub(_number, _one_line(value))


_CMAKE = re.compile(r'["\\$;@]')


def cmake_word(value: AnyText) -> str:
    """An argument of CMake, in quotation marks if it needs them."""
    text = cmake_argument(value)
    return text if _CMAKE_WORD.fullmatch(text) else f'"{text}"'


_CMAKE_WORD = re.compile(r"[A-Za-z0-9_./+-]+")


def python_string(value: AnyText) -> str:
    """A string literal of Python."""
    return repr(_raw(value))


def python_strings(value: AnyText, width: int) -> list[str]:
    """A string literal of Python, in pieces that are so wide at most."""
    found, rest = [], _raw(value)
    while len(repr(rest)) > width:
        at = rest.rfind(" ", 1, width - 10) + 1 or width - 10
        found.append(repr(rest[:at]))
        rest = rest[at:]
    return [*found, repr(rest)]


def docstring_text(value: AnyText) -> str:
    """Text within a docstring of Python in double quotes, on one line."""
    return _one_line(value).replace("\\", "\\\\").replace('"""', "'''").rstrip('"')


def xml_text(value: AnyText) -> str:
    """Text of an element of XML or HTML, or of an attribute in double quotes, on one line."""
    return escape(_one_line(value), {'"': "&quot;"})


def arxml_text(value: AnyText) -> str:
    """Text that the library for ARXML escapes: without characters that XML cannot have."""
    return _visible(value, "\n\t")


def markdown(value: AnyText) -> str:
    """Text of a paragraph or of a cell in Markdown, on one line, without markup of Markdown or HTML."""
    text = _MARKUP.sub(r"\\\g<0>", escape(_one_line(value)))
    return _NUMBERED.sub(r"\1\\", text)


_MARKUP = re.compile(r"[\\`*_\[\]|~]|^#|^[-+](?= |$)|^[-=]+$")
_NUMBERED = re.compile(r"^(\d+)(?=[.)](?: |$))")
"""The number of an item of a list."""


def markdown_code(value: AnyText) -> str:
    """A code span of Markdown."""
    text = _one_line(value).replace("`", "'").replace("|", r"\|")
    return f"`{text}`"


def mermaid_text(value: AnyText) -> str:
    """Text within a quoted label of Mermaid."""
    return "".join(each if each.isalnum() or each in " .,;:_-/~" else f"#{ord(each)};" for each in _one_line(value))


def yaml_string(value: AnyText) -> str:
    """A string of YAML in double quotes."""
    text = json.dumps(_storable(value), ensure_ascii=False)
    return "".join(each if each.isprintable() else f"\\U{ord(each):08X}" for each in text)


def _raw(value: AnyText) -> str:
    return value.raw if isinstance(value, Text) else value


def _one_line(value: AnyText) -> str:
    return _visible(" ".join(_raw(value).split()))


def _storable(value: AnyText) -> str:
    """The text with numbers of characters instead of those that strings of C and UTF-8 cannot have."""
    return re.sub("[\0\ud800-\udfff]", _number, _raw(value))


def _visible(value: AnyText, kept: str = "") -> str:
    """The text with numbers of characters instead of those that cannot be printed, but for those that are kept."""
    text = _raw(value)
    if text.isprintable():
        return text
    return "".join(each if each.isprintable() or each in kept else f"[U+{ord(each):04X}]" for each in text)


def _number(found: re.Match[str]) -> str:
    return f"[U+{ord(found[0]):04X}]"


def milliseconds(nanoseconds: int) -> str:
    """A time for people: `50 ms`."""
    return f"{nanoseconds / 10**6:.15g} ms"
