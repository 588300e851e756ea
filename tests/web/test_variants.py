"""Catalogues less some overlays, or with instances folded, are named alike in addresses of pages and of the API."""

import re

import pytest

from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.web.site import create_site
from tests.api.conftest import Ask, asker

VARIANT = "interfaces~without.error~folded"
API = "/api/v1/catalogues"


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library(shipped_sources())))


def test_the_api_knows_the_catalogue_of_the_page(site: Ask) -> None:
    detail = site(f"{API}/{VARIANT}").json()
    assert (detail["id"], detail["title"]) == (VARIANT, "VSS 6.0 with function interfaces, without error, folded")
    assert (
        detail["node_count"]
        == len(site(f"{API}/{VARIANT}/nodes?fields=path", headers={"Accept": "text/csv"}).text.splitlines()) - 1
    )
    assert site(f"{API}/{VARIANT}/nodes/Vehicle.Chassis.Axle.Wheel.Speed").status_code == 200
    assert site(f"{API}/{VARIANT}/nodes/Vehicle.Function.CoreAcc.Error.AliveError").status_code == 404
    assert site(f"{API}/interfaces/nodes/Vehicle.Function.CoreAcc.Error.AliveError").status_code == 200


@pytest.mark.parametrize("page", ["tree", "search", "units", "catalogues"])
def test_every_link_to_json_on_a_page_of_a_variant_is_answered(site: Ask, page: str) -> None:
    path = "/Vehicle.Chassis.Axle.Wheel.Speed" if page == "tree" else ""
    text = site(f"/{page}/{VARIANT}{path}").text
    (link,) = re.findall(r'href="([^"]+)">JSON</a>', text)
    assert site(link.replace("&amp;", "&")).status_code == 200


def test_an_etag_belongs_to_the_variant(site: Ask) -> None:
    tags = {name: site(f"{API}/{name}/units").headers["etag"] for name in ("interfaces", VARIANT, "interfaces~folded")}
    assert len(set(tags.values())) == 3
    again = site(f"{API}/{VARIANT}/units", headers={"If-None-Match": tags[VARIANT]})
    assert again.status_code == 304
    version = tags[VARIANT].removeprefix('W/"').rstrip('"')
    assert "immutable" in site(f"{API}/{VARIANT}@{version}/units").headers["cache-control"]


def test_variants_are_compared_and_checked_against(site: Ask) -> None:
    changes = site(f"{API}/interfaces~without.error/diff?to=interfaces").json()
    assert changes["summary"]
    linted = site(f"/api/v1/lint?catalogue={VARIANT}", "POST", content="Vehicle.Speed:\n  type: sensr\n")
    assert not linted.json()["ok"]


@pytest.mark.parametrize("name", ["interfaces~without.nope", "interfaces~nope", "nope~folded", "~", "~folded"])
def test_a_variant_that_cannot_be_is_not_found(site: Ask, name: str) -> None:
    assert site(f"{API}/{name}").status_code == 404
    assert site(f"/tree/{name}").status_code == 404


def test_a_variant_has_no_files_of_its_own_to_be_read_again(site: Ask) -> None:
    assert site(f"{API}/interfaces~folded/reload", "POST").status_code in (401, 404)


def test_another_catalogue_is_chosen_without_leaving_the_page(site: Ask) -> None:
    for address, other in (
        ("/search/interfaces?q=wheel&unit=m", "/search/vss?q=wheel&amp;unit=m"),
        ("/rules/I201?catalogue=vss", "/rules/I201?catalogue=interfaces"),
        ("/wiring?f=core_acc&f=eco_control_mpc", "/wiring?f=core_acc&amp;f=eco_control_mpc&amp;catalogue=vss"),
        ("/units/interfaces", "/units/vss"),
        ("/changes?old=vss&new=interfaces&kind=added", "/changes?old=vss&amp;kind=added&amp;new=vss"),
        ("/docs", "/tree/vss"),
        ("/rules/nope", "/tree/vss"),
    ):
        assert f'href="{other}"' in site(address).text


def test_a_folded_branch_has_the_pattern_of_its_instances(site: Ask) -> None:
    page = site("/tree/interfaces~folded/Vehicle.Chassis.Axle.Wheel").text
    assert "<code>Vehicle.<wbr>Chassis.<wbr>Axle.*.<wbr>Wheel.*</code>" in page
