"""Pages that cost much wait in the same queue as the API's heavy routes."""

import asyncio
import threading
from collections.abc import Iterator

import pytest

from sigcat.api.settings import Settings
from sigcat.api.work.queue import WorkQueue
from sigcat.catalogue.hosting.library import Library
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES, Ask, asker
from tests.waiting import wait_until


@pytest.fixture
def busy() -> Iterator[Ask]:
    """A service all of whose heavy work is taken, and that lets nothing wait."""
    app = create_site(Library(SOURCES), Settings(heavy_requests=1, heavy_waiting=0, heavy_seconds=20))
    queue: WorkQueue = app.state.work_queue
    done = threading.Event()
    holder = threading.Thread(target=lambda: asyncio.run(queue.of("a client").run_here(done.wait, 20)))
    holder.start()
    wait_until(lambda: queue.pending, "the only place is taken")
    yield asker(app)
    done.set()
    holder.join()


@pytest.mark.parametrize(
    ("address", "method"),
    [
        ("/try", "GET"), ("/try", "POST"), ("/wiring", "GET"), ("/wiring", "POST"), ("/wiring.json", "GET"),
        ("/changes?old=bare&new=small", "GET"), ("/tree/small~folded", "GET"),
        ("/api/v1/catalogues/small~folded/units", "GET"),
    ],
)  # fmt: skip
def test_heavy_pages_are_refused_while_the_service_is_busy(busy: Ask, address: str, method: str) -> None:
    answer = busy(address, method, **({"content": "kind=overlay&text=a"} if method == "POST" else {}))
    assert answer.status_code == 503
    assert answer.headers["retry-after"] == "2"
    if not address.startswith("/api") and not address.endswith(".json"):
        assert "Service busy" in answer.text
        assert "Try again in 2\u00a0seconds" in answer.text


@pytest.mark.parametrize("address", ["/tree/small/Vehicle.Speed", "/search/small?q=speed", "/units/small", "/docs"])
def test_other_pages_are_answered_all_the_same(busy: Ask, address: str) -> None:
    assert busy(address).status_code == 200
