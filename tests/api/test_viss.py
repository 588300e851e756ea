"""Static metadata as clients of VISS read it."""

import json

import pytest

from tests.api.conftest import Ask

VISS = "/api/v1/catalogues/small/viss"
METADATA = {"filter": '{"type":"static-metadata","parameter":""}'}


def test_metadata_of_a_signal_stands_under_its_name(ask: Ask) -> None:
    answer = ask(f"{VISS}/Vehicle/Speed", params=METADATA).json()
    assert answer["metadata"]["Speed"]["datatype"] == "double"
    assert answer["ts"].endswith("Z")


def test_metadata_of_a_branch_has_all_that_is_below(ask: Ask) -> None:
    door = ask(f"{VISS}/Vehicle/Door", params=METADATA).json()["metadata"]["Door"]
    assert door["children"]["Left"]["children"]["IsOpen"]["type"] == "actuator"


def test_later_drafts_call_the_kind_a_variant(ask: Ask) -> None:
    assert ask(f"{VISS}/Vehicle/Door", params={"filter": '{"variant":"static-metadata"}'}).status_code == 200


@pytest.mark.parametrize("text", ["", "{}", "[]", "null", "{", '{"type":"history","parameter":"P1D"}', "[" * 900])
def test_values_are_not_here(ask: Ask, text: str) -> None:
    refused = ask(f"{VISS}/Vehicle/Speed", params={"filter": text})
    assert refused.status_code == 400
    assert json.loads(refused.text)["error"]["reason"] == "bad_request"


@pytest.mark.parametrize("query", ["", "filters=1", f"filter={'x' * 2001}", "filter={}&depth=1"])
def test_whatever_is_wrong_with_a_request_is_told_in_the_form_of_viss(ask: Ask, query: str) -> None:
    refused = ask(f"{VISS}/Vehicle/Speed?{query}")
    assert (refused.status_code, refused.json()["error"]["number"], refused.json()["error"]["reason"]) == (
        400,
        "400",
        "bad_request",
    )
    assert "static-metadata" in refused.json()["error"]["message"]


def test_so_is_a_catalogue_that_does_not_exist(ask: Ask) -> None:
    refused = ask("/api/v1/catalogues/smal/viss/Vehicle/Speed", params=METADATA)
    assert (refused.status_code, refused.json()["error"]["reason"]) == (404, "invalid_path")


def test_a_path_that_does_not_exist_is_refused_in_the_words_of_viss(ask: Ask) -> None:
    refused = ask(f"{VISS}/Vehicle/Sped", params=METADATA)
    assert (refused.status_code, refused.json()["error"]["reason"]) == (404, "invalid_path")
