"""Tasks that each wait for a process, several at a time."""

import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from sigcat.players.commands import GROUPS

Answer = TypeVar("Answer")


def side_by_side(tasks: Iterable[Callable[[], Answer]]) -> list[Answer]:
    """Return the results of tasks in their order; as many run at a time as there are cores. An interrupt ends them."""
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        try:
            asked = [pool.submit(task) for task in tasks]
            return [each.result() for each in asked]
        except BaseException:
            with GROUPS.ended():
                pool.shutdown(cancel_futures=True)
            raise
