"""Signals are chosen while one browses, by keyboard, by mouse, and without JavaScript."""

import re

from playwright.sync_api import expect

from tests.web.in_browser.conftest import Opener, Use


def test_a_node_is_added_without_loading_the_page_again(open_page: Opener, use: Use) -> None:
    page = open_page("/tree/small/Vehicle.Speed?open=Vehicle.Door")
    page.evaluate("window.isSame = true")
    basket = page.get_by_role("link", name="Basket 1", exact=True)
    expect(basket).to_be_hidden()
    use(page.get_by_role("article").get_by_role("link", name="Add to basket"))
    expect(basket).to_be_visible()
    assert page.url.endswith("?open=Vehicle.Door&pick=Vehicle.Speed")
    assert page.evaluate("window.isSame")
    expect(page.get_by_role("treeitem", name=re.compile("^Speed.*, in the basket"))).to_be_visible()
    use(page.get_by_role("article").get_by_role("link", name="Remove from basket"))
    expect(page.locator("[data-basket]")).to_be_hidden()


def test_rows_of_the_tree_are_added_by_a_key(open_page: Opener) -> None:
    page = open_page("/tree/small")
    tree = page.get_by_role("tree")
    tree.focus()
    tree.press("ArrowDown")
    tree.press("+")
    tree.press("ArrowDown")
    tree.press("+")
    expect(page.get_by_role("link", name="Basket 2", exact=True)).to_be_visible()
    expect(page.locator("#said")).to_contain_text("2 in the basket")
    tree.press("+")
    expect(page.get_by_role("link", name="Basket 1", exact=True)).to_be_visible()
    assert "pick=Vehicle.Speed" in page.url


def test_rows_of_the_tree_are_added_by_their_mark(open_page: Opener) -> None:
    page = open_page("/tree/small")
    page.get_by_role("treeitem").filter(has_text="Door").first.locator(".pick").click()
    assert page.url.endswith("pick=Vehicle.Door")
    page.get_by_role("link", name="Basket 1", exact=True).click()
    expect(page.locator(".chosen li")).to_contain_text("2 signals")


def test_the_basket_goes_along_from_page_to_page(open_page: Opener) -> None:
    page = open_page("/tree/small/Vehicle.Speed")
    page.get_by_role("article").get_by_role("link", name="Add to basket").click()
    page.get_by_role("searchbox").fill("door")
    expect(page.locator("[data-hit]").first).to_be_visible()
    assert "pick=Vehicle.Speed" in page.url
    page.locator(".hits").get_by_role("link", name="Add to basket").first.click()
    expect(page.get_by_role("link", name="Basket 2", exact=True)).to_be_visible()
    page.get_by_role("link", name="Rules", exact=True).click()
    page.wait_for_url("**/rules?*")
    page.get_by_role("link", name="Basket 2", exact=True).click()
    expect(page.locator(".chosen li")).to_have_count(2)


def test_a_step_back_does_not_undo_the_choice(open_page: Opener) -> None:
    page = open_page("/tree/small/Vehicle.Speed")
    page.get_by_role("link", name="Next").click()
    expect(page.get_by_role("heading", level=1)).to_have_text("Door")
    page.get_by_role("article").get_by_role("link", name="Add to basket").click()
    page.go_back()
    expect(page.get_by_role("heading", level=1)).to_have_text("Speed")
    expect(page.get_by_role("link", name="Basket 1", exact=True)).to_be_visible()
    assert "pick=Vehicle.Door" in page.url


def test_without_javascript_links_do_the_same(open_page: Opener) -> None:
    page = open_page("/tree/small/Vehicle.Speed", java_script_enabled=False)
    page.get_by_role("article").get_by_role("link", name="Add to basket").click()
    page.get_by_role("link", name="Add to basket: Label").click()
    page.get_by_role("searchbox").fill("door")
    page.get_by_role("button", name="Search").click()
    page.locator(".hits").get_by_role("link", name="Add to basket").first.click()
    page.get_by_role("link", name="Basket 3", exact=True).click()
    expect(page.locator(".chosen li")).to_have_count(3)
    page.get_by_role("textbox", name="Add paths").fill("Vehicle.Built\nVehicle.OldSpeed")
    page.get_by_role("button", name="Add", exact=True).click()
    expect(page.locator(".chosen li")).to_have_count(5)
    with page.expect_download() as download:
        page.get_by_role("link", name="signals.csv").click()
    assert download.value.suggested_filename == "signals.csv"
