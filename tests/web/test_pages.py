"""Pages as the server writes them: they serve without JavaScript."""

import re

import pytest

from app.catalogue.hosting import Library
from app.web.headers import POLICY
from app.web.site import create_site
from tests.api.conftest import SETTINGS, SOURCES, Ask, asker

PAGES = (
    "/", "/tree/small", "/tree/small/Vehicle.Speed", "/tree/small?open=*", "/tree/broken", "/search/small?q=speed",
    "/search/small", "/units/small", "/rules", "/rules/I201", "/catalogues/broken", "/docs", "/problems/not-found",
)  # fmt: skip


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library(SOURCES), SETTINGS))


@pytest.mark.parametrize("address", PAGES)
def test_every_page_stands_and_runs_nothing_inline(site: Ask, address: str) -> None:
    page = site(address)
    assert page.status_code == 200
    assert page.headers["content-security-policy"] == POLICY
    assert not re.search(r"<style|\sstyle=|\son\w+=|<script(?! type=\"module\" src=)|https?://(?!sigcat/)", page.text)


def test_without_javascript_branches_open_by_links(site: Ask) -> None:
    closed = site("/tree/small/Vehicle.Label").text
    (link,) = re.findall(r'href="([^"]+)" aria-label="Open Door"', closed)
    assert link == "/tree/small/Vehicle.Label?open=Vehicle.Door"
    opened = site(link).text
    assert 'aria-label="Open Left"' in opened
    (back,) = re.findall(r'href="([^"]+)" aria-label="Close Door"', opened)
    assert back == "/tree/small/Vehicle.Label"


def test_closing_a_branch_selects_it_if_the_selected_node_was_below(site: Ask) -> None:
    page = site("/tree/small/Vehicle.Door.Left").text
    assert re.search(r'href="/tree/small/Vehicle.Door" aria-label="Close Door"', page)


def test_a_node_shows_each_attribute_with_its_origin_and_what_it_replaced(site: Ask) -> None:
    page = site("/tree/small/Vehicle.Speed").text
    assert "kilometer per hour" in page
    assert re.search(r"<s>float</s>", page)
    assert re.search(r"overlay\.vspec</span><span class=\"line\">:3<", page)


def test_a_node_is_also_json(site: Ask) -> None:
    node = site("/tree/small/Vehicle.Speed.json")
    assert node.json() == site("/api/v1/catalogues/small/nodes/Vehicle.Speed").json()


def test_markup_in_a_tree_shows_as_text(site: Ask) -> None:
    page = site("/tree/small/Vehicle.Label").text
    assert "<script>alert" not in page
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in page
    assert "&lt;b&gt;bold&lt;/b&gt;" in page
    results = site("/search/small?q=label").text
    assert "<script>alert" not in results


@pytest.mark.parametrize(
    "address", ["/tree/small/%3Cscript%3Ealert(1)%3C%2Fscript%3E", "/rules/%3Cb%3E", "/tree/%3Cb%3E"]
)
def test_markup_in_an_address_shows_as_text(site: Ask, address: str) -> None:
    page = site(address)
    assert page.status_code == 404
    assert "text/html" in page.headers["content-type"]
    assert "<script>alert" not in page.text
    assert "<b>'" not in page.text


def test_a_path_that_does_not_exist_proposes_links_to_near_ones(site: Ask) -> None:
    page = site("/tree/small/Vehicle.Sped")
    assert page.status_code == 404
    assert '<a href="/tree/small/Vehicle.Speed">' in page.text


def test_errors_of_the_api_stay_problem_documents(site: Ask) -> None:
    assert site("/api/v1/catalogues/nope").headers["content-type"] == "application/problem+json"
    assert site("/tree/small/Vehicle.Sped.json").headers["content-type"] == "application/problem+json"


def test_a_catalogue_with_errors_says_so_and_still_shows_its_tree(site: Ask) -> None:
    assert "Did you mean" in site("/catalogues/broken").text


def test_many_open_rows_come_in_pages(site: Ask) -> None:
    page = site("/tree/small?open=*&from=5").text
    assert "Rows 6 to 14 of 14" not in page  # nothing to page through: all fit
    assert site("/tree/small?from=-1").status_code == 422


def test_behind_a_proxy_every_link_leads_below_its_prefix() -> None:
    ask = asker(create_site(Library(SOURCES[:1]), SETTINGS), root_path="/signals")
    for address in ("/signals/tree/small/Vehicle.Speed", "/signals/search/small?q=speed", "/signals/tree/small/Nope"):
        links = re.findall(r'(?:href|src|action)="(/[^"]*)"', ask(address).text)
        assert links
        assert all(link.startswith("/signals/") for link in links)
