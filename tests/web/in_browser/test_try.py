"""Findings as one types, and the pages of functions by keyboard and mouse."""

import re

from playwright.sync_api import expect

from tests.web.in_browser.conftest import Opener, put


def test_findings_come_as_one_types(open_page: Opener) -> None:
    page = open_page("/try?catalogue=interfaces")
    expect(page.locator("[data-tally]")).to_contain_text("errors")
    expect(page.locator("[data-gutter] .error").first).to_have_text("11")
    field = page.get_by_role("textbox", name="Overlay")
    field.fill("Vehicle.Speed:\n  type: sensr\n")
    expect(page.locator("[data-gutter] .error")).to_have_text("2")
    expect(page.locator("#outcome")).to_contain_text("sensr")
    page.get_by_role("link", name="Line 2").first.click()
    expect(field).to_be_focused()
    assert field.evaluate("field => field.value.slice(field.selectionStart, field.selectionEnd)").endswith("sensr")


def test_markup_that_is_typed_shows_as_text(open_page: Opener) -> None:
    page = open_page("/try?catalogue=interfaces")
    page.get_by_role("textbox", name="Overlay").fill("Vehicle.<img src=x onerror=alert(1)>:\n  type: sensor\n")
    expect(page.locator("#outcome")).to_contain_text("<img")
    assert page.locator("#outcome img").count() == 0


def test_a_function_is_drawn_as_one_types(open_page: Opener) -> None:
    page = open_page("/try?kind=function&catalogue=interfaces")
    field = page.get_by_role("textbox", name="Function")
    put(field, field.input_value().replace("CoreAcc_Mode_Out", "CoreAcc_Mode_Ou"))
    expect(page.locator("[data-tally]")).to_contain_text("error")
    expect(page.locator("#outcome .diagram")).to_have_count(0)
    put(field, field.input_value().replace("CoreAcc_Mode_Ou]", "CoreAcc_Mode_Out]"))
    expect(page.locator("#outcome .diagram").first).to_be_visible()


def test_paths_units_and_datatypes_are_completed(open_page: Opener) -> None:
    page = open_page("/try?catalogue=interfaces")
    field = page.get_by_role("textbox", name="Overlay")
    options = page.get_by_role("listbox", name="Completions").get_by_role("option")
    field.fill("")
    field.press_sequentially("Vehicle.Cha")
    expect(options).to_have_count(1)
    field.press("Enter")
    expect(options.first).to_contain_text("Wheelbase")
    field.press_sequentially("bra")
    expect(options).to_have_text(["Brake branch", "ParkingBrake branch"])
    field.press("Tab")
    expect(options.first).to_contain_text("PedalPosition")
    field.press("ArrowUp")
    expect(options.last).to_have_attribute("aria-selected", "true")
    field.press("ArrowDown")
    expect(field).to_have_attribute("aria-activedescendant", "completion-0")
    options.first.click()
    expect(field).to_have_value("Vehicle.Chassis.Brake.PedalPosition:")
    field.press("Enter")
    field.press_sequentially("  unit: km/")
    expect(options.first).to_contain_text("km/h")
    field.press("Enter")
    field.press("Enter")
    field.press_sequentially("  datatype: flo")
    field.press_sequentially("at")
    expect(options).to_have_count(2)
    field.press("Enter")
    expect(field).to_have_value("Vehicle.Chassis.Brake.PedalPosition:\n  unit: km/h\n  datatype: float\n")
    field.press_sequentially("  datatype: u")
    field.press("Escape")
    expect(options).to_have_count(0)
    expect(field).to_be_focused()


def test_a_completion_is_undone_like_what_is_typed(open_page: Opener) -> None:
    page = open_page("/try?catalogue=interfaces")
    field = page.get_by_role("textbox", name="Overlay")
    field.fill("")
    field.press_sequentially("Vehicle.Spe")
    expect(page.get_by_role("listbox", name="Completions").get_by_role("option").first).to_contain_text("Speed")
    field.press("Tab")
    expect(field).to_have_value("Vehicle.Speed:")
    field.press("Control+z")
    expect(field).to_have_value("Vehicle.Spe")


def test_paths_of_a_function_are_those_of_instances(open_page: Opener) -> None:
    page = open_page("/try?kind=function&catalogue=interfaces")
    field = page.get_by_role("textbox", name="Function")
    field.fill("components: [{data: [{path: Vehicle.Cabin.Door.Row1")
    field.press_sequentially(".")
    expect(page.get_by_role("option")).to_have_text(["DriverSide branch", "PassengerSide branch"])


def test_paths_of_a_tree_are_the_branches_that_it_has_itself(open_page: Opener) -> None:
    page = open_page("/try?kind=tree&catalogue=interfaces")
    field = page.get_by_role("textbox", name="Tree")
    options = page.get_by_role("listbox", name="Completions").get_by_role("option")
    field.fill(
        "Boat:\n  type: branch\nBoat.Deck: {type: branch}\nBoat.Cabin.Light:\n  type: sensor\nBoat.Speed: {type: sensor}\n"
    )
    field.press_sequentially("Bo")
    expect(options).to_have_text(["Boat branch"])
    field.press("Enter")
    expect(options).to_have_text(["Deck branch", "Cabin branch"])
    field.press_sequentially("C")
    field.press("Enter")
    expect(field).to_have_value(re.compile(r"\nBoat\.Cabin\.$"))
    expect(options).to_have_count(0)


def test_what_an_overlay_does_follows_what_one_types(open_page: Opener) -> None:
    page = open_page("/try?catalogue=interfaces")
    page.get_by_role("textbox", name="Overlay").fill("Vehicle.Chassis.Brake.CylP:\n  type: sensor\n  delete: true\n")
    expect(page.locator("#outcome")).to_contain_text("no longer builds")
    expect(page.locator("#outcome .class-breaking").first).to_be_visible()


def test_without_javascript_a_text_is_checked_by_a_button(open_page: Opener) -> None:
    page = open_page("/try?catalogue=interfaces", java_script_enabled=False)
    page.get_by_role("textbox", name="Overlay").fill("Vehicle.Speed:\n  type: sensr\n")
    page.get_by_role("button", name="Check").click()
    expect(page.locator(".marked.error")).to_contain_text("sensr")


def test_without_javascript_tree_node_search_and_rules_serve(open_page: Opener) -> None:
    page = open_page("/tree/small", java_script_enabled=False)
    page.get_by_role("link", name="Open Door").click()
    page.get_by_role("link", name="Open Left").click()
    page.get_by_role("link", name="IsOpen").first.click()
    expect(page.locator("h1")).to_have_text("IsOpen")
    page.get_by_role("searchbox").fill("speed")
    page.get_by_role("searchbox").press("Enter")
    page.locator(".hits a").first.click()
    expect(page.locator("h1")).to_have_text("Speed")
    page.get_by_role("link", name="Rules").click()
    page.locator(".rules a").first.click()
    expect(page.locator("main")).to_contain_text("Findings in")


def test_a_made_document_is_copied(open_page: Opener) -> None:
    page = open_page(
        "/functions/core_acc?view=source&catalogue=interfaces", permissions=["clipboard-read", "clipboard-write"]
    )
    page.get_by_role("button", name="Copy").click()
    expect(page.locator("#said")).to_have_text("Copied")
    text = page.evaluate("navigator.clipboard.readText()")
    assert text.startswith("# Core adaptive cruise control")
    assert "\nfunction: CoreAcc\n" in text


def test_a_set_is_chosen_and_connected(open_page: Opener) -> None:
    page = open_page("/wiring?catalogue=interfaces")
    page.get_by_role("checkbox", name="EcoControlMpc").uncheck()
    page.get_by_role("button", name="Connect").press("Enter")
    expect(page.locator("main")).to_contain_text("No function of the set consumes what another one provides")


def test_overlays_and_instances_are_switched_in_the_tree(open_page: Opener) -> None:
    page = open_page("/tree/interfaces/Vehicle.Chassis.Axle.Row1.Wheel.Left.Speed")
    page.get_by_text("Show", exact=True).press("Enter")
    page.get_by_role("switch", name="Instances one by one").click()
    page.wait_for_selector("[data-ready]")
    assert page.url.endswith("/tree/interfaces~folded/Vehicle.Chassis.Axle.Wheel.Speed")
    expect(page.get_by_role("treeitem", name="Wheel").filter(has_text="×4").first).to_be_visible()
    page.get_by_text("Show", exact=True).click()
    page.get_by_role("switch", name="error").click()
    page.wait_for_selector("[data-ready]")
    assert "interfaces~without.error~folded" in page.url


def test_two_catalogues_are_chosen_and_changes_filtered(open_page: Opener) -> None:
    page = open_page("/changes")
    page.get_by_role("combobox", name="From").select_option("vss")
    page.get_by_role("combobox", name="To").select_option("interfaces")
    page.get_by_role("button", name="Compare").click()
    page.get_by_role("complementary", name="Filters").get_by_role("link", name="risky").click()
    expect(page.locator(".change")).to_have_count(1)
    expect(page.locator(".change")).to_contain_text("ASILlevel")
