"""Changes between hosted catalogues, and changes that an overlay would make."""

import pytest

from sigcat.api.application import create_app
from sigcat.catalogue.hosting.library import Library
from tests.api.conftest import SETTINGS, SOURCES, Ask, asker
from tests.migration.chained_releases import chained_sources

BARE, SMALL = "/api/v1/catalogues/bare", "/api/v1/catalogues/small"


def test_a_diff_tells_each_change_with_its_class(ask: Ask) -> None:
    diff = ask(f"{BARE}/diff?to=small").json()
    assert (diff["old"], diff["new"]) == ("bare", "small")
    by_path = {change["path"]: change for change in diff["changes"]}
    assert by_path["Vehicle.Function"]["kind"] == "added"
    (datatype,) = [each for each in by_path["Vehicle.Speed"]["attribute_changes"] if each["name"] == "datatype"]
    assert (datatype["old_value"], datatype["new_value"]) == ("float", "double")
    assert diff["summary"]["total"] == len(diff["changes"])


def test_a_diff_shows_only_the_classes_that_are_asked_for(ask: Ask) -> None:
    diff = ask(f"{BARE}/diff?to=small&compatibility=breaking&compatibility=risky").json()
    assert {change["compatibility"] for change in diff["changes"]} <= {"breaking", "risky"}


def test_a_diff_has_the_classes_for_the_bindings_that_are_asked_for(ask: Ask) -> None:
    whole, bound = (ask(f"{BARE}/diff?to=small{binding}").json()["changes"] for binding in ("", "&binding=graphql"))
    assert [each["compatibility"] for each in bound] == [each["bindings"]["graphql"] for each in whole]
    assert [each["compatibility"] for each in bound] != [each["compatibility"] for each in whole]
    assert ask(f"{BARE}/diff?to=small&binding=carrier-pigeon").status_code == 422


def test_a_diff_comes_as_release_notes_and_as_a_tree_of_text(ask: Ask) -> None:
    notes = ask(f"{BARE}/diff?to=small", headers={"Accept": "text/markdown"})
    assert notes.text.startswith("# Changes from `bare` to `small`")
    assert "changes:" in ask(f"{BARE}/diff?to=small", headers={"Accept": "text/plain"}).text


def test_a_catalogue_does_not_differ_from_itself(ask: Ask) -> None:
    assert ask(f"{SMALL}/diff?to=small").json()["changes"] == []


def test_the_catalogue_to_compare_with_has_to_exist(ask: Ask) -> None:
    assert ask(f"{SMALL}/diff?to=bre").json()["nearest"] == ["bare"]
    assert ask(f"{SMALL}/diff").status_code == 422


def test_an_unchanged_diff_is_not_sent_twice(ask: Ask) -> None:
    tag = ask(f"{BARE}/diff?to=small").headers["etag"]
    assert ask(f"{BARE}/diff?to=small", headers={"If-None-Match": tag}).status_code == 304
    assert ask(f"{SMALL}/diff?to=bare", headers={"If-None-Match": tag}).status_code == 200


def test_a_trial_tells_nodes_findings_and_changes_and_stores_nothing(ask: Ask) -> None:
    before = ask(SMALL).json()["digest"]
    trial = ask(f"{SMALL}/trial", "POST", content=b"Vehicle.Speed:\n  max: 100\n").json()
    assert trial["ok"]
    (node,) = trial["nodes"]
    assert (node["path"], node["values"]["max"]) == ("Vehicle.Speed", 100)
    assert trial["changes"][0]["compatibility"] == "compatible"
    assert ask(SMALL).json()["digest"] == before


def test_a_trial_of_a_wrong_overlay_tells_where_it_is_wrong(ask: Ask) -> None:
    trial = ask(f"{SMALL}/trial?name=mine.vspec", "POST", content=b"Vehicle.Speed:\n  datatype: flot\n").json()
    assert not trial["ok"]
    assert [(f["file"], f["line"]) for f in trial["findings"] if f["severity"] == "error"] == [("mine.vspec", 2)]


def test_a_trial_that_makes_many_nodes_lists_the_first(ask: Ask) -> None:
    text = b"Vehicle.Seat:\n  type: branch\n  instances: Row[1,30]\n  description: A seat.\n"
    trial = ask(f"{SMALL}/trial", "POST", content=text).json()
    assert (trial["node_count"], len(trial["nodes"])) == (31, 5)


def test_a_trial_cannot_make_more_nodes_than_the_service_allows(ask: Ask) -> None:
    text = b"Vehicle.Seat:\n  type: branch\n  instances: ['A[1,900]', 'B[1,900]']\n  description: A seat.\n"
    trial = ask(f"{SMALL}/trial", "POST", content=text).json()
    assert [finding["rule"] for finding in trial["findings"]] == ["V025"]


@pytest.fixture(scope="module")
def releases(tmp_path_factory: pytest.TempPathFactory) -> Ask:
    return asker(create_app(Library([*chained_sources(tmp_path_factory.mktemp("releases")), *SOURCES]), SETTINGS))


def test_the_history_of_a_node_has_an_event_for_each_release_in_which_something_happened(releases: Ask) -> None:
    history = releases("/api/v1/catalogues/v5.0/nodes/Vehicle.Speed/history").json()
    assert [(each["kind"], each["release"], each["path"]) for each in history["events"]] == [
        (None, "3.1", "Vehicle.Velocity"),
        ("changed", "4.0", "Vehicle.Velocity"),
        ("moved", "5.0", "Vehicle.Speed"),
        ("removed", "6.0", None),
    ]
    assert history["events"][1]["attribute_changes"][0]["old_value"] == "km/h"
    assert history["events"][2]["old_path"] == "Vehicle.Velocity"
    assert history["releases"] == ["3.1", "4.0", "5.0", "6.0"]
    assert history["missing_releases"] == ["3.0", "4.1", "4.2", "5.1"]
    assert history["summary_text"].startswith("in 3.1 already; unit changed in 4.0; moved in 4.1 or 4.2 or 5.0 from")


def test_a_catalogue_that_is_of_no_release_has_no_events(releases: Ask) -> None:
    history = releases("/api/v1/catalogues/small/nodes/Vehicle.Speed/history").json()
    assert (history["release"], history["events"]) == (None, [])


def test_a_history_comes_as_yaml_and_an_unchanged_one_is_not_sent_twice(releases: Ask) -> None:
    address = "/api/v1/catalogues/v5.0/nodes/Vehicle.Speed/history"
    written = releases(address, headers={"Accept": "application/yaml"})
    assert "kind: moved" in written.text
    assert releases(address, headers={"If-None-Match": written.headers["etag"]}).status_code == 304
    assert releases(f"{address}?colour=red").status_code == 422


def test_the_history_of_a_node_that_does_not_exist_proposes_near_ones(releases: Ask) -> None:
    answer = releases("/api/v1/catalogues/v5.0/nodes/Vehicle.Sped/history")
    assert (answer.status_code, answer.json()["nearest"][:1]) == (404, ["Vehicle.Speed"])
