"""The registry as requests change it."""

import hashlib
import json
import re
import sqlite3
import threading
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import httpx
import jsonschema_rs
import pytest

from sigcat.api.application import create_app
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library
from sigcat.project.project import RegistrySettings
from sigcat.registry.storing.database import reading, writing
from sigcat.registry.storing.signing import is_signed, new_key, public_key
from sigcat.registry.storing.sqlite import close_all
from sigcat.registry.storing.tokens import all_tokens, create_token, revoke_token
from sigcat.registry.storing.verify import verify
from tests.api.conftest import Ask, asker
from tests.clients.generating import ROOT
from tests.registry.served import CONTENT, LINE, OVERLAY, fleet, function_file

API = "/api/v1/registry"
DOCUMENT = json.loads((ROOT / "docs/reference/openapi.json").read_bytes())
LOCAL = {"Host": "localhost:8000"}
"""Requests of this machine, which need no token while there is none."""
LOST = function_file("CoreAcc", "{path: Vehicle.S1, role: consumed}", "2.0.0")
USER = function_file("User", "{path: Vehicle.S0, role: consumed}")
PROVIDER = function_file("Provider", "{path: Vehicle.S1, role: provided}")


class Service:
    """A service over a small catalogue, with a signed registry that is empty."""

    def __init__(self, folder: Path, settings: Settings = Settings()) -> None:  # noqa: B008 — it is frozen
        private, _ = new_key()
        self.database, key = folder / "registry.db", folder / "registry.key"
        key.write_bytes(private)
        self.key = public_key(key)
        library = Library([fleet(folder)])
        self.ask: Ask = asker(create_app(library, settings, registry=RegistrySettings(self.database, key)))

    def post(self, address: str, body: bytes | str = b"", headers: Mapping[str, str] = LOCAL) -> httpx.Response:
        answer = self.ask(f"{API}/{address}", "POST", content=body, headers=dict(headers))
        if answer.is_success:
            responses = DOCUMENT["paths"][f"{API}/{address.partition('?')[0]}"]["post"]["responses"]
            schema = responses[str(answer.status_code)]["content"]["application/json"]["schema"]
            jsonschema_rs.validate({**schema, "components": DOCUMENT["components"]}, answer.json())
        return answer

    def publish(self, *files: bytes, headers: Mapping[str, str] = LOCAL, query: str = "") -> httpx.Response:
        named = [{"name": f"f{number}.function.yaml", "text": each.decode()} for number, each in enumerate(files)]
        return self.post(f"publish{query}", json.dumps({"files": named}), headers)

    def token(self, name: str, *scopes: str, owner: str = "", expires: str = "") -> dict[str, str]:
        with writing(self.database) as connection:
            secret = create_token(connection, name, scopes, owner, expires)
        return {**LOCAL, "Authorization": f"Bearer {secret}"}


@pytest.fixture
def service(tmp_path: Path) -> Service:
    return Service(tmp_path)


def problem(answer: httpx.Response, status: int) -> dict[str, Any]:
    assert (answer.status_code, answer.headers["content-type"]) == (status, "application/problem+json"), answer.text
    found: dict[str, Any] = answer.json()
    return found


def rules(answer: httpx.Response, status: int) -> list[str]:
    return [each["rule"] for each in problem(answer, status)["findings"]]


# -- publishing ---------------------------------------------------------------------------------------------------


def test_a_posted_file_is_published_byte_for_byte_with_the_signed_head_of_the_log(service: Service) -> None:
    answer = service.post("publish", CONTENT)
    (outcome,) = answer.json()["versions_posted"]
    assert (answer.status_code, outcome["xid"], outcome["is_new"]) == (201, "/functions/CoreAcc/versions/1.0.0", True)
    head = answer.json()["head"]
    assert (head["epoch"], is_signed(head["hash"], head["signature"], service.key)) == (1, True)
    assert service.ask(f"{API}{outcome['xid']}").content == CONTENT
    again = service.post("publish", CONTENT)
    assert (again.status_code, again.json()["versions_posted"][0]["is_new"], again.json()["head"]) == (200, False, head)


def test_a_version_of_another_owner_names_the_owner_before(service: Service) -> None:
    found = []
    for version, owner in (("1.0.0", "Team CoreAcc"), ("1.1.0", "Another team")):
        text = CONTENT.replace(b"1.0.0", version.encode()).replace(b"Team CoreAcc", owner.encode())
        (outcome,) = service.post("publish", text).json()["versions_posted"]
        found.append((outcome["owner"], outcome["previous_owner"]))
    assert found == [("Team CoreAcc", None), ("Another team", "Team CoreAcc")]


def test_other_bytes_under_a_version_are_a_conflict(service: Service) -> None:
    service.post("publish", CONTENT)
    assert rules(service.post("publish", CONTENT.replace(b"An example", b"Another one")), 409) == ["E003"]


def test_several_files_are_published_or_none(service: Service) -> None:
    assert rules(service.publish(CONTENT, USER.replace(b"Vehicle.S0", b"Vehicle.S9")), 422)
    assert service.ask(API).json()["head"] is None
    assert [each["name"] for each in service.publish(CONTENT, USER).json()["versions_posted"]] == ["CoreAcc", "User"]
    assert service.ask(API).json()["epoch"] == 2


def test_an_overlay_is_published_over_the_catalogue_without_it(service: Service) -> None:
    assert "version" in problem(service.post("publish?name=signals.vspec", OVERLAY), 422)["detail"]
    answer = service.post("publish?name=signals.vspec&version=1.0.0&owner=Platform", OVERLAY)
    assert (answer.status_code, answer.json()["versions_posted"][0]["group"]) == (201, "overlays")
    details = service.ask(f"{API}/overlays/signals/versions/1.0.0$details").json()
    assert (details["owner"], details["content_digest"]) == ("Platform", hashlib.sha256(OVERLAY.encode()).hexdigest())
    narrower = OVERLAY.replace(
        "Vehicle.S0: {type: sensor, datatype: float", "Vehicle.S0: {type: sensor, datatype: int8"
    )
    assert rules(service.post("publish?name=signals.vspec&version=1.0.1", narrower), 422) == ["E004"]


@pytest.mark.parametrize(
    ("body", "name"),
    [
        (b"", "posted.yaml"),
        (b"\xff\xfe\x00", "posted.yaml"),
        (b"[1, 2]", "posted.yaml"),
        (b"Vehicle: {type: branch, description: A tree.}\nVehicle.A: {type: branch, description: B.}", "tree.vspec"),
        (b'{"files": []}', "posted.yaml"),
        (b'{"files": [{"name": "a.yaml"}]}', "posted.yaml"),
        (b'{"files": [{"name": "a.yaml", "text": 1}]}', "posted.yaml"),
        (b'{"files": ' + b"[" * 5000, "posted.yaml"),
        (CONTENT.replace(b"function: CoreAcc", "function: C\u043ereAcc".encode()), "function.yaml"),
        (CONTENT.replace(b"function: CoreAcc", b"function: ../../CoreAcc"), "function.yaml"),
        (CONTENT.replace(b"version: 1.0.0", b"version: 1.0"), "function.yaml"),
        (OVERLAY.encode(), "sign\u0430ls.vspec"),
    ],
)  # fmt: skip
def test_what_cannot_be_published_is_refused_and_changes_nothing(service: Service, body: bytes, name: str) -> None:
    problem(service.post(f"publish?version=1.0.0&name={name}", body), 422)
    assert not service.database.exists() or service.ask(API).json()["head"] is None


def test_a_body_beyond_the_limit_is_refused(tmp_path: Path) -> None:
    service = Service(tmp_path, Settings(body_bytes=100))
    problem(service.post("publish", CONTENT), 413)


# -- questions ----------------------------------------------------------------------------------------------------


def test_a_check_names_the_functions_that_break(service: Service) -> None:
    assert problem(service.post("check", CONTENT), 422)["detail"].startswith("Nothing is published")
    service.publish(CONTENT, USER, PROVIDER)
    report = service.post("check?name=signals.vspec", OVERLAY.replace("S0: {type: sensor, datatype: float", "S0: {type: sensor, datatype: string"))  # fmt: skip
    assert (report.status_code, report.json()["ok"]) == (200, False)
    assert {(each["rule"], each["line"]) for each in report.json()["findings"]} == {("E006", 1)}
    assert service.post("check", CONTENT).json()["ok"]
    assert [each["rule"] for each in service.post("check", LOST).json()["findings"]] == ["E008"]


def test_a_deployment_is_answered_and_recorded(service: Service) -> None:
    service.publish(CONTENT, USER, PROVIDER)
    question = f"can-i-deploy?function=CoreAcc@2.0.0&line={LINE}"
    for function in ("CoreAcc@1.0.0", "User@1.0.0", "Provider@1.0.0"):
        answer = service.post(f"record-deployment?function={function}&line={LINE}")
        assert is_signed(answer.json()["head"]["hash"], answer.json()["head"]["signature"], service.key)
    service.publish(LOST)
    found = service.post(question).json()
    assert (found["decision"], [each["rule"] for each in found["conflicts"]]) == ("no", ["E008"])
    assert found["conflicts"][0]["sides"][0]["name"] == "User"
    assert service.post(f"can-i-deploy?function=User@1.0.0&line={LINE}").json()["decision"] == "yes"
    unknown = service.post("can-i-deploy?function=User@1.0.0&line=SUV-2026").json()
    assert (unknown["decision"], unknown["finding"]["rule"]) == ("unknown", "E012")
    assert rules(service.post(f"can-i-deploy?function=Usr@1.0.0&line={LINE}"), 422) == ["E005"]
    assert service.post(f"support-ended?function=CoreAcc@1.0.0&line={LINE}").status_code == 200
    assert len(service.ask(f"{API}/lines?line={LINE}").json()["lines"][0]["deployments"]) == 2


def test_states_and_rules_are_set(service: Service) -> None:
    service.publish(CONTENT)
    assert service.post("deprecate?reference=CoreAcc@1.0.0&removal=2040-01-31").status_code == 200
    details = service.ask(f"{API}/functions/CoreAcc/versions/1.0.0$details").json()
    assert (details["lifecycle"], details["removal"]) == ("deprecated", "2040-01-31")
    assert service.post("rule?published=CoreAcc&compatibility_rule=full").status_code == 200
    assert rules(service.publish(LOST), 422) == ["E004"]
    assert service.post("retire?reference=CoreAcc@1.0.0").status_code == 200
    assert rules(service.post("retire?reference=CoreAcc@1.0.0"), 422) == ["E009"]
    assert rules(service.post("retire?reference=CoreAcc"), 422) == ["E005"]
    assert rules(service.post("record-release?function=CoreAcc@1.0.0&line=a/b"), 422) == ["E002"]


# -- access -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": "signals.example"},
        {**LOCAL, "X-Forwarded-For": "10.0.0.1"},
        {**LOCAL, "Forwarded": "for=10.0.0.1"},
        {**LOCAL, "Authorization": "Bearer forged"},
        {**LOCAL, "Authorization": "Basic YTpi"},
    ],
)
def test_a_request_that_may_come_from_elsewhere_needs_a_token(service: Service, headers: dict[str, str]) -> None:
    answer = service.publish(CONTENT, headers=headers)
    assert "sigcat registry token" in problem(answer, 401)["detail"]
    assert answer.headers["www-authenticate"] == 'Bearer realm="sigcat"'


def test_a_service_that_listens_elsewhere_needs_a_token(tmp_path: Path) -> None:
    service = Service(tmp_path, Settings(host="0.0.0.0"))
    problem(service.publish(CONTENT), 401)
    assert service.publish(CONTENT, headers=service.token("ci", "publish")).status_code == 201


def test_once_there_is_a_token_writing_needs_one_also_after_it_was_revoked(service: Service) -> None:
    with_token = service.token("ci", "publish")
    problem(service.publish(CONTENT), 401)
    assert service.publish(CONTENT, headers=with_token).status_code == 201
    with writing(service.database) as connection:
        revoke_token(connection, "ci")
    assert "'ci' is revoked" in problem(service.publish(USER, headers=with_token), 401)["detail"]
    problem(service.publish(USER), 401)


def test_an_expired_token_is_refused(service: Service) -> None:
    assert "expired" in problem(service.publish(CONTENT, headers=service.token("old", "publish", expires="2020-01-31")), 401)["detail"]  # fmt: skip
    assert service.publish(CONTENT, headers=service.token("new", "publish", expires="2999-01-31")).status_code == 201


def test_a_token_has_its_scopes_only(service: Service) -> None:
    by_scope = {scope: service.token(scope, scope) for scope in ("read", "publish", "approve", "administer")}
    service.publish(CONTENT, headers=by_scope["administer"])
    allowed = {
        "publish": ("publish", "administer"),
        f"record-deployment?function=CoreAcc@1.0.0&line={LINE}": ("approve", "administer"),
        "rule?published=CoreAcc&compatibility_rule=none": ("administer",),
        "deprecate?reference=CoreAcc@1.0.0": ("publish", "administer"),
    }
    for address, scopes in allowed.items():
        for scope, headers in by_scope.items():
            answer = service.post(address, CONTENT if address == "publish" else b"", headers)
            assert answer.status_code == (200 if scope in scopes else 403), (address, scope, answer.text)


def test_a_token_with_an_owner_records_what_the_owner_owns(service: Service) -> None:
    assert service.publish(CONTENT, headers=service.token("all", "administer")).status_code == 201
    other, own = (service.token(name, "approve", owner=f"Team {name}") for name in ("User", "CoreAcc"))
    recorded = "record-deployment?function=CoreAcc@1.0.0&line=SUV-2025"
    assert rules(service.post(recorded, headers=other), 403) == ["E015"]
    assert service.post(recorded, headers=own).status_code == 200
    ended = "support-ended?function=CoreAcc@1.0.0&line=SUV-2025"
    assert rules(service.post(ended, headers=other), 403) == ["E015"]


@pytest.mark.parametrize("more", ["line=SUV-2026", "function=CoreAcc@2.0.0"])
def test_a_question_about_two_lines_or_versions_is_refused(service: Service, more: str) -> None:
    service.publish(CONTENT)
    answer = service.post(f"can-i-deploy?function=CoreAcc@1.0.0&line=SUV-2025&{more}")
    assert "it takes one value" in problem(answer, 422)["detail"]


def test_a_token_with_an_owner_publishes_what_the_owner_owns(service: Service) -> None:
    core = service.token("core", "publish", owner="Team CoreAcc")
    assert service.publish(CONTENT, headers=core).status_code == 201
    assert rules(service.publish(USER, headers=core), 403) == ["E015"]
    user = service.token("user", "publish", owner="Team User")
    stolen = LOST.replace(b"Team CoreAcc", b"Team User")
    assert rules(service.publish(stolen, headers=user), 403) == ["E015"]
    assert rules(service.post("retire?reference=CoreAcc@1.0.0", headers=user), 403) == ["E015"]
    assert service.post("retire?reference=CoreAcc@1.0.0", headers=core).status_code == 200
    with reading(service.database) as connection:
        assert verify(connection).findings == ()
    assert [json.loads(each["entry"])["data"]["by"] for each in service.ask(f"{API}/log").json()["entries"]] == [
        "core",
        "core",
    ]


def test_the_database_has_no_token_but_its_hash(service: Service) -> None:
    secret = service.token("ci", "publish")["Authorization"].removeprefix("Bearer ")
    with reading(service.database) as connection:
        (token,) = all_tokens(connection)
    assert token.digest == hashlib.sha256(secret.encode()).hexdigest()
    assert secret.encode() not in b"".join(each.read_bytes() for each in service.database.parent.glob("registry.db*"))


@pytest.mark.parametrize(
    "headers",
    [
        {"Origin": "http://evil.example"},
        {"Origin": "null"},
        {"Sec-Fetch-Site": "cross-site"},
        {"Sec-Fetch-Site": "same-site", "Origin": "http://localhost:8000"},
    ],
)
def test_pages_of_other_sites_change_nothing(service: Service, headers: dict[str, str]) -> None:
    problem(service.publish(CONTENT, headers={**LOCAL, **headers}), 403)
    problem(service.publish(CONTENT, headers={**service.token("ci", "publish"), **headers}), 403)


def test_pages_of_the_service_and_of_configured_origins_may_write(tmp_path: Path) -> None:
    service = Service(tmp_path, Settings(origins=("https://tools.example",)))
    own = {**LOCAL, "Origin": "http://localhost:8000", "Sec-Fetch-Site": "same-origin"}
    assert service.publish(CONTENT, headers=own).status_code == 201
    other = {**LOCAL, "Origin": "https://tools.example", "Sec-Fetch-Site": "cross-site"}
    assert service.publish(USER, headers=other).status_code == 201


def test_where_reading_needs_a_token_one_of_the_registry_reads_the_registry(tmp_path: Path) -> None:
    service = Service(tmp_path, Settings(reading="token"))
    problem(service.ask(API), 401)
    problem(service.post("check", CONTENT), 401)
    headers = service.token("reader", "read")
    assert service.ask(API, headers=headers).status_code == 200
    problem(service.ask("/api/v1/catalogues", headers=headers), 401)


def reading_operations() -> list[str]:
    """Paths of the operations that read the registry, each parameter with a value."""
    paths = [path for path, operations in DOCUMENT["paths"].items() if path.startswith(API) and "get" in operations]
    return sorted(re.sub(r"{\w+}", "functions" if "{group}" in path else "x", path) for path in paths)


@pytest.mark.parametrize("path", reading_operations())
def test_where_reading_needs_a_token_no_operation_reads_the_registry_without(path: str, tmp_path: Path) -> None:
    service = Service(tmp_path, Settings(reading="token"))
    problem(service.ask(path), 401)


# -- databases that cannot be written -----------------------------------------------------------------------------


def test_a_locked_database_is_answered_with_when_to_come_again_and_reading_goes_on(
    service: Service, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sigcat.api.requests.hosted_registry.REGISTRY_REQUEST_SECONDS", 0.2)
    service.publish(CONTENT)
    locking = sqlite3.connect(service.database, isolation_level=None)
    locking.execute("BEGIN IMMEDIATE")
    answers: list[httpx.Response] = []
    writer = threading.Thread(target=lambda: answers.append(service.publish(USER)))
    writer.start()
    assert service.ask(f"{API}/functions").json()["total"] == 1
    writer.join()
    locking.execute("ROLLBACK")
    assert (rules(answers[0], 503), answers[0].headers["retry-after"]) == (["E011"], "2")
    assert service.publish(USER).status_code == 201


def test_a_full_disk_is_told_from_other_faults(service: Service, monkeypatch: pytest.MonkeyPatch) -> None:
    service.publish(CONTENT)

    def full(*_: object, **__: object) -> None:
        from sqlalchemy.exc import OperationalError

        error = sqlite3.OperationalError("database or disk is full")
        error.sqlite_errorcode = sqlite3.SQLITE_FULL
        raise OperationalError("INSERT", {}, error)

    monkeypatch.setattr("sigcat.registry.publish._publish", full)
    assert rules(service.publish(USER), 507) == ["E011"]
    assert service.ask(f"{API}/functions/CoreAcc").content == CONTENT
    monkeypatch.undo()
    assert service.publish(USER).status_code == 201


def test_a_service_that_starts_on_a_full_disk_reads_and_does_not_write(
    service: Service, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    service.publish(CONTENT)
    close_all()  # the last connection writes the log into the file
    assert not list(tmp_path.glob("registry.db-*"))
    monkeypatch.setattr("sigcat.registry.storing.sqlite.disk_usage", lambda _: SimpleNamespace(free=4096))
    assert service.ask(f"{API}/functions/CoreAcc").content == CONTENT
    answer = service.publish(USER)
    assert rules(answer, 507) == ["E011"]
    assert "Free space" in answer.json()["findings"][0]["fix"]
    assert not list(tmp_path.glob("registry.db-*"))
    monkeypatch.undo()
    assert service.publish(USER).status_code == 201


def test_a_database_that_disappears_is_not_replaced_by_an_empty_one(service: Service) -> None:
    service.publish(CONTENT)
    service.ask(API)
    for file in service.database.parent.glob("registry.db*"):
        file.unlink()
    assert rules(service.publish(USER), 503) == ["E011"]
    assert not service.database.exists()


def test_an_owner_acknowledges_a_deprecation(service: Service) -> None:
    service.publish(CONTENT, USER)
    service.post("deprecate?reference=CoreAcc@1.0.0&removal=2040-12-31")
    token = service.token("user", "approve", owner="Team User")
    answer = service.post("acknowledge?reference=CoreAcc@1.0.0", headers=token)
    assert answer.json()["head"]["epoch"] == 4
    (found,) = service.ask(f"{API}/deprecations").json()["versions_deprecated"]
    assert (found["xid"], found["removal"]) == ("/functions/CoreAcc/versions/1.0.0", "2040-12-31")
    (user,) = found["acknowledgements"]
    assert (user["owner"], user["using_functions"], bool(user["acknowledged"])) == ("Team User", "User 1.0.0", True)
    assert rules(service.post("acknowledge?reference=CoreAcc@1.0.0&owner=Other", headers=token), 403) == ["E015"]
