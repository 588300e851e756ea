"""Text of C++ files: what every header has, namespaces, comments."""

import re
import textwrap
from collections.abc import Iterable, Sequence

WIDEST = 120


def header(path: str, about: str, includes: Iterable[str], body: Sequence[str]) -> str:
    """A header: what it is, its guard, includes and sections."""
    guard = re.sub(r"[^A-Za-z0-9]", "_", path).upper() + "_"
    opening = f"#ifndef {guard}\n#define {guard}"
    return _sections([f"{comment(about)}\n{opening}", *_included(includes), *body, f"#endif  // {guard}"])


def source(about: str, includes: Iterable[str], body: Sequence[str]) -> str:
    """A source file: what it is, its includes and sections."""
    return _sections([comment(about), *_included(includes), *body])


def comment(text: str, levels: int = 0) -> str:
    """A comment of as many lines as it takes."""
    indent = "    " * levels
    words = " ".join(text.split()).rstrip("\\ ")
    rows = textwrap.wrap(words, WIDEST - len(indent) - 3, break_long_words=False, break_on_hyphens=False)
    return "\n".join(f"{indent}// {row}" for row in rows)


def within(namespace: Sequence[str], sections: Sequence[str]) -> list[str]:
    """Sections in a namespace; without one, as they are."""
    if not namespace:
        return list(sections)
    name = "::".join(namespace)
    return [f"namespace {name} {{", *sections, f"}}  // namespace {name}"]


def sentence(*parts: str | None) -> str:
    """What is known of something, without what is not."""
    return "; ".join(part.strip().rstrip(".;") for part in parts if part and part.strip())


def _included(includes: Iterable[str]) -> list[str]:
    """The standard library first, then everything else."""
    names = sorted(set(includes))
    groups = ([f"#include {name}" for name in names if name.startswith("<")],
              [f'#include "{name}"' for name in names if not name.startswith("<")])  # fmt: skip
    return ["\n".join(group) for group in groups if group]


def _sections(sections: Iterable[str]) -> str:
    return "\n\n".join(section for section in sections if section) + "\n"
