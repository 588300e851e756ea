"""A service in its own process, and a browser that looks at it."""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Error, Locator, Page, sync_playwright

ROOT = Path(__file__).parent.parent.parent
_SERVE = """
import sys
from pathlib import Path
from sigcat.catalogue.hosting.library import Library, Source, shipped_sources
from sigcat.api.server import run
from sigcat.api.settings import Settings
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES
big = Source("big", "100,000 signals", Path(sys.argv[1]))
rows = Source("rows", "Doors in rows", Path(sys.argv[1]).parent / "rows.vspec")
lost = Source("lost", "A tree that is not there", Path(sys.argv[1]).parent / "lost.vspec")
settings = Settings(port=0)
run(create_site(Library([*SOURCES, big, rows, lost, *shipped_sources()]), settings), settings)
"""


_ROWS = """
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Door: {type: branch, description: A door., instances: [[Front, Rear], [Left, Right]]}
Vehicle.Door.IsOpen: {type: actuator, datatype: boolean, description: Whether the door stands open.}
"""


def big_tree(branches: int) -> str:
    """A tree of 1,000 signals below each branch."""
    parts = ["Vehicle: {type: branch, description: Root.}"]
    for i in range(branches):
        parts.append(f"Vehicle.Branch{i}: {{type: branch, description: Branch.}}")
        for j in range(10):
            parts.append(f"Vehicle.Branch{i}.Sub{j}: {{type: branch, description: Branch.}}")
            parts += [
                f"Vehicle.Branch{i}.Sub{j}.Signal{k}: {{type: sensor, datatype: float, description: A signal.}}"
                for k in range(100)
            ]
    return "\n".join(parts)


@pytest.fixture(scope="session")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of a service that runs in a process of its own."""
    big = tmp_path_factory.mktemp("big") / "big.vspec"
    big.write_text(big_tree(100))
    (big.parent / "rows.vspec").write_text(_ROWS)
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "app")}
    command = [sys.executable, "-c", _SERVE, str(big)]
    with subprocess.Popen(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        match = re.search(r"http://\S+", process.stdout.readline())
        assert match, "the service did not start"
        yield match.group()
        process.terminate()
        assert process.wait(20) in (0, -15)


def _browser() -> Iterator[Browser]:
    installed = next(
        (path for name in ("chromium", "chromium-browser", "google-chrome") if (path := shutil.which(name))), None
    )
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=installed, args=["--no-sandbox"])
        except Error:
            pytest.skip("Chromium: install one (Debian: apt install chromium), or name it in SIGCAT_BROWSER")
        yield browser
        browser.close()


browser = pytest.fixture(scope="session")(_browser)

Opener = Callable[..., Page]
Use = Callable[[Locator], None]


def by_mouse(what: Locator) -> None:
    """Click it."""
    what.click()


def by_keyboard(what: Locator) -> None:
    """Press the key that works it, once it has the focus."""
    what.focus()
    what.press("Space" if what.get_attribute("type") == "checkbox" else "Enter")


@pytest.fixture(params=[by_mouse, by_keyboard])
def use(request: pytest.FixtureRequest) -> Use:
    """Works a control, by mouse in one run of the test and by keyboard in the other."""
    chosen: Use = request.param
    return chosen


@pytest.fixture
def open_page(browser: Browser, service: str) -> Iterator[Opener]:
    """Opens pages of the service; a message on the console or an error in a script fails the test."""
    contexts: list[BrowserContext] = []
    complaints: list[str] = []

    def opener(address: str, **options: object) -> Page:
        context = browser.new_context(viewport={"width": 1280, "height": 800}, **options)  # type: ignore[arg-type]
        contexts.append(context)
        page = context.new_page()
        page.set_default_timeout(8_000)
        page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.goto(service + address)
        if options.get("java_script_enabled", True) and page.locator("[data-tree]").count():
            page.wait_for_selector("[data-ready]")
        return page

    yield opener
    for context in contexts:
        context.close()
    assert not [each for each in complaints if not re.search("status of (404|422|503)", each)]
