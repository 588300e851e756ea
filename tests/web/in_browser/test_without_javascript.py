"""Every page serves without JavaScript: what it shows is there, and its links and buttons lead on."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Page, expect

from sigcat.data import EXAMPLES
from tests.web.in_browser.conftest import Opener, Windows

PAGES = {
    "/": "Declare a function", "/docs/README.md": "Look up",     "/tree/interfaces/Vehicle.Speed": "Attributes", "/tree/lost": "has no tree", "/search/small?q=speed": "results",
    "/search/small?q=sped": "Did you mean", "/functions?catalogue=interfaces": "CoreAcc", "/functions/core_acc?catalogue=interfaces": "Signals out",
    "/functions/core_acc?view=source&catalogue=interfaces": "function: CoreAcc", "/functions/core_acc?view=arxml&catalogue=interfaces": "&lt;AUTOSAR",
    "/functions/core_acc?view=run&catalogue=interfaces": "STANDBY", "/wiring?catalogue=interfaces": "fit together", "/changes?old=vss&new=interfaces": "compatible",
    "/functions/sets/ecocontrol/compare": "Acceptance criteria", "/try?catalogue=interfaces": "errors", "/compare?path=Vehicle.Speed&other=bare": "differ", "/history/interfaces/Vehicle.Speed": "already", "/vehicles/fleet": "They differ in", "/registry/lines": "may not be deployed", "/registry/login": "signed in for 8 hours", "/basket/interfaces?pick=Vehicle.Cabin.Door.IsOpen": "it is not stored", "/propose?change=Vehicle.Speed&catalogue=interfaces": "No changes yet", "/rules": "Kinds", "/rules/I201": "Wrong", "/units/small": "km/h",
    "/catalogues/small": "Layers", "/docs": "Other answers", "/docs/api/lint": "curl", "/problems/busy": "Retry-After", "/tree/small/Vehicle.Sped": "Did you mean",
}  # fmt: skip


@pytest.fixture(scope="module")
def plain(windows: Windows) -> Iterator[Page]:
    """One page that goes from address to address."""
    page = windows.page(java_script_enabled=False)
    yield page
    page.close()


@pytest.mark.parametrize(("address", "text"), PAGES.items())
def test_a_page_shows_what_it_has(plain: Page, service: str, address: str, text: str) -> None:
    plain.goto(service + address)
    assert text.lower() in plain.content().lower()
    assert not plain.locator(".copy").filter(visible=True).all()


def test_overlays_are_switched_by_links(open_page: Opener) -> None:
    page = open_page("/tree/interfaces/Vehicle.Speed", java_script_enabled=False)
    page.get_by_text("Show", exact=True).click()
    page.get_by_role("switch", name="Instances one by one").click()
    page.wait_for_url("**/tree/interfaces~folded/Vehicle.Speed")


def test_results_are_filtered_and_paged_by_links(open_page: Opener) -> None:
    page = open_page("/search/interfaces?q=wheel", java_script_enabled=False)
    page.get_by_role("link", name="More results").click()
    expect(page.locator("[data-tally]")).to_contain_text("from 51 on")
    page.get_by_role("complementary", name="Filters").get_by_role("link", name="attribute").click()
    assert "type=attribute" in page.url


def test_changes_are_compared_by_a_button(open_page: Opener) -> None:
    page = open_page("/changes?old=vss&new=interfaces", java_script_enabled=False)
    page.get_by_role("combobox", name="From").select_option("interfaces")
    page.get_by_role("combobox", name="To").select_option("vss")
    page.get_by_role("button", name="Compare").click()
    expect(page.locator(".tally")).to_contain_text("breaking")


def test_signals_of_a_run_are_chosen_by_a_button(open_page: Opener) -> None:
    page = open_page("/functions/core_acc?catalogue=interfaces", java_script_enabled=False)
    page.get_by_role("link", name="Run", exact=True).click()
    page.get_by_role("checkbox", name="AccelerationRequest").uncheck()
    page.get_by_role("checkbox", name="AccelerationProposal received").check()
    page.get_by_role("button", name="Draw").click()
    drawn = page.locator("svg.run text.strong")
    expect(drawn.nth(0)).to_have_text("Vehicle.ADAS.EcoControl.Status")
    expect(drawn.nth(1)).to_have_text("Vehicle.ADAS.EcoControl.AccelerationProposal [m/s²]")
    expect(page.get_by_role("checkbox", name="AccelerationRequest")).not_to_be_checked()
    with page.expect_download() as download:
        page.get_by_role("link", name="Download").click()
    assert download.value.path().read_bytes() == (EXAMPLES / "ecocontrol" / "run.csv").read_bytes()


def test_functions_of_ones_own_are_connected_by_a_button(open_page: Opener) -> None:
    page = open_page("/wiring?catalogue=interfaces", java_script_enabled=False)
    page.get_by_text("Your own functions").click()
    page.get_by_role("textbox", name="Documents").fill("function: A\n")
    page.get_by_role("button", name="Connect these").click()
    expect(page.locator(".findings").first).to_contain_text("is missing")


def test_a_text_is_checked_and_its_documents_kept_by_buttons(open_page: Opener) -> None:
    page = open_page("/try?kind=function&catalogue=interfaces", java_script_enabled=False)
    page.get_by_role("button", name="Check").click()
    page.get_by_role("button", name="ROS 2", exact=True).click()
    assert page.url.endswith("/try#made")
    expect(page.locator(".document")).to_contain_text('"FunctionName": "CoreAcc"')
    page.get_by_role("button", name="Check").click()
    expect(page.locator(".document")).to_contain_text('"FunctionName": "CoreAcc"')
    with page.expect_download() as kept:
        page.get_by_role("button", name="Download CoreAcc.ros2.json").click()
    assert kept.value.suggested_filename == "CoreAcc.ros2.json"
