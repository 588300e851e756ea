"""People who sign in to the pages of the registry, and what they change there."""

import re
from collections.abc import Mapping
from pathlib import Path

import httpx
import pytest

from sigcat import codes
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library
from sigcat.project.project import RegistrySettings
from sigcat.registry.reference import unusable
from sigcat.registry.storing import sessions
from sigcat.registry.storing.database import reading, writing
from sigcat.registry.storing.ledger import Ledger, log_page
from sigcat.registry.storing.tokens import create_token, revoke_token
from sigcat.web.site import create_site
from tests.api.conftest import asker
from tests.registry.served import OVERLAY, fleet, function_file
from tests.web.published import published

OWN = {"Host": "sigcat", "Origin": "http://sigcat", "Sec-Fetch-Site": "same-origin"}
"""Headers by which a browser sends a form of the service."""
OTHER = {"Host": "sigcat", "Origin": "https://evil.example", "Sec-Fetch-Site": "cross-site"}
NEW = function_file("Epsilon", "{path: Vehicle.S0, role: provided}")


class Person:
    """A browser of a person."""

    def __init__(self, folder: Path, settings: Settings = Settings(), root_path: str = "") -> None:  # noqa: B008 — it is frozen
        (folder / "tree").mkdir()
        self.database = published(folder).database
        library = Library([fleet(folder / "tree")])
        self.ask = asker(create_site(library, settings, registry=RegistrySettings(self.database)), root_path)
        self.cookie = ""

    def token(self, *scopes: str, name: str = "anna", owner: str = "") -> str:
        with writing(self.database) as connection:
            return create_token(connection, name, scopes, owner, "")

    def get(self, address: str) -> httpx.Response:
        return self.ask(address, headers={"Cookie": self.cookie} if self.cookie else {})

    def post(self, address: str, headers: Mapping[str, str] = OWN, **options: object) -> httpx.Response:
        sent = {**headers, "Cookie": self.cookie} if self.cookie else headers
        return self.ask(address, "POST", headers=sent, **options)

    def sign_in(self, *scopes: str, owner: str = "", name: str = "anna", after: str = "") -> httpx.Response:
        data = {"token": self.token(*scopes, owner=owner, name=name), "next": after}
        answer = self.post("/registry/login", data=data)
        self.cookie = answer.headers["set-cookie"].partition(";")[0]
        return answer

    @property
    def form(self) -> str:
        found = re.search(r'name="form" value="([0-9a-f]{64})"', self.get("/registry").text)
        assert found
        return found[1]

    def send(self, address: str, **fields: str) -> httpx.Response:
        return self.post(address, data={"form": self.form, **fields})

    def last_entry(self) -> Mapping[str, object]:
        with reading(self.database) as connection:
            return log_page(connection, 0, 1000)[-1].entry.data


@pytest.fixture
def person(tmp_path: Path) -> Person:
    return Person(tmp_path)


def test_a_session_is_a_cookie_that_no_script_and_no_other_site_has(person: Person) -> None:
    answer = person.sign_in("publish", owner="Team Alpha", after="/registry/functions/Alpha")
    assert (answer.status_code, answer.headers["location"]) == (303, "/registry/functions/Alpha")
    cookie = answer.headers["set-cookie"]
    assert "HttpOnly" in cookie
    assert "SameSite=strict" in cookie
    assert "Max-Age=28800" in cookie
    assert "sigcat_" not in cookie.partition("=")[2], "the token must not be in it"
    assert "Signed in as <b>anna</b> for Team Alpha" in person.get("/registry").text


def test_a_session_over_https_is_never_sent_without_it(tmp_path: Path) -> None:
    person = Person(tmp_path, Settings(trusted_proxies=("*",)))
    assert "Secure" not in person.sign_in("read").headers["set-cookie"]
    secret = person.token("read", name="other")
    answer = person.ask(
        "https://sigcat/registry/login", "POST", headers={**OWN, "Origin": "https://sigcat"}, data={"token": secret}
    )
    assert "Secure" in answer.headers["set-cookie"]


@pytest.mark.parametrize(
    "after", ["https://evil.example", "//evil.example", "/registry/../../x", "/registry\\x", "/tree"]
)
def test_the_page_after_signing_in_is_one_of_the_registry(person: Person, after: str) -> None:
    assert person.sign_in("read", after=after).headers["location"] == "/registry"


@pytest.mark.parametrize("token", ["", "sigcat_wrong", "\x00", "ü" * 300])
def test_an_unknown_token_begins_no_session(person: Person, token: str) -> None:
    answer = person.post("/registry/login", data={"token": token})
    assert (answer.status_code, "set-cookie" in answer.headers) == (403, False)
    assert "The token must be one of this registry" in answer.text


def test_signing_out_ends_the_session_for_whoever_has_the_cookie(person: Person) -> None:
    person.sign_in("publish")
    assert person.send("/registry/logout").headers["location"] == "/registry"
    assert "Sign in" in person.get("/registry").text
    assert "Signed in" not in person.get("/registry").text


def test_a_revoked_token_ends_its_sessions(person: Person) -> None:
    person.sign_in("publish")
    with writing(person.database) as connection:
        revoke_token(connection, "anna")
    assert person.get("/registry/publish").headers["location"] == "/registry/login?next=%2Fregistry%2Fpublish"


def test_a_session_ends(person: Person, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sessions, "SESSION_SECONDS", 0)
    person.sign_in("publish")
    assert "Signed in" not in person.get("/registry").text


def test_a_file_is_published_by_the_token_of_the_session(person: Person) -> None:
    person.sign_in("publish", owner="Team Epsilon")
    files = {"file": ("Epsilon.function.yaml", NEW)}
    answer = person.post("/registry/publish", data={"form": person.form}, files=files)
    assert 'Epsilon</a> 1.0.0: <span class="tag plain">published' in answer.text
    assert person.ask("/api/v1/registry/functions/Epsilon").content == NEW
    entry = person.last_entry()
    assert (entry["by"], entry["team"]) == ("anna", "Team Epsilon")


def test_a_version_of_another_owner_names_both(person: Person) -> None:
    person.sign_in("publish")
    files = {
        "file": (
            "Beta.function.yaml",
            function_file("Beta", "{path: Vehicle.S1, role: provided}", "3.0.0").replace(b"Team Beta", b"Team <Z>"),
        )
    }
    answer = person.post("/registry/publish", data={"form": person.form}, files=files)
    assert "owner changed from Team Beta to Team &lt;Z&gt;" in answer.text
    assert "owner changed from Team Beta to Team &lt;Z&gt;" in person.get("/registry").text


def test_an_overlay_has_the_version_of_the_form(person: Person) -> None:
    person.sign_in("publish")
    files = {"file": ("signals.vspec", OVERLAY.encode())}
    data = {"form": person.form, "version": "1.0.0", "owner": "Platform"}
    assert "signals</a> 1.0.0" in person.post("/registry/publish", data=data, files=files).text
    del data["version"]
    assert person.post("/registry/publish", data=data, files=files).status_code == 422


def test_findings_of_a_file_are_shown_and_nothing_is_published(person: Person) -> None:
    person.sign_in("publish")
    files = {"file": ("Epsilon.function.yaml", NEW.replace(b"Vehicle.S0", b"Vehicle.S9"))}
    answer = person.post("/registry/publish", data={"form": person.form}, files=files)
    assert (answer.status_code, "Vehicle.S9" in answer.text) == (422, True)
    assert person.ask("/api/v1/registry/functions/Epsilon").status_code == 404


def test_an_owner_acknowledges_a_deprecation(person: Person) -> None:
    person.sign_in("administer", owner="Team Beta")
    with writing(person.database) as connection:
        Ledger(connection, None).append(
            "state",
            {
                "kind": "function",
                "name": "Alpha",
                "version": "1.0.0",
                "state": "deprecated",
                "until": "",
                "successor": "",
            },
        )
    assert "Team Beta has not acknowledged it: it is used by Beta 1.0.0" in person.get("/registry").text
    fields = {"group": "functions", "reference": "Alpha@1.0.0", "owner": "Team Beta"}
    assert person.send("/registry/acknowledge", **fields).headers["location"] == "/registry#deprecated"
    assert "Team Beta acknowledged it on" in person.get("/registry").text
    assert person.send("/registry/acknowledge", **{**fields, "owner": "Team Gamma"}).status_code == 403


@pytest.mark.parametrize("action", ["approve", "reject"])
def test_an_owner_decides_about_a_pending_version(person: Person, action: str) -> None:
    person.sign_in("approve", owner="Team Gamma")
    page = person.get("/registry").text
    content = re.search(r'name="content" value="([0-9a-f]{64})"', page)
    assert content
    fields = {
        "group": "functions",
        "reference": "Beta@1.1.0",
        "content": content[1],
        "owner": "Team Gamma",
        "reason": "Not now.",
    }
    assert person.send("/registry/decide", action=action, **fields).headers["location"] == "/registry#pending"
    words = {"approve": "Team Gamma approved it until", "reject": "Team Gamma rejected it: Not now."}
    assert words[action] in person.get("/registry").text
    other = person.send("/registry/decide", action=action, **{**fields, "content": "0" * 64})
    assert (other.status_code, "SHA-256" in other.text) == (422, True)


def test_a_version_is_deprecated_and_retired(person: Person) -> None:
    person.sign_in("publish", owner="Team Alpha")
    fields = {"group": "functions", "reference": "Alpha@2.0.0"}
    answer = person.send("/registry/end", action="deprecate", until="2040-12-31", successor="1.0.0", **fields)
    assert answer.headers["location"] == "/registry/functions/Alpha"
    page = person.get("/registry/functions/Alpha").text
    assert "until 2040-12-31, successor 1.0.0" in page
    asked = page.partition("<summary>Retire the version</summary>")[2].partition("</details>")[0]
    assert 'value="retire"' in asked, "the button is behind a question"
    assert '<td data-label="Event">deprecated</td>' in person.get("/registry").text
    page = person.get("/registry/functions/Alpha?end=1.0.0").text
    assert 'value="Alpha@1.0.0"' in page
    offered = page.partition('<select name="successor">')[2].partition("</select>")[0]
    assert offered == "<option></option>", "neither the version itself nor a deprecated one"
    assert person.send("/registry/end", action="retire", **fields).status_code == 303
    running = person.send("/registry/end", action="retire", group="functions", reference="Alpha@1.0.0")
    assert (running.status_code, "E009" in running.text) == (422, True)


def failed_delivery(person: Person) -> str:
    found = re.search(r'name="delivery" value="(msg_[0-9a-f]+)"', person.get("/registry/deliveries?state=failed").text)
    return found[1] if found else ""


def test_a_failed_delivery_is_sent_again(person: Person) -> None:
    person.sign_in("administer")
    delivery = failed_delivery(person)
    assert person.send("/registry/redeliver", delivery=delivery).headers["location"] == "/registry/deliveries"
    assert failed_delivery(person) == ""
    unknown = person.send("/registry/redeliver", delivery="msg_0")
    assert (unknown.status_code, "E005" in unknown.text) == (422, True)


def test_a_refused_form_of_files_keeps_its_values(person: Person) -> None:
    person.sign_in("publish")
    data = {"form": person.form, "version": "1.x", "owner": "Team <Z>", "draft": "yes"}
    answer = person.post("/registry/publish", data=data, files={"file": ("own.vspec", OVERLAY)})
    assert answer.status_code == 422
    for kept in ('name="version" value="1.x"', 'name="owner" value="Team &lt;Z&gt;"', 'value="yes" checked'):
        assert kept in answer.text
    assert "Nothing was published." in answer.text
    assert 'class="findings' in answer.text


def test_a_refused_end_of_a_version_keeps_its_values(person: Person) -> None:
    person.sign_in("publish")
    typed = {"group": "functions", "reference": "Alpha@1.0.0", "until": "2020-02-03", "successor": "2.0.0"}
    answer = person.send("/registry/end", action="deprecate", **typed)
    assert answer.status_code == 422
    assert '<h2 id="end">End version 1.0.0</h2>' in answer.text
    for kept in ('name="until" value="2020-02-03"', "<option selected>2.0.0</option></select></label>\n<p"):
        assert kept in answer.text
    assert "Nothing was changed." in answer.text
    assert "must be today or later, not 2020-02-03" in answer.text
    retired = person.send("/registry/end", action="retire", **typed).text
    assert "<details open><summary>Retire the version" in retired
    assert "runs in line SUV-2025" in retired
    other = person.send("/registry/end", action="deprecate", **{**typed, "reference": "Alpha@9.0.0"})
    assert 'name="until" value=""' in other.text, "what was typed about a version is not offered for another one"


@pytest.mark.parametrize("action", ["approve", "reject"])
def test_a_refused_decision_keeps_its_values(person: Person, action: str) -> None:
    person.sign_in("approve")
    typed = {"group": "functions", "reference": "Beta@1.1.0", "owner": "Team Gamma", "content": "0" * 64}
    answer = person.send("/registry/decide", action=action, reason='Not "now".', **typed)
    assert answer.status_code == 422
    assert 'name="reason" value="Not &#34;now&#34;."' in answer.text
    assert "<option selected>Team Gamma</option>" in answer.text
    assert "must have the SHA-256" in answer.text


def test_a_form_is_shown_again_while_the_registry_is_busy_and_the_log_says_so(
    person: Person, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def busy(*_: object, **__: object) -> None:
        raise unusable(codes.REGISTRY_UNUSABLE.finding("The database is locked."))

    person.sign_in("publish")
    monkeypatch.setattr("sigcat.registry.lines.set_state", busy)
    monkeypatch.setattr("sigcat.registry.publish.publish", busy)
    typed = {"group": "functions", "reference": "Alpha@1.0.0", "until": "2040-02-03"}
    ended = person.send("/registry/end", action="deprecate", **typed)
    files = {"file": ("signals.vspec", OVERLAY.encode())}
    data = {"form": person.form, "version": "1.0.0", "owner": "Platform"}
    published_files = person.post("/registry/publish", data=data, files=files)
    assert 'name="until" value="2040-02-03"' in ended.text
    assert 'name="owner" value="Platform"' in published_files.text
    for answer in (ended, published_files):
        assert (answer.status_code, answer.headers["retry-after"]) == (503, "2")
    assert caplog.text.count("The database is locked.") == 2


def test_who_may_not_administer_sends_no_delivery_again(person: Person) -> None:
    person.sign_in("publish")
    assert failed_delivery(person) == ""
    assert person.send("/registry/redeliver", delivery="msg_0").status_code == 403


@pytest.mark.parametrize(
    ("scope", "owner", "address", "fields", "status"),
    [
        ("read", "", "/registry/end", {"reference": "Alpha@2.0.0"}, 403),
        ("publish", "Team Beta", "/registry/end", {"reference": "Alpha@2.0.0"}, 403),
        ("publish", "", "/registry/decide", {"reference": "Beta@1.1.0"}, 403),
        ("approve", "Team Alpha", "/registry/decide", {"reference": "Beta@1.1.0", "owner": "Team Gamma"}, 403),
        ("publish", "", "/registry/end", {"reference": "Alpha"}, 422),
        ("publish", "", "/registry/end", {"reference": "Alpha@2.0.0", "group": "lines"}, 422),
        ("publish", "", "/registry/end", {"reference": "Alpha@2.0.0", "action": "delete"}, 422),
        ("publish", "", "/registry/end", {"reference": "A" * 5000}, 422),
        ("publish", "", "/registry/publish", {}, 422),
    ],
)  # fmt: skip
def test_what_the_token_or_the_rules_refuse_changes_nothing(person, scope, owner, address, fields, status) -> None:
    person.sign_in(scope, owner=owner)
    before = person.last_entry()
    action = "approve" if address.endswith("decide") else "retire"
    answer = person.send(address, **{"group": "functions", "action": action, **fields})
    assert answer.status_code == status, answer.text
    assert person.last_entry() == before


@pytest.mark.parametrize(
    "address",
    [
        "/registry/login",
        "/registry/logout",
        "/registry/publish",
        "/registry/end",
        "/registry/decide",
        "/registry/redeliver",
    ],
)
def test_a_form_of_another_site_is_refused(person: Person, address: str) -> None:
    person.sign_in("administer")
    before = person.last_entry()
    fields = {"group": "functions", "reference": "Alpha@2.0.0", "action": "retire"}
    for headers in (OTHER, {**OWN, "Sec-Fetch-Site": "same-site"}, {**OWN, "Origin": "null"}):
        assert person.post(address, headers, data={"form": person.form, **fields}).status_code == 403
    assert person.last_entry() == before
    assert "Signed in" in person.get("/registry").text


@pytest.mark.parametrize("value", ["", "0" * 64, "ü"])
def test_a_form_without_the_value_of_the_session_is_refused(person: Person, value: str) -> None:
    person.sign_in("administer")
    data = {"form": value, "group": "functions", "reference": "Alpha@2.0.0", "action": "retire"}
    answer = person.post("/registry/end", {"Host": "sigcat"}, data=data)
    assert (answer.status_code, "must be one of this session" in answer.text) == (403, True)


def test_without_a_session_a_form_leads_to_the_page_to_sign_in(person: Person) -> None:
    answer = person.post("/registry/end", data={"reference": "Alpha@2.0.0"})
    assert (answer.status_code, answer.headers["location"]) == (303, "/registry/login")


def test_below_a_path_of_a_proxy_cookie_and_addresses_are_below_it(tmp_path: Path) -> None:
    person = Person(tmp_path, Settings(root_path="/sigcat"), "/sigcat")
    secret = person.token("publish")
    answer = person.post("/sigcat/registry/login", data={"token": secret})
    assert (answer.headers["location"], "Path=/sigcat" in answer.headers["set-cookie"]) == ("/sigcat/registry", True)


# -- where reading needs a token ----------------------------------------------------------------------------------


def test_where_reading_needs_a_token_pages_take_a_session_or_a_token_and_do_not_name_catalogues(tmp_path: Path) -> None:
    person = Person(tmp_path, Settings(reading="token"))
    assert person.get("/registry").headers["location"] == "/registry/login?next=%2Fregistry"
    login = person.get("/registry/login")
    assert login.status_code == 200
    secret = person.token("read", name="reader")
    by_token = person.ask("/registry/lines", headers={"Authorization": f"Bearer {secret}"})
    assert (by_token.status_code, "SUV-2025" in by_token.text) == (200, True)
    assert person.ask("/registry", headers={"Authorization": "Bearer wrong"}).status_code == 401
    person.sign_in("read")
    signed_in, missing = person.get("/registry"), person.get("/registry/functions/Nothing")
    assert (signed_in.status_code, missing.status_code) == (200, 404)
    for page in (login, by_token, signed_in, missing):
        assert "Fleet" not in page.text.replace("Vehicle.Fleet", "")
    assert person.get("/tree/fleet").status_code == 401
