"""A change is proposed in a form, with findings as one types."""

import re

from playwright.sync_api import expect

from tests.web.in_browser.conftest import Opener


def test_findings_and_effects_come_as_one_types(open_page: Opener) -> None:
    page = open_page("/tree/interfaces/Vehicle.Chassis.Brake.CylP")
    page.get_by_role("link", name="Change", exact=True).click()
    outcome = page.locator("#outcome")
    expect(outcome).to_contain_text("No changes yet")
    page.get_by_label("unit").fill("kPaa")
    expect(outcome.locator(".marked.error")).to_contain_text("unit: kPaa")
    page.get_by_label("unit").fill("kPa")
    expect(outcome).to_contain_text("1 breaking")
    expect(outcome.locator(".affected")).to_contain_text("CoreAcc")
    expect(page.locator("#said")).not_to_be_empty()


def test_both_files_are_downloaded_by_keyboard(open_page: Opener) -> None:
    page = open_page("/propose?change=Vehicle.Speed&catalogue=small")
    page.get_by_label("max", exact=True).fill("200")
    expect(page.locator("#outcome")).to_contain_text("max: 200")
    for name, file in (("Download overlay", "overlay.vspec"), ("Download patch", "proposal.patch")):
        button = page.get_by_role("button", name=name)
        button.focus()
        with page.expect_download() as download:
            button.press("Enter")
        assert download.value.suggested_filename == file
    expect(page.locator("#progress")).to_be_hidden()


def test_the_form_is_continued_as_text(open_page: Opener) -> None:
    page = open_page("/propose?change=Vehicle.Speed&catalogue=interfaces")
    page.get_by_label("max", exact=True).fill("300")
    page.get_by_role("button", name="Edit as text").click()
    field = page.get_by_role("textbox", name="Overlay")
    expect(field).to_have_value("Vehicle.Speed:\n  type: sensor\n  datatype: float\n  max: 300\n")
    field.fill("Vehicle.Speed:\n  type: sensor\n  datatype: float\n")
    expect(page.locator("#outcome")).to_contain_text("No changes yet")
    expect(page.locator("#outcome")).not_to_contain_text("O106")


def test_without_javascript_a_button_checks(open_page: Opener) -> None:
    page = open_page("/propose?below=Vehicle.Cabin&catalogue=interfaces", java_script_enabled=False)
    page.get_by_label("name", exact=True).fill("Humidity")
    page.get_by_label("unit").fill("percnt")
    page.get_by_role("button", name="Check").click()
    expect(page.locator("#outcome")).to_contain_text(re.compile("Vehicle.Cabin.Humidity"))
    expect(page.locator(".marked.error")).to_contain_text("percnt")
    expect(page.get_by_label("unit")).to_have_value("percnt")
