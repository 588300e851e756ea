"""Every error is a problem that names the reason."""

from typing import Any

import pytest

from sigcat.catalogue.hosting.library import Library
from sigcat.catalogue.model.definition import TYPES
from sigcat.catalogue.model.interfaces import CATEGORIES
from sigcat.web.site import create_site
from tests.api.conftest import SETTINGS, SOURCES, Ask, asker

SMALL = "/api/v1/catalogues/small"


def problem(ask: Ask, address: str, status: int, **options: object) -> dict[str, Any]:
    answer = ask(address, **options)
    assert answer.status_code == status
    assert answer.headers["content-type"] == "application/problem+json"
    body: dict[str, Any] = answer.json()
    assert set(body) == {"type", "title", "status", "detail", "findings", "nearest", "request_id"}
    assert body["status"] == status
    return body


def test_a_path_that_does_not_exist_proposes_near_ones(ask: Ask) -> None:
    body = problem(ask, f"{SMALL}/nodes/Vehicle.Sped", 404)
    assert body["type"] == "/problems/not-found"
    assert "Vehicle.Speed" in body["nearest"]


def test_below_a_path_the_type_opens_its_page_there_too() -> None:
    ask = asker(create_site(Library(SOURCES[:1]), SETTINGS), root_path="/signals")
    body = problem(ask, f"/signals{SMALL}/nodes/Vehicle.Sped", 404, headers={"Accept": "application/json"})
    assert body["type"] == "/signals/problems/not-found"
    assert "Not found" in ask(body["type"]).text


def test_a_catalogue_that_does_not_exist_proposes_near_ones(ask: Ask) -> None:
    assert problem(ask, "/api/v1/catalogues/smal", 404)["nearest"] == ["small"]


@pytest.mark.parametrize(
    "query",
    ["limit=0", "limit=many", "limit=-1", "deprecated=perhaps", "unknown=1", f"cursor={'x' * 301}", "depth=3"],
)
def test_a_parameter_that_does_not_fit_is_named(ask: Ask, query: str) -> None:
    (finding,) = problem(ask, f"{SMALL}/search?{query}", 422)["findings"]
    assert finding["pointer"] == f"/query/{query.partition('=')[0]}"


@pytest.mark.parametrize("cursor", ["abc", "////", "AAAA", "%F0%9F%92%A3", "MTIzOi0x", "'; drop table", "%00"])
def test_a_cursor_that_is_made_up_is_refused(ask: Ask, cursor: str) -> None:
    assert "cursor" in problem(ask, f"{SMALL}/search?cursor={cursor}", 422)["detail"]


def test_a_cursor_of_another_state_is_refused(ask: Ask) -> None:
    cursor = ask(f"{SMALL}/search?limit=2").json()["next_cursor"]
    assert "another state" in problem(ask, f"/api/v1/catalogues/bare/search?cursor={cursor}", 422)["detail"]


@pytest.mark.parametrize(
    "path",
    ["<script>alert(1)</script>", "..%2f..%2fetc%2fpasswd", "%00", "Vehicle." * 200, "'%20OR%201=1", "Vehicle..Speed"],
)
def test_a_hostile_path_is_a_path_that_does_not_exist(ask: Ask, path: str) -> None:
    problem(ask, f"{SMALL}/nodes/{path}", 404)


def test_a_path_that_is_longer_than_any_is_refused(ask: Ask) -> None:
    assert problem(ask, f"{SMALL}/nodes/{'Vehicle.' * 500}", 422)["findings"][0]["pointer"] == "/path/path"


@pytest.mark.parametrize("page", ["search?", "nodes?", "nodes?fields=path&"])
@pytest.mark.parametrize(
    ("wrong", "detail"),
    [
        (
            "type=senso",
            f"There is no type 'senso' in this catalogue; there are {', '.join(TYPES)}. Did you mean 'sensor'?",
        ),
        (
            "category=modes",
            f"There is no category 'modes' in this catalogue; there are {', '.join(CATEGORIES)}. Did you mean 'mode'?",
        ),
        ("unit=km/g", "There is no unit 'km/g' in this catalogue; there are km/h. Did you mean 'km/h'?"),
        ("datatype=flot", "There is no datatype 'flot' in this catalogue. Did you mean 'float'?"),
        ("asil=E", "There is no asil 'E' in this catalogue; there are QM, A, B, C, D."),
        ("type=sensor&type=actuator", "The parameter 'type' is given 2 times; it takes one value."),
    ],
)
def test_a_filter_that_nothing_can_have_is_refused_and_not_answered_with_nothing(
    ask: Ask, page: str, wrong: str, detail: str
) -> None:
    for accept in ("application/json", "text/csv"):
        answer = ask(f"{SMALL}/{page}{wrong}", headers={"Accept": accept})
        assert (answer.status_code, answer.json()["detail"]) == (422, detail)
    assert ask(f"{SMALL}/{page}type=struct").json()["total"] == 0


def test_a_field_that_no_node_can_have_is_refused(ask: Ask) -> None:
    detail = problem(ask, f"{SMALL}/nodes?fields=path,untit", 422)["detail"]
    assert detail == "Unknown field 'untit'. Did you mean 'unit'?"
    assert "Fields are ASILlevel, " in problem(ask, f"{SMALL}/nodes?fields=path,qqqq", 422)["detail"]
    assert ask(f"{SMALL}/nodes?fields=path,ASILlevel").status_code == 200


def test_a_cursor_belongs_to_its_search(ask: Ask) -> None:
    cursor = ask(f"{SMALL}/nodes?limit=1").json()["next_cursor"]
    assert ask(f"{SMALL}/nodes?limit=2&cursor={cursor}").status_code == 200
    assert "another search" in problem(ask, f"{SMALL}/nodes?limit=1&q=speed&cursor={cursor}", 422)["detail"]


def test_a_choice_that_is_none_is_answered_with_the_choices(ask: Ask) -> None:
    refused = problem(ask, f"{SMALL}/search?deprecated=maybe", 422)
    assert refused["detail"] == "Parameter 'deprecated': must be true or false."


def test_an_unknown_parameter_proposes_near_ones(ask: Ask) -> None:
    (finding,) = problem(ask, f"{SMALL}/search?overlays=error", 422)["findings"]
    assert (finding["message"], finding["fix"]) == ("Unknown parameter 'overlays'.", "Did you mean 'overlay'?")


@pytest.mark.parametrize("query", ["q=%FF", "q=speed%C3", "q=%ED%A0%80", "type=sensor&%FF=1"])
@pytest.mark.parametrize("page", ["search", "nodes", "tree"])
def test_bytes_that_are_not_utf_8_are_refused(ask: Ask, page: str, query: str) -> None:
    (finding,) = problem(ask, f"{SMALL}/{page}?{query}", 422)["findings"]
    assert finding["message"].endswith(": must be percent-encoded UTF-8.")


def test_any_text_in_utf_8_is_searched_for(ask: Ask) -> None:
    assert ask(f"{SMALL}/search?q=%C3%A9%EF%BF%BD").status_code == 200


def test_a_text_to_search_for_has_a_limit(ask: Ask) -> None:
    assert "200 characters" in problem(ask, f"{SMALL}/search?q={'a ' * 500}", 422)["detail"]


def test_an_address_or_method_that_does_not_exist_is_a_problem_too(ask: Ask) -> None:
    problem(ask, "/api/v2/catalogues", 404)
    problem(ask, "/api/v1/catalogues", 405, method="DELETE")


def test_where_reading_is_allowed_so_is_asking_for_the_head(ask: Ask) -> None:
    assert ask("/api/v1/catalogues", "DELETE").headers["allow"] == "GET, HEAD"
    assert ask("/api/v1/lint", "DELETE").headers["allow"] == "POST"


@pytest.mark.parametrize(
    "address", ["/openapi.json", "/health/live", "/health/ready", "/metrics", "/api/v1/rules", SMALL]
)
def test_no_address_takes_a_parameter_that_it_does_not_have(ask: Ask, address: str) -> None:
    (finding,) = problem(ask, f"{address}?colour=red", 422)["findings"]
    assert finding["pointer"] == "/query/colour"


@pytest.mark.parametrize("version", ['"1"', 'W/"1"', '"1", "2"', "", "the tag itself"])
@pytest.mark.parametrize("address", [SMALL, f"{SMALL}/nodes/Vehicle.Speed", f"{SMALL}/diff?to=bare"])
def test_a_version_that_is_not_there_is_not_answered_with_another_one(ask: Ask, address: str, version: str) -> None:
    tag = ask(address).headers["etag"]  # and from now on the answer is kept
    assert tag.startswith("W/"), "which is equal to none (RFC 9110, 8.8.3.2)"
    headers = {"If-Match": tag if version == "the tag itself" else version}
    assert "ID@VERSION" in problem(ask, address, 412, headers=headers)["detail"]
    assert ask(address, headers={"If-Match": "*"}).status_code == 200


@pytest.mark.parametrize("condition", [{"If-None-Match": "*"}, {"If-None-Match": "{tag}"}, {"If-Match": '"1"'}])
@pytest.mark.parametrize("address", [f"{SMALL}/nodes/Vehicle.Sped", f"{SMALL}/tree?path=Vehicle.Sped"])
def test_no_condition_hides_that_a_node_does_not_exist(ask: Ask, address: str, condition: dict[str, str]) -> None:
    tag = ask(SMALL).headers["etag"]
    problem(ask, address, 404, headers={name: value.format(tag=tag) for name, value in condition.items()})


def test_what_has_no_version_heeds_none(ask: Ask) -> None:
    assert ask("/api/v1/rules", headers={"If-Match": '"1"'}).status_code == 200


def test_what_fails_inside_tells_nothing_of_the_inside(ask: Ask, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise RuntimeError("secret")

    monkeypatch.setattr("sigcat.api.answers.serializers.node_data", fail)
    body = problem(ask, f"{SMALL}/nodes/Vehicle.Door.Left", 500)
    assert "secret" not in str(body)
