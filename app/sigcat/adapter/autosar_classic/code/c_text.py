"""Files of C, from templates of this platform."""

import re
from typing import Any

from sigcat.adapter.core.c.text.lines import Lines, lines
from sigcat.adapter.templates import rendered

_FOLDER = "adapter/autosar_classic"


def c_lines(template: str, /, **names: Any) -> Lines:
    """Lines of a file. Parts of a template that are empty leave no empty lines behind."""
    return lines(re.sub(r"\n{3,}", "\n\n", rendered(f"{_FOLDER}/{template}", **names)))
