"""Answers in the form that a client accepts, with the fields that it wants, at addresses that may be kept."""

import csv
import io

import pytest
import yaml

from sigcat.api.answers import negotiation
from sigcat.api.answers.negotiation import chosen_type, csv_lines, yaml_text
from tests.api.conftest import Ask

SMALL = "/api/v1/catalogues/small"


@pytest.mark.parametrize("address", ["", "/nodes/Vehicle.Speed", "/tree?depth=2", "/search?q=speed", "/units"])
def test_yaml_says_what_json_says(ask: Ask, address: str) -> None:
    answer = ask(SMALL + address, headers={"Accept": "application/yaml"})
    assert answer.headers["content-type"] == "application/yaml"
    assert yaml.safe_load(answer.text) == ask(SMALL + address).json()


@pytest.mark.parametrize("piece", [2, 7, 100])
def test_yaml_that_is_written_in_pieces_says_the_same(monkeypatch: pytest.MonkeyPatch, piece: int) -> None:
    long = "x: 'y' \u00e9 " * 200 + "\n\n  two lines  \n"
    shared = [1, 2]
    data = {
        "a: b": [{"deep": [{"deeper": list(range(9))}, [[], {}, [None, True]]]}, long, "-", ""],
        "nodes": [{"path": f"V.{n}", "text": long, "none": None, "children": [shared, shared]} for n in range(9)],
        "empty": {},
        "number": -1.5,
    }
    monkeypatch.setattr(negotiation, "_PIECE", piece)
    assert yaml.safe_load(yaml_text(data)) == data


def test_lists_are_tables_too(ask: Ask) -> None:
    answer = ask(f"{SMALL}/search?q=speed", headers={"Accept": "text/csv"})
    rows = list(csv.DictReader(io.StringIO(answer.text)))
    assert rows[0]["path"] == "Vehicle.Speed"
    assert ask("/api/v1/rules", headers={"Accept": "text/csv"}).text.startswith("id,name,")


def test_a_form_that_is_not_there_is_refused_with_those_that_are(ask: Ask) -> None:
    refused = ask(f"{SMALL}/nodes/Vehicle.Speed", headers={"Accept": "image/png"})
    assert refused.status_code == 406
    assert "application/yaml" in refused.json()["detail"]


@pytest.mark.parametrize(
    ("accepted", "chosen"),
    [
        ("*/*", "application/json"),
        ("text/html,application/xhtml+xml,*/*;q=0.8", "application/json"),
        ("text/csv;q=0.5, application/yaml", "application/yaml"),
        ("text/*", "text/csv"),
        ("application/json;q=0, */*", "application/yaml"),
        ("application/yaml;q=nonsense", "application/yaml"),
        ("", "application/json"),
    ],
)
def test_the_best_of_what_is_accepted_is_chosen(accepted: str, chosen: str) -> None:
    assert chosen_type(accepted, ("application/json", "application/yaml", "text/csv")) == chosen


def test_a_cell_is_never_a_formula() -> None:
    assert csv_lines([["=1+1", "@x", "-2", -2, "plain"]]) == "'=1+1,'@x,'-2,-2,plain\r\n"


def test_nodes_have_the_fields_that_are_asked_for(ask: Ask) -> None:
    page = ask(f"{SMALL}/nodes?fields=path,max,ASILlevel&type=sensor&limit=2").json()
    assert page["rows"][0] == {"path": "Vehicle.Speed", "max": 300, "ASILlevel": "B"}
    assert (page["total"], len(page["rows"])) == (3, 2)
    following = ask(f"{SMALL}/nodes?fields=path&type=sensor&limit=2&cursor={page['next_cursor']}").json()
    assert [set(node) for node in following["rows"]] == [{"path"}]


def test_a_table_without_a_limit_has_every_node(ask: Ask) -> None:
    table = ask(f"{SMALL}/nodes?fields=path,unit", headers={"Accept": "text/csv"}).text
    assert len(table.splitlines()) == 1 + ask(SMALL).json()["node_count"]


def test_an_address_with_the_version_never_changes(ask: Ask) -> None:
    version = ask(SMALL).json()["version"]
    fixed = ask(f"{SMALL}@{version}/nodes/Vehicle.Speed")
    assert "immutable" in fixed.headers["cache-control"]
    assert fixed.json() == ask(f"{SMALL}/nodes/Vehicle.Speed").json()
    assert ask(f"{SMALL}/nodes/Vehicle.Speed").headers["cache-control"] == "no-cache"


def test_an_address_with_another_version_tells_the_present_one(ask: Ask) -> None:
    gone = ask(f"{SMALL}@0123456789/nodes/Vehicle.Speed")
    assert gone.status_code == 404
    assert gone.json()["nearest"] == [f"small@{ask(SMALL).json()['version']}"]
