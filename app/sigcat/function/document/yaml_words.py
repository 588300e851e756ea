"""Values in messages, in the words of YAML and JSON: `null`, `true`, `false`."""

import datetime as dt
import json
from typing import Any

_MOST = 60


def in_yaml(value: Any) -> str:
    """A value as its author may have written it, cut where it is long. Texts are in quotes."""
    if isinstance(value, str):
        text = repr(value)
    elif isinstance(value, dt.date):
        text = value.isoformat()
    else:
        text = json.dumps(value, ensure_ascii=False, default=str)
    return text if len(text) <= _MOST else f"{text[: _MOST - 3]}..."
