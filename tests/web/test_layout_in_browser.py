"""Pages fit on a phone, a laptop and a wall, and on paper."""

import pytest
from playwright.sync_api import expect

from tests.web.conftest import Opener

PAGES = (
    "/tree/interfaces/Vehicle.Function.WheelSpeedCalculation.Error.RangeError", "/search/interfaces?q=wheel",
    "/functions?catalogue=interfaces", "/functions/core_acc?catalogue=interfaces",
    "/functions/core_acc?view=source&catalogue=interfaces", "/functions/core_acc?view=ros2&catalogue=interfaces",
    "/wiring?catalogue=interfaces", "/changes?old=vss&new=interfaces", "/try?kind=function&catalogue=interfaces",
    "/rules", "/rules/I201", "/units/interfaces", "/catalogues/interfaces", "/docs", "/tree/small/Vehicle.Sped",
)  # fmt: skip


@pytest.mark.parametrize("address", PAGES)
def test_nothing_sticks_out_sideways(open_page: Opener, address: str) -> None:
    page = open_page(address)
    for width in (320, 360, 768, 1280, 2560):
        page.set_viewport_size({"width": width, "height": 800})
        assert page.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize("width", [360, 1280, 2560])
def test_every_page_of_the_bar_is_in_sight(open_page: Opener, width: int) -> None:
    page = open_page("/functions?catalogue=interfaces")
    page.set_viewport_size({"width": width, "height": 800})
    for link in page.get_by_role("navigation", name="Pages").get_by_role("link").all():
        box = link.bounding_box()
        assert box
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width


@pytest.mark.parametrize("address", PAGES)
def test_paper_has_the_content_and_not_the_controls(open_page: Opener, address: str) -> None:
    page = open_page(address)
    page.emulate_media(media="print")
    expect(page.locator("h1").first).to_be_attached()
    for control in (".bar", ".tree", ".copy", ".facets", ".editor", ".choose", ".tabs", ".own"):
        for each in page.locator(control).all():
            expect(each).to_be_hidden()
    page.set_viewport_size({"width": 700, "height": 1000})
    assert page.evaluate("document.documentElement.scrollWidth") <= 700


def test_a_diagram_is_on_paper_even_where_the_screen_has_a_list(open_page: Opener) -> None:
    page = open_page("/functions/core_acc?catalogue=interfaces")
    page.set_viewport_size({"width": 360, "height": 800})
    expect(page.locator(".picture.interfaces")).to_be_hidden()
    expect(page.locator(".ports")).to_be_visible()
    page.emulate_media(media="print")
    expect(page.locator(".picture.interfaces")).to_be_visible()
    expect(page.locator(".ports")).to_be_hidden()
