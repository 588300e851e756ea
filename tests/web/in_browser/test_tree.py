"""The tree in a real browser, by keyboard and by mouse."""

import re
from urllib.parse import unquote

import pytest
from playwright.sync_api import Page, expect

from tests.web.in_browser.conftest import Opener


def rows(page: Page) -> list[str]:
    return page.locator("[role=treeitem] .name").all_inner_texts()


def active(page: Page) -> str:
    return page.locator("[role=treeitem].active .name").inner_text()


def test_opening_a_branch_loads_what_is_below_it(open_page: Opener) -> None:
    page = open_page("/tree/small")
    assert "IsOpen" not in rows(page)
    door = page.get_by_role("treeitem", name="Door")
    expect(door).to_have_attribute("aria-expanded", "false")
    door.locator(".chevron").click()
    expect(page.get_by_role("treeitem", name="Left")).to_have_attribute("aria-level", "3")
    expect(page.get_by_role("treeitem", name="Right")).to_have_attribute("aria-posinset", "2")
    expect(page.get_by_role("treeitem", name="Right")).to_have_attribute("aria-setsize", "2")
    door.locator(".chevron").click()
    expect(page.get_by_role("treeitem", name="Left")).to_have_count(0)


def test_the_address_is_the_state(open_page: Opener) -> None:
    page = open_page("/tree/small")
    page.get_by_role("treeitem", name="Door").locator(".name").click()
    expect(page.locator("h1")).to_have_text("Door")
    page.get_by_role("treeitem", name="Left").locator(".chevron").click()
    page.get_by_role("treeitem", name="IsOpen").locator(".name").click()
    expect(page.locator("h1")).to_have_text("IsOpen")
    assert "/tree/small/Vehicle.Door.Left.IsOpen" in page.url
    before = rows(page)
    page.reload()
    page.wait_for_selector("[data-ready]")
    assert rows(page) == before
    expect(page.locator("[aria-selected=true]")).to_contain_text("IsOpen")


def test_back_and_forward_go_through_the_nodes(open_page: Opener) -> None:
    page = open_page("/tree/small/Vehicle.Speed")
    page.get_by_role("treeitem", name="Label").locator(".name").click()
    expect(page.locator("h1")).to_have_text("Label")
    page.go_back()
    expect(page.locator("h1")).to_have_text("Speed")
    expect(page.locator("[aria-selected=true]")).to_contain_text("Speed")
    page.go_forward()
    expect(page.locator("h1")).to_have_text("Label")


def test_the_keyboard_of_the_tree_pattern(open_page: Opener) -> None:
    page = open_page("/tree/small")
    tree = page.get_by_role("tree")
    tree.focus()
    press = page.keyboard.press
    press("End")
    assert active(page) == rows(page)[-1] == "Function"
    press("Home")
    assert active(page) == "Vehicle"
    press("ArrowRight")
    assert active(page) == "Speed"
    press("ArrowDown")
    press("ArrowRight")
    expect(page.get_by_role("treeitem", name="Left")).to_be_visible()
    press("ArrowRight")
    assert active(page) == "Left"
    press("ArrowLeft")
    assert active(page) == "Door"
    press("ArrowLeft")
    expect(page.get_by_role("treeitem", name="Left")).to_have_count(0)
    press("ArrowLeft")
    assert active(page) == "Vehicle"
    page.keyboard.type("la")
    assert active(page) == "Label"
    press("Space")
    expect(page.locator("h1")).to_have_text("Label")
    press("*")
    expect(page.get_by_role("treeitem", name="Braking")).to_be_visible()
    expect(tree).to_have_attribute("aria-activedescendant", re.compile("row-"))


def test_enter_leads_to_the_node_and_space_stays_in_the_tree(open_page: Opener) -> None:
    page = open_page("/tree/small")
    tree = page.get_by_role("tree")
    tree.focus()
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Space")
    expect(page.locator("h1")).to_have_text("Speed")
    expect(tree).to_be_focused()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("Enter")
    expect(page.locator("h1")).to_have_text("Vehicle")
    expect(page.locator("article")).to_be_focused()


def test_a_link_to_the_root_opens_it(open_page: Opener) -> None:
    for options in ({}, {"java_script_enabled": False}):
        page = open_page("/tree/small/Vehicle", **options)
        expect(page.locator(".rows .name").get_by_text("Speed", exact=True)).to_be_visible()


def test_escape_returns_from_the_node_to_its_row_and_the_arrows_work_again(open_page: Opener) -> None:
    page = open_page("/tree/small")
    page.get_by_role("tree").focus()
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    expect(page.locator("article")).to_be_focused()
    page.keyboard.press("Tab")
    page.keyboard.press("Escape")
    expect(page.get_by_role("tree")).to_be_focused()
    assert active(page) == "Speed"
    page.keyboard.press("ArrowUp")
    assert active(page) == "Vehicle"


def test_the_type_of_a_node_needs_no_legend(open_page: Opener) -> None:
    page = open_page("/tree/small")
    expect(page.get_by_role("treeitem", name="Label").locator(".letter")).to_have_text("att")
    expect(page.get_by_role("treeitem", name="Speed", exact=False).first.locator(".letter")).to_have_text("sen")


def test_a_datatype_is_shown_whole_or_not_at_all(open_page: Opener) -> None:
    page = open_page("/tree/interfaces/Vehicle.Speed")
    page.set_viewport_size({"width": 1024, "height": 800})
    cut = """rows => rows.filter(row => {
        const hint = row.querySelector('.hint'), box = hint?.getBoundingClientRect(), around = row.getBoundingClientRect();
        return hint && (hint.scrollWidth > hint.clientWidth || (box.top < around.bottom && box.right > around.right));
    }).map(row => row.textContent)"""
    assert page.get_by_role("treeitem").evaluate_all(cut) == []


@pytest.mark.parametrize("width", [360, 1280])
def test_back_and_forward_return_to_where_one_was_in_a_node(open_page: Opener, width: int) -> None:
    page = open_page("/tree/small/Vehicle.Speed")
    page.set_viewport_size({"width": width, "height": 400})
    scrolled = "() => Math.max(document.querySelector('article').scrollTop, scrollY)"
    names = page.get_by_role("heading", name="Names")
    names.evaluate("names => names.scrollIntoView()")
    before = page.evaluate(scrolled)
    assert before > 100
    page.wait_for_timeout(200)
    page.get_by_role("link", name="Next").evaluate("link => link.click()")
    expect(page.locator("h1")).to_have_text("Door")
    expect(page.locator("h1")).to_be_in_viewport()
    page.go_back()
    expect(page.locator("h1")).to_have_text("Speed")
    expect(names).to_be_in_viewport()
    assert abs(page.evaluate(scrolled) - before) <= 1
    page.go_forward()
    expect(page.locator("h1")).to_have_text("Door")
    expect(page.locator("h1")).to_be_in_viewport()


def test_an_instance_leads_to_its_definition(open_page: Opener) -> None:
    page = open_page("/tree/rows/Vehicle.Door.Front.Left.IsOpen")
    page.get_by_role("link", name="Vehicle.Door.IsOpen").click()
    page.wait_for_url("**/tree/rows~folded/Vehicle.Door.IsOpen")
    expect(page.locator("h1")).to_have_text("IsOpen")


def test_a_definition_has_patterns_of_names_and_none_to_be_copied(open_page: Opener) -> None:
    page = open_page("/tree/rows~folded/Vehicle.Door.IsOpen")
    names = page.locator("section", has=page.get_by_role("heading", name="Patterns of names"))
    expect(names.locator("dd").first).to_have_text("Vehicle.Door.*.*.IsOpen")
    expect(names.locator("dl")).to_contain_text("door_*_*_is_open")
    expect(names).not_to_contain_text("Static id")
    expect(names.get_by_role("button")).to_have_count(0)
    names.get_by_role("link", name="Show them one by one").click()
    page.wait_for_url("**/tree/rows/Vehicle.Door.Front.Left.IsOpen")
    expect(page.get_by_role("heading", name="Names", exact=True)).to_be_visible()


def test_expand_all_and_collapse(open_page: Opener) -> None:
    page = open_page("/tree/small/Vehicle.Speed")
    page.get_by_text("Expand all").click()
    expect(page.get_by_role("treeitem", name="RangeError")).to_be_visible()
    assert unquote(page.url).endswith("?open=*")
    page.get_by_text("Collapse").click()
    expect(page.get_by_role("treeitem", name="RangeError")).to_have_count(0)


def test_a_hundred_thousand_nodes_need_a_hundred_rows(open_page: Opener) -> None:
    page = open_page("/tree/big")
    page.get_by_text("Expand all").click()
    expect(page).to_have_url(re.compile(r"open=\*$"))
    assert page.locator(".extent").evaluate("extent => extent.clientHeight") > 100_000 * 20
    tree = page.get_by_role("tree")
    tree.focus()
    page.mouse.move(100, 300)
    for _ in range(3):
        assert page.locator("[role=treeitem]").count() <= 100
        first = page.locator("[role=treeitem] .name").first.inner_text()
        page.mouse.wheel(0, 700_000)
        expect(page.locator("[role=treeitem] .name").first).not_to_have_text(first)
    page.keyboard.press("End")
    assert active(page) == "Signal99"
    assert page.locator("[role=treeitem]").count() <= 100


def test_previous_next_children_and_path_lead_on(open_page: Opener) -> None:
    page = open_page("/tree/small/Vehicle.Door")
    page.get_by_role("link", name="Next").click()
    expect(page.locator("h1")).to_have_text("Label")
    page.locator(".crumbs").get_by_role("link", name="Vehicle").click()
    expect(page.locator("h1")).to_have_text("Vehicle")
    page.locator(".nodes").get_by_role("link", name="Door").click()
    expect(page.locator("h1")).to_have_text("Door")
    expect(page.locator("[aria-selected=true]")).to_contain_text("Door")


def test_a_path_can_be_copied(open_page: Opener) -> None:
    page = open_page("/tree/small/Vehicle.Speed", permissions=["clipboard-read", "clipboard-write"])
    page.get_by_role("button", name="Copy path").click()
    expect(page.locator("#said")).to_contain_text("Vehicle.Speed")
    assert page.evaluate("navigator.clipboard.readText()") == "Vehicle.Speed"
