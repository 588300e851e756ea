"""Subscribes to an event group with pysomeip, and prints each message: its header and its payload.

Run in the network of a test: python -m tests.adapter.autosar_adaptive.application.raw_listener ADDRESS SERVICE INSTANCE GROUP
"""

import asyncio
import sys

from someip import config, header, sd

from tests.adapter.autosar_adaptive.bench.pysomeip_peer import discovery, lines, tell


class Listener(sd.SOMEIPDatagramProtocol):  # type: ignore[misc]
    """Says each message."""

    def message_received(self, message: header.SOMEIPHeader, _from: object, _multicast: bool) -> None:
        tell(f"{message.method_id:#06x} {message.build().hex()}")


async def main(address: str, service: int, instance: int, group: int) -> None:
    protocol = await discovery(address)
    await Listener.create_unicast_endpoint(local_addr=(address, 40000))
    udp = header.L4Protocols.UDP
    protocol.discovery.find_subscribe_eventgroup(config.Eventgroup(service, instance, 1, group, (address, 40000), udp))
    protocol.start()
    tell("ready")
    await (await lines()).readline()


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1], *(int(each, 0) for each in sys.argv[2:])))
