"""A service over a small tree, asked in process."""

import asyncio
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import pytest

from sigcat.api.application import create_app
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library, Source

TREE = Path(__file__).parent / "tree"
SOURCES = (
    Source("small", "A small tree", TREE / "tree.vspec", (TREE / "overlay.vspec",)),
    Source("bare", "The small tree alone", TREE / "tree.vspec"),
    Source("broken", "A tree that is wrong", TREE / "broken.vspec"),
)
SETTINGS = Settings(body_bytes=10_000, results=5, tree_nodes=12)

Ask = Callable[..., httpx.Response]


def asker(app: Any, root_path: str = "") -> Ask:
    """A function that asks an ASGI application; an exception inside is an answer."""

    async def request(method: str, address: str, options: Mapping[str, Any]) -> httpx.Response:
        transport = httpx.ASGITransport(app, raise_app_exceptions=False, root_path=root_path)
        async with httpx.AsyncClient(transport=transport, base_url="http://sigcat") as client:
            return await client.request(method, address, **options)

    def ask(address: str, method: str = "GET", **options: Any) -> httpx.Response:
        # in a separate thread: a browser that is open in this one keeps an event loop running here
        with ThreadPoolExecutor(1) as thread:
            return thread.submit(lambda: asyncio.run(request(method, address, options))).result()

    return ask


@pytest.fixture(scope="session")
def library() -> Library:
    return Library(SOURCES)


@pytest.fixture(scope="session")
def ask(library: Library) -> Ask:
    return asker(create_app(library, SETTINGS))
