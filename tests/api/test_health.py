"""Health: what a container asks."""


def test_the_process_lives(ask):
    for path in ("/health", "/healthz", "/health/live"):
        assert ask(path).json() == {"state": "alive", "digests": {}, "outdated": [], "skipped": []}


def test_a_ready_service_tells_the_hash_of_each_catalogue(ask):
    answer = ask("/health/ready").json()
    assert answer["state"] == "ready"
    listed = {entry["id"]: entry["digest"] for entry in ask("/api/v1/catalogues").json()["catalogues"]}
    assert listed
    assert answer["digests"] == listed
