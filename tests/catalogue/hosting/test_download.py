"""Fetching from a server that misbehaves."""

import socket
from collections.abc import Mapping, Sequence
from pathlib import Path
from urllib.parse import urlsplit

import pytest

from sigcat.catalogue.hosting.download import FetchFailed, fetch
from sigcat.catalogue.hosting.public_network import Network, Place, is_public
from sigcat.limits import FetchLimits
from tests.catalogue.hosting.server import GOOD

LIMITS = FetchLimits(bytes=1_000_000)


def failure(address: str, tmp_path: Path, *, is_named: bool = True, limits: FetchLimits = LIMITS) -> str:
    """Why an address is not fetched, though it may be a private one."""
    with pytest.raises(FetchFailed) as failed:
        fetch(address, tmp_path / "file", is_named=is_named, allows_private=True, limits=limits)
    return str(failed.value)


@pytest.mark.parametrize("path", ["good", "moved", "without-length"])
def test_a_file_arrives_whole(server, tmp_path, data, path):
    steps = []
    progress = lambda *step: steps.append(step)  # noqa: E731
    fetch(f"{server}/{path}", tmp_path / "file", is_named=True, allows_private=True, progress=progress)
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


def test_plain_http_is_only_for_addresses_that_the_user_named(server, tmp_path, data):
    assert "it must be https" in failure(f"{server}/good", tmp_path, is_named=False)


# -- which addresses are asked, with a resolver of the tests: none outside this machine ever is ------------------------

PUBLIC, OTHER = "93.184.215.14", "2606:2800:21f:cb07:6820:80da:af6b:8b2c"
PRIVATE = (
    "127.0.0.1", "127.9.9.9", "::1", "0.0.0.0", "::", "10.1.2.3", "172.16.0.1", "192.168.1.1", "100.64.0.1", "169.254.169.254",
    "fe80::1", "fe80::1%eth0", "fd00::1", "fec0::1", "224.0.0.1", "239.255.255.250", "ff02::1", "ff0e::1", "255.255.255.255", "240.0.0.1",
    "192.0.2.1", "2001:db8::1", "::ffff:127.0.0.1", "::ffff:93.184.215.14", "2002:7f00:1::", "2001:0:7f00:1::", "64:ff9b::7f00:1",
    "64:ff9b::a9fe:a9fe",
)  # fmt: skip


class Names:
    """A network of names: each resolves to the next of its answers. Public addresses lead to a server of this machine."""

    def __init__(self, answers: Mapping[str, Sequence[Sequence[str]]], server: str) -> None:
        self._answers = {name: list(each) for name, each in answers.items()}
        self._server = urlsplit(server)
        self.connected: list[str] = []
        self.network = Network(self._resolve, self._connect)

    def _resolve(self, host: str, port: int) -> list[Place]:
        answers = self._answers[host]
        addresses = answers.pop(0) if len(answers) > 1 else answers[0]
        return [Place(socket.AF_INET6 if ":" in each else socket.AF_INET, (each, port)) for each in addresses]

    def _connect(self, place: Place, seconds: float | None) -> socket.socket:
        self.connected.append(place.address[0])
        return socket.create_connection((self._server.hostname, self._server.port), seconds)

    def fetched(self, address: str, target: Path, *, is_named: bool = True, allows_private: bool = False) -> str:
        """The address that it came from, or why it was refused."""
        try:
            return fetch(
                address,
                target,
                is_named=is_named,
                allows_private=allows_private,
                limits=LIMITS,
                network=self.network,
            )
        except FetchFailed as failed:
            return str(failed)


def test_public_addresses_are_public():
    assert is_public(PUBLIC)
    assert is_public(OTHER)
    assert is_public("64:ff9b::5db8:d70e"), "the public address behind a network that has no IPv4"
    assert not any(map(is_public, PRIVATE))


@pytest.mark.parametrize("address", PRIVATE)
def test_a_private_address_is_not_even_connected_to_whoever_names_it(server, tmp_path, data, address):
    names = Names({"mirror.example": [[address]]}, server)
    for is_named in (True, False):
        reason = names.fetched("https://mirror.example/file", tmp_path / "file", is_named=is_named)
        assert f"mirror.example is not asked: {address} is not a public address" in reason
        assert ("--allow-private" in reason) == is_named
    assert names.connected == []


@pytest.mark.parametrize(
    "host", ["127.0.0.1", "localhost", "[::1]", "0.0.0.0", "127.1", "2130706433", "0x7f.1", "[::ffff:7f00:1]"]
)
def test_a_private_address_is_refused_however_it_is_written(tmp_path, data, host):
    with socket.create_server(("127.0.0.1", 0)) as listening:
        port = listening.getsockname()[1]
        with pytest.raises(FetchFailed, match="is not a public address; --allow-private"):
            fetch(f"http://{host}:{port}/", tmp_path / "file", is_named=True, limits=LIMITS)
        listening.settimeout(0.05)
        with pytest.raises(TimeoutError):
            listening.accept()


def test_what_was_checked_is_what_is_connected_to_though_the_name_changes_its_mind(server, tmp_path, data):
    names = Names({"mirror.example": [[PUBLIC], ["127.0.0.1"]]}, server)
    assert names.fetched("http://mirror.example/good", tmp_path / "file") == "http://mirror.example/good"
    assert names.connected == [PUBLIC]
    assert "is not a public address" in names.fetched("http://mirror.example/good", tmp_path / "file")
    assert names.connected == [PUBLIC]


def test_of_several_addresses_only_public_ones_are_tried(server, tmp_path, data):
    names = Names({"mirror.example": [["10.0.0.1", OTHER, "::1", PUBLIC]]}, server)
    assert names.fetched("http://mirror.example/good", tmp_path / "file") == "http://mirror.example/good"
    assert names.connected == [OTHER]


@pytest.mark.parametrize("allows_private", [True, False])
@pytest.mark.parametrize("address", ["10.0.0.1", "169.254.169.254", "::1"])
def test_a_redirect_to_a_private_address_is_never_followed(server, tmp_path, data, address, allows_private):
    names = Names({"mirror.example": [[PUBLIC]], "inside.example": [[address]]}, server)
    reason = names.fetched("http://mirror.example/to-inside", tmp_path / "file", allows_private=allows_private)
    assert reason == f"inside.example is not asked: {address} is not a public address"
    assert names.connected == [PUBLIC]


def test_a_redirect_to_the_same_name_is_checked_again(server, tmp_path, data):
    names = Names({"mirror.example": [[PUBLIC], ["127.0.0.1"]]}, server)
    assert "127.0.0.1 is not a public address" in names.fetched("http://mirror.example/moved", tmp_path / "file")
    assert names.connected == [PUBLIC]


def test_a_private_mirror_is_asked_if_the_user_says_so(server, tmp_path, data):
    names = Names({"mirror.example": [["10.0.0.1"]]}, server)
    assert (
        names.fetched("http://mirror.example/moved", tmp_path / "file", allows_private=True)
        == "http://mirror.example/good"
    )
    assert names.connected == ["10.0.0.1"] * 2


@pytest.mark.parametrize("host", ["169.254.169.254", "127.1", "[fd00::1]"])
def test_a_proxy_is_not_asked_for_private_addresses(server, tmp_path, data, monkeypatch, host):
    monkeypatch.setenv("http_proxy", "http://proxy.example:3128")
    names = Names({"proxy.example": [["10.0.0.9"]]}, server)
    assert "is not a public address" in names.fetched(f"http://{host}/good", tmp_path / "file")
    assert names.connected == []


def test_a_proxy_may_be_at_a_private_address(server, tmp_path, data, monkeypatch):
    monkeypatch.setenv("http_proxy", "http://proxy.example:3128")
    names = Names({"proxy.example": [["10.0.0.9"]]}, server)
    assert "mirror.example answers 404" in names.fetched("http://mirror.example/good", tmp_path / "file")
    assert names.connected == ["10.0.0.9"]


@pytest.mark.parametrize(
    "host", ["１２７.０.０.１", "bücher.example", "a..example", "a" * 64 + ".example", ".", "h\u00df.example", "h/ä"]
)
def test_a_host_that_cannot_be_asked_for_is_refused_in_words(tmp_path, data, host):
    assert "is not an address as it is sent: in ASCII" in failure(f"http://{host}", tmp_path)


@pytest.mark.parametrize(
    "address", ["file:///etc/passwd", "ftp://host/file", "http://", "http://[", "gopher:x", "https://h:0/"]
)
def test_what_is_no_web_address_is_refused(tmp_path, data, address):
    assert "is no" in failure(address, tmp_path)


def test_a_host_that_is_not_there_is_a_reason_too(tmp_path, data):
    assert "cannot be read" in failure("http://127.0.0.1:9/file", tmp_path)
