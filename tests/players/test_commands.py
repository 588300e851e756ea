"""Processes of commands end with whoever started them."""

import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from sigcat.players.commands import Groups, Interrupted
from tests.waiting import DEADLINE

WAITS = [sys.executable, "-c", "input()"]


def test_whoever_ends_all_groups_kills_what_runs_and_lets_nothing_start():
    groups, begun = Groups(), threading.Event()

    def waits() -> None:
        with groups.started(WAITS, stdin=subprocess.PIPE) as process:
            begun.set()
            process.wait()

    with ThreadPoolExecutor(1) as pool:
        waiting = pool.submit(waits)
        assert begun.wait(DEADLINE)
        with groups.ended():
            with pytest.raises(Interrupted):
                waiting.result(DEADLINE)
            with pytest.raises(Interrupted), groups.started(WAITS):
                pass
    with groups.started([sys.executable, "-c", ""]) as process:
        assert process.wait() == 0
