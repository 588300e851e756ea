"""Search as one types."""

from playwright.sync_api import Route, expect

from tests.web.in_browser.conftest import Opener


def test_results_come_as_one_types_and_back_returns_to_the_tree(open_page: Opener) -> None:
    page = open_page("/tree/small/Vehicle.Label")
    page.keyboard.press("/")
    page.keyboard.type("spee vehi", delay=15)
    expect(page.locator(".hits a").first).to_have_text("Vehicle.Speed")
    page.wait_for_url("**/search/small?q=spee+vehi")
    expect(page.locator("nav [aria-current=page]")).to_have_count(0)
    expect(page.locator(".hits mark").first).to_have_text("Vehi")
    page.go_back()
    expect(page.locator("h1")).to_have_text("Label")
    page.go_forward()
    expect(page.locator(".hits a").first).to_have_text("Vehicle.Speed")


def test_a_step_in_the_history_while_the_page_loads_is_followed(open_page: Opener) -> None:
    page = open_page("/tree/small/Vehicle.Label")
    page.keyboard.press("/")
    page.keyboard.type("speed")
    expect(page.locator(".hits a").first).to_have_text("Vehicle.Speed")
    waiting: list[Route] = []
    page.route("**/sigcat*.js*", lambda route: waiting.append(route))  # noqa: PLW0108 — playwright marks the function
    page.go_back(wait_until="commit")
    expect(page.locator("h1")).to_have_text("Label")
    page.go_forward(wait_until="commit")
    for route in waiting.copy():
        route.continue_()
    page.unroute("**/sigcat*.js*")
    expect(page.locator(".hits a").first).to_have_text("Vehicle.Speed")


def test_results_are_walked_by_arrows_and_opened_by_enter(open_page: Opener) -> None:
    page = open_page("/search/small?q=speed")
    page.get_by_role("searchbox").focus()
    page.keyboard.press("ArrowDown")
    expect(page.locator("[data-hit]").first).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.locator("h1")).to_have_text("Speed")


def test_enter_leads_to_the_first_result(open_page: Opener) -> None:
    page = open_page("/tree/small")
    page.get_by_role("searchbox").focus()
    page.keyboard.type("speed")
    page.keyboard.press("Enter")
    expect(page.locator("[data-hit]").first).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.locator("h1")).to_have_text("Speed")
    page.go_back()
    page.get_by_role("searchbox").fill("xyzzy")
    page.keyboard.press("Enter")
    expect(page.locator("[data-tally]")).to_contain_text("Nothing")
    expect(page.get_by_role("searchbox")).to_be_focused()


def test_filters_narrow_and_widen(open_page: Opener) -> None:
    page = open_page("/search/small?q=vehicle")
    facets = page.get_by_role("complementary", name="Filters")
    facets.get_by_role("link", name="actuator").click()
    expect(page.locator("[data-tally]")).to_have_text("1\u00a0result")
    assert "type=actuator" in page.url
    facets.get_by_role("link", name="Remove filter Type").click()
    expect(page.locator("[data-tally]")).to_have_text("12\u00a0results")


def test_a_near_miss_proposes_a_word(open_page: Opener) -> None:
    page = open_page("/search/small?q=sped")
    page.get_by_role("link", name="speed").click()
    expect(page.locator(".hits a").first).to_have_text("Vehicle.Speed")


def test_a_proposal_is_taken_by_keyboard_and_the_next_tab_reaches_the_results(open_page: Opener) -> None:
    page = open_page("/search/small?q=vehicle+sped")
    page.get_by_role("searchbox").focus()
    page.keyboard.press("ArrowDown")
    expect(page.get_by_role("link", name="vehicle speed")).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.locator(".hits a").first).to_have_text("Vehicle.Speed")
    expect(page.get_by_role("searchbox")).to_have_value("vehicle speed")
    page.keyboard.press("Tab")
    assert page.evaluate("document.getElementById('main').contains(document.activeElement)")


def test_markup_that_is_typed_shows_as_text(open_page: Opener) -> None:
    page = open_page("/search/small")
    page.get_by_role("searchbox").fill("<img src=x onerror=alert(1)>")
    expect(page.locator("[data-tally]")).to_contain_text("Nothing")
    assert page.locator("main img").count() == 0


def test_another_catalogue_is_searched_for_what_was_typed(open_page: Opener) -> None:
    page = open_page("/tree/small")
    page.get_by_role("searchbox").fill("speed")
    expect(page.locator(".hits a").first).to_have_text("Vehicle.Speed")
    page.locator("summary[aria-label^='Catalogue']").click()
    page.locator("details.menu a[data-elsewhere=interfaces]").click()
    page.wait_for_url("**/search/interfaces?q=speed")
    expect(page.get_by_role("searchbox")).to_have_value("speed")
