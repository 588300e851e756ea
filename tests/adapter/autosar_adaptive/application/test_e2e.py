"""Messages that end-to-end protection rejects set the error of the function, over the wire, and it heals."""

import struct
import sys
from pathlib import Path

import pytest
from e2e import p04, p05

from scripts import run_autosar
from sigcat.function.function_file import build_function
from sigcat.function.function_json.wire import written
from tests.adapter.autosar_adaptive.application.generated import files, write
from tests.adapter.autosar_adaptive.application.test_generate import STRICT
from tests.adapter.autosar_adaptive.own_network import network, own_network
from tests.function.shipped import interfaces
from tests.integration.autosar_adaptive.sets import deployed, derive
from tests.needs import cmake, sampled

pytestmark = [cmake, own_network]

GUARD = Path(__file__).parent / "guard"
MOST = 3
"""Two messages may be lost."""


def integrated(profile):
    function, _ = build_function((GUARD / "function.yaml").read_bytes(), "function.yaml", interfaces())
    return derive([function], deployed(autosarAdaptive={"e2e": {"profile": profile, "maxDeltaCounter": MOST}})).model


class Sender:
    """Messages of the event, as autosar-e2e makes them: each has the next counter."""

    def __init__(self, interface, event, program, counter):
        self._head = struct.pack("!HH", interface.service_id, event.event_id)
        self._protection, self._program, self._counter, self._last = event.protection, program, counter, b""

    def send(self, value, *, lost=0, spoilt=False):
        """Send a value, after so many that were lost, or with one bit wrong."""
        self._counter += lost
        half = bytes.fromhex("0000 0001 01 01 02 00")
        data = bytearray(half + self._header() + struct.pack("!f", value))
        protect = p04.e2e_p04_protect if self._protection.profile == 4 else p05.e2e_p05_protect
        protect(data, self._protection.data_id, offset=len(half), increment_counter=False)
        self._counter += 1
        if spoilt:
            data[-1] ^= 1
        self._last = self._head + struct.pack("!I", len(data)) + bytes(data)
        self.repeat()

    def _header(self):
        if self._protection.profile == 4:
            return struct.pack("!HHII", 0, self._counter % 2**16, 0, 0)
        return struct.pack("!HB", 0, self._counter % 2**8)

    def repeat(self):
        """Send the last one again."""
        self._program.do(self._last.hex())


@pytest.fixture(scope="module", params=sampled([4, 5], [4]))
def running(request, tmp_path_factory):
    """The application and its sender, which is there first: the application hears it from its hundredth message on."""
    model = integrated(request.param)
    folder = tmp_path_factory.mktemp("guard")
    write(files(written(model), bench=True), folder)
    run_autosar.build(folder, " ".join(STRICT), "-DCMAKE_BUILD_TYPE=None", code={"GUARD_CODE": GUARD})
    interface = next(each for each in model.components[0].services if each.services[0].events)
    ids = (interface.service_id, interface.instance_id, interface.event_groups[0].id)
    with network(folder) as net:
        module = f"{__package__}.raw_sender"
        peer = net.start([sys.executable, "-m", module, "127.0.0.100", *map(str, ids)])
        guard = net.start([folder / "build/GuardExecutable/GuardExecutable"], BENCH_STORAGE=str(folder))
        peer.tells("subscribed")
        yield guard, Sender(interface, interface.services[0].events[0], peer, counter=100)


def test_broken_repeated_and_lost_messages_set_the_error_and_the_next_good_one_heals_it(running):
    guard, sender = running
    sender.send(1)
    guard.tells("speed 1.0, sound")
    sender.send(9, spoilt=True)
    guard.tells("speed 1.0, broken")
    sender.send(2)
    guard.tells("speed 2.0, sound")
    sender.repeat()
    guard.tells("speed 2.0, broken")
    sender.send(3)
    guard.tells("speed 3.0, sound")
    sender.send(4, lost=MOST - 1)
    guard.tells("speed 4.0, sound")
    sender.send(5, lost=MOST)
    guard.tells("speed 4.0, broken")
    sender.send(6)
    guard.tells("speed 6.0, sound")
    assert not [line for line in guard.told if "9.0" in line or "5.0" in line]
