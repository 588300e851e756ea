"""Files of C, from templates of this platform."""

import re

from sigcat.adapter.core.c.lines import Lines, lines
from sigcat.adapter.templates import Plan, rendered

_FOLDER = "adapter/autosar_classic"


def c_lines(template: str, plan: Plan) -> Lines:
    """Lines of a file. Parts of a template that are empty leave no empty lines behind."""
    return lines(re.sub(r"\n{3,}", "\n\n", rendered(f"{_FOLDER}/{template}", plan)))
