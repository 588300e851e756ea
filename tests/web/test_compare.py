"""Two nodes side by side."""

import html
import re
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, Source
from sigcat.web.site import create_site
from tests.api.conftest import SETTINGS, SOURCES, Ask, asker


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library(SOURCES), SETTINGS))


def text_of(page: str) -> str:
    """The words of the content of a page."""
    content = page.partition('id="content"')[2]
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", content)).split())


def row(page: str, name: str) -> str:
    """The words of the row of an attribute, or of a node below."""
    found = re.search(rf"<tr[^>]*><th[^>]*>(?:<span[^>]*>[^<]*</span>)?{name}\b.*?</tr>", page, re.DOTALL)
    assert found, name
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", found[0])).split())


def test_every_attribute_of_both_nodes_has_a_row_and_differences_are_marked(site: Ask) -> None:
    page = site("/compare?path=Vehicle.Speed&other=bare").text
    assert re.match(r"type sensor overlay .*overlay\.vspec :2 sensor .*tree\.vspec :6 equal", row(page, "type"))
    assert re.match(r"≠ datatype differs double .* float .* breaking", row(page, "datatype"))
    assert re.match(r"≠ max differs 300 .* none", row(page, "max"))
    assert row(page, "unit").endswith("equal")
    assert "3 of 7 attributes differ." in text_of(page)


def test_the_class_is_that_of_the_change_from_left_to_right(site: Ask) -> None:
    there = site("/compare?path=Vehicle.Speed&other=bare").text
    back = site("/compare?catalogue=bare&path=Vehicle.Speed&other=small").text
    assert row(there, "max").endswith("risky")
    assert row(back, "max").endswith("compatible")


def test_two_nodes_of_one_catalogue_are_compared(site: Ask) -> None:
    page = site("/compare?path=Vehicle.Speed&with=Vehicle.OldSpeed").text
    assert "deprecation differs none moved to Vehicle.Speed" in row(page, "deprecation")
    assert 'href="/tree/small/Vehicle.OldSpeed"' in page


def test_equal_nodes_are_equal(site: Ask) -> None:
    page = site("/compare?path=Vehicle.Label&other=bare").text
    assert "attributes are equal." in text_of(page).replace("\u00a0", " ")
    assert "differs" not in text_of(page)


def test_only_differences_are_shown_on_request(site: Ask) -> None:
    page = site("/compare?path=Vehicle.Speed&other=bare").text
    (link,) = re.findall(r'href="([^"]+)">Show differences only<', page)
    shown = site(html.unescape(link)).text
    assert "datatype" in text_of(shown)
    assert "km/h" not in text_of(shown)
    assert "Show all attributes" in shown


def test_sides_are_swapped(site: Ask) -> None:
    page = site("/compare?path=Vehicle.Speed&other=bare").text
    (link,) = re.findall(r'href="([^"]+)">Swap<', page)
    assert re.match(r"≠ datatype differs float .* double", row(site(html.unescape(link)).text, "datatype"))


def test_nodes_below_two_branches_are_compared_by_name(site: Ask) -> None:
    page = site("/compare?path=Vehicle&other=bare").text
    assert row(page, "Function").endswith("only left")
    assert row(page, "Speed").endswith("differs")
    assert row(page, "Label").endswith("equal")


def test_a_conversion_is_shown_where_units_differ(tmp_path: Path) -> None:
    tree = tmp_path / "tree.vspec"
    tree.write_text(
        "Vehicle: {type: branch, description: A vehicle.}\n"
        "Vehicle.A: {type: sensor, datatype: float, unit: km/h, description: A.}\n"
        "Vehicle.B: {type: sensor, datatype: float, unit: m/s, description: B.}\n"
    )
    site = asker(create_site(Library([Source("two", "Two", tree)])))
    page = site("/compare?path=Vehicle.A&with=Vehicle.B").text
    assert "km/h → m/s: × 0.277778" in row(page, "unit").replace("\u00a0", " ")


def test_the_page_of_a_node_leads_to_the_choice_of_a_second_one(site: Ask) -> None:
    page = site("/tree/bare/Vehicle.Speed").text
    (link,) = re.findall(r'href="([^"]+)">Compare</a>', page)
    shown = site(html.unescape(link))
    assert shown.status_code == 200
    assert "Choose a second node" in shown.text
    assert 'catalogue=bare&amp;path=Vehicle.Speed&amp;other=small&amp;with=Vehicle.Speed"' in shown.text


def test_nodes_of_the_same_name_are_proposed_once_for_all_instances(tmp_path: Path) -> None:
    tree = tmp_path / "tree.vspec"
    tree.write_text(
        "Vehicle: {type: branch, description: A vehicle.}\n"
        "Vehicle.Speed: {type: sensor, datatype: float, description: A.}\n"
        "Vehicle.Wheel: {type: branch, instances: [Left, Right], description: A wheel.}\n"
        "Vehicle.Wheel.Speed: {type: sensor, datatype: float, description: B.}\n"
    )
    page = asker(create_site(Library([Source("two", "Two", tree)])))("/compare?path=Vehicle.Speed").text
    assert re.findall(r"with=(Vehicle\.Wheel[^\"]+)", page) == ["Vehicle.Wheel.Left.Speed"]


@pytest.mark.parametrize("query", ["path=Vehicle.Sped&with=Vehicle.Speed", "path=Vehicle.Speed&with=Vehicle.Sped"])
def test_a_path_that_does_not_exist_proposes_near_ones(site: Ask, query: str) -> None:
    page = site(f"/compare?{query}")
    assert page.status_code == 404
    assert "has no node Vehicle. Sped" in text_of(page.text)
    (link,) = re.findall(r'href="([^"]+)">Vehicle\.<wbr>Speed</a></li>', page.text)[:1]
    assert site(html.unescape(link)).status_code == 200


def test_markup_in_a_path_shows_as_text(site: Ask) -> None:
    page = site("/compare?path=%3Cscript%3Ealert(1)%3C/script%3E&with=Vehicle.%3Cb%3E")
    assert page.status_code == 404
    assert "<script>alert" not in page.text
    assert "<b>" not in page.text.partition('id="content"')[2]


def test_an_unknown_catalogue_is_not_found(site: Ask) -> None:
    assert site("/compare?path=Vehicle.Speed&other=nope").status_code == 404


def test_a_catalogue_without_a_tree_has_nothing_to_compare(tmp_path: Path) -> None:
    site = asker(create_site(Library([Source("lost", "Lost", tmp_path / "lost.vspec")])))
    assert site("/compare").status_code == 200


def test_the_menu_keeps_the_nodes_for_another_catalogue(site: Ask) -> None:
    menu = site("/compare?path=Vehicle.Speed&with=Vehicle.OldSpeed").text.partition('class="menu"')[2]
    assert "/compare?path=Vehicle.Speed&amp;with=Vehicle.OldSpeed&amp;catalogue=bare" in menu.partition("</details>")[0]


def test_instances_of_two_branches_are_compared_as_they_are_written(tmp_path: Path) -> None:
    tree = tmp_path / "tree.vspec"
    tree.write_text(
        "Vehicle: {type: branch, description: A vehicle.}\n"
        "Vehicle.Door: {type: branch, instances: [Left, Right], description: A door.}\n"
        "Vehicle.Seat: {type: branch, instances: [Front, Rear], description: A seat.}\n"
    )
    site = asker(create_site(Library([Source("two", "Two", tree)])))
    page = site("/compare?path=Vehicle.Door&with=Vehicle.Seat").text
    assert re.match(
        r"≠ instances differs Left Right .*tree\.vspec :2 Front Rear .*tree\.vspec :3", row(page, "instances")
    )
