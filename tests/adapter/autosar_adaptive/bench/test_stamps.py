"""With BENCH_STAMPS, events have the time at which they were sent beside them; payloads stay as they are."""

import struct
import time
from collections.abc import Mapping
from pathlib import Path

import pytest

from tests.adapter.autosar_adaptive.bench.probe_service import MODE, SPEED
from tests.adapter.autosar_adaptive.bench.test_pysomeip import peer
from tests.adapter.autosar_adaptive.bench.test_services import subscribed
from tests.adapter.autosar_adaptive.own_network import Network, Program, own_network
from tests.needs import c_compiler

pytestmark = [own_network, c_compiler]


def sender_and_receiver(net: Network, built: Mapping[str, Path], **variables: str) -> tuple[Program, Program]:
    sender = net.start([built["sender"]], **variables).tells("ready").do("mode 0", "offer").tells("done offer")
    receiver = net.start([built["receiver"]]).tells_in_any_order("ready", "found 1")
    return sender, subscribed(receiver)


@pytest.mark.parametrize(("command", "told"), [("speed 12.5", "Speed"), ("image 200000", "Image")])
def test_a_sample_is_given_with_the_time_at_which_it_was_sent(
    net: Network, built: Mapping[str, Path], command: str, told: str
) -> None:
    """One that goes in many datagrams, too."""
    sender, receiver = sender_and_receiver(net, built, BENCH_STAMPS="1")
    before = time.monotonic_ns()
    sender.do(command).tells(f"done {command.split(maxsplit=1)[0]}")
    after = time.monotonic_ns()
    stamps: list[int] = []
    while not stamps:
        line = receiver.next_line()
        stamps = [int(line.rpartition(" ")[2])] if line.startswith(f"{told} was sent at") else []
    assert before <= stamps[0] <= after


def test_without_the_variable_nothing_is_beside_an_event(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = sender_and_receiver(net, built)
    sender.do("speed 1", "speed 2").tells("done speed", "done speed")
    receiver.tells("speed 1", "speed 2")
    assert not [line for line in receiver.told if "was sent at" in line]


def test_to_another_receiver_it_is_a_service_that_it_does_not_use(net: Network, built: Mapping[str, Path]) -> None:
    """pysomeip, which hears the events as without it."""
    sender = net.start([built["sender"]], BENCH_STAMPS="1").tells("ready").do("mode 1", "offer").tells("done offer")
    client = peer(net, "client").tells(f"notification {MODE:#06x} E_OK 01")
    sender.do("speed 2.5")
    client.tells(f"notification {SPEED:#06x} E_OK {struct.pack('!f', 2.5).hex()}")
