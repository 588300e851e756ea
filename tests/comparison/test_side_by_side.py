"""Tasks side by side: answers in the order of the tasks, and no process that outlives an interrupt or a failure."""

import os
import signal
import threading
from functools import partial
from pathlib import Path

import pytest

from sigcat.comparison.side_by_side import side_by_side
from sigcat.players.commands import BuildFails, ran
from tests.waiting import wait_until


def test_answers_are_in_the_order_of_the_tasks():
    tasks = [partial(ran, ["sh", "-c", f"sleep {wait}; echo {wait}"]) for wait in ("0.2", "0.1", "0")]
    assert side_by_side(tasks) == ["0.2\n", "0.1\n", "0\n"]


def test_a_task_that_fails_ends_the_processes_of_the_others(tmp_path: Path):
    sleeps, waits = _sleeping(tmp_path, "other"), _waiting(tmp_path / "other")

    def fails() -> str:
        waits()
        raise BuildFails("no compiler")

    with pytest.raises(BuildFails, match="no compiler"):
        side_by_side([fails, sleeps])
    assert not _is_alive(tmp_path / "other")
    assert ran(["echo", "afterwards"]) == "afterwards\n"


def test_an_interrupt_ends_all_processes(tmp_path: Path):
    tasks = [_sleeping(tmp_path, "one"), _sleeping(tmp_path, "other")]
    both = (
        [_waiting(tmp_path / "one")]
        if os.cpu_count() == 1
        else [_waiting(tmp_path / each) for each in ("one", "other")]
    )

    def interrupts() -> None:
        for waits in both:
            waits()
        os.kill(os.getpid(), signal.SIGINT)

    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Thread(target=interrupts).start()
    try:
        with pytest.raises(KeyboardInterrupt):
            side_by_side(tasks)
    finally:
        signal.signal(signal.SIGINT, before)
    assert not any(_is_alive(path) for path in (tmp_path / "one", tmp_path / "other") if path.exists())


def test_an_interrupt_while_tasks_are_being_started_ends_those_that_run(tmp_path):
    def tasks():
        yield _sleeping(tmp_path, "one")
        wait_until((tmp_path / "one").exists, "the process has begun")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        side_by_side(tasks())
    assert not _is_alive(tmp_path / "one")


def _sleeping(folder: Path, name: str):
    """A task whose process writes its id, and would run for long."""
    return lambda: ran(["sh", "-c", f"echo $$ > {name}.new && mv {name}.new {name} && exec sleep 600"], folder=folder)


def _waiting(path: Path):
    """Until the process has begun."""

    def waits() -> None:
        wait_until(path.exists, "the process has begun")

    return waits


def _is_alive(path: Path) -> bool:
    return Path(f"/proc/{path.read_text().strip()}").exists()
