"""A bus that fails while functions run: it is reported at once, frames are sent again, and what waits is bounded."""

from typing import Any

import pytest

from sigcat.errors import UsageError
from sigcat.gateway.frames import Frame
from sigcat.gateway.returning import Returning
from tests.waiting import wait_until


class Bus:
    """A bus that refuses frames while `fails` is positive, which each refused frame lowers."""

    def __init__(self, fails: int = 0) -> None:
        self.fails = fails
        self.sent: list[int] = []

    def send(self, frame: Frame) -> None:
        if self.fails:
            self.fails -= 1
            raise UsageError("a frame cannot be sent: no buffer")
        self.sent.append(frame.identifier)


class Sender:
    """Makes a frame of each value: its text is the identifier."""

    def __init__(self) -> None:
        self.waiting: list[int] = []

    def take(self, name: str, text: str) -> None:
        self.waiting.append(int(text))

    def due(self, time: int) -> list[Frame]:
        frames = [Frame(time, number, False, b"", "") for number in self.waiting]
        self.waiting.clear()
        return frames

    def next_time(self) -> None:
        return None


def returning(bus: Any, told: list[str], **options: Any) -> Returning:
    sender: Any = Sender()
    return Returning(sender, bus, told.append, pauses=(0, 0), **{"is_lock_step": False, **options})


def test_a_frame_that_the_bus_refuses_is_sent_again():
    told: list[str] = []
    bus = Bus(fails=2)
    with returning(bus, told) as sending:
        sending.take(0, "A", "7")
        sending.close()
    assert (bus.sent, sending.lost, list(sending.findings("log"))) == ([7], 0, [])
    assert told == [
        "a frame cannot be sent: no buffer; it is tried again", "frames are sent to CAN again; 0 are lost",
    ]  # fmt: skip


def test_an_error_is_reported_before_the_end_and_later_frames_are_sent():
    told: list[str] = []
    bus = Bus(fails=4)
    with returning(bus, told) as sending:
        sending.take(0, "A", "1")
        wait_until(lambda: sending.lost == 1, "the first frame is given up")
        assert told == ["a frame cannot be sent: no buffer; it is tried again"]
        sending.take(1, "A", "2")
        wait_until(lambda: sending.lost == 2, "the next one is tried once")
        sending.take(2, "A", "3")
        sending.close()
    assert bus.sent == [3]
    assert told[1:] == ["frames are sent to CAN again; 2 are lost"]
    assert [each.line_of_text for each in sending.findings("log")] == [
        "log: error B008 2 frames were not sent to CAN: a frame cannot be sent: no buffer."
    ]


def test_of_too_many_values_that_wait_the_oldest_are_dropped(monkeypatch):
    monkeypatch.setattr("sigcat.gateway.returning._MOST_WAITING", 3)
    told: list[str] = []
    bus = Bus()
    sending = returning(bus, told)  # nothing takes from the queue yet
    for number in range(5):
        sending.take(0, "A", str(number))
    with sending:
        sending.close()
    assert (bus.sent, sending.dropped) == ([2, 3, 4], 2)
    assert told == ["more than 3 values wait to be sent to CAN: the oldest are dropped"]
    assert "2 values were dropped" in next(sending.findings("log")).message


def test_what_breaks_is_reported_at_once_and_raised_at_the_end():
    class Broken(Bus):
        def send(self, frame: Frame) -> None:
            raise ZeroDivisionError("broken")

    told: list[str] = []
    with returning(Broken(), told) as sending:
        sending.take(0, "A", "1")
        wait_until(lambda: bool(told), "the error is reported")
        for number in range(20_000):
            sending.take(1, "A", str(number))
        with pytest.raises(ZeroDivisionError):
            sending.close()
    assert told == ["nothing is sent to CAN any more: broken"]
