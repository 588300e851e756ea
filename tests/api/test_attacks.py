"""During an attack, an ordinary client is answered as usual, and memory stays bounded.

An ordinary GET, each on its own connection, is answered every time. Its median time is compared with that of the same requests
without an attack, measured right before: machines differ, and have other work too.
"""

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from http.client import HTTPConnection
from pathlib import Path
from statistics import median

import pytest

from tests import plain_http
from tests.api.attackers import ATTACKS
from tests.api.serving import Service, served
from tests.clients.generating import ROOT
from tests.documentation.pages import text_of
from tests.waiting import DEADLINE, wait_until

pytestmark = pytest.mark.skipif(
    not sys.platform.startswith("linux"),
    reason="Linux, which has addresses for two clients and tells the memory of a process",
)
NODE = "/api/v1/catalogues/local/nodes/Vehicle.S7"
ORDINARY = (NODE, "/api/v1/rules/V102", "/api/v1/schemas", "/api/v1/catalogues/local/nodes/Vehicle.S{0}", "/rules/V102")
"""Kept answers, answers made in a thread, answers that were never requested before, and a page."""
ASKED = 150
TIMES = 10
"""Factor by which an ordinary request may be slower during an attack."""
UNHURRIED = 0.02
"""Seconds that a request without an attack counts for at least: of less, the ratio says nothing."""


SIGNAL = "Vehicle.S{0}: {{type: sensor, datatype: float, unit: km/h, description: Signal number {0} of a tree.}}\n"


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A tree of which the longest answer has megabytes."""
    file = tmp_path_factory.mktemp("attacked") / "tree.vspec"
    file.write_text("Vehicle: {type: branch, description: A vehicle.}\n" + "".join(map(SIGNAL.format, range(10_000))))
    return file


@pytest.fixture(scope="module")
def service(tree: Path) -> Iterator[Service]:
    """As it is shipped, with as many files as systems usually allow."""
    with served(tree, ["sh", "-c", 'ulimit -n 1024 && exec "$@"', "sh"]) as service:
        wait_until(lambda: plain_http.get(service.address + NODE).is_success, "the service answers")
        yield service


def asked(service: Service) -> tuple[float, int]:
    """Median seconds of an answer, and the most memory that was held meanwhile."""
    seconds, most = [], 0
    for number in range(ASKED):
        address = ORDINARY[number % len(ORDINARY)].format(number)
        start = time.perf_counter()
        with closing(HTTPConnection(service.address.removeprefix("http://"), timeout=DEADLINE)) as connection:
            connection.request("GET", address)
            answer = connection.getresponse()
            assert (answer.status, len(answer.read()) > 100) == (200, True)
        seconds.append(time.perf_counter() - start)
        most = max(most, service.memory)
    return median(seconds), most


@contextmanager
def attacked(service: Service, attack: str) -> Iterator[None]:
    host, port = service.address.removeprefix("http://").split(":")
    command = [sys.executable, "-m", "tests.api.attackers", attack, host, port]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        assert process.stdout is not None
        try:
            assert process.stdout.readline() == "ready\n"
            yield
        finally:
            process.kill()


@pytest.mark.parametrize("attack", ATTACKS)
def test_an_ordinary_request_is_answered_and_memory_is_bounded(service: Service, attack: str) -> None:
    usual, _ = asked(service)
    memory = service.memory
    with attacked(service, attack):
        during, most = asked(service)
    assert most < 2 * memory
    assert during < TIMES * max(usual, UNHURRIED)
    assert "Traceback" not in service.log.read_text()


def test_the_page_names_each_attack() -> None:
    table = text_of("docs/how-to/production.md").partition("## Connections")[2].partition("\n## ")[0]
    assert [attack for attack in ATTACKS if f"| {attack} |" not in table] == []
