"""Text of C++ files: what every header has, namespaces, comments."""

import re
from collections.abc import Iterable, Sequence

from sigcat.function.document.text_filters import AnyText, c_header, comment_rows

WIDEST = 120


def header(path: str, about: AnyText, includes: Iterable[str], body: Sequence[str]) -> str:
    """A header: what it is, its guard, includes and sections."""
    guard = re.sub(r"[^A-Za-z0-9]", "_", path).upper() + "_"
    opening = f"#ifndef {guard}\n#define {guard}"
    return _sections([f"{comment(about)}\n{opening}", *_included(includes), *body, f"#endif  {comment(guard)}"])


def source(about: AnyText, includes: Iterable[str], body: Sequence[str]) -> str:
    """A source file: what it is, its includes and sections."""
    return _sections([comment(about), *_included(includes), *body])


def comment(text: AnyText, levels: int = 0) -> str:
    """A comment of as many lines as it takes."""
    indent = "    " * levels
    return "\n".join(f"{indent}{row}" for row in comment_rows(text, "//", WIDEST - len(indent)))


def within(namespace: Sequence[str], sections: Sequence[str]) -> list[str]:
    """Sections in a namespace; without one, as they are."""
    if not namespace:
        return list(sections)
    name = "::".join(namespace)
    return [f"namespace {name} {{", *sections, f"}}  {comment(f'namespace {name}')}"]


def _included(includes: Iterable[str]) -> list[str]:
    """The standard library first, then everything else."""
    names = sorted(set(includes))
    groups = ([f"#include {name}" for name in names if name.startswith("<")],
              [f"#include {c_header(name)}" for name in names if not name.startswith("<")])  # fmt: skip
    return ["\n".join(group) for group in groups if group]


def _sections(sections: Iterable[str]) -> str:
    return "\n\n".join(section for section in sections if section) + "\n"
