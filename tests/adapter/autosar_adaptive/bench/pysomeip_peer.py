"""The service of the tests on another implementation of SOME/IP: offered (`server`) or used (`client`), by the lines of the input.

Run in the network of a test: python -m tests.adapter.autosar_adaptive.bench.pysomeip_peer server|client ADDRESS
"""

import asyncio
import struct
import sys

from someip import config, header, sd, service

from tests.adapter.autosar_adaptive.bench import probe_service as probe

GROUP = ("224.244.224.245", 30490)
TIMES = {
    "INITIAL_DELAY_MAX": 0.01,
    "REQUEST_RESPONSE_DELAY_MIN": 0.0,
    "REQUEST_RESPONSE_DELAY_MAX": 0.005,
    "CYCLIC_OFFER_DELAY": 0.2,
    "ANNOUNCE_TTL": 1,
    "SUBSCRIBE_TTL": 1,
    "SUBSCRIBE_REFRESH_INTERVAL": 0.2,
}


def tell(line: str) -> None:
    print(line, flush=True)


class Probe(service.SimpleService):  # type: ignore[misc]
    """The counterpart of the C++ sender of the tests."""

    service_id = probe.SERVICE_ID
    version_major = 1
    version_minor = 0

    def __init__(self, instance_id: int) -> None:
        super().__init__(instance_id)
        self.register_method(probe.ADD, self._add)
        self.register_method(probe.RESET, lambda _request, _from: b"")
        self.register_method(probe.GET_MODE, lambda _request, _from: b"\x01")
        self.fast = service.SimpleEventgroup(self, id=probe.FAST)
        fields = service.SimpleEventgroup(self, id=probe.FIELDS)
        fields.values[probe.MODE] = b"\x01"
        self.register_eventgroup(self.fast)
        self.register_eventgroup(fields)

    @staticmethod
    def _add(request: header.SOMEIPHeader, _from: object) -> bytes:
        if len(request.payload) != 8:
            raise service.MalformedMessageError
        left, right = struct.unpack("!ii", request.payload)
        return struct.pack("!i", left + right)


class Client(sd.SOMEIPDatagramProtocol):  # type: ignore[misc]
    """Tells every message that comes."""

    def message_received(self, message: header.SOMEIPHeader, _from: object, _multicast: bool) -> None:
        kind = message.message_type.name.lower()
        tell(f"{kind} {message.method_id:#06x} {message.return_code.name} {message.payload.hex()}")


class Watcher(sd.ClientServiceListener):  # type: ignore[misc]
    """Tells offers, and where they lead."""

    def __init__(self, found: asyncio.Future[tuple[str, int]]) -> None:
        self._found = found

    def service_offered(self, offered: config.Service, _source: object) -> None:
        option = offered.options_1[0]
        tell(f"offered {offered.service_id:#06x} {offered.instance_id:#06x} {offered.major_version}")
        if not self._found.done():
            self._found.set_result((str(option.address), option.port))

    def service_stopped(self, _stopped: config.Service, _source: object) -> None:
        tell("stopped")


async def lines() -> asyncio.StreamReader:
    reader = asyncio.StreamReader()
    await asyncio.get_running_loop().connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), sys.stdin)
    return reader


async def discovery(address: str) -> sd.ServiceDiscoveryProtocol:
    *_, protocol = await sd.ServiceDiscoveryProtocol.create_endpoints(
        family=2, local_addr=address, multicast_addr=GROUP[0], port=GROUP[1]
    )
    for name, seconds in TIMES.items():  # its parts share them
        setattr(protocol.timings, name, seconds)
    return protocol


async def serve(address: str) -> None:
    protocol = await discovery(address)
    _, probe_service = await Probe.create_unicast_endpoint(probe.INSTANCE_ID, local_addr=(address, 40000))
    probe_service.start_announce(protocol.announcer)
    protocol.start()
    tell("ready")
    reader = await lines()
    while (line := (await reader.readline()).decode().strip()) not in ("", "quit"):
        event, payload = line.split()
        probe_service.fast.values[int(event, 0)] = bytes.fromhex(payload)
        probe_service.fast.notify_once([int(event, 0)])
    protocol.stop()
    await asyncio.sleep(0.1)


async def use(address: str) -> None:
    protocol = await discovery(address)
    found: asyncio.Future[tuple[str, int]] = asyncio.get_running_loop().create_future()
    _, client = await Client.create_unicast_endpoint(local_addr=(address, 40000))
    wanted = config.Service(probe.SERVICE_ID)
    protocol.discovery.watch_service(wanted, Watcher(found))
    for group in (probe.FAST, probe.FIELDS):
        protocol.discovery.find_subscribe_eventgroup(
            config.Eventgroup(probe.SERVICE_ID, probe.INSTANCE_ID, 1, group, (address, 40000), header.L4Protocols.UDP)
        )
    protocol.start()
    tell("ready")
    reader = await lines()
    while (line := (await reader.readline()).decode().strip()) not in ("", "quit"):
        method, version, payload = line.split()
        request = header.SOMEIPHeader(
            service_id=probe.SERVICE_ID,
            method_id=int(method, 0),
            client_id=1,
            session_id=1,
            interface_version=int(version),
            message_type=header.SOMEIPMessageType.REQUEST,
            payload=bytes.fromhex(payload.strip("-")),
        )
        client.send(request.build(), await found)
    protocol.stop()
    await asyncio.sleep(0.1)


if __name__ == "__main__":
    asyncio.run({"server": serve, "client": use}[sys.argv[1]](sys.argv[2]))
