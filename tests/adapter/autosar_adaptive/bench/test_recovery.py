"""Either side may end at any moment, and start again: the other one detects it, and continues."""

import time
from collections.abc import Mapping
from itertools import count
from pathlib import Path

import pytest

from tests.adapter.autosar_adaptive.bench.test_services import pair, subscribed
from tests.adapter.autosar_adaptive.own_network import Network, own_network
from tests.needs import IS_SLOW_RUN, c_compiler

pytestmark = [own_network, c_compiler]
TIMES = 20 if IS_SLOW_RUN else 3
OFFER_HOLDS = 1.0
"""Seconds, as the deployment of the service says."""


def test_a_sender_that_was_killed_is_missed_when_its_offer_ends(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    subscribed(receiver)
    sender.kill()
    receiver.tells_in_any_order("Speed is pending", "found 0")


@pytest.mark.parametrize("address", ["127.0.0.50", ""], ids=["same address", "whichever is free"])
def test_a_sender_that_begins_anew_is_found_at_once(net: Network, built: Mapping[str, Path], address: str) -> None:
    own = {"SIGCAT_BENCH_ADDRESS": address} if address else {}
    sender = net.start([built["sender"]], **own).tells("ready").do("mode 0", "offer").tells("done offer")
    receiver = subscribed(net.start([built["receiver"]]).tells("found 1"))
    for turn in range(TIMES):
        sender.kill()
        sender = net.start([built["sender"]], **own).tells("ready").do(f"mode {turn % 2}", "offer")
        receiver.tells_in_any_order("found 1", "Mode is subscribed", f"mode {turn % 2}")
        sender.do(f"speed {turn}")
        receiver.tells(f"speed {turn}")


def test_a_receiver_that_begins_anew_is_sent_everything_at_once(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    subscribed(receiver)
    for turn in range(TIMES):
        receiver.kill()
        sender.do(f"mode {turn % 2}").tells("done mode")
        receiver = net.start([built["receiver"]]).tells("found 1")
        receiver.do("subscribe").tells(f"mode {turn % 2}")
        sender.do(f"speed {turn}")
        receiver.tells(f"speed {turn}")


def test_a_request_to_who_was_killed_fails_when_its_offer_ends(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    sender.kill()
    receiver.do("add 1 1").tells("done add")
    assert {"add timed out", "add failed: The service is not available. 0"} & set(receiver.told)
    if "found 0" not in receiver.told:
        receiver.tells("found 0")
    receiver.do("add 1 1").tells("add failed: The service is not available. 0")


def test_a_subscription_lasts_for_as_long_as_there_are_offers(net: Network, built: Mapping[str, Path]) -> None:
    sender, receiver = pair(net, built)
    subscribed(receiver)
    until = time.monotonic() + 2 * OFFER_HOLDS
    for number in count():
        sender.do(f"speed {number}")
        receiver.tells(f"speed {number}")
        if time.monotonic() > until:
            break
    assert "Speed is pending" not in receiver.told[receiver.told.index("Speed is subscribed") :]
