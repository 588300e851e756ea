"""A virtual bus of python-can, in this process."""

import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

import can
from can.interfaces.virtual import channels

from tests.waiting import wait_until


@contextmanager
def sending(channel: str, frames: Sequence[can.Message], first: Callable[[], None] = lambda: None) -> Iterator[None]:
    """Send frames with their own times once a receiver listens; when all are received, tell this process to end."""

    def send() -> None:
        first()
        wait_until(lambda: len(channels[channel]) == 2, "a receiver listens")
        for frame in frames:
            bus.send(frame)
        wait_until(lambda: all(queue.empty() for queue in channels[channel]), "all frames are received")
        os.kill(os.getpid(), signal.SIGINT)

    with can.Bus(interface="virtual", channel=channel, preserve_timestamps=True) as bus:
        sender = threading.Thread(target=send)
        sender.start()
        yield
        sender.join()
