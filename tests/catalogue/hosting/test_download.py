"""Fetching from a server that misbehaves."""

import socket
from pathlib import Path

import pytest

from sigcat.catalogue.hosting.download import FetchFailed, fetch
from sigcat.limits import FetchLimits
from tests.catalogue.hosting.server import GOOD

LIMITS = FetchLimits(bytes=1_000_000)


def failure(address: str, tmp_path: Path, *, is_trusted: bool = True, limits: FetchLimits = LIMITS) -> str:
    """Why an address is not fetched."""
    with pytest.raises(FetchFailed) as failed:
        fetch(address, tmp_path / "file", is_trusted=is_trusted, limits=limits)
    return str(failed.value)


@pytest.mark.parametrize("path", ["good", "moved", "without-length"])
def test_a_file_arrives_whole(server, tmp_path, data, path):
    steps = []
    fetch(f"{server}/{path}", tmp_path / "file", is_trusted=True, progress=lambda *step: steps.append(step))
    assert (tmp_path / "file").read_bytes() == GOOD
    assert steps[-1] == (len(GOOD), None if path == "without-length" else len(GOOD))


@pytest.mark.parametrize(
    ("path", "reason"),
    [
        ("truncated", "the connection ended after"),
        ("endless", "more than 1,000,000 bytes"),
        ("huge", "10,000,000,000 bytes; the limit is"),
        ("loop", "redirects more than 5 times"),
        ("to-file", "redirects to 'file:///etc/passwd', which is not followed"),
        ("to-nowhere", "without an address"),
        ("to-other-port", "it must be https"),
        ("broken", "answers 503"),
        ("nothing-here", "answers 404 Not Found: there is no such file"),
    ],
)
def test_each_misbehaviour_has_its_clear_reason(server, tmp_path, data, path, reason):
    assert reason in failure(f"{server}/{path}", tmp_path)


@pytest.mark.parametrize(
    ("path", "limits", "reason"),
    [
        ("silent", LIMITS._replace(idle_seconds=0.5), "does not answer in time"),
        ("slow", LIMITS._replace(total_seconds=1.0), "took longer than 1 seconds"),
        ("slow-headers", LIMITS._replace(total_seconds=1.0), "took longer than 1 seconds"),
    ],
)
def test_a_server_that_takes_its_time_is_given_up(server, tmp_path, data, path, limits, reason):
    assert reason in failure(f"{server}/{path}", tmp_path, limits=limits)


def test_a_redirect_to_a_private_host_is_not_asked(server, tmp_path, data):
    reason = failure(f"{server}/to-private-https", tmp_path)
    assert "localhost" in reason
    assert "not a public address" in reason


def test_plain_http_and_private_hosts_are_only_for_addresses_that_the_user_named(server, tmp_path, data):
    assert "it must be https" in failure(f"{server}/good", tmp_path, is_trusted=False)


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost", "[::1]", "0.0.0.0", "127.1", "2130706433"])
def test_a_private_address_is_refused_however_it_is_written(tmp_path, data, host):
    with socket.create_server(("127.0.0.1", 0)) as listening:
        port = listening.getsockname()[1]
        reason = failure(f"https://{host}:{port}/", tmp_path, is_trusted=False)
    assert ("not a public address" if host != "[::1]" else "cannot be read") in reason


@pytest.mark.parametrize(
    "address", ["file:///etc/passwd", "ftp://host/file", "http://", "http://[", "gopher:x", "https://h:0/"]
)
def test_what_is_no_web_address_is_refused(tmp_path, data, address):
    assert "is no" in failure(address, tmp_path)


def test_a_host_that_is_not_there_is_a_reason_too(tmp_path, data):
    assert "cannot be read" in failure("http://127.0.0.1:9/file", tmp_path)
