"""One walk over HTTP through a service that runs in a process of its own."""

import httpx

from tests import plain_http


def test_from_the_tree_to_a_node_to_a_lint(service: str) -> None:
    with httpx.Client(base_url=service) as client:
        (first, *_) = client.get("/api/v1/catalogues").json()["catalogues"]
        tree = client.get(f"/api/v1/catalogues/{first['id']}/tree").json()
        leaf = next(child for child in tree["subtrees"] if child["type"] == "sensor")
        node = client.get(f"/api/v1/catalogues/{first['id']}/nodes/{leaf['path']}").json()
        assert node["name"] == leaf["name"]
        report = client.post("/api/v1/lint", content=b"Vehicle.Speed:\n  type: sensr\n").json()
        assert not report["ok"]
        assert report["findings"][0]["line"] == 2


def test_a_body_beyond_the_limit_is_refused_before_it_is_read(service: str) -> None:
    answer = plain_http.post(f"{service}/api/v1/lint", content=b"a" * 5_000_000)
    assert answer.status_code == 413
    assert "4,194,304 bytes" in answer.json()["detail"]
