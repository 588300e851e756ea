"""History of a node over releases."""

import re
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, Source
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES, Ask, asker
from tests.migration.chained_releases import chained_sources
from tests.web.test_compare import text_of


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("releases")


@pytest.fixture(scope="module")
def site(folder: Path) -> Ask:
    sources = chained_sources(folder)
    overlay = folder / "own.vspec"
    overlay.write_text("Vehicle.Speed: {type: sensor, datatype: float, max: 90}\n")
    own = Source("own", "Our vehicle", folder / "5.0.vspec", (overlay,))
    return asker(create_site(Library([own, *sources, *SOURCES])))


def test_the_page_of_a_node_leads_to_its_history(site: Ask) -> None:
    (link,) = re.findall(r'href="([^"]+)">History</a>', site("/tree/v5.0/Vehicle.Speed").text)
    assert site(link).status_code == 200


def test_each_release_has_a_row_from_the_first_that_has_the_node(site: Ask) -> None:
    page = text_of(site("/history/v5.0/Vehicle.Speed").text)
    assert "VSS 3.1 · In 3.1 already, the oldest release here Vehicle. Velocity , compare" in page
    assert "VSS 4.0 ~ Unit changed in 4.0 unit from km/h → to m/s breaking" in page
    assert "VSS 4.1 or 4.2 or 5.0 this catalogue → Moved" in page
    assert "4.1, 4.2 are not here" in page
    assert "VSS 5.1 or 6.0 − Removed in 5.1 or 6.0 5.1 is not here" in page


def test_an_unchanged_release_is_a_row(site: Ask) -> None:
    page = text_of(site("/history/v6.0/Vehicle").text)
    assert "VSS 4.0 = Unchanged" in page


def test_what_the_catalogue_itself_changes_follows_its_release(site: Ask) -> None:
    page = text_of(site("/history/own/Vehicle.Speed").text)
    assert re.search(
        r"VSS 4\.1 or 4\.2 or 5\.0 → .* Our vehicle ~ Max changed in this catalogue .* VSS 5\.1 or 6\.0 −", page
    )


def test_links_lead_to_the_node_in_each_release_and_to_a_comparison(site: Ask) -> None:
    page = site("/history/own/Vehicle.Speed").text
    links = [link.replace("&amp;", "&") for link in re.findall(r'href="(/(?:tree|compare)[^"]*Velocity[^"]*)"', page)]
    assert "/tree/v4.0/Vehicle.Velocity" in links
    assert "/compare?catalogue=v4.0&path=Vehicle.Velocity&other=own&with=Vehicle.Speed" in links
    assert {site(link).status_code for link in links} == {200}


def test_missing_releases_are_named_with_the_command_that_brings_one(site: Ask) -> None:
    page = site("/history/v5.0/Vehicle.Speed").text
    assert "3.0, 4.1, 4.2, 5.1" in page
    assert "sigcat pull v5.1" in page


def test_a_catalogue_of_no_release_says_so(site: Ask) -> None:
    assert "does not say which release of VSS" in site("/history/small/Vehicle.Speed").text


def test_folded_instances_have_the_history_of_one(tmp_path: Path) -> None:
    sources = chained_sources(tmp_path)
    for source in sources:
        with source.spec.open("a") as file:
            file.write(
                "Vehicle.Door: {type: branch, instances: [Left, Right], description: A door.}\n"
                "Vehicle.Door.IsOpen: {type: actuator, datatype: boolean, description: Open.}\n"
            )
    site = asker(create_site(Library(sources)))
    page = text_of(site("/history/v5.0~folded/Vehicle.Door.IsOpen").text)
    assert "Shown for the instance Vehicle. Door. Left. IsOpen" in page
    assert "In 3.1 already" in page


def test_an_unknown_node_is_not_found(site: Ask) -> None:
    page = site("/history/v5.0/Vehicle.Sped")
    assert page.status_code == 404
    assert "/tree/v5.0/Vehicle.Speed" in page.text
