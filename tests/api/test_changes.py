"""Changes between hosted catalogues, and changes that an overlay would make."""

from tests.api.conftest import Ask

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
