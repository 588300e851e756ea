"""Health: what a container asks."""

from pathlib import Path

from sigcat.api.application import create_app
from sigcat.catalogue.hosting.library import Library
from sigcat.function.hosting import FunctionLibrary
from sigcat.limits import HOSTED_FUNCTION_BYTES
from tests.api.conftest import asker


def test_the_process_lives(ask):
    for path in ("/health", "/healthz", "/health/live"):
        assert ask(path).json() == {"state": "alive", "digests": {}, "outdated": [], "skipped": []}


def test_a_ready_service_tells_the_hash_of_each_catalogue(ask):
    answer = ask("/health/ready").json()
    assert answer["state"] == "ready"
    listed = {entry["id"]: entry["digest"] for entry in ask("/api/v1/catalogues").json()["catalogues"]}
    assert listed
    assert answer["digests"] == listed


def test_a_function_file_that_is_too_large_is_named(tmp_path: Path, library: Library) -> None:
    (tmp_path / "large.function.yaml").write_bytes(b"function: Large\n".ljust(HOSTED_FUNCTION_BYTES + 1, b"#"))
    functions = FunctionLibrary([tmp_path], has_shipped=False, catalogues=library)
    ready = asker(create_app(library, functions=functions))("/health/ready").json()
    assert ready["skipped"] == [f"{tmp_path.name}/large.function.yaml"]
