"""Messages of SOME/IP and of its service discovery, byte by byte, and a sender of them."""

import itertools
import struct
import sys
from pathlib import Path

from tests.adapter.autosar_adaptive.bench.probe_service import ADD, FAST, INSTANCE_ID, SERVICE_ID
from tests.adapter.autosar_adaptive.own_network import Network, Program

STRANGER = "127.0.0.66"
SERVICES, DISCOVERY = 30509, 30490
REQUEST, REQUEST_NO_RETURN, NOTIFICATION, RESPONSE, ERROR = 0x00, 0x01, 0x02, 0x80, 0x81
FIND_ENTRY, OFFER_ENTRY, SUBSCRIBE_ENTRY, ACKNOWLEDGE_ENTRY = 0x00, 0x01, 0x06, 0x07
FOR_EVER = 0xFFFFFF
_SESSIONS = itertools.count(1)
_PEER = Path(__file__).parent / "datagrams.py"


def message(
    method: int = ADD,
    payload: bytes = struct.pack("!ii", 40, 2),
    *,
    service: int = SERVICE_ID,
    kind: int = REQUEST,
    code: int = 0,
    protocol: int = 1,
    interface: int = 1,
    session: int = 1,
) -> bytes:
    """A message of SOME/IP."""
    head = struct.pack("!HHIHHBBBB", service, method, len(payload) + 8, 0x77, session, protocol, interface, kind, code)
    return head + payload


def entry(kind: int, ttl: int, last: bytes, *, options: int = 1, service: int = SERVICE_ID, major: int = 1) -> bytes:
    """An entry of service discovery with the first of the options, or none."""
    return (
        struct.pack("!BBBBHHB", kind, 0, 0, options << 4, service, INSTANCE_ID, major) + ttl.to_bytes(3, "big") + last
    )


def discovery(*entries: bytes, options: bytes = b"", session: int = 0, flags: int = 0xC0) -> bytes:
    """A message of service discovery; without a given session, it has the next one."""
    session = session or next(_SESSIONS)
    listed = b"".join(entries)
    payload = struct.pack("!BxxxI", flags, len(listed)) + listed + struct.pack("!I", len(options)) + options
    return message(0x8100, payload, service=0xFFFF, kind=NOTIFICATION, session=session)


def endpoint(address: str, port: int) -> bytes:
    """An option that names an endpoint of UDP."""
    return struct.pack("!HBx4BxBH", 9, 4, *map(int, address.split(".")), 0x11, port)


SUBSCRIBE = entry(0x06, 3, struct.pack("!HH", 0, FAST))
OFFER = entry(0x01, 3, struct.pack("!I", 0))
FIND = entry(0x00, 3, b"\xff" * 4, options=0)


def stranger(net: Network, port: int = 40000) -> Program:
    """Somebody who sends datagrams by hand."""
    return net.start([sys.executable, _PEER, STRANGER, str(port)]).tells("ready")


def next_datagram(program: Program) -> bytes:
    """The next one that comes to it."""
    return bytes.fromhex(program.next_line().split()[2])
