"""Values that are received after a call is due and before its snapshot: on platforms with threads this happens."""

from pathlib import Path

import pytest

from tests.adapter.core import core_side
from tests.adapter.core.compared import difference
from tests.adapter.core.script import Script
from tests.adapter.core.subject import subject
from tests.adapter.written import FLOAT, U8, function, on_event, queue, signal

INPUTS = {
    "a queue": (queue("A", 8, U8, ValuesPerStep=4, CountVariable="count"), "01"),
    "a queue of single values": (queue("A", 8, U8), "01"),
    "a signal": (signal("A", FLOAT), "3f800000"),
}
CALLS = {"a queue": 1, "a queue of single values": 2, "a signal": 1}
"""Number of calls for two values."""
WHOLE_CALL: Script = [("advance", 0, 0)] * 4


@pytest.mark.parametrize("kind", INPUTS)
def test_a_value_before_the_snapshot_makes_no_call_without_a_value(kind: str, tmp_path: Path) -> None:
    given, bits = INPUTS[kind]
    made = subject(function(on_event(given)))
    received = ("receive", 0, bits, 0)
    script: Script = [("init", 0, 0), ("start", 0), received, ("next", 0), received]
    for _ in range(3):
        script += [*WHOLE_CALL, ("next", 0)]
    printed = core_side.run(core_side.compiled(made, tmp_path, ("-w",)), script)
    assert difference(made, script, printed) == ""
    assert sum(line.startswith("call=1") for line in printed) == CALLS[kind]
