"""Pages as the server writes them: they serve without JavaScript."""

import re
from pathlib import Path
from urllib.parse import quote

import pytest

from sigcat.api.answers.problems import KINDS, MEDIA_TYPE
from sigcat.api.work.turns import Turns
from sigcat.catalogue.hosting.library import Library, Source
from sigcat.web.security_headers import POLICY
from sigcat.web.site import create_site
from tests.api.conftest import SETTINGS, SOURCES, TREE, Ask, asker

PAGES = (
    "/", "/tree/small", "/tree/small/Vehicle.Speed", "/tree/small?open=*", "/tree/broken", "/search/small?q=speed",
    "/search/small", "/compare?path=Vehicle.Speed&with=Vehicle.OldSpeed", "/history/small/Vehicle.Speed", "/basket/small?pick=Vehicle.Speed,Vehicle.Door", "/propose?change=Vehicle.Speed", "/propose?below=Vehicle.Door&as=text", "/units/small", "/rules", "/rules/I201", "/catalogues/broken", "/docs", "/docs/api/exports", "/docs/api/schemas", "/docs/reference/functions.md", "/problems/not-found",
)  # fmt: skip


def title_of(page: str) -> str:
    """Title in a browser's tab."""
    return str(re.findall(r"<title>([^<]*)</title>", page)[0])  # those after it belong to pictures


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library(SOURCES), SETTINGS))


@pytest.mark.parametrize("address", PAGES)
def test_every_page_stands_and_runs_nothing_inline(site: Ask, address: str) -> None:
    page = site(address)
    assert page.status_code == 200
    assert page.headers["content-security-policy"] == POLICY
    assert not re.search(r"<style|\sstyle=|\son\w+=|<script(?! type=\"module\" src=)|https?://", page.text)


def test_other_catalogues_are_linked_at_the_node_if_they_have_it(site: Ask) -> None:
    for node in ("Vehicle", "Vehicle.Speed", "Vehicle.Door", "Vehicle.Door.Row1"):
        page = site(f"/tree/small/{node}")
        assert page.status_code in (200, 404)
        for link in re.findall(r'<a href="(/tree/[^"]+)" data-elsewhere', page.text):
            assert site(link).status_code == 200, link


def test_where_not_even_a_page_of_the_problem_can_be_made_the_problem_is_answered() -> None:
    app = create_site(Library(SOURCES), SETTINGS)
    app.state.thread_turns = Turns(at_once=0, waiting=0, share=1)
    for address, status in (("/rules", 503), ("/nope", 404)):
        answer = asker(app)(address)
        assert (answer.status_code, answer.headers["content-type"]) == (status, MEDIA_TYPE)


@pytest.mark.parametrize(
    "address",
    [*PAGES, "/docs/", "/tree/small/", "/api/v1/rules/", "/openapi.json", "/api/v1/schemas", "/tree/small/Nope"],
)
def test_no_answer_repeats_the_host_that_a_client_sent(site: Ask, address: str) -> None:
    usual, other = site(address), site(address, headers={"Host": "stranger.example:81"})
    assert (other.status_code, other.text) == (usual.status_code, usual.text)
    assert "stranger" not in f"{other.headers} {other.text}"
    assert other.headers.get("location", "/").startswith("/")


@pytest.mark.parametrize("address", [*PAGES, "/static/icon.svg", "/openapi.json", "/metrics"])
def test_no_address_takes_a_parameter_that_it_does_not_have(site: Ask, address: str) -> None:
    refused = site(f"{address}{'&' if '?' in address else '?'}colour=red")
    assert refused.status_code == 422
    assert "Unknown parameter" in refused.text


def test_a_file_of_pages_is_sent_in_the_version_that_is_wanted(site: Ask) -> None:
    tag = site("/static/icon.svg").headers["etag"]
    statuses = [
        site("/static/icon.svg", headers={"If-Match": each}).status_code for each in (tag, "*", '"1"', f"W/{tag}")
    ]
    assert statuses == [200, 200, 412, 412]


def test_a_file_that_is_packed_has_a_tag_of_its_own_and_the_client_has_it_all_the_same(site: Ask) -> None:
    plain = site("/static/sigcat.css", headers={"Accept-Encoding": "identity"})
    packed = site("/static/sigcat.css", headers={"Accept-Encoding": "gzip"})
    assert packed.headers["content-encoding"] == "gzip"
    assert packed.headers["etag"] == f"W/{plain.headers['etag']}"
    for tag in (plain.headers["etag"], packed.headers["etag"]):
        assert site("/static/sigcat.css", headers={"If-None-Match": tag, "Accept-Encoding": "gzip"}).status_code == 304


@pytest.mark.parametrize("asked", ["bytes=0-9", "bytes=999999999-", "bytes=x", "lines=1-2"])
def test_a_file_of_pages_is_sent_whole(site: Ask, asked: str) -> None:
    answer = site("/static/icon.svg", headers={"Range": asked})
    assert (answer.status_code, answer.content) == (200, site("/static/icon.svg").content)
    assert answer.headers["accept-ranges"] == "none"


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


def test_every_kind_of_problem_has_a_page(site: Ask) -> None:
    assert KINDS
    for kind, title in KINDS.values():
        page = site(f"/problems/{kind}")
        assert page.status_code == 200
        assert f"<h1>{title}</h1>" in page.text


def test_a_catalogue_that_failed_to_load_shows_its_findings_where_the_tree_would_be(tmp_path: Path) -> None:
    ask = asker(create_site(Library([Source("lost", "Lost", tmp_path / "lost.vspec")])))
    page = ask("/tree/lost")
    assert page.status_code == 200
    assert "Lost has no tree" in page.text
    assert re.search(r'class="error">.*lost\.vspec', page.text, re.DOTALL)


@pytest.mark.parametrize(
    ("facet", "value", "count"),
    [
        ("type", "actuator", 1), ("datatype", "boolean", 1), ("unit", "km/h", 2), ("category", "error", 1),
        ("asil", "B", 2), ("overlay", "overlay", 5), ("deprecated", "yes", 1),
    ],
)  # fmt: skip
def test_every_filter_has_counts_and_narrows(site: Ask, facet: str, value: str, count: int) -> None:
    page = site("/search/small").text
    (link, shown) = re.search(
        rf'<a href="(/search/small\?{facet}={quote(value, safe="")})" data-filter>.*?<span class="number">(\d+)<', page
    ).groups()  # type: ignore[union-attr]
    assert int(shown) == count
    assert re.search(rf">{count}\u00a0results?<", site(link).text)


def test_a_filter_that_every_result_meets_is_not_offered(site: Ask) -> None:
    assert "datatype=" not in site("/search/small?type=branch").text


def test_a_filter_that_nothing_can_have_is_refused_as_in_the_api(site: Ask) -> None:
    page = site("/search/small?type=sensr")
    assert page.status_code == 422
    assert "There is no type &#39;sensr&#39; in this catalogue" in page.text
    assert "Did you mean &#39;sensor&#39;?" in page.text
    assert site("/search/small?type=struct").status_code == 200


def test_a_near_miss_proposes_names(site: Ask) -> None:
    assert re.search(r'Did you mean <a href="/search/small\?q=speed"', site("/search/small?q=sped").text)
    assert re.search(
        r'Did you mean <a href="/search/small\?q=vehicle\+speed"', site("/search/small?q=vehicle+sped").text
    )


def test_a_range_is_drawn_and_allowed_values_are_listed(site: Ask) -> None:
    assert 'aria-label="Range from 0 to 300 kilometer per hour"' in site("/tree/small/Vehicle.Speed").text
    assert re.search(r'<ul class="chips"><li>.*<li>plain</li></ul>', site("/tree/small/Vehicle.Label").text)


def test_an_address_of_a_page_that_is_data_is_offered(site: Ask) -> None:
    for address in ("/tree/small/Vehicle.Speed", "/search/small?q=speed", "/history/small/Vehicle.Speed", "/units/small", "/rules", "/rules/I201",
                    "/catalogues/small", "/changes?old=bare&new=small", "/functions"):  # fmt: skip
        (link,) = re.findall(r'href="([^"]+)">JSON</a>', site(address).text)
        assert site(link.replace("&amp;", "&")).headers["content-type"].startswith("application/json")


def test_a_function_that_cannot_be_built_is_no_json(site: Ask) -> None:
    answer = site("/functions/core_acc.json")
    assert (answer.status_code, answer.headers["content-type"]) == (422, "application/problem+json")


def test_errors_of_the_api_stay_problem_documents(site: Ask) -> None:
    assert site("/api/v1/catalogues/nope").headers["content-type"] == "application/problem+json"
    assert site("/tree/small/Vehicle.Sped.json").headers["content-type"] == "application/problem+json"


def test_a_catalogue_with_errors_says_so_and_still_shows_its_tree(site: Ask) -> None:
    assert "Did you mean" in site("/catalogues/broken").text


def test_every_page_of_a_catalogue_with_errors_leads_to_them(site: Ask) -> None:
    for address in ("/tree/broken", "/tree/broken/Vehicle.Speed", "/search/broken?q=speed", "/units/broken"):
        page = site(address).text
        assert "This catalogue has errors and may be incomplete." in page
        assert 'href="/catalogues/broken#findings">Show errors</a>' in page
    assert '<h2 id="findings">' in site("/catalogues/broken").text


def test_a_catalogue_without_errors_says_nothing_of_them(tmp_path: Path) -> None:
    (tmp_path / "whole.vspec").write_text("Vehicle: {type: branch, description: A vehicle.}")
    whole = asker(create_site(Library([Source("whole", "Whole", tmp_path / "whole.vspec")])))
    assert "have errors" not in whole("/tree/whole").text


def test_a_catalogue_tells_what_it_holds_however_little(site: Ask, tmp_path: Path) -> None:
    assert ">signal</text>" in site("/catalogues/broken").text
    empty = asker(create_site(Library([Source("lost", "Lost", tmp_path / "lost.vspec")])))
    assert re.search(r"0\u00a0nodes</a>\.", empty("/catalogues/lost").text)


def test_every_page_has_a_title_of_its_own(site: Ask) -> None:
    addresses = (
        "/", "/tree/small/Vehicle.Speed", "/tree/bare/Vehicle.Speed", "/search/small?q=speed", "/search/bare?q=speed",
        "/search/small?q=speed&type=sensor", "/units/small", "/units/bare", "/rules?catalogue=bare", "/rules/I201",
        "/rules/V101", "/catalogues/small", "/catalogues/bare", "/changes?old=bare&new=small",
        "/changes?old=small&new=bare", "/try", "/try?kind=tree", "/functions", "/functions/core_acc", "/wiring",
        "/functions/eco_control_mpc", "/wiring?f=core_acc", "/docs", "/problems/busy", "/tree/nope", "/tree/small/Nope",
    )  # fmt: skip
    titles = [title_of(site(address).text) for address in addresses]
    assert len(set(titles)) == len(titles)
    assert all(title.endswith(" · sigcat") for title in titles)
    assert title_of(site("/search/small?q=speed").text) == "speed · A small tree · sigcat"


def test_catalogues_of_one_title_are_told_apart_by_their_ids() -> None:
    twins = [Source(each, "The tree", TREE / "tree.vspec") for each in ("left", "right")]
    site = asker(create_site(Library([*twins, Source("other", "Another", TREE / "tree.vspec")]), SETTINGS))
    assert title_of(site("/units/left").text) == "Units · The tree (left) · sigcat"
    assert "<h1>The tree (left) → The tree (right)</h1>" in site("/changes?old=left&new=right").text
    assert re.findall(r"<option[^>]*>([^<]+)<", site("/changes").text)[:3] == [
        "The tree (left)", "The tree (right)", "Another",
    ]  # fmt: skip
    assert title_of(site("/tree/left~folded").text) == "Tree · The tree, folded (left~folded) · sigcat"


def test_a_catalogue_and_the_rules_tell_the_same_number_of_findings(site: Ask) -> None:
    for name in ("small", "bare", "broken"):
        (own,) = re.findall(r'id="findings">Findings <span class="number">(\d+)', site(f"/catalogues/{name}").text)
        rules = site(f"/rules?catalogue={name}").text
        assert f"{own}\u00a0finding" in rules
        of_each = re.search(r"With findings(.*?)</section>", rules, re.DOTALL)
        assert of_each
        assert sum(int(number) for number in re.findall(r"(\d+)\u00a0finding", of_each.group(1))) == int(own) > 0


def test_changes_begin_with_the_breaking_ones(site: Ask) -> None:
    page = site("/changes?old=bare&new=small").text
    assert ": 1 breaking, 1 compatible." in page
    headings = re.findall(r'<h2>(\w+) <span class="number">', page)
    assert headings == ["breaking", "compatible"]
    assert page.index(">Speed</a>") < page.index(">Function</a>")


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


@pytest.mark.parametrize("address", ["/health/live?on=1", "/health/ready?on=1", "/api/v1/catalogues?on=1"])
def test_programs_get_a_problem_document(site, address):
    answer = site(address)
    assert (answer.status_code, answer.headers["content-type"]) == (422, "application/problem+json")


@pytest.mark.parametrize("address", ["/", "/docs", "/functions", "/rules", "/search/small", "/tree/small/Vehicle"])
def test_a_page_refuses_a_parameter_that_it_does_not_have(site, address):
    answer = site(f"{address}?prat=1")
    assert (answer.status_code, answer.headers["content-type"]) == (422, "text/html; charset=utf-8")
    assert "Did you mean" in answer.text
    assert "part" in answer.text


def test_the_metrics_refuse_it_too(site):
    assert site("/metrics?name=x").headers["content-type"] == "application/problem+json"
