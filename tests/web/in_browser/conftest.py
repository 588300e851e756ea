"""A service in its own process, and a browser that looks at it."""

import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Error, Locator, Page, expect, sync_playwright

from scripts.browser import find_browser
from tests.needs import slow
from tests.waiting import DEADLINE

ROOT = Path(__file__).parents[3]
_SERVE = """
import sys
from pathlib import Path
from sigcat.catalogue.hosting.library import Library, Source, shipped_sources
from sigcat.api.server import run
from sigcat.api.settings import Settings
from sigcat.registry.storing.database import writing
from sigcat.registry.storing.tokens import create_token
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES
from tests.web.fleet import FLEET
from tests.web.published import published
big = Source("big", "100,000 signals", Path(sys.argv[1]))
rows = Source("rows", "Doors in rows", Path(sys.argv[1]).parent / "rows.vspec")
lost = Source("lost", "A tree that is not there", Path(sys.argv[1]).parent / "lost.vspec")
settings = Settings(port=0, log="none")
library = Library([*SOURCES, big, rows, lost, FLEET, *shipped_sources()])
registry = published(Path(sys.argv[1]).parent)
with writing(registry.database) as connection:
    secret = create_token(connection, "anna", ["administer"], "", "")
(Path(sys.argv[1]).parent / "token").write_text(secret)
run(create_site(library, settings, registry=registry), settings)
"""


_ROWS = """
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Door: {type: branch, description: A door., instances: [[Front, Rear], [Left, Right]]}
Vehicle.Door.IsOpen: {type: actuator, datatype: boolean, description: Whether the door stands open.}
"""


def big_tree() -> str:
    """A tree of 100,000 signals: 100 below each of 1,000 instances."""
    signals = (
        f"Vehicle.Part.Signal{n}: {{type: sensor, datatype: float, description: A signal.}}\n" for n in range(100)
    )
    return (
        "Vehicle: {type: branch, description: A vehicle.}\n"
        "Vehicle.Part: {type: branch, description: A part., instances: ['Branch[1,100]', 'Sub[1,10]']}\n"
        + "".join(signals)
    )


@pytest.fixture(scope="session")
def served_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the service: `token` there has a token of its registry."""
    return tmp_path_factory.mktemp("big")


@pytest.fixture(scope="session")
def service(served_folder: Path) -> Iterator[str]:
    """Address of a service that runs in a separate process."""
    big = served_folder / "big.vspec"
    big.write_text(big_tree())
    (big.parent / "rows.vspec").write_text(_ROWS)
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "app")}
    command = [sys.executable, "-c", _SERVE, str(big)]
    with subprocess.Popen(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        match = re.search(r"http://\S+", process.stdout.readline())
        assert match, "the service did not start"
        yield match.group()
        process.terminate()
        assert process.wait(DEADLINE) in (0, -15)


def _browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=find_browser(), args=["--no-sandbox"])
        except Error:
            pytest.skip(
                "Chromium: install one (Debian: apt install chromium-headless-shell), or name it in SIGCAT_BROWSER"
            )
        yield browser
        browser.close()


browser = pytest.fixture(scope="session")(_browser)


class Windows:
    """The windows of a browser, one for all pages with the same options: opening one costs more than most tests."""

    def __init__(self, browser: Browser, origin: str) -> None:
        self._browser = browser
        self._origin = origin
        self._contexts: dict[str, BrowserContext] = {}

    def page(self, **options: object) -> Page:
        """A new page that finds nothing of those before it, but what the browser has in its cache."""
        key = repr(sorted(options.items()))
        if key not in self._contexts:
            context = self._browser.new_context(viewport={"width": 1280, "height": 800}, **options)  # type: ignore[arg-type]
            context.new_page()  # which keeps the window open
            self._contexts[key] = context
        context = self._contexts[key]
        page = context.new_page()
        stored = {
            "origin": self._origin,
            "storageTypes": "cookies,local_storage,indexeddb,service_workers,cache_storage",
        }
        context.new_cdp_session(page).send("Storage.clearDataForOrigin", stored)
        return page


@pytest.fixture(scope="session")
def windows(browser: Browser, service: str) -> Windows:
    return Windows(browser, service)


expect.set_options(timeout=DEADLINE * 1000)

Opener = Callable[..., Page]
Use = Callable[[Locator], None]


def put(field: Locator, text: str) -> None:
    """Let a field hold a long text, as by pasting it; `fill` edits line by line, which takes seconds."""
    field.focus()
    field.evaluate(
        "(field, text) => { field.value = text; field.dispatchEvent(new Event('input', {bubbles: true})); }", text
    )


def by_mouse(what: Locator) -> None:
    """Click it."""
    what.click()


def by_keyboard(what: Locator) -> None:
    """Press the key that works it, once it has the focus."""
    what.focus()
    what.press("Space" if what.get_attribute("type") == "checkbox" else "Enter")


@pytest.fixture(params=[pytest.param(by_mouse, marks=slow), by_keyboard])
def use(request: pytest.FixtureRequest) -> Use:
    """Works a control by keyboard, and in a slow run by mouse as well."""
    chosen: Use = request.param
    return chosen


@pytest.fixture
def open_page(windows: Windows, service: str) -> Iterator[Opener]:
    """Opens pages of the service; an error in a script fails the test, and without `console=False` a message as well."""
    opened: list[Page] = []
    complaints: list[str] = []

    def opener(address: str, *, console: bool = True, **options: object) -> Page:
        page = windows.page(**options)
        opened.append(page)
        page.set_default_timeout(DEADLINE * 1000)
        if console:
            page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.goto(service + address)
        if options.get("java_script_enabled", True) and page.locator("[data-tree]").count():
            page.wait_for_selector("[data-ready]")
        return page

    yield opener
    for page in opened:
        page.close()
    assert not [each for each in complaints if not re.search("status of (404|422|503)", each)]
