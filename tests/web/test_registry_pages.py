"""The registry in the browser: names, versions, users of a signal, and what may be deployed."""

import html
import re

import pytest

from sigcat.catalogue.hosting.library import Library
from sigcat.project.project import RegistrySettings
from sigcat.registry.lines import record, set_state
from sigcat.registry.publish import publish
from sigcat.registry.reference import Reference
from sigcat.registry.storing.database import writing
from sigcat.registry.storing.ledger import Registry
from sigcat.web.site import create_site
from tests.api.conftest import SOURCES, Ask, asker
from tests.registry.parts import candidate, catalogue, declaration
from tests.web.published import published

PAGES = (
    "/registry", "/registry/deliveries", "/registry/lines", "/registry/users", "/registry/users?path=Vehicle.S0", "/registry/users?path=Vehicle.Nothing",
    "/registry/functions/Alpha", "/registry/functions/Gamma",
)  # fmt: skip


def site_over(database) -> Ask:
    return asker(create_site(Library(SOURCES), registry=RegistrySettings(database)))


@pytest.fixture(scope="module")
def site(tmp_path_factory) -> Ask:
    return site_over(published(tmp_path_factory.mktemp("registry")).database)


def text_of(page: str) -> str:
    """The text of a page, with one space between words."""
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", page.replace("<wbr>", ""))).split())


def test_names_have_their_newest_version_owner_and_lines(site):
    page = text_of(site("/registry").text)
    assert "4 published names, 2 vehicle lines." in page
    assert "Alpha function 2.0.0 published Team Alpha 2 SUV-2025, VAN-2026" in page
    assert "Gamma function 1.0.0 deprecated Team Gamma 1" in page
    assert "published function Alpha 2.0.0" in page


def test_a_pending_version_has_the_owners_that_must_approve_it(site):
    page = text_of(site("/registry").text)
    assert "Beta 1.1.0 Team Beta" in page
    assert "Team Gamma must approve it: it breaks Gamma 1.0.0" in page


def test_deliveries_of_webhooks_have_their_answer_and_no_secret(site):
    page = site("/registry/deliveries?state=failed").text
    assert "published Delta@1.0.0 hooks.example.org failed 12 answered 503" in text_of(page)
    assert "secret-path" not in page
    assert "token=1" not in page


def test_a_cell_says_what_runs_and_why_the_newest_version_may_not_be_deployed(site):
    page = text_of(site("/registry/lines").text)
    assert "Alpha 2.0.0 1.0.0 ✕ 2.0.0 may not be deployed Removing Vehicle.S0 breaks Beta 1.0.0" in page
    assert "call Beta_Step, owner Team Beta" in page
    assert "1.0.0 ✓ 2.0.0 may be deployed" in page


def test_a_cell_says_that_support_has_ended_of_what_runs_and_of_what_may_be_deployed(tmp_path):
    settings = published(tmp_path)
    registry = Registry(settings.database)
    set_state(registry, "function", Reference("Alpha", "1.0.0"), "deprecated", "2040-01-31", "2.0.0")
    set_state(registry, "function", Reference("Alpha", "2.0.0"), "deprecated", "2040-02-28")
    page = text_of(site_over(settings.database)("/registry/lines").text)
    assert "1.0.0 deprecated until 2040-01-31, successor 2.0.0 ✓ 2.0.0 may be deployed Beta" in page
    with writing(settings.database) as connection:  # the days have passed
        connection.exec_driver_sql(
            "UPDATE versions SET until = replace(until, '2040', '2020') WHERE until LIKE '2040%'"
        )
    page = text_of(site_over(settings.database)("/registry/lines").text)
    assert "1.0.0 deprecated , support ended on 2020-01-31, successor 2.0.0" in page
    assert "2.0.0 may be deployed 1 warning The support of Alpha 2.0.0 ended on 2020-02-28." in page


def test_users_are_a_picture_and_a_table(site):
    found = site("/registry/users?path=Vehicle.S0").text
    assert "Vehicle.S0: provided by Alpha 1.0.0; used by Beta 1.0.0, Gamma 1.0.0" in found
    assert "Beta 1.0.0 consumes Vehicle.S0 Beta_Step Team Beta SUV-2025" in text_of(found)


def test_users_of_nothing_are_none(site):
    page = text_of(site("/registry/users?path=Vehicle.Speed").text)
    assert "No published function uses it." in page


def test_an_unknown_path_is_told_with_a_near_one(site):
    page = text_of(site("/registry/users?path=Vehicle.Sped").text)
    assert "No published catalogue or function has 'Vehicle.Sped'" in page
    assert "Vehicle.Speed" in page


def test_a_name_has_its_versions_and_the_changes_between_two(site):
    page = text_of(site("/registry/functions/Alpha").text)
    assert "Changes from 1.0.0 to 2.0.0" in page
    assert "breaking Vehicle.S0 Removing Vehicle.S0" in page
    assert "Changes from" not in text_of(site("/registry/functions/Gamma").text)
    backwards = text_of(site("/registry/functions/Alpha?old=2.0.0&new=1.0.0").text)
    assert "breaking Vehicle.S2 Removing Vehicle.S2" in backwards


@pytest.mark.parametrize(
    ("address", "near"),
    [
        ("/registry/functions/Alpa", "Alpha"), ("/registry/function/Alpha", "functions"), ("/registry/overlays/Alpha", ""),
        ("/registry/functions/Alpha?old=1.0.1", "1.0.0"), ("/registry/functions/%3Cscript%3E", ""),
    ],
)  # fmt: skip
def test_what_is_not_there_is_not_found_with_near_names(site, address, near):
    answer = site(address)
    assert answer.status_code == 404
    assert near in answer.text
    assert "<script>" not in answer.text.partition("</head>")[2]


@pytest.mark.parametrize("address", PAGES)
def test_pages_run_nothing_inline(site, address):
    answer = site(address)
    assert answer.status_code == 200
    assert " onclick" not in answer.text
    assert "style=" not in answer.text


@pytest.mark.parametrize("text", ["<script>alert(1)</script>", "\x00", "'\"><img src=x>", "%", "a" * 2000])
def test_a_sought_path_is_text(site, text):
    answer = site("/registry/users", params={"path": text})
    assert answer.status_code == 200
    assert "<script>alert" not in answer.text
    assert "<img" not in answer.text


def test_a_node_leads_to_its_published_users_where_there_is_a_registry(site):
    node = "/tree/small/Vehicle.Speed"
    assert "/registry/users?path=Vehicle.Speed" in site(node).text
    assert "/registry" not in asker(create_site(Library(SOURCES)))(node).text


def test_without_a_registry_its_pages_say_how_to_have_one():
    answer = asker(create_site(Library(SOURCES)))("/registry")
    assert answer.status_code == 404
    assert "[registry]" in answer.text


def test_an_empty_registry_has_empty_pages(tmp_path):
    empty = site_over(tmp_path / "registry.db")
    assert "Nothing is published." in empty("/registry").text
    assert "No vehicle line is recorded." in empty("/registry/lines").text
    assert empty("/registry/users?path=Vehicle.Speed").status_code == 200
    assert "No deliveries." in empty("/registry/deliveries").text
    assert not (tmp_path / "registry.db").exists()


def test_many_users_of_a_signal_are_cut_in_the_picture_and_not_in_the_table(tmp_path):
    registry, over = Registry(tmp_path / "registry.db"), catalogue()
    for version in (f"{major}.0.0" for major in range(1, 16)):
        publish(registry, [candidate(declaration("Alpha", ("S0",), version=version), over)])
        record(registry, "release", "SUV-2025", Reference("Alpha", version))
    page = site_over(registry.database)("/registry/users?path=Vehicle.S0").text
    assert "Alpha 12.0.0, 3 more; used by no published function" in page
    assert "Alpha 15.0.0 provides Vehicle.S0" in text_of(page)
