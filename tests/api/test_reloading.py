"""Reloading needs a token, takes a new state whole, and keeps the last good one."""

from pathlib import Path

import pytest

from sigcat.api.application import create_app
from sigcat.api.settings import Settings
from sigcat.api.tokens import new_token, token_from_text, token_named
from sigcat.catalogue.hosting.library import Library, Source, shipped_sources, tell_errors
from sigcat.function.hosting import FunctionLibrary
from tests.api.conftest import Ask, asker
from tests.function.test_hosting import noise

SECRET, TOKEN = new_token("ci", ["reload"])
READER, READ_TOKEN = new_token("reader", ["read"])
ADDRESS = "/api/v1/catalogues/mine/reload"
TREE = "Vehicle:\n  type: branch\n  description: A vehicle.\n"
SIGNAL = "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  description: Speed.\n"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    file = tmp_path / "tree.vspec"
    file.write_text(TREE)
    return file


@pytest.fixture
def mine(tree: Path) -> Ask:
    return asker(create_app(Library([Source("mine", "Mine", tree)]), Settings(tokens=(TOKEN, READ_TOKEN))))


def bearer(secret: str) -> dict[str, str]:
    return {"Authorization": f"Bearer {secret}"}


def test_a_reload_takes_the_new_state(mine: Ask, tree: Path) -> None:
    tree.write_text(TREE + SIGNAL)
    assert mine(ADDRESS, "POST", headers=bearer(SECRET)).json()["node_count"] == 2
    assert mine("/api/v1/catalogues/mine/nodes/Vehicle.Speed").status_code == 200


def test_a_broken_edit_keeps_the_last_good_state_and_says_so(mine: Ask, tree: Path) -> None:
    tree.write_text(TREE + SIGNAL.replace("sensor", "sensr"))
    answer = mine(ADDRESS, "POST", headers=bearer(SECRET)).json()
    assert (answer["node_count"], answer["findings"]) == (1, [])
    assert [finding["rule"] for finding in answer["rejected"]] == ["V001"]


def test_a_broken_edit_is_logged_and_leaves_addresses_with_a_version_as_they_are(
    mine: Ask, tree: Path, caplog: pytest.LogCaptureFixture
) -> None:
    before = mine("/api/v1/catalogues/mine")
    fixed = f"/api/v1/catalogues/mine@{before.json()['version']}"
    tree.write_text(TREE + SIGNAL.replace("sensor", "sensr"))
    mine(ADDRESS, "POST", headers=bearer(SECRET))
    after = mine("/api/v1/catalogues/mine")
    assert "V001" in caplog.text
    assert (mine(fixed).json(), after.json()["version"]) == (before.json(), before.json()["version"])
    assert after.headers["etag"] != before.headers["etag"]
    assert after.json()["rejected"]


def test_errors_that_are_there_from_the_start_are_logged(tree: Path, caplog: pytest.LogCaptureFixture) -> None:
    tree.write_text(TREE + SIGNAL.replace("sensor", "sensr"))
    tell_errors(Library([Source("mine", "Mine", tree)]))
    assert "no earlier valid version" in caplog.text
    assert "V001" in caplog.text


@pytest.mark.parametrize("headers", [{}, bearer("guess"), {"Authorization": f"Basic {SECRET}"}, bearer("")])
def test_without_a_token_there_is_no_reload(mine: Ask, headers: dict[str, str]) -> None:
    refused = mine(ADDRESS, "POST", headers=headers)
    assert refused.status_code == 401
    assert refused.headers["www-authenticate"].startswith("Bearer")
    assert refused.json()["type"] == "/problems/unauthorized"


def test_a_token_does_only_what_its_scopes_allow(mine: Ask) -> None:
    refused = mine(ADDRESS, "POST", headers=bearer(READER))
    assert refused.status_code == 403
    assert "'reload'" in refused.json()["detail"]


def test_only_hashes_of_tokens_are_kept() -> None:
    assert SECRET not in str(TOKEN)
    assert token_from_text(str(TOKEN)) == TOKEN
    assert token_named(SECRET, (READ_TOKEN, TOKEN)) == TOKEN
    assert token_named(SECRET[:-1], (READ_TOKEN, TOKEN)) is None


@pytest.mark.parametrize("text", ["", "ci", "ci:reload:123", f"ci:everything:{'0' * 64}", f"c i:read:{'0' * 64}"])
def test_a_token_that_is_written_wrong_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"scope|NAME"):
        token_from_text(text)


def test_functions_are_read_again(tree: Path, tmp_path: Path) -> None:
    folder = tmp_path / "functions"
    folder.mkdir()
    functions = FunctionLibrary([folder], has_shipped=False)
    ask = asker(create_app(Library([Source("mine", "Mine", tree)]), Settings(tokens=(TOKEN,)), functions))
    (folder / "noise.function.yaml").write_text("function: Noise\n")
    assert ask("/api/v1/functions/reload", "POST").status_code == 401
    answer = ask("/api/v1/functions/reload", "POST", headers=bearer(SECRET)).json()
    assert answer == {
        "functions": [{"id": "noise", "file": "functions/noise.function.yaml", "rejected": []}],
        "runs": [],
    }
    (folder / "drive.csv").write_text("time,call,Noise_Mode_Out\n")
    answer = ask("/api/v1/functions/reload", "POST", headers=bearer(SECRET)).json()
    assert answer["runs"] == [{"id": "drive", "file": "functions/drive.csv"}]


def test_a_function_that_breaks_keeps_its_last_good_state_and_health_and_metrics_say_so(tmp_path: Path) -> None:
    folder = tmp_path / "functions"
    folder.mkdir()
    file = folder / "noise.function.yaml"
    file.write_text(noise())
    library = Library(shipped_sources())
    ask = asker(create_app(library, Settings(tokens=(TOKEN,)), FunctionLibrary([folder], catalogues=library)))
    gauge = 'sigcat_function_rejected{function="noise"}'
    assert ask("/health/ready").json()["outdated"] == []
    assert f"{gauge} 0.0" in ask("/metrics").text
    file.write_text(noise(path="Vehicle.Sped"))
    answer = ask("/api/v1/functions/reload", "POST", headers=bearer(SECRET)).json()
    assert {each["id"] for each in answer["functions"] if each["rejected"]} == {"noise"}
    assert ask("/health/ready").json()["outdated"] == ["function noise"]
    assert f"{gauge} 1.0" in ask("/metrics").text


def test_health_names_catalogues_that_keep_an_older_state(mine: Ask, tree: Path) -> None:
    tree.write_text(TREE + SIGNAL.replace("sensor", "sensr"))
    mine(ADDRESS, "POST", headers=bearer(SECRET))
    assert mine("/health/ready").json()["outdated"] == ["catalogue mine"]
