"""The documentation, served from its Markdown files."""

import html
import re
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library
from sigcat.data import DOCUMENTATION
from sigcat.web import documentation
from sigcat.web.rendering import CHAPTER_OF
from sigcat.web.site import create_site
from tests.api.conftest import SETTINGS, SOURCES, Ask, asker

CHAPTERS = sorted(
    path.relative_to(DOCUMENTATION).as_posix() for path in DOCUMENTATION.rglob("*.md") if path.parent.name != "rules"
)


@pytest.fixture(scope="module")
def site() -> Ask:
    return asker(create_site(Library(SOURCES), SETTINGS))


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_links_of_a_chapter_lead_to_pages_and_their_headings(site: Ask, chapter: str) -> None:
    page = site(f"/docs/{chapter}")
    assert page.status_code == 200
    assert len(page.content) < 500_000
    content = page.text.partition('id="content"')[2]
    assert "&lt;!--" not in re.sub("<pre.*?</pre>", "", content, flags=re.DOTALL)
    for address, anchor in set(re.findall(r'href="(/docs/[^"#]*)#?([^"]*)"', content)):
        assert address.removeprefix("/docs/") in documentation.files()
        if anchor:
            sections = documentation.chapter_at(address.removeprefix("/docs/"), "").sections
            assert html.unescape(anchor) in {section.anchor for section in sections}, address


def test_the_index_has_two_addresses_and_the_reference_of_the_api_stays(site: Ask) -> None:
    assert '<h1 id="documentation">Documentation</h1>' in site("/docs/").text
    assert '<h1 id="documentation">Documentation</h1>' in site("/docs/README.md").text
    assert "<h1>API</h1>" in site("/docs").text
    assert site("/docs/reference/python-api.pyi").status_code == 200


def test_every_operation_of_the_api_is_in_one_chapter(site: Ask) -> None:
    document = site("/openapi.json").json()
    ids = {entry["operationId"] for methods in document["paths"].values() for entry in methods.values()}
    chapters = re.findall(r'href="(/docs/api/[a-z]+)"', site("/docs").text)
    pages = [site(chapter).text for chapter in dict.fromkeys(chapters)]
    shown = [each for page in pages for each in re.findall(r'class="operation" id="([^"]+)"', page)]
    assert sorted(shown) == sorted(ids)
    assert {f"schema-{name}" for name in document["components"]["schemas"]} == set(
        re.findall(r'id="(schema-[^"]+)"', "".join(pages))
    )
    overview = site("/docs").text
    assert overview.count("Too many requests of one client") == 1
    assert set(re.findall(r'href="/docs/api/[a-z]+#([^"]+)"', overview)) == ids


def test_an_unknown_chapter_of_the_api_names_near_ones(site: Ask) -> None:
    page = site("/docs/api/catalogs")
    assert (page.status_code, "catalogues" in page.text) == (404, True)


@pytest.mark.parametrize(
    "chapter", ["how-to/comparee.md", "../pyproject.toml", "%2e%2e/pyproject.toml", "how-to", "<b>"]
)
def test_an_unknown_chapter_is_a_page_that_is_not_there(site: Ask, chapter: str) -> None:
    page = site(f"/docs/{chapter}")
    assert page.status_code == 404
    assert "text/html" in page.headers["content-type"]
    assert "<b>'" not in page.text


def test_every_page_links_to_its_chapter(site: Ask) -> None:
    assert set(CHAPTER_OF.values()) <= documentation.files()
    for address, chapter in (
        ("/", "README.md"), ("/tree/small/Vehicle.Speed", "reference/interfaces.md"), ("/docs", "reference/api.md"),
        ("/functions", "reference/functions.md"), ("/functions/sets/ecocontrol/compare", "how-to/compare.md"),
    ):  # fmt: skip
        assert f'<a href="/docs/{chapter}" title="The chapter about this page"' in site(address).text


def test_sections_of_a_long_chapter_are_folded_and_a_link_opens_them(site: Ask) -> None:
    text = site("/docs/reference/functions.md").text
    assert '<summary><h2>The code</h2>\n</summary><div id="the-code">' in text
    assert text.count('<details class="section">') == text.count("</div></details>") == text.count("<summary><h2>") == 7
    assert '<details class="section">' not in site("/docs/how-to/simulate.md").text


def test_the_search_finds_chapters(site: Ask) -> None:
    assert re.search(r'<a href="/docs/how-to/gateway\.md#[^"]*">', site("/search/small?q=carry+can+to+functions").text)
    assert "In the documentation" not in site("/search/small?q=zzzzzz").text


def test_markup_in_a_chapter_shows_as_text_and_links_out_of_the_folder_are_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = '# Bad\n\n<script>alert(1)</script> <b onclick="x">b</b> [js](javascript:alert) [up](../secret.md)\n\n```sh title="<i>"\n<u>\n```\n'
    (tmp_path / "bad.md").write_text(text)
    monkeypatch.setattr(documentation, "DOCUMENTATION", tmp_path)
    documentation.files.cache_clear()
    try:
        body = documentation.chapter_at("bad.md", "")
    finally:
        documentation.files.cache_clear()
        documentation.chapter_at.cache_clear()
    assert not re.search(r"<(script|b|i|u)\b|href", body.body)
    assert "&lt;script&gt;" in body.body
