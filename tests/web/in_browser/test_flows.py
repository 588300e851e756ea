"""Tasks of people on the pages, each by keyboard; `make slow` does them by mouse as well."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Route, expect

from tests.web.in_browser.conftest import Opener, Use, put

NODE = "/tree/interfaces/Vehicle.ADAS.EcoControl.AccelerationProposal"
COPYING = {"permissions": ["clipboard-read", "clipboard-write"]}


def test_another_catalogue_is_chosen(open_page: Opener, use: Use) -> None:
    page = open_page("/search/interfaces?q=wheel")
    menu = page.locator("details.menu").first
    use(menu.locator("summary"))
    use(menu.get_by_role("link", name="The small tree alone"))
    page.wait_for_url("**/search/bare?q=wheel")
    expect(menu.locator("summary")).to_have_text("The small tree alone")


def test_a_menu_closes_by_escape_and_by_a_click_elsewhere(open_page: Opener) -> None:
    page = open_page("/units/small")
    menu = page.locator("details.menu").first
    for close in (lambda: page.keyboard.press("Escape"), lambda: page.locator("h1").click()):
        menu.locator("summary").click()
        expect(menu).to_have_attribute("open", "")
        close()
        expect(menu).not_to_have_attribute("open", "")


def test_overlays_are_switched_and_instances_folded(open_page: Opener, use: Use) -> None:
    page = open_page("/tree/interfaces/Vehicle.Speed")
    for name, part in (("Instances one by one", "~folded"), ("error", "~without.error~folded")):
        use(page.get_by_text("Show", exact=True))
        use(page.get_by_role("switch", name=name))
        page.wait_for_url(f"**/tree/interfaces{part}/Vehicle.Speed")
        page.wait_for_selector("[data-ready]")


def test_branches_are_opened_and_nodes_selected(open_page: Opener, use: Use) -> None:
    page = open_page("/tree/small/Vehicle.Speed")
    use(page.locator(".crumbs").get_by_role("link", name="Vehicle"))
    expect(page.locator("h1")).to_have_text("Vehicle")
    use(page.locator("article .nodes").get_by_role("link", name="Door"))
    expect(page.locator("h1")).to_have_text("Door")
    use(page.get_by_role("link", name="Next"))
    expect(page.locator("h1")).to_have_text("Label")
    use(page.get_by_role("link", name="Previous"))
    expect(page.locator("h1")).to_have_text("Door")
    use(page.get_by_text("Expand all"))
    expect(page.get_by_role("treeitem", name="RangeError")).to_be_visible()
    use(page.get_by_text("Collapse"))
    expect(page.get_by_role("treeitem", name="RangeError")).to_have_count(0)


@pytest.mark.parametrize(("label", "catalogue", "offers"), [("Left", "", 1), ("Right", "The small tree alone", 0)])
def test_a_path_to_compare_is_completed_from_the_catalogue_beside_it(
    open_page: Opener, label: str, catalogue: str, offers: int
) -> None:
    page = open_page("/compare?catalogue=interfaces&path=Vehicle.Speed")
    side = page.get_by_role("group", name=label)
    if catalogue:
        side.get_by_label("Catalogue").select_option(catalogue)
    side.get_by_label("Path").fill("")
    with page.expect_response("**/search?q=EcoControl.AccelerationProp**"):
        side.get_by_label("Path").press_sequentially("EcoControl.AccelerationProp")
    options = side.locator("datalist option")
    expect(options).to_have_count(offers)
    if offers:
        expect(options).to_have_attribute("value", NODE.rpartition("/")[2])


def test_the_tree_is_made_wider(open_page: Opener) -> None:
    page = open_page("/tree/small")
    divider = page.get_by_role("separator", name="Width of the tree")
    before = int(divider.get_attribute("aria-valuenow") or 0)
    divider.press("ArrowRight")
    wider = int(divider.get_attribute("aria-valuenow") or 0)
    assert wider > before
    box = divider.bounding_box()
    assert box
    page.mouse.move(box["x"] + 1, 300)
    page.mouse.down()
    page.mouse.move(box["x"] + 101, 300)
    page.mouse.up()
    assert int(divider.get_attribute("aria-valuenow") or 0) > wider


@pytest.mark.parametrize(
    ("where", "name"),
    [
        ("C", "adas_eco_control_acceleration_proposal"),
        ("C++ (ara::com)", "EcoControlMpcServiceProxy::ADAS_EcoControl_AccelerationProposal"),
        ("Python", "adas_eco_control_acceleration_proposal"),
        ("ROS 2 topic", "vehicle/adas/eco_control/acceleration_proposal"),
        ("ROS 2 field", "acceleration_proposal"),
        ("SOME/IP event", "ADAS_EcoControl_AccelerationProposal"),
        ("AUTOSAR", "EcoControlMpcService/ADAS_EcoControl_AccelerationProposal"),
    ],
)
def test_each_name_of_a_node_is_copied(open_page: Opener, where: str, name: str) -> None:
    page = open_page(NODE, **COPYING)
    page.get_by_role("button", name=f"Copy name: {where}", exact=True).click()
    expect(page.locator("#said")).to_have_text(f"Copied {name}")
    assert page.evaluate("navigator.clipboard.readText()") == name


def test_a_search_is_filtered_and_a_result_opened(open_page: Opener, use: Use) -> None:
    page = open_page("/search/small?q=vehicle")
    use(page.get_by_role("complementary", name="Filters").get_by_role("link", name="actuator"))
    expect(page.locator("[data-tally]")).to_have_text("1\u00a0result")
    use(page.locator("[data-hit]").first)
    expect(page.locator("h1")).to_have_text("IsOpen")
    page.go_back()
    expect(page.locator("[data-tally]")).to_have_text("1\u00a0result")


def test_filters_beyond_the_most_frequent_are_shown(open_page: Opener, use: Use) -> None:
    page = open_page("/search/interfaces")
    units = page.get_by_role("complementary", name="Filters").locator("section", has_text="Unit")
    expect(units.locator("details a").last).to_be_hidden()
    use(units.locator("summary"))
    last = units.locator("details a").last
    chosen = last.locator("span").first.inner_text()
    use(last)
    expect(units.locator(".chosen")).to_contain_text(chosen)


def test_changes_are_filtered_and_followed(open_page: Opener, use: Use) -> None:
    page = open_page("/changes?old=vss&new=interfaces")
    use(page.get_by_role("complementary", name="Filters").get_by_role("link", name="risky"))
    expect(page.locator(".change")).to_have_count(1)
    use(page.get_by_role("link", name="Remove filter Class: risky"))
    expect(page.locator(".change")).to_have_count(7)
    use(page.locator("summary", has_text="Chassis"))
    expect(page.get_by_role("link", name="CylP")).to_be_hidden()
    use(page.get_by_role("link", name="Longitudinal"))
    expect(page.locator("h1")).to_have_text("Longitudinal")


def test_a_function_is_read_in_every_form(open_page: Opener, use: Use) -> None:
    page = open_page("/functions?catalogue=interfaces")
    use(page.locator(".cards").get_by_role("link", name="CoreAcc"))
    expect(page.locator(".diagram").first).to_be_visible()
    for name, text in (
        ("Documents", "function: CoreAcc"),
        ("ROS 2", '"FunctionName": "CoreAcc"'),
        ("AUTOSAR adaptive", '"FunctionName": "CoreAcc"'),
    ):
        use(page.get_by_role("navigation", name="Views").get_by_role("link", name=name, exact=True))
        expect(page.locator("main")).to_contain_text(text)
    use(page.get_by_role("navigation", name="Files").get_by_role("link", name="types.arxml"))
    expect(page.get_by_role("region", name="types.arxml")).to_contain_text("<AUTOSAR")
    with page.expect_download() as kept:
        use(page.get_by_role("link", name="Download types.arxml"))
    assert kept.value.suggested_filename == "types.arxml"
    with page.expect_download() as kept:
        use(page.get_by_role("link", name="Download all"))
    assert kept.value.suggested_filename == "CoreAcc.autosar-adaptive.zip"
    expect(page.get_by_role("progressbar")).to_be_hidden()


def test_a_run_is_zoomed_by_dragging_and_by_links(open_page: Opener, use: Use) -> None:
    page = open_page("/functions/wheel_speed_calculation?view=run&catalogue=interfaces")
    picture = page.locator("svg.run")
    box = picture.bounding_box()
    assert box
    page.mouse.move(box["x"] + 300, box["y"] + 80)
    page.mouse.down()
    page.mouse.move(box["x"] + 500, box["y"] + 80, steps=4)
    page.mouse.up()
    expect(page).to_have_url(re.compile(r"from=\d+\.\d+&to=\d+\.\d+"))
    expect(page.get_by_role("textbox", name="From")).not_to_have_value("")
    use(page.get_by_role("link", name="Whole run"))
    expect(page).not_to_have_url(re.compile("from="))
    expect(picture).to_have_attribute("data-last", "40")
    expect(page.locator("[data-run]")).to_be_focused()


def test_values_of_a_run_are_read_under_the_pointer_and_by_keys(open_page: Opener) -> None:
    speed = "Vehicle.Chassis.Axle.Row1.Wheel.Left.Speed"
    page = open_page(f"/functions/wheel_speed_calculation?view=run&catalogue=interfaces&signal={speed}")
    page.locator("svg.run").hover(position={"x": 420, "y": 60})
    expect(page.locator("[data-readout]")).to_have_text(re.compile(r"^\d+(\.\d+)?$"))
    page.mouse.move(0, 0)
    expect(page.locator("[data-readout]")).to_have_text("")
    page.locator("[data-run]").focus()
    page.keyboard.press("ArrowRight")
    expect(page.locator("#said")).to_have_text(re.compile(r"^\d+\.\d+ s, Vehicle\.\S+Left\.Speed \[km/h\]: "))


def test_an_operation_is_called_from_its_reference(open_page: Opener, use: Use) -> None:
    page = open_page("/docs/api/catalogues")
    operation = page.locator(".operation", has_text="nodes/{path}")
    use(operation.get_by_text("Call this service"))
    expect(operation.get_by_label("catalogue")).to_have_value("interfaces")
    operation.get_by_label("path").fill("Vehicle.Speed")
    use(operation.get_by_role("button", name="Send"))
    expect(operation.locator("[data-answer]")).to_contain_text("200")
    expect(operation.locator("[data-answer]")).to_contain_text('"Vehicle.Speed"')
    operation.get_by_label("path").fill("Vehicle.Sped")
    use(operation.get_by_role("button", name="Send"))
    expect(operation.locator("[data-answer]")).to_contain_text("404")


def test_a_link_to_a_schema_opens_it(open_page: Opener, use: Use) -> None:
    page = open_page("/docs/api/catalogues")
    use(page.get_by_role("link", name="CatalogueList"))
    expect(page.locator("#schema-CatalogueList")).to_be_visible()
    expect(page.locator("#schema-Catalogue")).to_be_hidden()


@pytest.mark.parametrize("has_scripts", [True, False])
def test_a_link_to_a_section_of_a_long_chapter_opens_it(open_page: Opener, *, has_scripts: bool) -> None:
    page = open_page("/docs/reference/command-line.md", java_script_enabled=has_scripts)
    expect(page.locator("details.section[open]")).to_have_count(0)
    page.get_by_role("link", name="sigcat diff").first.click()
    expect(page.locator("details.section[open] > div")).to_have_id("sigcat-diff")


def test_a_signal_in_a_diagram_leads_to_its_node(open_page: Opener) -> None:
    page = open_page("/functions/core_acc?catalogue=interfaces")
    page.locator(".picture").get_by_role("link", name="Chassis.Brake.CylP").click()
    expect(page.locator("h1")).to_have_text("CylP")


def test_functions_of_ones_own_are_connected(open_page: Opener, use: Use, tmp_path: Path) -> None:
    page = open_page("/wiring?catalogue=interfaces")
    mine = tmp_path / "mine.json"
    made = page.request.get(page.url.replace("/wiring", "/functions/eco_control_mpc.json")).text()
    mine.write_text(made.replace('"VssUnit": "m/s^2"', '"VssUnit": "km/h"'))
    use(page.get_by_text("Your own functions"))
    page.get_by_label("Files").set_input_files([mine])
    use(page.get_by_role("group", name="Together with").get_by_role("checkbox", name="CoreAcc"))
    use(page.get_by_role("button", name="Connect these"))
    expect(page.locator("h1")).to_have_text("Posted functions")
    expect(page.locator(".wire.mismatched")).to_have_count(1)
    expect(page.locator(".findings").first).to_contain_text("must be km/h")
    use(page.get_by_role("button", name="ROS 2", exact=True))
    expect(page.locator(".open-file .notice")).to_have_text("It cannot be made.")
    expect(page.locator(".open-file > .findings")).to_contain_text("must have one datatype and unit")
    use(page.get_by_role("button", name="AUTOSAR adaptive"))
    expect(page.locator(".document")).to_contain_text('"FunctionName": "CoreAcc and EcoControlMpc"')
    use(page.get_by_role("button", name="Files"))
    with page.expect_download() as kept:
        use(page.get_by_role("button", name="Download AUTOSAR adaptive as an archive"))
    assert kept.value.suggested_filename == "FunctionSet.autosar-adaptive.zip"


def test_documents_are_pasted_and_edited(open_page: Opener, use: Use) -> None:
    page = open_page("/functions?catalogue=interfaces")
    use(page.get_by_role("navigation", name="Functions").get_by_role("link", name="Check your own set"))
    page.get_by_role("textbox", name="Documents").fill("--- # a.yaml\nfunction: A\n--- # b.yaml\nfunction: B\n")
    use(page.get_by_role("button", name="Connect these"))
    field = page.get_by_role("textbox", name="Documents")
    expect(field).to_be_visible()
    assert field.input_value().startswith("--- # a.yaml\nfunction: A")
    use(page.get_by_role("link", name="b.yaml:1").first)
    assert page.url.endswith("#file-2-1")


def test_the_wiring_tells_what_happens_to_each_value(open_page: Opener) -> None:
    page = open_page("/wiring?catalogue=interfaces")
    inside = page.get_by_role("region", name="Signals within the set")
    assert inside.get_by_role("columnheader").all_inner_texts() == ["Signal", "From", "To", "Conversion", "Fits"]
    outside = page.get_by_role("region", name="Signals from outside")
    assert outside.get_by_role("columnheader").all_inner_texts() == ["Signal", "Function", "Call", "Conversion"]
    speed = outside.get_by_role("row", name="Vehicle.Speed EcoControlMpc")
    expect(speed).to_contain_text("EgoSpd m/s")
    expect(speed).to_contain_text("km/h → m/s: ×\u00a00.277778")
    expect(outside.get_by_role("row", name="Vehicle.Mass")).to_contain_text("none")
    assert page.get_by_role("region", name="Signals to outside").get_by_role("columnheader").count() == 4


def test_a_text_is_tried_and_its_documents_kept(open_page: Opener, use: Use) -> None:
    page = open_page("/try?catalogue=interfaces")
    use(page.get_by_role("link", name="Line 11").first)
    expect(page.get_by_role("textbox", name="Overlay")).to_be_focused()
    use(page.get_by_role("navigation", name="What to try").get_by_role("link", name="Function"))
    use(page.get_by_role("button", name="Function JSON"))
    expect(page.locator(".document")).to_contain_text('"FunctionName": "CoreAcc"')
    expect(page.get_by_role("button", name="Function JSON")).to_be_focused()
    with page.expect_download() as kept:
        use(page.get_by_role("button", name="Download CoreAcc.json"))
    assert kept.value.suggested_filename == "CoreAcc.json"
    expect(page.get_by_role("progressbar")).to_be_hidden()


def test_a_function_with_mistakes_is_mended_on_the_page_and_its_arxml_kept(open_page: Opener, use: Use) -> None:
    page = open_page("/try?kind=function&catalogue=interfaces")
    field = page.get_by_role("textbox", name="Function")
    mistakes = {"CylP\n": "CylPressure\n", "rangeErrorAction": "rangeErorAction", "timeout: 200": "timeout: soon"}
    for right, wrong in mistakes.items():
        put(field, field.input_value().replace(right, wrong, 1))
    height = height_of(field)
    for wrong, right in (("soon", "200"), ("rangeEror", "rangeError"), ("CylPressure", "CylP")):
        finding = page.locator(".findings li", has_text=wrong)
        use(finding.get_by_role("link", name="Line"))
        expect(field).to_be_focused()
        assert wrong in field.evaluate("field => field.value.slice(field.selectionStart).split('\\n')[0]")
        put(field, field.input_value().replace(wrong, right))
        expect(finding).to_have_count(0)
    use(page.get_by_role("button", name="AUTOSAR adaptive", exact=True))
    use(page.get_by_role("button", name="interfaces.arxml", exact=True))
    assert height_of(field) == height
    with page.expect_download() as kept:
        use(page.get_by_role("button", name="Download interfaces.arxml"))
    assert kept.value.suggested_filename == "interfaces.arxml"


def test_who_comes_back_finds_the_text_and_its_findings(open_page: Opener) -> None:
    page = open_page("/try?catalogue=interfaces")
    page.get_by_role("textbox", name="Overlay").fill("Vehicle.Speed:\n  type: sensr\n")
    page.locator("#outcome").get_by_role("link", name="V001").click()
    page.go_back()
    assert page.get_by_role("textbox", name="Overlay").input_value() == "Vehicle.Speed:\n  type: sensr\n"
    expect(page.locator("[data-gutter] .error")).to_have_text(["2"])
    expect(page.locator("#outcome")).to_contain_text("sensr")


def test_a_file_is_opened_and_checked(open_page: Opener, tmp_path: Path) -> None:
    page = open_page("/try?catalogue=interfaces")
    overlay = tmp_path / "mine.vspec"
    overlay.write_text("Vehicle.Speed:\n  type: sensr\n")
    page.get_by_label("Open a file").set_input_files([overlay])
    expect(page.locator("[data-gutter] .error")).to_have_text(["2"])
    assert page.get_by_role("textbox", name="Overlay").input_value() == "Vehicle.Speed:\n  type: sensr\n"


def test_a_file_that_is_no_text_is_told_until_it_is_mended(open_page: Opener, tmp_path: Path) -> None:
    page = open_page("/try?catalogue=interfaces")
    overlay = tmp_path / "mine.vspec"
    overlay.write_bytes(b"Vehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: km/h\n  description: Stra\xdfe.\n")
    page.get_by_label("Open a file").set_input_files([overlay])
    expect(page.locator("#outcome")).to_contain_text("Byte 0xDF is not UTF-8.")
    field = page.get_by_role("textbox", name="Overlay")
    field.fill(field.input_value().replace("\ufffd", "ss"))
    expect(page.locator("#outcome")).not_to_contain_text("is not UTF-8.")


def test_a_rule_leads_to_its_findings_and_they_to_the_node(open_page: Opener, use: Use) -> None:
    page = open_page("/tree/small")
    use(page.get_by_role("navigation", name="Pages").get_by_role("link", name="Rules"))
    expect(page.locator(".lead")).to_contain_text("A small tree")
    use(page.get_by_role("navigation", name="Kinds of rules").get_by_role("link", name="vss"))
    use(page.locator(".rule-group", has_text="With findings").locator("li", has_text="I201").get_by_role("link"))
    expect(page.locator("h2", has_text="Findings in A small tree")).to_contain_text("4")
    use(page.locator(".findings .where").get_by_role("link").first)
    expect(page.locator("h1")).to_have_text("RangeError")


def test_the_first_thing_that_tab_reaches_leads_past_the_bar(open_page: Opener) -> None:
    page = open_page("/functions")
    page.keyboard.press("Tab")
    expect(page.get_by_role("link", name="Skip to content")).to_be_focused()
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    expect(page.locator(".cards a").first).to_be_focused()


# -- what takes long --------------------------------------------------------------------------------------------------


def test_what_takes_long_shows_a_bar(open_page: Opener) -> None:
    page = open_page("/tree/small")
    bar = page.locator("#progress")
    expect(bar).to_be_hidden()
    held: list[Route] = []

    def hold(route: Route) -> None:
        held.append(route)

    page.route("**/rows/small?path=Vehicle.Door*", hold)
    page.get_by_role("treeitem", name="Door").locator(".chevron").click()
    expect(bar).to_be_visible()
    held[0].continue_()
    expect(page.get_by_role("treeitem", name="Left")).to_be_visible()
    expect(bar).to_be_hidden()


def test_a_busy_service_is_asked_again(open_page: Opener) -> None:
    page = open_page("/try?catalogue=interfaces")
    asked: list[str] = []

    def answer(route: Route) -> None:
        asked.append(route.request.url)
        if len(asked) == 1:
            route.fulfill(status=503, headers={"Retry-After": "1"}, body='<p class="lead">The service is busy.</p>')
        else:
            route.continue_()

    page.route("**/try?part*", answer)
    page.get_by_role("textbox", name="Overlay").fill("Vehicle.Speed:\n  type: sensr\n")
    expect(page.locator("[data-tally]")).to_have_text("The service is busy.")
    expect(page.locator("#outcome")).to_contain_text("sensr")
    assert len(asked) == 2


def height_of(element: Locator) -> float:
    box = element.bounding_box()
    assert box is not None
    return box["height"]
