"""Picture every page: starts the service on a free port and looks at it with Chromium.

What the README shows goes to docs/pictures, the other pages to build/pictures, where people look at them.
"""

import argparse
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Literal, NamedTuple

from playwright.sync_api import Browser, Error, Page, sync_playwright

from scripts.browser import find_browser

ROOT = Path(__file__).parent.parent
SHOWN = ROOT / "docs" / "pictures"
OTHERS = ROOT / "build" / "pictures"
_SERVE = """
from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.api.server import run
from sigcat.api.settings import Settings
from sigcat.web.site import create_site
settings = Settings(port=0)
run(create_site(Library(shipped_sources()), settings), settings)
"""


class Picture(NamedTuple):
    """A page as it is pictured."""

    name: str
    address: str
    scheme: Literal["light", "dark"] = "light"
    width: int = 1280
    height: int = 800
    is_shown: bool = False
    """Whether the README shows it."""

    prepare: Callable[[Page], None] | None = None
    """Actions on the page before the picture."""

    @property
    def file(self) -> Path:
        """Path of the picture."""
        return (SHOWN if self.is_shown else OTHERS) / f"{self.name}.png"


def post_functions(page: Page) -> None:
    """Connect a posted function, whose unit is wrong, with a shipped one."""
    made = page.request.get(page.url.replace("/wiring", "/functions/eco_control_mpc.json")).text()
    page.get_by_text("Your own functions").click()
    wrong = made.replace('"VssUnit": "m/s^2"', '"VssUnit": "km/h"')
    page.get_by_role("textbox", name="Documents").fill(f"--- # eco_control_mpc.json\n{wrong}")
    page.get_by_role("group", name="Together with").get_by_role("checkbox", name="CoreAcc").check()
    page.get_by_role("button", name="Connect these").click()
    page.wait_for_selector(".wire.mismatched")


def open_show(page: Page) -> None:
    """Open the menu of overlays and instances."""
    page.get_by_text("Show", exact=True).click()


def complete_path(page: Page) -> None:
    """Begin a path, so that its completions show."""
    field = page.get_by_role("textbox", name="Overlay")
    field.fill("Vehicle.Chassis.Brake.CylP:\n  type: sensor\n  unit: kPa\n")
    field.press_sequentially("Vehicle.Chassis.")
    page.wait_for_selector("#completions:not([hidden])")


def write_functions(page: Page) -> None:
    """Open the form for functions of the user."""
    page.get_by_text("Your own functions").click()


def show_timing(page: Page) -> None:
    """Scroll to the distributions."""
    page.locator("#timing").evaluate("heading => window.scrollTo(0, heading.getBoundingClientRect().top - 60)")


_SIGNAL = "/tree/interfaces/Vehicle.ADAS.EcoControl.AccelerationRequest"
_ERROR = "/tree/interfaces/Vehicle.Function.WheelSpeedCalculation.Error.RangeError"
_OVERLAID = "/tree/interfaces/Vehicle.Acceleration.Longitudinal"
PAGES = (
    Picture("start", "/"),
    Picture("chapter", "/docs/reference/functions.md"),
    Picture("tree", _SIGNAL, is_shown=True),
    Picture("node", _OVERLAID, is_shown=True),
    Picture("wiring", "/wiring", is_shown=True),
    Picture("changes", "/changes?old=vss&new=interfaces", is_shown=True),
    Picture("comparison", "/functions/sets/ecocontrol/compare", is_shown=True, prepare=show_timing),
    Picture("comparison-top", "/functions/sets/ecocontrol/compare", "dark"),
    Picture("comparison-narrow", "/functions/sets/ecocontrol/compare", width=360, height=780),
    Picture("tree-dark", _ERROR, "dark"),
    Picture("tree-narrow", "/tree/interfaces/Vehicle.Cabin.HVAC", width=360, height=780),
    Picture("tree-wall", _SIGNAL, width=2560, height=1440),
    Picture("tree-menu", _SIGNAL, prepare=open_show),
    Picture("tree-folded", "/tree/interfaces~folded/Vehicle.Chassis.Axle.Wheel"),
    Picture("error-interface", _ERROR),
    Picture("search", "/search/interfaces?q=wheel+speed"),
    Picture("search-dark", "/search/interfaces?q=battery&unit=V", "dark"),
    Picture("search-narrow", "/search/interfaces?q=wheel+speed", width=360, height=780),
    Picture("near-miss", "/search/interfaces?q=weel"),
    Picture("not-found", "/tree/interfaces/Vehicle.Chasis.Axle"),
    Picture("functions", "/functions"),
    Picture("function", "/functions/wheel_speed_calculation"),
    Picture("function-dark", "/functions/core_acc", "dark"),
    Picture("functions-elsewhere", "/functions?catalogue=vss"),
    Picture("function-findings", "/functions/core_acc?catalogue=vss"),
    Picture("function-run", "/functions/wheel_speed_calculation?view=run", height=1200),
    Picture("function-run-narrow", "/functions/core_acc?view=run", "dark", 360, 780),
    Picture("function-arxml", "/functions/core_acc?view=arxml"),
    Picture("function-wall", "/functions/core_acc", width=2560, height=1440),
    Picture("function-narrow", "/functions/core_acc", width=360, height=780),
    Picture("wiring-dark", "/wiring?f=core_acc&f=eco_control_mpc&f=wheel_speed_calculation", "dark"),
    Picture("wiring-narrow", "/wiring", width=360, height=780),
    Picture("wiring-own", "/wiring", prepare=write_functions),
    Picture("wiring-mismatch", "/wiring", prepare=post_functions),
    Picture("wiring-mismatch-dark", "/wiring", "dark", prepare=post_functions),
    Picture("changes-dark", "/changes?old=vss&new=interfaces", "dark"),
    Picture("changes-narrow", "/changes?old=vss&new=interfaces", width=360, height=780),
    Picture("try", "/try"),
    Picture("propose", "/propose?change=Vehicle.Chassis.Brake.CylP", "dark", 1600, 1000),
    Picture("compare", "/compare?path=Vehicle.Speed&with=Vehicle.ADAS.CruiseControl.SpeedSet"),
    Picture("history", "/history/interfaces/Vehicle.Speed"),
    Picture("basket", "/basket/interfaces?pick=Vehicle.Speed,Vehicle.Cabin.Door.IsOpen,Vehicle.Chassis.Axle"),
    Picture("try-completion", "/try", prepare=complete_path),
    Picture("try-function", "/try?kind=function"),
    Picture("try-function-dark", "/try?kind=function", "dark", 2560, 1440),
    Picture("try-narrow", "/try", width=360, height=780),
    Picture("rules", "/rules"),
    Picture("rule", "/rules/I201"),
    Picture("rule-dark", "/rules/I201", "dark"),
    Picture("rule-narrow", "/rules/I201", width=360, height=780),
    Picture("units", "/units/interfaces"),
    Picture("units-narrow", "/units/interfaces", width=360, height=780),
    Picture("catalogue", "/catalogues/interfaces"),
    Picture("catalogue-dark", "/catalogues/interfaces", "dark"),
    Picture("api", "/docs"),
    Picture("api-narrow", "/docs", width=360, height=780),
)


def main(arguments: list[str] | None = None) -> int:
    """Take the pictures whose names are given, or all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", help="names of pictures; without any, all are taken")
    names = parser.parse_args(arguments).names
    wanted = [picture for picture in PAGES if not names or picture.name in names]
    for folder in (SHOWN, OTHERS):
        folder.mkdir(parents=True, exist_ok=True)
    with service() as address, chromium() as browser:
        for picture in wanted:
            take(picture, address, browser)
            print(picture.file.relative_to(ROOT))
    return 0


@contextmanager
def service() -> Iterator[str]:
    """The address of a service that runs while the block does."""
    with subprocess.Popen([sys.executable, "-c", _SERVE], cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            match = re.search(r"http://\S+", process.stdout.readline())
            if match is None:
                sys.exit("The service did not start.")
            yield match.group()
        finally:
            process.terminate()


@contextmanager
def chromium() -> Iterator[Browser]:
    """The system's Chromium, or the one that Playwright installed."""
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=find_browser(), args=["--no-sandbox"])
        except Error as error:
            sys.exit(f"Chromium cannot be started: {error.message.splitlines()[0]}")
        yield browser


def take(picture: Picture, address: str, browser: Browser) -> None:
    """Picture one page."""
    size = {"width": picture.width, "height": picture.height}
    page = browser.new_page(viewport=size, color_scheme=picture.scheme)  # type: ignore[arg-type]
    page.goto(address + picture.address)
    if page.locator("[data-tree]").count():
        page.wait_for_selector("[data-ready]")
    if picture.prepare:
        picture.prepare(page)
    page.wait_for_load_state("networkidle")
    page.screenshot(path=picture.file)
    page.close()


if __name__ == "__main__":
    sys.exit(main())
