"""Pages fit on a phone, a laptop and a wall, and on paper."""

import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import FloatRect, Locator, Page, expect

from tests.web.in_browser.conftest import Opener, Windows

PAGES = (
    "/", "/docs/reference/functions.md", "/docs/reference/command-line.md", "/docs/how-to/registry.md",
    "/tree/interfaces/Vehicle.Function.WheelSpeedCalculation.Error.RangeError", "/search/interfaces?q=wheel",
    "/functions?catalogue=interfaces", "/functions/core_acc?catalogue=interfaces",
    "/functions/core_acc?view=source&catalogue=interfaces", "/functions/core_acc?view=ros2&catalogue=interfaces",
    "/functions/wheel_speed_calculation?view=run&catalogue=interfaces",
    "/functions/sets/ecocontrol/compare", "/wiring?catalogue=interfaces", "/changes?old=vss&new=interfaces", "/vehicles/fleet?show=all", "/registry", "/registry/lines", "/registry/deliveries", "/registry/login", "/registry/users?path=Vehicle.S0", "/registry/functions/Alpha", "/compare?catalogue=interfaces&path=Vehicle.Chassis&other=vss", "/history/interfaces/Vehicle.Speed", "/basket/interfaces?pick=Vehicle.Speed,Vehicle.Cabin.Door.IsOpen,Vehicle.Chassis.Axle.Row1.Wheel.Left.Tire.Pressure,Vehicle.Sped", "/propose?change=Vehicle.Chassis.Brake.CylP&catalogue=interfaces", "/try?kind=function&catalogue=interfaces",
    "/rules", "/rules/I201", "/units/interfaces", "/catalogues/interfaces", "/docs", "/docs/api/exports", "/docs/api/schemas", "/problems/busy", "/tree/small/Vehicle.Sped",
)  # fmt: skip


@pytest.fixture(scope="module")
def one_page(windows: Windows) -> Iterator[Page]:
    """A page that goes from address to address."""
    page = windows.page()
    yield page
    page.close()


@pytest.fixture(scope="module", params=PAGES)
def visited(one_page: Page, service: str, request: pytest.FixtureRequest) -> Page:
    """Each page, once for all that is asked of it."""
    one_page.emulate_media(media="screen")
    one_page.set_viewport_size({"width": 1280, "height": 800})
    one_page.goto(service + request.param)
    return one_page


@pytest.fixture
def shown(visited: Page) -> Page:
    """The page on a screen, whatever was asked of it before."""
    visited.emulate_media(media="screen")
    return visited


def test_nothing_sticks_out_sideways(shown: Page) -> None:
    for width in (320, 360, 768, 1280, 2560):
        shown.set_viewport_size({"width": width, "height": 800})
        assert shown.evaluate("document.documentElement.scrollWidth") <= width


def test_no_page_is_taller_than_one_reads(shown: Page) -> None:
    shown.set_viewport_size({"width": 1440, "height": 900})
    assert shown.evaluate("document.documentElement.scrollHeight") < 8_000


SCROLLED = "pre, textarea, .side, .source, .document, .bar nav, .scroll:not(.interfaces):not(:has(.attributes))"
"""Elements that scroll sideways on purpose: text as written, filters on a phone, pictures of time, wide tables."""
SHORTENED = ".menu summary span, .row .name"
"""Names that end in an ellipsis: of the chosen catalogue, and in the tree. They are read out whole, and are told elsewhere."""
_CUT = """purpose => [...document.body.querySelectorAll("*")]
    .filter(each => getComputedStyle(each).overflowX !== "visible" && each.scrollWidth > each.clientWidth + 1)
    .filter(each => each.clientWidth && each.textContent.trim() && !each.matches(purpose) && !each.closest(".unseen"))
    .map(each => `${each.tagName}.${each.className}: ${each.textContent.trim().slice(0, 60)}`)"""


def test_no_text_is_cut(shown: Page) -> None:
    for width in (320, 390, 768, 1024, 1440):
        shown.set_viewport_size({"width": width, "height": 800})
        assert shown.evaluate(_CUT, f"{SCROLLED}, {SHORTENED}") == [], width


def begins(page: Page) -> list[int]:
    """Left edge of the content of a page, at three widths."""
    places = []
    for width in (1024, 1280, 2560):
        page.set_viewport_size({"width": width, "height": 800})
        places.append(round(box_of(page.locator("h1").first)["x"]))
    return places


@pytest.fixture(scope="module")
def usual_places(windows: Windows, service: str) -> list[int]:
    """Left edge of the content of the first page."""
    page = windows.page()
    page.goto(service + PAGES[0])
    places = begins(page)
    page.close()
    return places


def test_the_content_of_every_page_begins_at_the_same_place(shown: Page, usual_places: list[int]) -> None:
    assert begins(shown) == usual_places


def test_every_page_of_the_bar_is_in_sight(open_page: Opener) -> None:
    page = open_page("/functions?catalogue=interfaces")
    links = page.get_by_role("navigation", name="Pages").get_by_role("link").all()
    assert len(links) > 4
    for width in (360, 1280, 2560):
        page.set_viewport_size({"width": width, "height": 800})
        boxes = [box_of(link) for link in links]
        assert [box for box in boxes if box["x"] < 0 or box["x"] + box["width"] > width] == [], width


def test_the_search_box_has_room_for_words(open_page: Opener) -> None:
    page = open_page("/tree/interfaces~folded")
    inner = "box => box.clientWidth - parseFloat(getComputedStyle(box).paddingLeft) - parseFloat(getComputedStyle(box).paddingRight)"
    for width in (360, 760, 768, 900, 1023, 1024, 1280):
        page.set_viewport_size({"width": width, "height": 800})
        assert page.get_by_role("searchbox").evaluate(inner) >= 150, width


def test_nothing_moves_for_those_who_ask_for_it(open_page: Opener) -> None:
    page = open_page("/tree/small", reduced_motion="reduce")
    moving = "getComputedStyle(document.querySelector('#progress'), '::before').animationName"
    page.evaluate("document.getElementById('progress').hidden = false")
    assert page.evaluate(moving) == "none"


def test_paper_has_the_content_and_not_the_controls(shown: Page) -> None:
    shown.emulate_media(media="print")
    expect(shown.locator("h1").first).to_be_attached()
    seen = ".bar, .tree, .copy, .side, .editor, .choose, .tabs, .own"
    assert not shown.locator(seen).filter(visible=True).all()
    shown.set_viewport_size({"width": 700, "height": 1000})
    assert shown.evaluate("document.documentElement.scrollWidth") <= 700


def test_each_sheet_names_the_catalogue_and_its_content(open_page: Opener) -> None:
    page = open_page("/units/interfaces")
    expect(page.locator(".sheet")).to_be_hidden()
    page.emulate_media(media="print")
    expect(page.locator(".sheet")).to_have_text(
        re.compile(r"^VSS 6\.0 with function interfaces, content [0-9a-f]{12} sigcat \d")
    )
    for name, value in (("display", "table-header-group"), ("break-inside", "avoid")):  # repeated on every sheet
        expect(page.locator(".sheet")).to_have_css(name, value)


def test_what_fits_on_a_sheet_takes_no_second_one(open_page: Opener) -> None:
    page = open_page("/changes?old=bare&new=small")
    assert len(re.findall(rb"/Type /Page\b", page.pdf(format="A4", prefer_css_page_size=True))) == 1


def test_rows_stand_three_together_on_paper(open_page: Opener) -> None:
    page = open_page("/tree/interfaces/Vehicle.Speed")
    page.emulate_media(media="print")
    kept = [row.evaluate("row => getComputedStyle(row).breakAfter") for row in page.locator("tbody tr").all()]
    assert kept[:2] == kept[-3:-1] == ["avoid", "avoid"]
    assert kept[-1] == "auto"


def test_a_diagram_is_on_paper_even_where_the_screen_has_a_list(open_page: Opener) -> None:
    page = open_page("/functions/core_acc?catalogue=interfaces")
    page.set_viewport_size({"width": 360, "height": 800})
    expect(page.locator(".picture.interfaces")).to_be_hidden()
    expect(page.locator(".ports")).to_be_visible()
    page.emulate_media(media="print")
    expect(page.locator(".picture.interfaces")).to_be_visible()
    expect(page.locator(".ports")).to_be_hidden()


def test_paper_has_tables_where_a_phone_has_lists(open_page: Opener) -> None:
    page = open_page("/rules/I201")
    page.set_viewport_size({"width": 688, "height": 1000})
    expect(page.locator("thead")).to_be_hidden()
    page.emulate_media(media="print")
    expect(page.locator("thead")).to_be_visible()
    expect(page.locator("tbody tr").first).to_have_css("display", "table-row")


def test_a_value_of_named_parts_stays_a_table_on_a_phone(open_page: Opener) -> None:
    page = open_page("/tree/interfaces/Vehicle.Function.WheelSpeedCalculation.Scheduling.Step")
    page.set_viewport_size({"width": 360, "height": 800})
    part = page.get_by_role("row", name="minIndications 9").last
    assert box_of(part.get_by_role("rowheader"))["y"] == box_of(part.get_by_role("cell"))["y"]


def test_a_long_name_among_values_breaks_behind_its_underscores(open_page: Opener) -> None:
    page = open_page("/tree/interfaces/Vehicle.Function.WheelSpeedCalculation.Scheduling.Step")
    value = page.get_by_role("cell", name="WheelSpeedCalculation_DeadlineError_ErrorSts", exact=True)
    assert value.inner_html() == "WheelSpeedCalculation_<wbr>DeadlineError_<wbr>ErrorSts"


def test_what_a_change_says_stands_below_its_name(open_page: Opener) -> None:
    page = open_page("/changes?old=bare&new=rows")
    change = page.locator(".change", has_text="instances")
    left = box_of(change.locator("b"))["x"]
    assert box_of(change.locator("dt"))["x"] == left
    told = change.locator("p.muted", has_text=re.compile("Added|Removed")).all()
    assert told
    for each in told:
        assert (
            box_of(each)["x"] + float(each.evaluate("each => parseFloat(getComputedStyle(each).paddingLeft)")) == left
        )
    expect(change.locator(".new .chips .chips")).to_have_text(["FrontRear", "LeftRight"])
    for chips in change.locator(".new .chips").all():
        expect(chips).to_have_css("border-left-width", "0px")


def test_a_node_of_an_unknown_type_is_marked_in_the_tree(open_page: Opener) -> None:
    page = open_page("/tree/broken")
    expect(page.get_by_role("treeitem").filter(has_text="Speed").locator(".letter")).to_have_text("?")


def box_of(what: Locator) -> FloatRect:
    """Position on the page."""
    box = what.bounding_box()
    assert box
    return box


@pytest.mark.parametrize(
    ("address", "targets"),
    [
        ("/tree/interfaces/Vehicle.Chassis.Axle", ".tools a, .tools summary, .crumbs a, .row .name, .overlay-links a"),
        ("/units/interfaces", ".wide tbody th a"),
        ("/wiring?catalogue=interfaces", ".choose label, .side nav a"),
    ],
)
def test_what_is_touched_is_24_pixels_high(open_page: Opener, address: str, targets: str) -> None:
    page = open_page(address)
    page.set_viewport_size({"width": 390, "height": 800})
    heights = page.locator(targets).evaluate_all("each => each.map((one) => one.getBoundingClientRect().height)")
    assert min(height for height in heights if height) >= 24


def test_what_scrolls_sideways_has_a_shadow_where_there_is_more(shown: Page) -> None:
    shown.set_viewport_size({"width": 390, "height": 800})
    plain = shown.evaluate(
        "[...document.querySelectorAll('.scroll:has(> table, > svg)')].filter((each) => each.scrollWidth > each.clientWidth"
        " && !getComputedStyle(each).backgroundImage.includes('gradient')).length"
    )
    assert plain == 0


REGISTRY = ("/registry", "/registry/lines", "/registry/users?path=Vehicle.S0", "/registry/deliveries")


@pytest.mark.parametrize("address", [*REGISTRY, "/registry/functions/Alpha", "/registry/login"])
def test_pages_of_the_registry_use_the_width_of_a_tablet(one_page: Page, service: str, address: str) -> None:
    one_page.set_viewport_size({"width": 768, "height": 1024})
    one_page.goto(service + address)
    assert one_page.locator(".page").bounding_box()["width"] == 768  # type: ignore[index]
    widths = one_page.locator(".page .scroll").evaluate_all("(all) => all.map((e) => [e.scrollWidth, e.clientWidth])")
    assert all(needed <= given for needed, given in widths), widths


@pytest.mark.parametrize("address", REGISTRY)
def test_the_menu_and_the_account_are_close_together_on_a_phone(one_page: Page, service: str, address: str) -> None:
    one_page.set_viewport_size({"width": 390, "height": 800})
    one_page.goto(service + address)
    menu = one_page.get_by_role("navigation", name="Registry").bounding_box()
    account = one_page.get_by_role("link", name="Sign in").bounding_box()
    assert menu is not None
    assert account is not None
    assert 0 <= account["y"] - (menu["y"] + menu["height"]) <= 30


BROKEN_WORDS = """
() => [...document.querySelectorAll(".chapter td")].flatMap((cell) => {
  const range = document.createRange(), texts = document.createTreeWalker(cell, NodeFilter.SHOW_TEXT), found = [];
  for (let text = texts.nextNode(); text; text = texts.nextNode())
    for (const word of text.textContent.matchAll(/[A-Za-z0-9]+/g)) {
      range.setStart(text, word.index);
      range.setEnd(text, word.index + word[0].length);
      if (new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size > 1) found.push(word[0]);
    }
  return found;
})
"""


@pytest.mark.parametrize("width", [390, 768, 1440])
def test_no_word_is_broken_in_the_tables_of_a_chapter(one_page: Page, service: str, width: int) -> None:
    one_page.set_viewport_size({"width": width, "height": 800})
    one_page.goto(service + "/docs/reference/configuration.md")
    one_page.evaluate("document.querySelectorAll('details').forEach((each) => { each.open = true; })")
    assert one_page.evaluate(BROKEN_WORDS) == []
