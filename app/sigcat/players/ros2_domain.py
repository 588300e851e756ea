"""A domain of DDS for the nodes of one run: they find each other, and nothing else on this machine."""

import socket
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from sigcat.players.commands import BuildFails

_FIRST_PORT = 22119
"""Whoever holds this port, plus the number of a domain, has the domain."""
_DOMAINS = range(1, 100)


@contextmanager
def own_domain() -> Iterator[int]:
    """One that no other run of sigcat has. Raises BuildFails if all are taken."""
    with socket.socket() as held:
        for number in _DOMAINS:
            try:
                held.bind(("127.0.0.1", _FIRST_PORT + number))
            except OSError:
                continue
            yield number
            return
    raise BuildFails("every domain of DDS on this machine is taken")


def variables_in_domain(number: int, home: Path) -> Mapping[str, str]:
    """Return the environment of the processes of a domain: they keep their files in a folder and stay on this machine."""
    return {
        "ROS_DOMAIN_ID": str(number),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "ROS_HOME": str(home),
        "ROS_LOG_DIR": str(home / "log"),
    }
