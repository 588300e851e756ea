"""The player of a drive asks one node after the other: what one has sent has come here before the next one takes it."""

import importlib
import sys
from collections import Counter
from types import SimpleNamespace
from unittest.mock import MagicMock

import pytest

MODULES = (
    "rclpy", "rclpy.executors", "rclpy.qos", "lifecycle_msgs", "lifecycle_msgs.msg", "lifecycle_msgs.srv",
)  # fmt: skip


@pytest.fixture
def player_module(monkeypatch):
    for name in MODULES:
        monkeypatch.setitem(sys.modules, name, MagicMock())
    monkeypatch.delitem(sys.modules, "scripts.ros2_player", raising=False)
    module = importlib.import_module("scripts.ros2_player")
    monkeypatch.setattr(module, "message_type", lambda _: SimpleNamespace(Request=SimpleNamespace))
    yield module
    del sys.modules["scripts.ros2_player"]


class Node:
    """A node that has taken what others sent before it is asked, and sends one message in its first step."""

    def __init__(self, others, is_sender):
        self.others, self.is_sender, self.taken, self.sent = others, is_sender, 0, 0

    def call_async(self, _request):
        if self.is_sender and not self.sent:
            self.sent = 1
            for other in self.others:
                other.taken += 1
        answer = SimpleNamespace(success=True, message="", received=self.taken, sent=self.sent)
        return SimpleNamespace(done=lambda: True, result=lambda: answer)


def test_a_message_that_the_player_hears_last_is_not_one_too_many(player_module):
    taker = Node((), is_sender=False)
    sender = Node((taker,), is_sender=True)
    player = player_module.Player.__new__(player_module.Player)
    player.nodes, player.interfaces = ["sender", "taker"], "messages"
    player.steps = {"sender": sender, "taker": taker}
    player.sent, player.given = Counter(), Counter()

    def spin_once(_seconds):
        player.sent["sender"] += 1
        player.given["taker"] += 1

    player.executor = SimpleNamespace(spin_once=spin_once)
    assert player.step(0) is True
    assert player.step(0) is False
    assert player.given["taker"] == taker.taken == 1
