"""The page of a comparison shows what `sigcat compare` has stored, and no file of its folder breaks it."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.comparison.report.model import to_json
from sigcat.function.hosting import FunctionLibrary
from sigcat.limits import COMPARISON_BYTES
from sigcat.web.security_headers import POLICY
from sigcat.web.site import create_site
from tests.api.conftest import Ask, asker
from tests.comparison.test_report import whole

PAGE = "/functions/sets/acc/compare"


@pytest.fixture(scope="module")
def library() -> Library:
    return Library([source for source in shipped_sources() if source.id == "interfaces"])


@pytest.fixture
def ask(tmp_path: Path, library: Library) -> Callable[..., Ask]:
    """A service over a folder with a file as the comparison of `acc`."""

    def service(data: bytes = to_json(whole())) -> Ask:
        (tmp_path / "acc").mkdir(exist_ok=True)
        (tmp_path / "acc/comparison.json").write_bytes(data)
        return asker(create_site(library, functions=FunctionLibrary([tmp_path], has_shipped=False)))

    return service


def test_it_shows_what_must_hold_and_runs_nothing_inline(ask: Callable[..., Ask]) -> None:
    page = ask()(PAGE)
    assert page.status_code == 200
    assert "<h1>Set on every platform</h1>" in page.text
    assert "fail" in page.text
    assert page.headers["content-security-policy"] == POLICY
    assert not re.search(r"<style|\sstyle=|\son\w+=|<script(?! type=\"module\" src=)|https?://", page.text)


def test_markup_of_a_comparison_shows_as_text(ask: Callable[..., Ask]) -> None:
    page = ask()(PAGE).text
    assert "late &lt;b&gt;" in page
    assert "late <b>" not in page


def test_pages_of_functions_and_of_sets_lead_to_it(ask: Callable[..., Ask]) -> None:
    service = ask()
    for address in ("/functions", PAGE):
        assert f'href="{PAGE}"' in service(address).text


def test_it_is_data_too(ask: Callable[..., Ask]) -> None:
    answer = ask()(f"{PAGE}.json")
    assert answer.headers["content-type"] == "application/json"
    assert answer.json()["name"] == "Set"


@pytest.mark.parametrize("data", [b"", b"{}", b"[" * 100_000, b"\xff\xfe", b" " * (COMPARISON_BYTES + 1)])
def test_a_file_that_is_none_is_told_and_breaks_nothing(ask: Callable[..., Ask], data: bytes) -> None:
    page = ask(data)(PAGE)
    assert page.status_code == 200
    assert "acc/comparison.json" in page.text


def test_one_that_is_not_there_is_not_found_and_near_ones_are_named(ask: Callable[..., Ask]) -> None:
    service = ask()
    for name in ("ac", "%3Cscript%3E"):
        page = service(f"/functions/sets/{name}/compare")
        assert page.status_code == 404
        assert "<script>" not in page.text


def test_one_that_is_gone_meanwhile_is_not_found(ask: Callable[..., Ask], tmp_path: Path) -> None:
    service = ask()
    (tmp_path / "acc/comparison.json").unlink()
    assert service(PAGE).status_code == 404


def test_folders_of_one_name_are_told_apart(ask: Callable[..., Ask], tmp_path: Path) -> None:
    (tmp_path / "other/acc").mkdir(parents=True)
    (tmp_path / "other/acc/comparison.json").write_bytes(to_json(whole()))
    assert ask()("/functions/sets/acc-2/compare").status_code == 200
