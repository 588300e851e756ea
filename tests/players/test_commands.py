"""Processes of commands end with whoever started them."""

import subprocess
import sys

import pytest

from sigcat.players.commands import BuildFails, Groups

WAITS = [sys.executable, "-c", "input()"]


def test_whoever_ends_all_groups_kills_what_runs_and_lets_nothing_start():
    groups = Groups()
    with groups.started(WAITS, stdin=subprocess.PIPE) as process, groups.ended():
        assert process.wait() < 0
        with pytest.raises(BuildFails, match="interrupted"), groups.started(WAITS):
            pass
    with groups.started([sys.executable, "-c", ""]) as process:
        assert process.wait() == 0
