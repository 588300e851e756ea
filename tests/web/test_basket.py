"""The basket: chosen signals in the address, and files made of them."""

import csv
import html
import io
import re
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.cli import main
from sigcat.errors import UsageError
from sigcat.web.basket import EMPTY, read_basket
from sigcat.web.site import create_site
from sigcat.web.views.chosen_signals import chosen_signals, signals_overlay
from tests.api.conftest import SOURCES, Ask, asker
from tests.web.test_compare import text_of

PICK = "pick=Vehicle.Speed,Vehicle.Cabin.Door.IsOpen,Vehicle.Chassis.Axle.Row1.Wheel.Left,Vehicle.Chassis.Brake.CylP"


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library([*shipped_sources(), *SOURCES])))


def test_paths_are_in_it_once_and_in_their_order() -> None:
    basket = read_basket("Vehicle.B,Vehicle.A\nVehicle.B Vehicle/C;")
    assert basket.text == "Vehicle.B,Vehicle.A,Vehicle.C"
    assert basket.toggled("Vehicle.A").text == "Vehicle.B,Vehicle.C"
    assert EMPTY.toggled("Vehicle.A").toggled("Vehicle.A") == EMPTY


def test_a_node_is_added_and_removed_by_links(site: Ask) -> None:
    page = site("/tree/small/Vehicle.Speed").text
    (link,) = re.findall(r'href="([^"]+)" data-pick="Vehicle.Speed">Add to basket<', page)
    assert link == "/tree/small/Vehicle.Speed?pick=Vehicle.Speed"
    added = site(link).text
    (link,) = re.findall(r'href="([^"]+)" data-pick="Vehicle.Speed">Remove from basket<', added)
    assert link == "/tree/small/Vehicle.Speed"
    assert re.search(r'href="/basket/small\?pick=Vehicle.Speed" data-basket>Basket <span[^>]*>1<', added)


def test_an_address_may_give_its_paths_one_by_one(site: Ask) -> None:
    page = site("/basket/small?pick=Vehicle.Speed&pick=Vehicle.Cabin").text
    assert "2 entries" in text_of(page)


def test_links_of_the_tree_and_of_searches_keep_the_basket(site: Ask) -> None:
    for address in (
        "/tree/small/Vehicle.Speed?open=Vehicle&pick=Vehicle.Door",
        "/search/small?q=speed&pick=Vehicle.Door",
    ):
        page = site(address).text.partition("<main")[2]
        shown = re.sub(r'<a class="pick[^>]*>', "", page)
        links = [each for each in re.findall(r'href="(/(?:tree|search)/[^"]+)"', shown) if ".json" not in each]
        assert links
        assert [each for each in links if "pick=Vehicle.Door" not in each] == []
        assert '<input type="hidden" name="pick" value="Vehicle.Door">' in site(address).text


def test_each_row_of_the_tree_adds_its_node(site: Ask) -> None:
    page = site("/tree/small?pick=Vehicle.Speed").text
    (link,) = re.findall(r'href="([^"]+)" aria-label="Add to basket: Door"', page)
    assert html.unescape(link).endswith("pick=Vehicle.Speed,Vehicle.Door")
    assert 'aria-label="Remove from basket: Speed"' in page


def test_a_result_that_stands_for_instances_adds_all_of_them(site: Ask) -> None:
    page = site("/search/interfaces?q=door+isopen").text
    assert 'data-pick="Vehicle.Cabin.Door.IsOpen"' in page


def test_the_page_counts_entries_and_signals(site: Ask) -> None:
    page = text_of(site(f"/basket/interfaces?{PICK}").text).replace("\u00a0", " ")
    assert "4 entries, 17 signals:" in page
    assert re.search(r"Vehicle\. Cabin\. Door\. IsOpen 4 signals", page)
    assert re.search(r"Vehicle\. Speed float km/h Speed of the vehicle", page)


def test_a_path_of_another_catalogue_is_named_with_a_similar_one_in_its_place(site: Ask) -> None:
    page = site("/basket/interfaces?pick=Vehicle.Sped").text
    assert "not in this catalogue" in page
    assert 'href="/basket/interfaces?pick=Vehicle.Speed"' in page


def test_pasted_paths_are_added_and_the_address_is_the_link(site: Ask) -> None:
    answer = site("/basket/interfaces?pick=Vehicle.Speed&add=Vehicle.Mass%0D%0AVehicle.Speed%0D%0A")
    assert answer.status_code == 303
    assert answer.headers["location"] == "/basket/interfaces?pick=Vehicle.Speed,Vehicle.Mass"


@pytest.mark.parametrize(
    "address", ["/basket/small", "/tree/small", "/search/small", "/rules", "/basket/small/signals.csv"]
)
def test_a_basket_that_is_too_long_for_an_address_is_refused(site: Ask, address: str) -> None:
    page = site(f"{address}?pick={'Vehicle.Speed,' * 500}")
    assert page.status_code == 422
    assert "at most 6,000 characters" in page.text


def test_the_table_has_every_signal_once(site: Ask) -> None:
    answer = site(f"/basket/interfaces/signals.csv?{PICK},Vehicle.Chassis.Axle.Row1.Wheel")
    assert answer.headers["content-disposition"] == 'attachment; filename="signals.csv"'
    rows = list(csv.DictReader(io.StringIO(answer.text)))
    assert rows[0] | {"description": ""} == {
        "path": "Vehicle.Speed", "type": "sensor", "datatype": "float", "unit": "km/h", "min": "", "max": "",
        "allowed": "", "default": "", "description": "",
    }  # fmt: skip
    assert len({row["path"] for row in rows}) == len(rows) == 28


def test_the_overlay_has_one_statement_for_all_instances_and_no_error(site: Ask) -> None:
    text = site(f"/basket/interfaces/overlay.vspec?{PICK}").text
    assert "\nVehicle.Cabin.Door.IsOpen:\n" in text
    assert "\nVehicle.Chassis.Axle.Row1.Wheel.Left.Speed:\n" in text
    findings = site("/api/v1/lint?catalogue=interfaces", "POST", content=text).json()["findings"]
    assert {each["rule"] for each in findings if each["severity"] != "info"} == set()
    whole = site("/basket/interfaces/overlay.vspec?pick=Vehicle.Speed").text
    findings = site("/api/v1/lint?catalogue=interfaces", "POST", content=whole).json()["findings"]
    assert [each["rule"] for each in findings] == ["O106"], "nothing is changed yet"


def test_the_overlay_carries_branches_of_other_overlays_to_a_tree_without_them(site: Ask, tmp_path: Path) -> None:
    text = site("/basket/interfaces/overlay.vspec?pick=Vehicle.Function.CoreAcc.Error.AliveError").text
    assert "\nVehicle.Function.CoreAcc:\n  type: branch\n" in text
    (tmp_path / "overlay.vspec").write_text(text)
    assert (
        main(["show", "Vehicle.Function.CoreAcc.Error.AliveError", "-s", "vss", "-l", str(tmp_path / "overlay.vspec")])
        == 0
    )


def test_the_function_is_sound(site: Ask, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = site(f"/basket/interfaces/function.yaml?{PICK},Vehicle.Function.CoreAcc.Error.AliveError").text
    assert "- path: Vehicle.Speed # sensor float km/h\n            role: consumed\n" in text
    assert "role: provided\n            name: CabinDoorRow1DriverSideIsOpen\n" in text
    assert "Left out, as it is an interface of another function: Vehicle.Function.CoreAcc.Error.AliveError" in text
    (tmp_path / "function.yaml").write_text(text)
    assert main(["function", "build", str(tmp_path / "function.yaml"), "-o", str(tmp_path / "made.json")]) == 0, (
        capsys.readouterr().err
    )


def test_a_function_of_an_empty_basket_is_one_without_signals(site: Ask, tmp_path: Path) -> None:
    (tmp_path / "function.yaml").write_text(site("/basket/interfaces/function.yaml").text)
    assert main(["function", "build", str(tmp_path / "function.yaml"), "-o", str(tmp_path / "made.json")]) == 0


def test_markup_and_odd_paths_of_a_tree_are_no_yaml(site: Ask) -> None:
    assert "<script>" not in site("/basket/small?pick=%3Cscript%3Ealert(1)%3C/script%3E").text
    assert "script" not in site("/basket/small/overlay.vspec?pick=%3Cscript%3E").text


def test_an_unknown_file_is_answered_with_a_near_one(site: Ask) -> None:
    answer = site("/basket/small/overlay.vspc")
    assert answer.status_code == 404
    assert "overlay.vspc" in answer.text


def test_a_whole_catalogue_is_a_table_but_no_overlay(site: Ask, monkeypatch: pytest.MonkeyPatch) -> None:
    assert len(site("/basket/interfaces/signals.csv?pick=Vehicle").text.splitlines()) > 1_000
    monkeypatch.setattr("sigcat.web.views.chosen_signals.BASKET_SIGNALS", 100)
    catalogue = Library(shipped_sources()).default.catalogue
    with pytest.raises(UsageError, match="at most 100 signals"):
        signals_overlay(catalogue, chosen_signals(catalogue, ["Vehicle"]))


def test_the_basket_is_of_the_catalogue_that_is_shown(site: Ask) -> None:
    menu = site("/basket/vss?pick=Vehicle.Speed").text.partition('class="menu"')[2].partition("</details>")[0]
    assert "/basket/small?pick=Vehicle.Speed" in menu
