"""Vehicles on pages and in the API: a switch, a matrix with filters, and the vehicles that have a node."""

import csv
import re
from io import StringIO
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, tell_errors
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES, Ask, asker
from tests.web.fleet import FLEET
from tests.web.test_compare import text_of

COUPE = "fleet~vehicle.coupe~state.sop"


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library([FLEET, *SOURCES])))


def test_the_matrix_has_a_row_where_vehicles_differ_and_a_column_for_each_state(site: Ask) -> None:
    page = text_of(site("/vehicles/fleet").text)
    assert "3 vehicles of A fleet. They differ in 2 places" in page
    assert "Node Signals coupe@sop coupe@ota2 truck" in page
    assert "Vehicle. Speed 1 ✓ yes ✓ yes – no" in page
    assert re.search(r"Vehicle\. Door \d+ – no ✓ yes ✓ yes", page)


def test_errors_of_a_vehicle_are_on_the_page_and_in_the_log(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    overlay = tmp_path / "wrong.vspec"
    overlay.write_text("Vehicle.Speed:\n  unit: furlong\n", encoding="utf-8")
    wrong = FLEET._replace(vehicles=(FLEET.vehicles[0]._replace(overlays=(overlay,)), *FLEET.vehicles[1:]))
    library = Library([wrong])
    page = text_of(asker(create_site(library))("/vehicles/fleet").text)
    assert "The description of a vehicle has errors." in page
    assert page.count("Unknown unit 'furlong'") == 1
    assert "has errors" not in text_of(asker(create_site(Library([FLEET])))("/vehicles/fleet").text)
    tell_errors(library)
    messages = [record.getMessage() for record in caplog.records]
    (index,) = [
        number for number, each in enumerate(messages) if each.startswith("vehicle:coupe@sop of catalogue fleet")
    ]
    assert f"{overlay}:2:9: error V006" in messages[index + 1]


def test_filters_choose_nodes_and_vehicles(site: Ask) -> None:
    assert "They differ in 1 place" in text_of(site("/vehicles/fleet?q=SPEED").text)
    assert "Node Signals coupe@sop coupe@ota2" in text_of(site("/vehicles/fleet?fact=steering:left").text)
    assert "1 vehicle of A fleet" in text_of(site("/vehicles/fleet?fact=steering:left&fact=release:OTA 2").text)
    assert "They do not differ in any node that has these words" in text_of(site("/vehicles/fleet?q=zzz").text)
    assert "Vehicle. Label 1 ✓ yes ✓ yes ✓ yes" in text_of(site("/vehicles/fleet?show=all").text)
    assert site("/vehicles/fleet?show=none").status_code == 422
    assert site("/vehicles/fleet?from=-1").status_code == 422
    assert site("/vehicles/fleet?from=99999").status_code == 200
    assert site("/vehicles/fleet?nonsense=1").status_code == 422


def test_the_table_is_offered_as_csv(site: Ask) -> None:
    (link,) = re.findall(r'href="([^"]+)">CSV</a>', site("/vehicles/fleet?q=speed").text)
    answer = site(link.replace("&amp;", "&"))
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    assert list(csv.reader(StringIO(answer.text))) == [
        ["path", "type", "signals", "coupe@sop", "coupe@ota2", "truck"],
        ["Vehicle.Speed", "sensor", "1", "1", "1", "0"],
    ]


def test_a_vehicle_is_a_catalogue_with_pages(site: Ask) -> None:
    for page in ("tree", "units", "catalogues", "search", "vehicles"):
        assert site(f"/{page}/{COUPE}").status_code == 200
    assert "A fleet, Coupé, sop" in site(f"/tree/{COUPE}").text
    assert site(f"/tree/{COUPE}/Vehicle.Speed").status_code == 200
    assert site(f"/api/v1/catalogues/{COUPE}/nodes/Vehicle.Door").status_code == 404
    assert site(f"/api/v1/catalogues/{COUPE}~folded/nodes/Vehicle.Speed").status_code == 200
    assert site("/api/v1/catalogues/fleet~vehicle.coupe/nodes/Vehicle.Door").status_code == 200


def test_the_tree_switches_to_a_vehicle_and_back(site: Ask) -> None:
    page = site("/tree/fleet/Vehicle.Speed").text
    assert f'href="/tree/{COUPE}/Vehicle.Speed" role="switch" aria-checked="false"' in page
    switched = site(f"/tree/{COUPE}/Vehicle.Speed").text
    assert 'href="/tree/fleet/Vehicle.Speed" role="switch" aria-checked="true"' in switched
    assert "Vehicles" not in text_of(site("/tree/bare/Vehicle.Speed").text)


def test_the_page_of_a_node_lists_the_vehicles_that_have_it(site: Ask) -> None:
    page = text_of(site("/tree/fleet/Vehicle.Speed").text)
    assert "Vehicles 2 of 3 truck does not have it" in page
    assert "coupe@sop has it" in page
    assert "All 3 vehicles have it." in text_of(site("/tree/fleet/Vehicle").text)


def test_a_node_that_only_other_vehicles_have_leads_to_the_branch_above(site: Ask) -> None:
    answer = site(f"/tree/{COUPE}/Vehicle.Door")
    assert (answer.status_code, answer.headers["location"]) == (307, f"/tree/{COUPE}/Vehicle")


@pytest.mark.parametrize(
    "name",
    ["fleet~vehicle.nope", "fleet~state.sop", "fleet~vehicle.truck~state.sop", "bare~vehicle.coupe", "~vehicle.coupe"],
)
def test_an_unknown_vehicle_is_not_found(site: Ask, name: str) -> None:
    assert site(f"/tree/{name}").status_code == 404
    assert site(f"/api/v1/catalogues/{name}").status_code == 404


def test_the_api_lists_the_vehicles_of_a_catalogue(site: Ask) -> None:
    first, *others = site("/api/v1/catalogues/fleet").json()["vehicles"]
    assert first == {
        "name": "coupe@sop",
        "title": "Coupé, sop",
        "catalogue": COUPE,
        "facts": [{"name": "steering", "fact": "left"}],
    }
    assert {site(f"/api/v1/catalogues/{each['catalogue']}").status_code for each in (first, *others)} == {200}
    assert site("/api/v1/catalogues/bare").json()["vehicles"] == []


def test_vehicles_are_compared(site: Ask) -> None:
    changes = site(f"/api/v1/catalogues/{COUPE}/diff?to=fleet~vehicle.truck").json()["changes"]
    assert "Vehicle.Speed" in {change["path"] for change in changes}


def test_a_catalogue_without_vehicles_says_how_to_add_one(site: Ask) -> None:
    assert "has no vehicles" in text_of(site("/vehicles/bare").text)


def test_vehicles_of_a_tree_that_cannot_be_read_are_listed_without_nodes(tmp_path: Path) -> None:
    lost = FLEET._replace(spec=tmp_path / "lost.vspec")
    site = asker(create_site(Library([lost])))
    assert "3 vehicles of A fleet" in text_of(site("/vehicles/fleet").text)
    assert site(f"/tree/{COUPE}").status_code == 200
