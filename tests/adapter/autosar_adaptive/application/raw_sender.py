"""Offer a service with another implementation of SOME/IP, and send its subscribers the messages in the lines of the input, unchanged.

Run in the network of a test: python -m tests.adapter.autosar_adaptive.application.raw_sender ADDRESS SERVICE INSTANCE GROUP
"""

import asyncio
import sys

from someip import service

from tests.adapter.autosar_adaptive.bench.pysomeip_peer import discovery, lines, tell


async def main(address: str, service_id: int, instance_id: int, group_id: int) -> None:
    class Offered(service.SimpleService):  # type: ignore[misc]
        version_major = 1
        version_minor = 0

    Offered.service_id = service_id
    protocol = await discovery(address)
    _, offered = await Offered.create_unicast_endpoint(instance_id, local_addr=(address, 40000))
    group = service.SimpleEventgroup(offered, id=group_id)
    offered.register_eventgroup(group)
    offered.start_announce(protocol.announcer)
    protocol.start()
    await group.has_clients.wait()
    tell("subscribed")
    reader = await lines()
    while (line := (await reader.readline()).decode().strip()) not in ("", "quit"):
        for endpoint in group.subscribed_endpoints:
            offered.send(bytes.fromhex(line), await endpoint.addrinfo())


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1], *(int(each, 0) for each in sys.argv[2:])))
