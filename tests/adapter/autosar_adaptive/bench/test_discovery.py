"""Service discovery message by message, as PRS_SOMEIPServiceDiscovery has it: searches, subscriptions, times to live, restarts."""

import struct
from collections.abc import Mapping
from pathlib import Path

import pytest

from tests.adapter.autosar_adaptive.bench.messages import (
    ACKNOWLEDGE_ENTRY,
    DISCOVERY,
    FIND,
    FOR_EVER,
    OFFER_ENTRY,
    SERVICES,
    STRANGER,
    SUBSCRIBE_ENTRY,
    discovery,
    endpoint,
    entry,
    next_datagram,
    stranger,
)
from tests.adapter.autosar_adaptive.bench.probe_service import FAST, FIELDS, INSTANCE_ID, MODE, SERVICE_ID, SPEED
from tests.adapter.autosar_adaptive.own_network import Network, Program, own_network
from tests.needs import c_compiler
from tests.waiting import wait_until

pytestmark = [own_network, c_compiler]
OURS = "127.0.0.20"
REBOOT, WRAPPED = 0xC0, 0x40
"""Flags of a sender that counts from the beginning, and of one that has begun again after 65,535."""


@pytest.fixture
def sender(net: Network, built: Mapping[str, Path]) -> Program:
    """Program that offers the service, at a known address."""
    started = net.start([built["sender"]], SIGCAT_BENCH_ADDRESS=OURS).tells("ready")
    return started.do("mode 1", "offer").tells("done offer")


def entries_of(datagram: bytes) -> list[bytes]:
    """The entries of a message of service discovery."""
    length = int.from_bytes(datagram[20:24], "big")
    return [datagram[at : at + 16] for at in range(24, 24 + length, 16)]


def next_entry(client: Program, kind: int) -> bytes:
    """The next entry of a kind."""
    while True:
        found = [each for each in entries_of(next_datagram(client)) if each[0] == kind]
        if found:
            return found[0]


def subscription(group: int, seconds: int, port: int = 40001, session: int = 0) -> bytes:
    """A subscription, for events sent to a port."""
    wish = entry(SUBSCRIBE_ENTRY, seconds, struct.pack("!HH", 0, group))
    return discovery(wish, options=endpoint(STRANGER, port), session=session)


def subscribe(client: Program, group: int, seconds: int, port: int = 40001) -> None:
    """Subscribe until it is accepted: in its initial wait, a service refuses."""
    while True:
        client.do(f"{OURS} {DISCOVERY} {subscription(group, seconds, port).hex()}")
        if next_entry(client, ACKNOWLEDGE_ENTRY)[9:12] != bytes(3):
            return


def test_a_search_is_answered_with_the_offer_and_its_endpoint(net: Network, sender: Program) -> None:
    client = stranger(net, DISCOVERY)
    subscribe(client, FAST, 1)
    client.do(f"{OURS} {DISCOVERY} {discovery(FIND).hex()}")
    answer = next_datagram(client)
    (offer,) = entries_of(answer)
    assert offer[0] == OFFER_ENTRY
    assert struct.unpack("!HHB", offer[4:9]) == (SERVICE_ID, INSTANCE_ID, 1)
    assert int.from_bytes(offer[9:12], "big") == 1
    assert answer.endswith(endpoint(OURS, SERVICES))


@pytest.mark.parametrize(
    ("service", "major"), [(0x4321, 1), (SERVICE_ID, 2)], ids=["another service", "another major version"]
)
def test_a_search_for_something_else_is_not_answered(net: Network, sender: Program, service: int, major: int) -> None:
    client = stranger(net, DISCOVERY)
    subscribe(client, FAST, 1)
    other = entry(0x00, 3, b"\xff" * 4, options=0, service=service, major=major)
    client.do(f"{OURS} {DISCOVERY} {discovery(other).hex()}")
    client.says_nothing_more(0.3)


def test_a_new_subscription_is_sent_the_value_of_a_field_and_a_renewed_one_not(net: Network, sender: Program) -> None:
    client, events = stranger(net, DISCOVERY), stranger(net, 40001)
    subscribe(client, FIELDS, 5)
    assert struct.unpack("!HH", next_datagram(events)[:4]) == (SERVICE_ID, MODE)
    subscribe(client, FIELDS, 5)
    events.says_nothing_more(0.2)
    ended = subscription(FIELDS, 0)
    client.do(f"{OURS} {DISCOVERY} {ended.hex()}")
    subscribe(client, FIELDS, 5)
    assert struct.unpack("!HH", next_datagram(events)[:4]) == (SERVICE_ID, MODE)


def test_a_subscription_ends_with_its_time_to_live(net: Network, sender: Program) -> None:
    client, ending, lasting = (stranger(net, port) for port in (DISCOVERY, 40001, 40002))
    subscribe(client, FAST, 60)
    subscribe(client, FAST, FOR_EVER, port=40002)
    sender.do("speed 1")
    assert next_datagram(ending).endswith(struct.pack("!f", 1.0))
    subscribe(client, FAST, 1)

    def is_over() -> bool:
        sender.do("speed 2").tells("done speed")
        return ending.is_silent(0.2)

    wait_until(is_over, "the shorter subscription has ended")
    sender.do("speed 3").tells("done speed")
    while not next_datagram(lasting).endswith(struct.pack("!f", 3.0)):
        pass


def test_events_are_counted(net: Network, sender: Program) -> None:
    client, events = stranger(net, DISCOVERY), stranger(net, 40001)
    subscribe(client, FAST, 5)
    sender.do("speeds 3")
    found = [struct.unpack("!HHIHH", next_datagram(events)[:12]) for _ in range(3)]
    assert [(method, session) for _, method, _, _, session in found] == [(SPEED, 1), (SPEED, 2), (SPEED, 3)]


def test_who_begins_anew_has_no_subscription_any_more(net: Network, sender: Program) -> None:
    client, events = stranger(net, DISCOVERY), stranger(net, 40001)
    client.do(f"{OURS} {DISCOVERY} {subscription(FAST, 60, session=7).hex()}")
    while next_entry(client, ACKNOWLEDGE_ENTRY)[9:12] == bytes(3):
        client.do(f"{OURS} {DISCOVERY} {subscription(FAST, 60, session=8).hex()}")
    client.do(f"{OURS} {DISCOVERY} {discovery(session=1).hex()}")
    client.do(f"{OURS} {DISCOVERY} {discovery(FIND, session=2).hex()}")
    next_entry(client, OFFER_ENTRY)
    sender.do("speed 1").tells("done speed")
    events.says_nothing_more(0.2)


@pytest.mark.parametrize(
    ("sessions", "is_lost"),
    [
        ([(REBOOT, 1), (REBOOT, 2), (REBOOT, 65535)], False),
        ([(REBOOT, 65535), (WRAPPED, 1), (WRAPPED, 2)], False),
        ([(WRAPPED, 65535), (WRAPPED, 1)], False),
        ([(REBOOT, 5), (REBOOT, 5)], True),
        ([(REBOOT, 5), (REBOOT, 1)], True),
        ([(WRAPPED, 5), (REBOOT, 6)], True),
    ],
    ids=["counts on", "wraps", "wraps again", "the same again", "from the beginning", "reboots after it wrapped"],
)
def test_a_restart_is_told_from_the_session_and_its_flag(
    net: Network, built: Mapping[str, Path], sessions: list[tuple[int, int]], is_lost: bool
) -> None:
    receiver = net.start([built["receiver"]], SIGCAT_BENCH_ADDRESS=OURS).tells("ready")
    server = stranger(net, DISCOVERY)
    offer = entry(OFFER_ENTRY, FOR_EVER, struct.pack("!I", 0))
    for flags, session in sessions:
        whole = discovery(offer, options=endpoint(STRANGER, SERVICES), flags=flags, session=session)
        server.do(f"{OURS} {DISCOVERY} {whole.hex()}")
    receiver.tells("found 1")
    if is_lost:
        receiver.tells("found 0", "found 1")
    else:
        receiver.says_nothing_more(0.3)


def test_an_offer_of_another_major_version_is_logged_once_with_both(net: Network, built: Mapping[str, Path]) -> None:
    receiver = net.start([built["receiver"]], SIGCAT_BENCH_ADDRESS=OURS).tells("ready")
    server = stranger(net, DISCOVERY)
    for session, major in enumerate((2, 2, 1), 1):
        offer = entry(OFFER_ENTRY, FOR_EVER, struct.pack("!I", 7), major=major)
        whole = discovery(offer, options=endpoint(STRANGER, SERVICES), session=session)
        server.do(f"{OURS} {DISCOVERY} {whole.hex()}")
    receiver.tells("found 1")
    assert receiver.errors.count("ProbeService: version 2.7 is offered, but version 1.0 is needed") == 1


@pytest.mark.parametrize(
    ("address", "reason"),
    [
        (OURS, "cannot be used: Address already in use"),
        ("192.0.2.1", "must be a loopback address such as 127.0.0.2, not 192.0.2.1"),
        ("localhost", "must be a loopback address such as 127.0.0.2, not localhost"),
    ],
)
def test_a_process_whose_address_cannot_be_used_says_why(
    net: Network, built: Mapping[str, Path], sender: Program, address: str, reason: str
) -> None:
    other = net.start([built["receiver"]], SIGCAT_BENCH_ADDRESS=address)
    assert other.process.wait(60) != 0
    assert reason in other.errors
    sender.do("quit")


def test_our_own_sessions_count_from_1_and_wrap_without_the_flag(net: Network, built: Mapping[str, Path]) -> None:
    net.start([built["sessions"]]).tells("1 up", "65535 up", "1 down", "65535 down", "1 down")
