"""A failed request is reported, can be sent again, and leaves the shown content unchanged."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, Route, expect

from tests.web.in_browser.conftest import Opener

FAILURES: dict[str, Callable[[Route], None]] = {
    "The service does not answer.": lambda route: route.abort(),
    "The service is busy.": lambda route: route.fulfill(status=503),
    "The service failed (500).": lambda route: route.fulfill(status=500),
}


def failing(page: Page, address: str, how: str = "The service does not answer.") -> None:
    """Let the next request for an address fail, and those after it succeed."""
    page.route(address, FAILURES[how], times=1)


def told(page: Page) -> str:
    message = page.get_by_role("alert")
    expect(message).to_be_visible()
    return message.locator("p").inner_text()


@pytest.mark.parametrize("how", FAILURES)
def test_a_node_that_does_not_come_leaves_the_one_before(open_page: Opener, how: str) -> None:
    page = open_page("/tree/small/Vehicle.Speed", console=False)
    failing(page, "**/tree/small/Vehicle.Label?part=", how)
    page.get_by_role("treeitem", name="Label").locator(".name").click()
    assert told(page) == how
    expect(page.locator("article h1")).to_have_text("Speed")
    expect(page.locator("article")).to_have_css("opacity", "1")
    expect(page.locator("[aria-selected=true]")).to_contain_text("Speed")
    assert page.url.endswith("/tree/small/Vehicle.Speed")
    page.get_by_role("button", name="Try again").click()
    expect(page.locator("article h1")).to_have_text("Label")
    expect(page.get_by_role("alert")).to_be_hidden()
    assert page.url.endswith("/tree/small/Vehicle.Label")
    assert page.evaluate("document.getElementById('main').contains(document.activeElement)")


def test_rows_that_do_not_come_leave_the_branch_closed(open_page: Opener) -> None:
    page = open_page("/tree/small", console=False)
    failing(page, "**/rows/small?path=Vehicle.Door*")
    door = page.get_by_role("treeitem", name="Door")
    door.locator(".chevron").click()
    told(page)
    expect(door).to_have_attribute("aria-expanded", "false")
    expect(door.locator(".waiting")).to_have_count(0)
    page.get_by_role("button", name="Try again").click()
    expect(page.get_by_role("treeitem", name="Left")).to_be_visible()


def test_a_tree_without_its_rows_keeps_its_links(open_page: Opener) -> None:
    page = open_page("/units/small", console=False)
    failing(page, "**/rows/small?*")
    page.get_by_role("navigation", name="Pages").get_by_role("link", name="Tree").click()
    told(page)
    expect(page.locator(".rows").get_by_role("link", name="Speed", exact=True)).to_be_visible()
    page.get_by_role("button", name="Try again").click()
    expect(page.get_by_role("treeitem", name="Label")).to_be_visible()


def test_results_that_do_not_come_leave_those_before(open_page: Opener) -> None:
    page = open_page("/search/small?q=speed", console=False)
    failing(page, "**/search/small?q=label&part=")
    page.get_by_role("searchbox").fill("label")
    told(page)
    expect(page.locator("[data-hit]").first).to_have_text("Vehicle.Speed")
    page.get_by_role("button", name="Try again").click()
    expect(page.locator("[data-hit]").first).to_have_text("Vehicle.Label")


def test_a_text_that_could_not_be_checked_is_checked_again(open_page: Opener) -> None:
    page = open_page("/try?catalogue=small", console=False)
    failing(page, "**/try?part=")
    page.get_by_role("textbox", name="Overlay").fill("Vehicle.Speed:\n  type: sensr\n")
    assert "earlier text" in told(page)
    page.get_by_role("button", name="Try again").click()
    expect(page.locator("#outcome")).to_contain_text("sensr")


def test_a_message_is_dismissed(open_page: Opener) -> None:
    page = open_page("/tree/small", console=False)
    failing(page, "**/tree/small/Vehicle.Label?part=")
    page.get_by_role("treeitem", name="Label").locator(".name").click()
    told(page)
    page.get_by_role("button", name="Dismiss").click()
    expect(page.get_by_role("alert")).to_be_hidden()
