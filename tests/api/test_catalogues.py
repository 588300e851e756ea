"""Reading catalogues over HTTP."""

import pytest

from sigcat.api.answers import schemas
from sigcat.api.answers.negotiation import json_bytes
from sigcat.api.answers.serializers import node_data, node_detail
from sigcat.api.application import create_app
from sigcat.catalogue.hosting.library import Library
from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.hosting.sources import shipped_sources
from tests.api.conftest import SETTINGS, SOURCES, Ask, asker

SMALL = "/api/v1/catalogues/small"


def test_the_default_catalogue_comes_first(ask: Ask) -> None:
    listed = ask("/api/v1/catalogues").json()["catalogues"]
    assert [each["id"] for each in listed] == ["small", "bare", "broken"]
    assert listed[1]["types"] == {"branch": 4, "sensor": 2, "actuator": 2, "attribute": 2}


def test_a_catalogue_tells_its_layers_and_its_findings(ask: Ask) -> None:
    broken = ask("/api/v1/catalogues/broken").json()
    assert broken["finding_counts"]["errors"] == 1
    (problem,) = broken["findings"]
    assert (problem["rule"], problem["line"], problem["path"]) == ("V001", 6, "Vehicle.Speed")
    assert "sensor" in problem["fix"]
    assert [layer["is_overlay"] for layer in ask(SMALL).json()["layers"]] == [False, True]


def test_a_node_has_children_unit_and_neighbours(ask: Ask) -> None:
    speed = ask(f"{SMALL}/nodes/Vehicle.Speed").json()
    assert speed["unit_definition"]["name"] == "kilometer per hour"
    assert (speed["parent"], speed["previous"], speed["next"]) == ("Vehicle", None, "Vehicle.Door")
    door = ask(f"{SMALL}/nodes/Vehicle.Door").json()
    assert [child["name"] for child in door["children"]] == ["Left", "Right"]


def test_every_attribute_tells_where_it_was_written_and_what_it_was_before(ask: Ask) -> None:
    speed = ask(f"{SMALL}/nodes/Vehicle.Speed").json()
    attributes = {each["name"]: each for each in speed["attributes"]}
    datatype = attributes["datatype"]
    assert datatype["value"] == "double"
    assert (datatype["origin"]["line"], datatype["origin"]["overlay"]) == (3, "overlay")
    assert [(entry["value"], entry["origin"]["overlay"]) for entry in datatype["history"]] == [
        ("float", None),
        ("double", "overlay"),
    ]
    assert attributes["ASILlevel"]["is_extended"]
    assert attributes["min"]["origin"]["file"].endswith("tree.vspec")


def test_an_instance_knows_its_definition(ask: Ask) -> None:
    assert ask(f"{SMALL}/nodes/Vehicle.Door.Left.IsOpen").json()["definition_path"] == "Vehicle.Door.IsOpen"


def test_an_error_interface_has_the_name_that_its_path_gives(ask: Ask) -> None:
    node = ask(f"{SMALL}/nodes/Vehicle.Function.Braking.Error.RangeError").json()
    assert (node["category"], node["interface_name"]) == ("error", "Braking_RangeError_ErrorSts")


def test_a_yaml_date_is_sent_as_text(ask: Ask) -> None:
    attributes = ask(f"{SMALL}/nodes/Vehicle.Built").json()["attributes"]
    assert next(each["value"] for each in attributes if each["name"] == "default") == "2024-01-31"


def test_the_tree_goes_down_to_the_depth_asked_for(ask: Ask) -> None:
    tree = ask(f"{SMALL}/tree", params={"path": "Vehicle.Door", "depth": 1}).json()
    assert [child["subtrees"] for child in tree["subtrees"]] == [None, None]
    assert [child["child_count"] for child in tree["subtrees"]] == [1, 1]
    assert ask(f"{SMALL}/tree?depth=0").json()["subtrees"] is None


def test_a_tree_beyond_the_limit_is_refused_with_what_to_do(ask: Ask) -> None:
    refused = ask(f"{SMALL}/tree?depth=9")
    assert refused.status_code == 422
    assert "less depth" in refused.json()["detail"]


def test_search_takes_words_and_filters_and_counts_what_it_found(ask: Ask) -> None:
    page = ask(f"{SMALL}/search", params={"q": "speed", "deprecated": "no"}).json()
    assert [node["path"] for node in page["hits"]] == ["Vehicle.Speed"]
    assert page["facets"]["type"] == {"sensor": 1}
    by_overlay = ask(f"{SMALL}/search", params={"overlay": "overlay", "type": "sensor"}).json()
    assert by_overlay["total"] == 2


def test_search_pages_by_cursor_until_the_end(ask: Ask) -> None:
    paths, cursor = [], ""
    while True:
        page = ask(f"{SMALL}/search", params={"q": "vehicle", "limit": 4} | ({"cursor": cursor} if cursor else {}))
        paths += [node["path"] for node in page.json()["hits"]]
        cursor = page.json()["next_cursor"]
        if cursor is None:
            break
    assert len(paths) == len(set(paths)) == page.json()["total"] == 12


@pytest.mark.parametrize("limit", [0, -1, 6, 100_000, 10**30])
def test_a_limit_that_the_service_does_not_give_is_refused_however_it_is_wrong(ask: Ask, limit: int) -> None:
    for page in ("search", "nodes"):
        refused = ask(f"{SMALL}/{page}", params={"limit": limit})
        assert (refused.status_code, refused.json()["findings"][0]["pointer"]) == (422, "/query/limit")


@pytest.mark.parametrize("page", ["search?q=vehicle&instances=true", "nodes?q=vehicle"])
@pytest.mark.parametrize("accept", ["application/json", "text/csv"])
def test_each_page_names_the_next_one(library: Library, page: str, accept: str) -> None:
    ask = asker(create_app(library, SETTINGS), root_path="/signals")
    address: str | None = f"/signals{SMALL}/{page}&limit=5"
    lines: list[str] = []
    while address:
        answer = ask(address, headers={"Accept": accept})
        lines += answer.text.splitlines()[1:]
        address = answer.links.get("next", {}).get("url")
    total = ask(f"{SMALL}/{page}").json()["total"]
    assert total > 10
    assert accept != "text/csv" or len(lines) == total


def test_a_near_miss_proposes_words(ask: Ask) -> None:
    assert ask(f"{SMALL}/search?q=sped").json()["suggestions"] == ["speed"]


def test_units_and_quantities_are_listed(ask: Ask) -> None:
    assert [unit["key"] for unit in ask(f"{SMALL}/units").json()["units"]] == ["km/h"]
    assert [each["key"] for each in ask(f"{SMALL}/quantities").json()["quantities"]] == ["velocity"]


def test_an_unchanged_catalogue_is_not_sent_twice(ask: Ask) -> None:
    first = ask(f"{SMALL}/nodes/Vehicle.Speed")
    again = ask(f"{SMALL}/nodes/Vehicle.Speed", headers={"If-None-Match": first.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")
    assert ask(f"{SMALL}/units", headers={"If-None-Match": '"another"'}).status_code == 200


@pytest.mark.parametrize("source", [*SOURCES, *shipped_sources()], ids=lambda source: source.id)
def test_a_node_is_sent_unchecked_and_fits_its_schema(source: Source) -> None:
    catalogue = load(source)
    assert catalogue.nodes
    for node in catalogue.nodes.values():
        data = node_data(catalogue, node)
        assert list(schemas.Node.model_validate(data, strict=True).model_dump().items()) == list(data.items())
        assert json_bytes(data) == json_bytes(node_detail(catalogue, node))
