"""Every link of a page leads somewhere, and every page is found from the index."""

import re
from collections.abc import Iterator

from tests.documentation.pages import PAGES, ROOT, text_of

_LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")


def links(page: str) -> Iterator[tuple[str, str]]:
    """File and anchor of each link into the repository."""
    prose = re.sub(r"^ *```.*?^ *```$|`[^`\n]+`", "", text_of(page), flags=re.MULTILINE | re.DOTALL)
    for target in _LINK.findall(prose):
        if not re.match(r"https?://|mailto:", target):
            file, _, anchor = target.partition("#")
            yield ((ROOT / page).parent / file).resolve().relative_to(ROOT).as_posix() if file else page, anchor


def anchors(page: str) -> set[str]:
    """The anchors of headings, as GitHub makes them."""
    headings = re.findall(
        r"^#+ (.*)$", re.sub(r"^```.*?^```$", "", text_of(page), flags=re.MULTILINE | re.DOTALL), re.MULTILINE
    )
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def test_links_lead_somewhere():
    found = {(page, file, anchor) for page in PAGES for file, anchor in links(page)}
    there = {file for file in {file for _, file, _ in found} if (ROOT / file).exists()}
    assert sorted(f"{page}: {file}" for page, file, _ in found if file not in there) == []
    headings = {file: anchors(file) for file in {file for _, file, anchor in found if anchor}}
    assert (
        sorted(f"{page}: {file}#{anchor}" for page, file, anchor in found if anchor and anchor not in headings[file])
        == []
    )


def test_every_page_is_found_from_the_index():
    found, ahead = {"docs/README.md"}, ["docs/README.md"]
    while ahead:
        pages = {file for file, _ in links(ahead.pop()) if file in PAGES} - found
        found |= pages
        ahead.extend(pages)
    assert {page for page in PAGES if page.startswith("docs/")} <= found


def test_the_readme_leads_to_the_index_and_to_those_who_contribute():
    assert {"docs/README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md"} <= {
        file for file, _ in links("README.md")
    }
