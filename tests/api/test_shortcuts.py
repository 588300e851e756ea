"""A shortcut answers as the operation does that it leads around."""

import pytest

from sigcat.api.application import create_app
from sigcat.api.routes.shortcuts import Shortcuts
from sigcat.catalogue.hosting.library import Library
from tests.api.conftest import SETTINGS, Ask, asker

NODES = "/api/v1/catalogues/small/nodes"
SEARCH = "/api/v1/catalogues/small/search"


@pytest.fixture(scope="module")
def without(library: Library) -> Ask:
    """The same service, in which every request takes the long way."""
    app = create_app(library, SETTINGS)
    app.user_middleware[:] = [each for each in app.user_middleware if each.cls is not Shortcuts]  # type: ignore[comparison-overlap]
    return asker(app)


@pytest.mark.parametrize("accepted", ["*/*", "application/json", "application/yaml", "text/csv", "image/png"])
@pytest.mark.parametrize(
    "address",
    [f"{NODES}/Vehicle.Speed", f"{NODES}/Vehicle", f"{NODES}/Vehicle.Sped", f"{NODES}/{'a' * 300}", f"{NODES}/%00",
     f"{NODES}/Vehicle.Speed?colour=red", "/api/v1/catalogues/smal/nodes/Vehicle", f"/api/v1/catalogues/{'a' * 300}/nodes/Vehicle",
     "/api/v1/catalogues/small~without.overlay/nodes/Vehicle.Speed", "/api/v1/catalogues/small@1/nodes/Vehicle.Speed", f"{NODES}/",
     f"{SEARCH}?q=vehicle", f"{SEARCH}?q=Vehicle+Speed", f"{SEARCH}?q=speed+door+vehicle+left", f"{SEARCH}?q=sped", f"{SEARCH}?q=",
     f"{SEARCH}?q=speed&limit=2", f"{SEARCH}?q=speed&q=door", f"{SEARCH}?q=speed&type=sensor", f"{SEARCH}?q={'speed+' * 30}speed",
     f"{SEARCH}?q={'a' * 1000}", "/api/v1/catalogues/smal/search?q=speed", "/api/v1/catalogues/small~without.overlay/search?q=speed"],
)  # fmt: skip
def test_a_shortcut_changes_no_answer(ask: Ask, without: Ask, address: str, accepted: str) -> None:
    short, long = (each(address, headers={"Accept": accepted}, follow_redirects=False) for each in (ask, without))
    assert short.status_code == long.status_code
    assert body(short) == body(long)
    assert headers(short) == headers(long)


@pytest.mark.parametrize("method", ["HEAD", "POST", "DELETE", "OPTIONS"])
def test_other_methods_are_answered_alike(ask: Ask, without: Ask, method: str) -> None:
    short, long = (each(f"{NODES}/Vehicle.Speed", method) for each in (ask, without))
    assert (short.status_code, headers(short)) == (long.status_code, headers(long))


def test_a_known_state_is_not_sent_again(ask: Ask, without: Ask) -> None:
    known = {"If-None-Match": ask(f"{NODES}/Vehicle.Speed").headers["etag"], "Accept-Encoding": "identity"}
    short, long = (each(f"{NODES}/Vehicle.Door", headers=known) for each in (ask, without))
    assert (short.status_code, headers(short)) == (long.status_code, headers(long))
    assert short.status_code == 304
    assert short.headers["vary"] == "Accept, Accept-Encoding"
    ask(f"{NODES}/Vehicle.Door")  # from now on it is cached
    assert headers(ask(f"{NODES}/Vehicle.Door", headers=known)) == headers(long)


def body(answer) -> object:
    if answer.headers.get("content-type") != "application/problem+json":
        return answer.content
    return {key: value for key, value in answer.json().items() if key != "request_id"}


def headers(answer) -> dict[str, str]:
    return {key: value for key, value in answer.headers.items() if key not in ("x-request-id", "content-length")}
