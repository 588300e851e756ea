"""Programs that use the bench, and a network for each test."""

import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from tests.adapter.autosar_adaptive.bench.building import ADDRESSES, programs
from tests.adapter.autosar_adaptive.own_network import Network, network


@pytest.fixture(scope="session")
def built() -> Mapping[str, Path]:
    """Each program, checked by the address sanitizer while it runs."""
    if sys.platform != "linux":
        pytest.skip("the bench: it runs on Linux")
    return programs(("sender", "receiver", "serialization", "core", "stress", "sessions", "storage"), ADDRESSES)


@pytest.fixture
def net(tmp_path: Path) -> Iterator[Network]:
    """A separate network."""
    with network(tmp_path) as made:
        yield made
