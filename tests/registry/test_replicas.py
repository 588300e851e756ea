"""Services on one database: many writers at once, and services and databases that are killed."""

import random
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from pathlib import Path
from shutil import copyfile, disk_usage

import httpx
import pytest

from sigcat.registry.published import all_versions
from sigcat.registry.storing.database import Place, reading
from sigcat.registry.storing.verify import verify
from tests.needs import IS_SLOW_RUN, own_disk, postgresql
from tests.registry.served import function_file
from tests.registry.server import Server, programs, running
from tests.registry.test_over_a_server import PROJECT, Served, serving, write

pytestmark = pytest.mark.real
WRITERS, PUBLISHES = 20, 1_000 if IS_SLOW_RUN else 200
KILLS = 100 if IS_SLOW_RUN else 4
"""Kills of a service, and of a database."""
_WAIT = 60


def project(folder: Path, place: Place) -> Path:
    folder.mkdir()
    write(folder, f"[registry]\ndatabase = {str(place)!r}\n{PROJECT}")
    return folder


def post(address: str, version: str) -> httpx.Response:
    """Publish a version of one name."""
    body = function_file("Shared", "{path: Vehicle.S0, role: provided}", version)
    return httpx.post(f"{address}/api/v1/registry/publish", content=body, timeout=_WAIT)


def stored(place: Place) -> Sequence[str]:
    with reading(place) as connection:
        assert verify(connection).findings == ()
        return [each.version for each in all_versions(connection)]


@own_disk
def test_on_a_full_disk_a_service_answers_507_and_publishes_nothing_by_half(tmp_path: Path) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = 'mount -t tmpfs -o size=4m tmpfs "$0" && exec "$@"'
    with serving(
        project(tmp_path / "served", disk / "registry.db"), before=("unshare", "-Urm", "sh", "-c", mount, str(disk))
    ) as service:
        first = post(service.address, "1.0.0")
        assert first.status_code == 201, first.text
        filler = Path(f"/proc/{service.process.pid}/root{disk}/filler")
        filler.write_bytes(bytes(disk_usage(filler.parent).free - 150_000))
        names = [f"1.{number}.0" for number in range(1, 60)]
        answers = [(name, post(service.address, name).status_code) for name in names]
        assert {status for _, status in answers} == {201, 507}
        address = f"{service.address}/api/v1/registry/functions/Shared/versions/1.0.0"
        assert httpx.get(address, timeout=_WAIT).status_code == 200, "reading works on a full disk"
        filler.unlink()
        published = ["1.0.0", *(name for name, status in answers if status == 201)]
        assert post(service.address, "2.0.0").status_code == 201
        for name in ("registry.db", "registry.db-wal"):
            copyfile(filler.with_name(name), tmp_path / name)
        found = stored(tmp_path / "registry.db")
        assert sorted(found) == sorted([*published, "2.0.0"])


@postgresql
def test_twenty_writers_and_two_replicas_publish_each_version_once(server: Server, tmp_path: Path) -> None:
    place = server.new_database()
    statuses: Counter[int] = Counter()

    def publish(addresses: Sequence[str], number: int) -> None:
        while (answer := post(addresses[number % 2], f"1.{number}.0")).status_code in (429, 503):
            statuses[answer.status_code] += 1
            time.sleep(float(answer.headers["retry-after"]))
        statuses[answer.status_code] += 1

    with ExitStack() as stack:
        folders = (project(tmp_path / name, place) for name in ("one", "other"))
        services = [stack.enter_context(serving(folder)) for folder in folders]
        with ThreadPoolExecutor(WRITERS) as pool:
            list(pool.map(lambda number: publish([each.address for each in services], number), range(PUBLISHES)))
    assert statuses.keys() <= {201, 429, 503}  # a busy replica gives one client a share, and says when to come again
    assert statuses[201] == PUBLISHES
    assert sorted(stored(place)) == sorted(f"1.{number}.0" for number in range(PUBLISHES))


@postgresql
def test_when_a_replica_is_killed_under_load_only_its_requests_fail(server: Server, tmp_path: Path) -> None:
    place = server.new_database()
    with serving(project(tmp_path / "one", place)) as one, serving(project(tmp_path / "other", place)) as other:
        answered = {each: list[str]() for each in (one.address, other.address)}
        failed: Counter[str] = Counter()

        def publish(number: int) -> None:
            address = (one, other)[number % 2].address
            try:
                answer = post(address, f"1.{number}.0")
            except httpx.HTTPError:
                failed[address] += 1
                return
            assert answer.status_code == 201, answer.text
            answered[address].append(f"1.{number}.0")

        with ThreadPoolExecutor(4) as pool:
            found = pool.map(publish, range(60))
            while len(answered[one.address]) < 5:
                time.sleep(0.01)
            one.process.kill()
            list(found)
    assert failed.keys() == {one.address}
    assert len(answered[other.address]) == 30
    found_versions = stored(place)
    assert {each for versions in answered.values() for each in versions} <= set(found_versions)


class Publishing:
    """A client that publishes one version after the other, until it is stopped or gets no answer."""

    def __init__(self, address: str, numbers: Iterator[int]) -> None:
        self.answered: list[str] = []
        self.asked: list[str] = []
        self.faults: list[str] = []
        self._address, self._numbers, self._is_stopped = address, numbers, False
        self._thread = threading.Thread(target=self._publish)
        self._thread.start()

    def _publish(self) -> None:
        for number in self._numbers:
            if self._is_stopped:
                return
            version = f"1.{number}.0"
            self.asked.append(version)
            try:
                answer = post(self._address, version)
            except httpx.HTTPError:
                return
            if answer.status_code == 201:
                self.answered.append(version)
            elif answer.status_code != 503:
                self.faults.append(answer.text)

    def killed_after(self, seconds: float, kill: Callable[[], None]) -> None:
        """Kill something after its first answer and some time."""
        while not self.answered and not self.faults and self._thread.is_alive():
            time.sleep(0.005)
        time.sleep(seconds)
        kill()
        self._is_stopped = True
        self._thread.join(_WAIT)
        assert self.faults == []


def check(place: Place, answered: Sequence[str], asked: Sequence[str]) -> None:
    """Every answered version is there, and none that nobody asked for."""
    found = stored(place)
    assert set(answered) <= set(found) <= set(asked)


def test_a_service_that_is_killed_keeps_what_it_answered(place: Place, tmp_path: Path) -> None:
    folder, numbers, chance = project(tmp_path / "served", place), iter(range(1_000_000)), random.Random(1)
    answered, asked = list[str](), list[str]()
    for _ in range(KILLS):
        with serving(folder) as service:
            client = Publishing(service.address, numbers)
            client.killed_after(chance.uniform(0, 0.5), service.process.kill)
        answered += client.answered
        asked += client.asked
        check(place, answered, asked)
    assert len(answered) >= KILLS


@postgresql
def test_a_database_that_is_killed_keeps_what_the_service_answered(tmp_path: Path) -> None:
    folder = programs()
    assert folder is not None
    numbers, chance = iter(range(1_000_000)), random.Random(2)
    answered, asked = list[str](), list[str]()
    with running(folder) as server:
        place = server.new_database()
        with serving(project(tmp_path / "served", place)) as service:
            for _ in range(KILLS):
                client = Publishing(service.address, numbers)
                client.killed_after(chance.uniform(0, 0.5), server.kill)
                answered += client.answered
                asked += client.asked
                assert is_away(service)
                server.start()
                check(place, answered, asked)
    assert len(answered) >= KILLS


def is_away(service: Served) -> bool:
    answer = httpx.get(f"{service.address}/api/v1/registry/functions", timeout=_WAIT)
    return answer.status_code == 503 and "retry-after" in answer.headers
