"""People sign in by OpenID Connect at a small provider, which can be made to lie."""

import base64
import json
import secrets
import threading
import time
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlencode, urlsplit

import httpx
import pytest
from joserfc import jwt
from joserfc.jwk import OctKey, RSAKey

from sigcat.api.groups import group_from_text
from sigcat.api.settings import Settings
from sigcat.digest import digest_of
from sigcat.errors import UsageError
from sigcat.web.openid import check_openid
from tests.web.test_registry_forms import Person

SECRET = "the secret of the client, with more than 14 bytes"
KEY = RSAKey.generate_key(2048, {"kid": "one"})
OTHER_KEY = RSAKey.generate_key(2048, {"kid": "one"})
Claims = dict[str, Any]


class Provider:
    """A provider on loopback with one person. Its answers can be changed."""

    def __init__(self) -> None:
        self.claims: Claims = {"email": "eva@example.org", "groups": ["staff", "cockpit"]}
        self.key: Any = KEY
        self.algorithm = "RS256"
        self.metadata: Claims = {}
        self.status = 200
        self.client = "https://signals.example"
        """Address of the service."""
        self.codes: dict[str, dict[str, str]] = {}
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), self._handler())
        self.issuer = f"http://127.0.0.1:{self._server.server_port}"
        threading.Thread(target=self._server.serve_forever, args=(0.05,), daemon=True).start()

    def close(self) -> None:
        self._server.shutdown()
        self._server.server_close()

    def authorize(self, address: str) -> dict[str, str]:
        """What the provider sends a browser back with, whose person has agreed."""
        asked = {name: values[0] for name, values in parse_qs(urlsplit(address).query).items()}
        assert address.startswith(f"{self.issuer}/authorize?")
        assert (asked["response_type"], asked["code_challenge_method"]) == ("code", "S256")
        assert asked["redirect_uri"] == f"{self.client}/registry/openid/return"
        code = secrets.token_urlsafe(8)
        self.codes[code] = asked
        return {"code": code, "state": asked["state"], "iss": self.issuer, "session_state": "x"}

    def document(self) -> Claims:
        paths = {"authorization_endpoint": "authorize", "token_endpoint": "token", "jwks_uri": "keys"}
        addresses = {name: f"{self.issuer}/{path}" for name, path in paths.items()}
        return {"issuer": self.issuer, **addresses, "id_token_signing_alg_values_supported": ["RS256"], **self.metadata}

    def token(self, form: dict[str, str], authorization: str) -> Claims:
        asked = self.codes.pop(form["code"], None)
        challenge = (
            base64.urlsafe_b64encode(bytes.fromhex(digest_of(form["code_verifier"].encode()))).decode().rstrip("=")
        )
        expected = base64.b64encode(f"sigcat:{SECRET}".encode()).decode()
        if asked is None or asked["code_challenge"] != challenge or authorization != f"Basic {expected}":
            return {"error": "invalid_grant"}
        now = int(time.time())
        claims = {
            "iss": self.issuer,
            "aud": "sigcat",
            "sub": "42",
            "iat": now,
            "exp": now + 300,
            "nonce": asked["nonce"],
        }
        kept = {name: value for name, value in {**claims, **self.claims}.items() if value is not None}
        header = {"alg": self.algorithm, "kid": "one"}
        signed = jwt.encode(header, kept, self.key, algorithms=[self.algorithm])
        return {"access_token": "x", "token_type": "Bearer", "id_token": signed}

    def _handler(provider) -> type[BaseHTTPRequestHandler]:  # noqa: N805 — the handler has the other `self`
        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                if self.path.startswith("/authorize?"):
                    self._ask_person()
                    return
                known = {
                    "/.well-known/openid-configuration": provider.document(),
                    "/keys": {"keys": [KEY.as_dict(private=False)]},
                }
                self._send(known.get(self.path))

            def do_POST(self) -> None:
                body = self.rfile.read(int(self.headers["Content-Length"])).decode()
                form = {name: values[0] for name, values in parse_qs(body).items()}
                self._send(provider.token(form, self.headers.get("Authorization", "")))

            def _ask_person(self) -> None:
                query = urlencode(provider.authorize(f"{provider.issuer}{self.path}"))
                self.send_response(200)
                self.send_header("Content-Type", "text/html")
                self.end_headers()
                self.wfile.write(f'<a href="{provider.client}/registry/openid/return?{query}">Agree</a>'.encode())

            def _send(self, answer: Claims | None) -> None:
                self.send_response(provider.status if answer and "error" not in answer else 400)
                self.send_header("Content-Type", "application/json")
                self.end_headers()
                self.wfile.write(json.dumps(answer).encode())

            def log_message(self, *_: object) -> None:
                pass

        return Handler


@pytest.fixture
def provider() -> Iterator[Provider]:
    running = Provider()
    yield running
    running.close()


def settings_for(provider: Provider, folder: Path, **others: Any) -> Settings:
    (folder / "openid.secret").write_text(f"{SECRET}\n")
    given = {
        "openid_issuer": provider.issuer, "openid_client": "sigcat", "openid_secret_file": str(folder / "openid.secret"),
        "openid_address": "https://signals.example",
        "openid_groups": "boss:administer,cockpit:publish+approve:Team Gamma,staff:read",
    }  # fmt: skip
    return Settings(**{**given, **others})


@pytest.fixture
def person(provider: Provider, tmp_path: Path) -> Person:
    return Person(tmp_path, settings_for(provider, tmp_path))


def begun(person: Person) -> httpx.Response:
    answer = person.get("/registry/openid")
    person.cookie = answer.headers.get("set-cookie", "").partition(";")[0]
    return answer


def returned(person: Person, sent: dict[str, str]) -> httpx.Response:
    return person.ask("/registry/openid/return", params=sent, headers={"Cookie": person.cookie})


def signed_in(person: Person, provider: Provider) -> httpx.Response:
    answer = returned(person, provider.authorize(begun(person).headers["location"]))
    found = [
        each.partition(";")[0] for each in answer.headers.get_list("set-cookie") if each.startswith("sigcat_session=")
    ]
    person.cookie = found[0] if found else ""
    return answer


def test_a_person_signs_in_and_has_the_rights_of_the_first_group_of_the_settings(person, provider) -> None:
    assert "Sign in with OpenID Connect" in person.get("/registry/login").text
    answer = signed_in(person, provider)
    assert answer.status_code == 200
    assert "SameSite=strict" in next(each for each in answer.headers.get_list("set-cookie") if "sigcat_session" in each)
    assert 'content="0; url=/registry"' in answer.text
    assert "Signed in as <b>eva@example.org</b> for Team Gamma" in person.get("/registry").text
    fields = {"group": "functions", "reference": "Gamma@1.0.0", "action": "retire"}
    assert person.send("/registry/end", **fields).status_code == 303
    assert (person.last_entry()["by"], person.last_entry()["team"]) == ("eva@example.org", "Team Gamma")
    assert person.send("/registry/end", **{**fields, "reference": "Alpha@2.0.0"}).status_code == 403


def test_the_cookie_of_a_sign_in_is_sent_to_its_return_only(person) -> None:
    cookie = begun(person).headers["set-cookie"]
    assert all(part in cookie for part in ("HttpOnly", "SameSite=lax", "Max-Age=600", "Path=/registry/openid"))


@pytest.mark.parametrize(
    "claims",
    [
        {"iss": "https://other.example"}, {"aud": "another client"}, {"aud": None}, {"exp": int(time.time()) - 3600},
        {"exp": None}, {"nonce": "another"}, {"nonce": None}, {"iat": int(time.time()) + 3600}, {"sub": None},
        {"aud": ["sigcat", "another client"], "azp": "another client"}, {"groups": []}, {"groups": None}, {"groups": "nothing"},
    ],
)  # fmt: skip
def test_an_id_token_with_wrong_claims_begins_no_session(person, provider, claims) -> None:
    provider.claims.update(claims)
    answer = signed_in(person, provider)
    assert (answer.status_code, person.cookie) == (403, "")


@pytest.mark.parametrize(
    ("algorithm", "key"),
    [("RS256", OTHER_KEY), ("HS256", OctKey.import_key(SECRET)), ("none", OctKey.import_key(SECRET))],
)
def test_an_id_token_with_a_wrong_signature_begins_no_session(person, provider, algorithm, key) -> None:
    provider.algorithm, provider.key = algorithm, key
    provider.metadata = {"id_token_signing_alg_values_supported": ["RS256", "HS256", "none"]}
    answer = signed_in(person, provider)
    assert (answer.status_code, person.cookie) == (403, "")


Change = Callable[[dict[str, str]], dict[str, str]]


@pytest.mark.parametrize(
    "change",
    [
        lambda sent: {**sent, "state": "another"}, lambda sent: {**sent, "state": ""}, lambda sent: {**sent, "code": "wrong"},
        lambda sent: {**sent, "code": ""}, lambda sent: {**sent, "iss": "https://other.example"},
        lambda sent: {"state": sent["state"], "error": "access_denied"},
    ],
)  # fmt: skip
def test_a_return_that_does_not_fit_begins_no_session(person, provider, change: Change) -> None:
    answer = returned(person, change(provider.authorize(begun(person).headers["location"])))
    assert (answer.status_code, "sigcat_session" in str(answer.headers)) == (403, False)


def test_a_return_to_another_browser_or_a_second_one_begins_no_session(person, provider) -> None:
    sent = provider.authorize(begun(person).headers["location"])
    assert person.ask("/registry/openid/return", params=sent).status_code == 403
    assert returned(person, sent).status_code == 200
    assert returned(person, sent).status_code == 403


@pytest.mark.parametrize("metadata", [{"issuer": "https://other.example"}, {"authorization_endpoint": "ftp://x"}, {"authorization_endpoint": None}])  # fmt: skip
def test_a_provider_with_wrong_metadata_is_not_used(person, provider, metadata) -> None:
    provider.metadata = metadata
    assert begun(person).status_code == 503


def test_a_provider_that_is_away_is_reported(person, provider) -> None:
    provider.status = 500
    answer = begun(person)
    assert (answer.status_code, "OpenID Connect" in answer.text) == (503, True)
    assert "Traceback" not in answer.text


def test_without_settings_there_is_no_such_page(tmp_path: Path) -> None:
    person = Person(tmp_path)
    assert "OpenID" not in person.get("/registry/login").text
    assert person.get("/registry/openid").status_code == 404
    assert person.get("/registry/openid/return").status_code == 404


@pytest.mark.parametrize("missing", ["openid_client", "openid_address", "openid_groups", "openid_secret_file"])
def test_settings_that_cannot_work_are_refused_at_the_start(provider, tmp_path: Path, missing: str) -> None:
    check_openid(settings_for(provider, tmp_path))
    without = "" if missing != "openid_secret_file" else str(tmp_path / "missing")
    with pytest.raises(UsageError, match=missing):
        check_openid(settings_for(provider, tmp_path, **{missing: without}))


@pytest.mark.parametrize("text", ["", "a", "a:fly", "a:read:b:c", ":read", "a:"])
def test_a_group_that_is_none_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="must be"):
        group_from_text(text)


@pytest.mark.parametrize(
    "issuer", ["http://login.example", "login.example", "https://x?y", "http://127.0.0.1.evil.example"]
)
def test_an_issuer_without_https_must_be_on_loopback(issuer: str) -> None:
    with pytest.raises(ValueError, match="openid_issuer"):
        Settings(openid_issuer=issuer)
