"""The table of settings in docs/how-to/production.md."""

import re
from collections.abc import Mapping
from pathlib import Path

from sigcat.api.read_settings import shown
from sigcat.api.settings import Settings

PAGE = "docs/how-to/production.md"
_TABLE = re.compile(r"(?<=^\| Setting \| Default \| Meaning \|\n\|---\|---\|---\|\n)(?:\|.*\n)*", re.MULTILINE)


def files() -> Mapping[str, str]:
    """The page with the settings that there are."""
    text = (Path(__file__).parents[1] / PAGE).read_text(encoding="utf-8")
    rows = "".join(f"| `{name}` | `{value}` | {description} |\n" for name, value, description in shown(Settings()))
    page, found = _TABLE.subn(lambda _: rows, text)
    assert found == 1, f"There must be one table of settings in {PAGE}, not {found}."
    return {PAGE: page}
