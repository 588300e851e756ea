"""The bench and pysomeip, an independent implementation, understand each other: discovery, subscriptions, events, methods."""

import struct
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from sigcat.adapter.autosar_adaptive.arxml.method_errors import DOMAIN_ID
from tests.adapter.autosar_adaptive.bench.probe_service import (
    ADD,
    GET_MODE,
    IMAGE,
    INSTANCE_ID,
    MODE,
    RESET,
    SERVICE_ID,
    SPEED,
)
from tests.adapter.autosar_adaptive.own_network import Network, Program, own_network
from tests.needs import c_compiler
from tests.reference_tools import checked_with

pytestmark = [own_network, c_compiler]
_PEER = "tests.adapter.autosar_adaptive.bench.pysomeip_peer"


def application_error(code: int) -> str:
    """The payload of an answer that is an application error: a union of a struct of domain and code (SWS_CM_10428)."""
    return struct.pack("!IBHQi", 14, 1, 12, DOMAIN_ID, code).hex()


def peer(net: Network, role: str) -> Program:
    """pysomeip in the network."""
    return net.start([sys.executable, "-m", _PEER, role, "127.0.0.100"]).tells("ready")


@checked_with("pysomeip", "Both find, subscribe to, notify and answer each other over SOME/IP")
def test_it_finds_what_we_offer_and_hears_that_it_ends(net: Network, built: Mapping[str, Path]) -> None:
    client = peer(net, "client")
    sender = net.start([built["sender"]]).tells("ready").do("mode 1", "offer")
    client.tells(f"offered {SERVICE_ID:#06x} {INSTANCE_ID:#06x} 1")
    sender.do("stop")
    client.tells("stopped")


@checked_with("pysomeip", "Both find, subscribe to, notify and answer each other over SOME/IP")
def test_it_is_sent_our_events_and_the_value_of_our_field(net: Network, built: Mapping[str, Path]) -> None:
    sender = net.start([built["sender"]]).tells("ready").do("mode 1", "offer").tells("done offer")
    client = peer(net, "client").tells(f"notification {MODE:#06x} E_OK 01")
    sender.do("speed 2.5", "image 3")
    client.tells(f"notification {SPEED:#06x} E_OK {struct.pack('!f', 2.5).hex()}")
    client.tells(f"notification {IMAGE:#06x} E_OK 00000003000102")


@checked_with("pysomeip", "Both find, subscribe to, notify and answer each other over SOME/IP")
@pytest.mark.parametrize(
    ("request_", "answer"),
    [
        (f"{ADD} 1 {struct.pack('!ii', 40, 2).hex()}", f"response {ADD:#06x} E_OK 0000002a"),
        (f"{RESET} 1 -", f"response {RESET:#06x} E_OK "),
        (f"{GET_MODE} 1 -", f"response {GET_MODE:#06x} E_OK 01"),
        (f"{ADD} 1 0000", f"error {ADD:#06x} E_MALFORMED_MESSAGE "),
        (f"{ADD} 1 {struct.pack('!ii', -1, 1).hex()}", f"error {ADD:#06x} E_NOT_OK {application_error(1)}"),
        (f"{ADD} 1 {struct.pack('!ii', -1, -1).hex()}", f"error {ADD:#06x} E_NOT_OK {application_error(2)}"),
        (f"{ADD} 1 {struct.pack('!ii', 1, -1).hex()}", f"error {ADD:#06x} E_NOT_OK "),
        (f"{ADD} 2 {struct.pack('!ii', 1, 1).hex()}", f"error {ADD:#06x} E_WRONG_INTERFACE_VERSION "),
        ("119 1 -", "error 0x0077 E_UNKNOWN_METHOD "),
    ],
)
def test_its_requests_are_answered(net: Network, built: Mapping[str, Path], request_: str, answer: str) -> None:
    net.start([built["sender"]]).tells("ready").do("mode 1", "offer").tells("done offer")
    client = peer(net, "client").tells(f"offered {SERVICE_ID:#06x} {INSTANCE_ID:#06x} 1")
    client.do(request_).tells(answer)


@checked_with("pysomeip", "Both find, subscribe to, notify and answer each other over SOME/IP")
def test_we_find_what_it_offers_and_hear_that_it_ends(net: Network, built: Mapping[str, Path]) -> None:
    receiver = net.start([built["receiver"]]).tells("ready")
    server = peer(net, "server")
    receiver.tells("found 1")
    server.quit()
    receiver.tells("found 0")


@checked_with("pysomeip", "Both find, subscribe to, notify and answer each other over SOME/IP")
def test_we_are_sent_its_events_and_the_value_of_its_field(net: Network, built: Mapping[str, Path]) -> None:
    server = peer(net, "server")
    receiver = net.start([built["receiver"]]).tells("found 1").do("subscribe")
    receiver.tells_in_any_order("Speed is subscribed", "mode 1")
    server.do(f"{SPEED} {struct.pack('!f', 2.5).hex()}")
    receiver.tells("speed 2.5")


@checked_with("pysomeip", "Both find, subscribe to, notify and answer each other over SOME/IP")
def test_it_answers_our_requests(net: Network, built: Mapping[str, Path]) -> None:
    peer(net, "server")
    receiver = net.start([built["receiver"]]).tells("found 1")
    receiver.do("add 40 2").tells("sum 42")
    receiver.do("reset").tells("reset")
    receiver.do("get").tells("got 1")
