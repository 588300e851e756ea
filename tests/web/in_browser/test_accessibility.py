"""No page has a violation that axe finds, on a laptop and a phone, in light and in dark; none complains on the console."""

from typing import Literal, NamedTuple
from urllib.parse import parse_qs

import pytest
from axe_playwright_python.sync_playwright import Axe  # type: ignore[import-untyped]
from playwright.sync_api import Page, expect

from tests.needs import IS_SLOW_RUN
from tests.reference_tools import checked_with
from tests.web.in_browser.conftest import Opener, put

PAGES = (
    "/", "/docs/reference/functions.md", "/docs/how-to/pipeline.md",
    "/tree/interfaces/Vehicle.Function.WheelSpeedCalculation.Scheduling.Step", "/tree/small/Vehicle.OldSpeed",
    "/tree/broken", "/search/small?q=speed", "/search/small?q=sped", "/functions?catalogue=interfaces",
    "/functions/core_acc?catalogue=interfaces", "/functions/core_acc?view=source&catalogue=interfaces",
    "/functions/wheel_speed_calculation?view=run&catalogue=interfaces",
    "/functions/sets/ecocontrol/compare", "/wiring?catalogue=interfaces", "/changes",
    "/changes?old=vss&new=interfaces", "/registry", "/registry/lines", "/registry/deliveries", "/registry/login", "/registry/users?path=Vehicle.S0", "/registry/functions/Alpha", "/vehicles/fleet", "/tree/fleet~vehicle.truck/Vehicle.Door", "/compare?path=Vehicle.Speed&other=bare", "/history/interfaces/Vehicle.Speed", "/basket/interfaces?pick=Vehicle.Speed,Vehicle.Cabin.Door,Vehicle.Sped", "/try", "/try?kind=function&catalogue=interfaces", "/propose?change=Vehicle.Chassis.Brake.CylP&catalogue=interfaces", "/rules", "/rules/I201",
    "/units/interfaces", "/catalogues/interfaces", "/docs", "/docs/api/integration", "/docs/api/schemas", "/problems/busy", "/tree/small/Vehicle.Sped",
)  # fmt: skip
"""One page of each kind."""
VARIANTS = (
    "/tree/interfaces~folded", "/vehicles/small", "/vehicles/fleet?show=all", "/functions?catalogue=vss", "/tree/small/Vehicle.Speed", "/search/small?q=zzz", "/search/interfaces", "/functions",
    "/functions/core_acc?view=function-json&catalogue=interfaces", "/functions/core_acc?view=run&catalogue=interfaces",
    "/functions/core_acc?view=arxml&catalogue=interfaces", "/functions/core_acc?catalogue=small",
    "/wiring?catalogue=small", "/changes?old=bare&new=small", "/changes?old=small&new=small", "/try?kind=tree",
    "/compare?path=Vehicle", "/propose?below=Vehicle.Cabin&catalogue=interfaces", "/propose?change=Vehicle.Speed&as=text", "/basket/small", "/tree/small/Vehicle.Speed?pick=Vehicle.Speed", "/compare?path=Vehicle.Sped&with=Vehicle.Speed", "/compare?path=Vehicle.Door&with=Vehicle", "/rules/V101", "/rules/I201?catalogue=small", "/catalogues/broken", "/problems/not-found", "/tree/nope",
    "/rules/nope", "/functions/core", "/functions/core_acc?view=ros2&catalogue=interfaces", "/tree/lost",
    "/catalogues/lost", "/nothing", "/tree/small?from=-1",
)  # fmt: skip
"""The same kinds with other content; `make slow` takes them too."""


class Look(NamedTuple):
    """Look of a page."""

    scheme: Literal["light", "dark"]
    width: int
    height: int


LAPTOP = Look("light", 1280, 800)
LOOKS = (LAPTOP, Look("dark", 390, 844), Look("dark", 1280, 800), Look("light", 390, 844))
"""A usual run checks every other page in the first and the rest in the second, `make slow` every page in all."""


@checked_with("axe", "No page has a violation, on a laptop and a phone, in light and in dark")
@pytest.mark.parametrize("address", [*PAGES, *(VARIANTS if IS_SLOW_RUN else ())])
def test_axe_finds_nothing(open_page: Opener, address: str) -> None:
    _check(open_page(address), LOOKS[PAGES.index(address) % 2] if address in PAGES else LAPTOP)


@checked_with("axe", "No page has a violation, on a laptop and a phone, in light and in dark")
def test_axe_finds_nothing_in_open_menus(open_page: Opener) -> None:
    page = open_page("/tree/interfaces")
    for menu in page.locator("details.menu").all():
        menu.locator("summary").click()
        _check(page)
        page.keyboard.press("Escape")


@checked_with("axe", "No page has a violation, on a laptop and a phone, in light and in dark")
def test_axe_finds_nothing_in_what_was_posted(open_page: Opener) -> None:
    page = open_page("/wiring?catalogue=interfaces")
    made = page.request.get(page.url.replace("/wiring", "/functions/eco_control_mpc.json")).text()
    page.get_by_text("Your own functions").click()
    wrong = made.replace('"VssUnit": "m/s^2"', '"VssUnit": "km/h"')
    put(page.get_by_role("textbox", name="Documents"), f"{wrong}\n---\nfunction: Bad\ncomponents: 3\n")
    page.get_by_role("group", name="Together with").get_by_role("checkbox", name="CoreAcc").check()
    page.get_by_role("button", name="Connect these").click()
    expect(page.locator(".wire.mismatched")).to_have_count(1)
    page.get_by_text("Edit your").click()
    _check(page)


@checked_with("axe", "No page has a violation, on a laptop and a phone, in light and in dark")
def test_axe_finds_nothing_in_a_text_that_was_checked_without_javascript(open_page: Opener, service: str) -> None:
    page = open_page("/try?catalogue=interfaces")
    form: dict[str, str | float | bool] = {
        "kind": "overlay",
        "catalogue": "interfaces",
        "text": "Vehicle.Speed:\n  type: sensr\n",
    }
    page.set_content(page.request.post(f"{service}/try", form=form).text().replace('href="/', f'href="{service}/'))
    expect(page.locator(".marked.error")).to_have_count(1)
    _check(page)


@checked_with("axe", "No page has a violation, on a laptop and a phone, in light and in dark")
def test_axe_finds_nothing_in_completions(open_page: Opener) -> None:
    page = open_page("/propose?change=Vehicle.Chassis.Brake.CylP&catalogue=interfaces&as=text")
    field = page.get_by_role("textbox", name="Overlay")
    field.fill("")
    with page.expect_response(lambda answer: ["Vehicle."] in parse_qs(answer.request.post_data or "").values()):
        field.press_sequentially("Vehicle.")
    expect(page.get_by_role("option").first).to_be_visible()
    expect(page.locator("[aria-busy]")).to_have_count(0)
    expect(page.locator(".verdict")).to_have_css("opacity", "1")
    _check(page)


@checked_with("axe", "No page has a violation, on a laptop and a phone, in light and in dark")
def test_axe_finds_nothing_while_the_service_is_busy(open_page: Opener) -> None:
    page = open_page("/try?catalogue=interfaces")
    page.evaluate("document.getElementById('progress').hidden = false")
    _check(page)


_TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]


_SHORTEN = """() => {
    for (const parent of document.querySelectorAll("main, main *")) {
        const seen = new Map();
        for (const child of [...parent.children]) {
            const kind = `${child.tagName} ${child.className}`;
            seen.set(kind, (seen.get(kind) ?? 0) + 1);
            if (seen.get(kind) > 8) child.remove();
        }
    }
}"""
"""Keep only the first eight rows, list entries and sections of one kind: axe checks each as if it were the only one."""


def _check(page: Page, look: Look = LAPTOP) -> None:
    """Check a page in one look and the first of its repeated parts, and in a slow run all of it in all looks."""
    found = []
    if not IS_SLOW_RUN:
        page.evaluate(_SHORTEN)
    for scheme, width, height in LOOKS if IS_SLOW_RUN else (look,):
        page.emulate_media(color_scheme=scheme)
        page.set_viewport_size({"width": width, "height": height})
        found += Axe().run(page, options={"runOnly": _TAGS, "resultTypes": ["violations"]}).response["violations"]
    assert not [f"{v['id']}: {n['html'][:200]} {n['failureSummary']}" for v in found for n in v["nodes"]]
