"""The registry as the service answers about it."""

import hashlib
import json
import sqlite3
from pathlib import Path

import pytest

from sigcat.api.application import create_app
from sigcat.catalogue.hosting.library import Library
from sigcat.registry.storing.signing import is_signed, public_key
from tests.api.conftest import Ask, asker
from tests.registry.served import CONTENT, LINE, asking, signed_registry

API = "/api/v1/registry"
CORE = f"{API}/functions/CoreAcc"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("registry")


@pytest.fixture(scope="module")
def ask(folder: Path) -> Ask:
    return asking(signed_registry(folder))


def test_the_registry_has_its_counts_and_the_head_of_its_log(ask: Ask) -> None:
    found = ask(API).json()
    assert (found["functionscount"], found["overlayscount"], found["linescount"], found["epoch"]) == (2, 0, 1, 4)
    assert (found["head"]["epoch"], len(found["head"]["signature"])) == (4, 128)


def test_a_version_has_its_content_byte_for_byte_and_its_details_apart_from_it(ask: Ask) -> None:
    content = ask(f"{CORE}/versions/1.0.0")
    assert (content.content, content.headers["content-type"]) == (CONTENT, "application/octet-stream")
    assert ask(CORE).content == CONTENT
    details = ask(f"{CORE}/versions/1.0.0$details").json()
    assert details["content_digest"] == hashlib.sha256(CONTENT).hexdigest()
    assert (details["xid"], details["vehicle_lines"], details["uses"]) == (
        "/functions/CoreAcc/versions/1.0.0",
        [LINE],
        None,
    )
    assert ask(f"{API}/contents?digest={details['content_digest']}").content == CONTENT
    assert (
        json.loads(ask(f"{API}/contents?digest={details['resolved_digest']}").content)["FunctionInfo"]["FunctionName"]
        == "CoreAcc"
    )


def test_versions_have_their_ancestors_and_one_is_the_default(ask: Ask) -> None:
    found = ask(f"{API}/functions/Alpha/versions").json()["versions"]
    assert [(each["versionid"], each["ancestorid"], each["isdefault"]) for each in found] == [
        ("1.0.0", "1.0.0", False), ("1.1.0", "1.0.0", True),
    ]  # fmt: skip
    name = ask(f"{API}/functions/Alpha$details").json()
    assert (name["defaultversionid"], name["versionscount"], name["compatibility_rule"]) == ("1.1.0", 2, "backward")


def test_uses_are_given_on_demand(ask: Ask) -> None:
    uses = ask(f"{CORE}/versions/1.0.0$details?inline=uses").json()["uses"]
    assert ("provides", "Vehicle.S0") in [(each["verb"], each["element"]) for each in uses]


def test_users_of_a_path_are_named_with_their_lines(ask: Ask) -> None:
    found = ask(f"{API}/users?path=Vehicle.S1").json()
    assert [(each["name"], each["versionid"], each["vehicle_lines"]) for each in found["users"]] == [
        ("Alpha", "1.1.0", []), ("CoreAcc", "1.0.0", [LINE]),
    ]  # fmt: skip
    older = ask(f"{API}/users?path=Vehicle.S1&all_versions=true").json()["users"]
    assert [each["versionid"] for each in older if each["name"] == "Alpha"] == ["1.0.0", "1.1.0"]


def test_lines_have_what_their_vehicles_run(ask: Ask) -> None:
    (line,) = ask(f"{API}/lines").json()["lines"]
    assert ask(f"{API}/lines?line={LINE}").json() == {"lines": [line]}
    assert [(each["name"], each["versionid"]) for each in line["deployments"]] == [("CoreAcc", "1.0.0")]


def test_names_and_the_log_have_pages(ask: Ask) -> None:
    for address, key in ((f"{API}/functions", "names"), (f"{API}/log", "entries")):
        whole = ask(address).json()[key]
        page = ask(f"{address}?limit=1").json()
        pages = page[key]
        while page["next_cursor"]:
            page = ask(f"{address}?limit=1&cursor={page['next_cursor']}").json()
            pages += page[key]
        assert (pages, len(pages) > 1) == (whole, True)


def test_the_log_and_the_key_are_what_a_client_needs_to_verify_them(ask: Ask, folder: Path) -> None:
    key = folder / "served.pub"
    key.write_bytes(ask(f"{API}/key").content)
    previous = "0" * 64
    for each in ask(f"{API}/log").json()["entries"]:
        assert hashlib.sha256(f"{previous}\n{each['entry']}".encode()).hexdigest() == each["hash"]
        assert is_signed(each["hash"], each["signature"], public_key(key))
        previous = each["hash"]
    assert ask(API).json()["head"]["hash"] == previous


@pytest.mark.parametrize(
    ("address", "nearest"),
    [
        (f"{API}/functions/CoreAc", ["CoreAcc"]),
        (f"{API}/functions/CoreAcc/versions/1.0.1", ["1.0.0"]),
        (f"{API}/functions/CoreAcc/versions/1.0.1$details", ["1.0.0"]),
        (f"{API}/lines?line=SUV-2026", [LINE]),
        (f"{API}/contents?digest={'0' * 64}", []),
    ],
)
def test_an_unknown_name_is_not_found_and_near_ones_are_named(ask: Ask, address: str, nearest: list[str]) -> None:
    answer = ask(address, headers={"If-None-Match": "*"})
    assert (answer.status_code, answer.json()["nearest"]) == (404, nearest)


@pytest.mark.parametrize(
    "address", [f"{API}/things", f"{API}/functions/{'x' * 301}", f"{API}/users", f"{API}/log?limit=0"]
)
def test_a_request_that_does_not_fit_is_refused(ask: Ask, address: str) -> None:
    assert ask(address).status_code == 422


@pytest.mark.parametrize("address", [API, f"{API}/functions", CORE, f"{CORE}/versions/1.0.0$details", f"{API}/lines"])
def test_a_client_that_has_the_state_gets_no_body(ask: Ask, address: str) -> None:
    tag = ask(address).headers["etag"]
    assert ask(address, headers={"If-None-Match": tag}).status_code == 304
    assert ask(address, headers={"If-Match": '"other"'}).status_code == 412


def test_without_a_registry_nothing_is_created_and_the_problem_says_how_to_have_one() -> None:
    answer = asker(create_app(Library(())))(API)
    assert (answer.status_code, answer.headers["content-type"]) == (404, "application/problem+json")
    assert "[registry]" in answer.json()["detail"]


def test_a_registry_that_nothing_was_published_in_is_empty_and_has_no_file(tmp_path: Path) -> None:
    ask = asking(signed_registry(tmp_path)._replace(database=tmp_path / "other.db", key=None))
    assert (ask(API).json()["head"], ask(f"{API}/functions").json()["names"]) == (None, [])
    assert ask(f"{API}/key").status_code == 404
    assert not (tmp_path / "other.db").exists()


# -- databases that cannot be used --------------------------------------------------------------------------------


def test_a_database_that_disappears_is_not_answered_with_an_empty_registry(tmp_path: Path) -> None:
    registry = signed_registry(tmp_path)
    ask = asking(registry)
    assert ask(API).status_code == 200
    (tmp_path / "registry.db").rename(tmp_path / "moved.db")
    answer = ask(API)
    assert (answer.status_code, answer.headers["retry-after"]) == (503, "2")
    assert [each["message"] for each in answer.json()["findings"]] == ["The database is gone."]


def test_a_database_of_a_newer_program_or_another_one_is_reported_without_its_place(tmp_path: Path) -> None:
    registry = signed_registry(tmp_path)
    with sqlite3.connect(tmp_path / "registry.db") as connection:
        connection.execute("PRAGMA user_version = 99")
    (finding,) = asking(registry)(API).json()["findings"]
    assert finding["fix"] == "Use a newer sigcat."
    (tmp_path / "registry.db").write_bytes(b"no database" * 1000)
    answer = asking(registry)(f"{API}/functions")
    assert (answer.status_code, str(tmp_path) in answer.text) == (503, False)


def test_damaged_content_is_a_finding(tmp_path: Path) -> None:
    registry = signed_registry(tmp_path)
    with sqlite3.connect(tmp_path / "registry.db") as connection:
        connection.execute("UPDATE contents SET data = 'other'")
    assert asking(registry)(CORE).json()["findings"][0]["rule"] == "E010"
