"""The network may send anything: an error is answered, or nothing; the next message is served."""

import struct
from collections.abc import Mapping
from pathlib import Path

import pytest

from tests.adapter.autosar_adaptive.bench.messages import (
    DISCOVERY,
    ERROR,
    FIND,
    NOTIFICATION,
    OFFER,
    REQUEST_NO_RETURN,
    RESPONSE,
    SERVICES,
    STRANGER,
    SUBSCRIBE,
    discovery,
    endpoint,
    entry,
    message,
    next_datagram,
    stranger,
)
from tests.adapter.autosar_adaptive.bench.probe_service import FAST, IMAGE, SPEED, TRACK
from tests.adapter.autosar_adaptive.own_network import Network, Program, own_network
from tests.needs import c_compiler
from tests.properties import FUZZ, seeds

pytestmark = [own_network, c_compiler]
SENDER = "127.0.0.20"
HERE = "tests/adapter/autosar_adaptive/bench/test_hostile.py"
TRIES = 25_000 if FUZZ else 1000
"""Spoilt datagrams of each of four kinds; `make fuzz` sends 100,000, other ones each time."""


@pytest.fixture
def sender(net: Network, built: Mapping[str, Path]) -> Program:
    """Program that offers the service, at a known address."""
    started = net.start([built["sender"]], SIGCAT_BENCH_ADDRESS=SENDER).tells("ready")
    return started.do("mode 0", "offer").tells("done offer")


@pytest.mark.parametrize(
    ("request_", "code"),
    [
        (message(service=0x4321), 0x02),
        (message(0x7777), 0x03),
        (message(protocol=2), 0x07),
        (message(interface=2), 0x08),
        (message(payload=b"\x00\x00\x00"), 0x09),
        (message(payload=b""), 0x09),
    ],
    ids=["unknown service", "unknown method", "protocol version", "interface version", "short", "empty"],
)
def test_a_request_that_cannot_be_served_is_answered_with_its_error(
    net: Network, sender: Program, request_: bytes, code: int
) -> None:
    client = stranger(net).do(f"{SENDER} {SERVICES} {request_.hex()}")
    answer = next_datagram(client)
    assert answer[:4] == request_[:4]
    assert answer[8:12] == request_[8:12]
    assert (answer[14], answer[15]) == (ERROR, code)
    sender.quit()


@pytest.mark.parametrize(
    "datagram",
    [
        message(kind=REQUEST_NO_RETURN),
        message(0x7777, kind=REQUEST_NO_RETURN),
        message(kind=RESPONSE),
        message(kind=ERROR, code=1),
        message(SPEED, b"\x00" * 4, kind=NOTIFICATION),
        message(kind=0x42),
        message()[:15],
        message()[:4] + b"\xff\xff\xff\xff" + message()[8:],
        message()[:4] + b"\x00\x00\x00\x07" + message()[8:],
        b"",
    ],
    ids=[
        "no answer expected", "no answer expected of an unknown method", "answer", "error", "event", "unknown type",
        "cut", "too long", "too short", "empty",
    ],
)  # fmt: skip
def test_what_asks_for_no_answer_gets_none_and_the_next_is_served(
    net: Network, sender: Program, datagram: bytes
) -> None:
    client = stranger(net).do(f"{SENDER} {SERVICES} {datagram.hex()}") if datagram else stranger(net)
    client.do(f"{SENDER} {SERVICES} {message(session=9).hex()}")
    answer = next_datagram(client)
    assert answer == message(payload=struct.pack("!i", 42), kind=RESPONSE, session=9)
    sender.quit()


def test_several_messages_in_a_datagram_are_all_served(net: Network, sender: Program) -> None:
    both = message(session=1) + message(payload=struct.pack("!ii", 1, 1), session=2)
    client = stranger(net).do(f"{SENDER} {SERVICES} {both.hex()}")
    answers = [next_datagram(client) for _ in range(2)]
    assert [struct.unpack("!i", answer[16:])[0] for answer in answers] == [42, 2]


@pytest.mark.parametrize(
    ("wrong", "options"),
    [
        (entry(0x06, 3, struct.pack("!HH", 0, 0x99)), endpoint(STRANGER, 40000)),
        (entry(0x06, 3, struct.pack("!HH", 0, FAST), major=2), endpoint(STRANGER, 40000)),
        (entry(0x06, 3, struct.pack("!HH", 0, FAST), service=0x4321), endpoint(STRANGER, 40000)),
        (entry(0x06, 3, struct.pack("!HH", 0, FAST), options=0), b""),
        (SUBSCRIBE, endpoint("192.0.2.1", 40000)),
    ],
    ids=["unknown group", "major version", "unknown service", "no endpoint", "endpoint outside of loopback"],
)
def test_a_subscription_that_cannot_be_is_refused(net: Network, sender: Program, wrong: bytes, options: bytes) -> None:
    client = stranger(net, DISCOVERY)
    while True:  # until the service is past its initial wait, every subscription is refused
        client.do(f"{SENDER} {DISCOVERY} {discovery(SUBSCRIBE, options=endpoint(STRANGER, 40000)).hex()}")
        if acknowledged(client) > 0:
            break
    client.do(f"{SENDER} {DISCOVERY} {discovery(wrong, options=options).hex()}")
    assert acknowledged(client) == 0
    sender.quit()


def acknowledged(client: Program) -> int:
    """Seconds for which the next acknowledgement holds; 0 refuses."""
    while True:
        answer = next_datagram(client)
        if answer[24] == 0x07:
            return int.from_bytes(answer[33:36], "big")


@pytest.mark.parametrize("seed", seeds(f"{HERE}::test_a_sender_stands_spoilt_datagrams", 1))
def test_a_sender_stands_spoilt_datagrams(net: Network, sender: Program, seed: int) -> None:
    client = stranger(net)
    good = [
        message(),
        message(0x0002, b""),
        message(0x0003, b""),
        message(kind=0x20, payload=b"\x00\x00\x00\x01" + b"x" * 16),
    ]
    searches = [
        discovery(SUBSCRIBE, FIND, options=endpoint(STRANGER, 40001)),
        discovery(OFFER, options=endpoint(STRANGER, 40001)),
        discovery(SUBSCRIBE, SUBSCRIBE, options=endpoint(STRANGER, 40001) * 3),
    ]
    for port, samples in ((SERVICES, good), (DISCOVERY, searches)):
        client.do(f"fuzz {seed} {TRIES} {SENDER} {port} {' '.join(each.hex() for each in samples)}").tells(
            f"sent {TRIES}", within=120
        )
    client.do(f"{SENDER} {SERVICES} {message(payload=struct.pack('!ii', 1000, 1), session=77).hex()}")
    client.tells(f"{SENDER} {SERVICES} {message(payload=struct.pack('!i', 1001), kind=RESPONSE, session=77).hex()}")
    sender.quit()


@pytest.mark.parametrize("seed", seeds(f"{HERE}::test_a_receiver_stands_spoilt_datagrams", 2))
def test_a_receiver_stands_spoilt_datagrams(net: Network, built: Mapping[str, Path], seed: int) -> None:
    receiver = net.start([built["receiver"]], SIGCAT_BENCH_ADDRESS=SENDER).tells("ready")
    server = stranger(net, SERVICES)
    offers = discovery(OFFER, options=endpoint(STRANGER, SERVICES))
    lasting = discovery(entry(0x01, 0xFFFFFF, struct.pack("!I", 0)), options=endpoint(STRANGER, SERVICES))
    server.do(f"{SENDER} {DISCOVERY} {lasting.hex()}")
    receiver.tells("found 1").do("subscribe").tells("done subscribe")
    events = [
        message(SPEED, struct.pack("!f", 1.0), kind=NOTIFICATION),
        message(TRACK, bytes.fromhex("00000006efbbbf6162 00 01 00000008 0001fffe0003fffc 00000003 010001 3fe0000000000000"), kind=NOTIFICATION),
        message(IMAGE, struct.pack("!I", 5) + b"12345", kind=NOTIFICATION),
        message(IMAGE, b"\x00\x00\x00\x01" + struct.pack("!I", 1500) + b"x" * 1388, kind=0x22),
    ]  # fmt: skip
    server.do(f"fuzz {seed} {TRIES} {SENDER} {SERVICES} {' '.join(each.hex() for each in events)}").tells(
        f"sent {TRIES}", within=120
    )
    server.do(f"fuzz {seed + 1} {TRIES} {SENDER} {DISCOVERY} {offers.hex()}").tells(f"sent {TRIES}", within=120)
    # Like a restarted sender: the content of the last damaged offer is forgotten.
    server.do(f"{SENDER} {DISCOVERY} {lasting.hex()}", f"{SENDER} {DISCOVERY} {lasting.hex()}")
    server.do(f"{SENDER} {SERVICES} {message(SPEED, struct.pack('!f', 4711.0), kind=NOTIFICATION).hex()}")
    receiver.tells("speed 4711").do("quit")
    assert receiver.process.wait(20) == 0
    assert "ERROR" not in receiver.errors
