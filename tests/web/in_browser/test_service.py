"""One walk over HTTP through a service that runs in a separate process."""

from tests.plain_http import get, post


def test_from_the_tree_to_a_node_to_a_lint(service: str) -> None:
    api = f"{service}/api/v1"
    (first, *_) = get(f"{api}/catalogues").json()["catalogues"]
    tree = get(f"{api}/catalogues/{first['id']}/tree").json()
    leaf = next(child for child in tree["subtrees"] if child["type"] == "sensor")
    node = get(f"{api}/catalogues/{first['id']}/nodes/{leaf['path']}").json()
    assert node["name"] == leaf["name"]
    report = post(f"{api}/lint", content=b"Vehicle.Speed:\n  type: sensr\n").json()
    assert not report["ok"]
    assert report["findings"][0]["line"] == 2


def test_a_body_beyond_the_limit_is_refused_before_it_is_read(service: str) -> None:
    answer = post(f"{service}/api/v1/lint", content=b"a" * 5_000_000)
    assert answer.status_code == 413
    assert "4,194,304 bytes" in answer.json()["detail"]
