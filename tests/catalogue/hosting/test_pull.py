"""Pulling a release: it is in the data folder completely, or not at all."""

import hashlib
import json
import os
import signal
import subprocess
import sys
import threading

import pytest

from sigcat.catalogue.hosting import releases
from sigcat.catalogue.hosting.archive import ArchiveRefused
from sigcat.catalogue.hosting.download import FetchFailed, FileMissing
from sigcat.catalogue.hosting.releases import (
    PullLimits,
    find_release,
    pulled_releases,
    release_name,
    releases_folder,
)
from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import release_source
from sigcat.errors import InputRefused, NotFound, UsageError
from sigcat.limits import FetchLimits
from tests.catalogue.hosting.archives import FILES, ROOT_FILE, TOP, everything_in, member, saved, tar_bytes, zip_bytes
from tests.catalogue.hosting.server import GOOD
from tests.needs import OFFICIAL, official_releases
from tests.waiting import wait_until

DIGEST = hashlib.sha256(GOOD).hexdigest()


def pull(name, origin="", digest="", **options):
    """Pull from the server of the tests, which is at a private address."""
    is_there = origin.startswith("http://127.0.0.1")
    return releases.pull(name, origin, digest, allows_private=is_there, **options)


IMPATIENT = PullLimits(fetch=FetchLimits(bytes=1_000_000, idle_seconds=0.5, total_seconds=1.0))


def test_a_release_is_kept_with_its_source_digest_date_and_size(server, data):
    release = pull("v5.0", f"{server}/moved", DIGEST)
    assert release == find_release("5.0") == pulled_releases()[0]
    assert release.source == f"{server}/good"
    assert release.digest == DIGEST
    assert release.nodes == 2
    assert release.folder == data / "releases" / "v5.0"
    assert release.spec.read_text() == FILES[ROOT_FILE]
    assert [path.name for path in release.overlays] == ["extra.vspec"]
    assert json.loads((release.folder / "release.json").read_text())["pulled"].endswith("+00:00")


def test_struct_types_of_a_release_belong_to_its_tree(tmp_path, data):
    """VSS keeps them in `spec/VehicleDataTypes.vspec`, which its Makefile passes as `--types`."""
    files = {
        **FILES,
        "spec/VehicleDataTypes.vspec": (
            "VehicleDataTypes: {type: branch, description: Types.}\n#include include/Position.vspec VehicleDataTypes\n"
        ),
        "spec/include/Position.vspec": (
            "Position: {type: struct, description: A place.}\n"
            "Position.Height: {type: property, datatype: float, description: Its height.}\n"
        ),
        "spec/Cabin/Cabin.vspec": (
            "Place: {type: sensor, datatype: VehicleDataTypes.Position, description: Where it is.}\n"
        ),
    }
    release = pull("v7.0", str(saved(tmp_path, tar_bytes(files=files))))
    catalogue = load(release_source("v7.0"))
    assert catalogue.findings == ()
    assert [layer.name for layer in catalogue.type_layers] == [str(release.types[0])]
    assert "VehicleDataTypes.Position.Height" in catalogue.nodes
    assert release.nodes == len(catalogue.nodes) == 5


def test_a_file_serves_as_well_and_the_content_digest_does_not_depend_on_the_packing(tmp_path, data):
    tar = pull("v5.0", str(saved(tmp_path, tar_bytes())))
    zipped = pull("v6.0", str(saved(tmp_path, zip_bytes())))
    assert tar.content_digest == zipped.content_digest
    assert tar.digest != zipped.digest
    assert [release.name for release in pulled_releases()] == ["v5.0", "v6.0"]


def test_the_address_of_a_release_is_the_source_archive_of_its_tag(monkeypatch, data):
    asked = []

    def fetch(address, target, **_):
        asked.append(address)
        target.write_bytes(GOOD)
        return address

    monkeypatch.setattr(releases, "fetch", fetch)
    pull("4.1")
    assert asked == ["https://github.com/COVESA/vehicle_signal_specification/archive/refs/tags/v4.1.tar.gz"]


def test_without_a_network_the_way_around_it_is_named(monkeypatch, data):
    def fetch(address, target, **_):
        raise FetchFailed("github.com cannot be read: Network is unreachable")

    monkeypatch.setattr(releases, "fetch", fetch)
    with pytest.raises(FetchFailed, match=r"cannot be read: .+ bring https://.+/v4\.1\.tar\.gz here and .* --from$"):
        pull("4.1")


def test_a_private_address_is_asked_only_if_that_is_allowed(server, data):
    with pytest.raises(FetchFailed, match="not a public address; --allow-private asks it all the same"):
        releases.pull("v5.0", f"{server}/good")
    assert releases.pull("v5.0", f"{server}/good", allows_private=True).source == f"{server}/good"


@pytest.mark.parametrize("origin", ["", "archive.tar.gz"])
def test_allowing_private_addresses_needs_one(data, origin):
    with pytest.raises(UsageError, match="--allow-private is for the address that --from names"):
        releases.pull("v5.0", origin, allows_private=True)


def test_a_file_that_is_missing_is_told_from_a_missing_network(server, data):
    with pytest.raises(FileMissing):
        pull("4.1", f"{server}/none")


def test_a_release_that_is_here_is_not_fetched_again(server, data):
    first = pull("v5.0", f"{server}/good")
    assert pull("v5.0", f"{server}/broken") == first
    with pytest.raises(InputRefused, match="is here already"):
        pull("v5.0", f"{server}/good", "0" * 64)


@pytest.mark.parametrize(
    ("path", "digest"),
    [
        ("truncated", ""), ("truncated-without-length", ""), ("silent", ""), ("slow", ""), ("slow-headers", ""),
        ("endless", ""), ("huge", ""), ("loop", ""), ("to-file", ""), ("to-other-port", ""),
        ("to-private-https", ""), ("no-archive", ""), ("broken", ""), ("nothing-here", ""), ("good", "0" * 64),
    ],
)  # fmt: skip
def test_what_is_refused_leaves_nothing_behind(server, data, path, digest):
    with pytest.raises((FetchFailed, InputRefused)):
        pull("v5.0", f"{server}/{path}", digest, limits=IMPATIENT)
    assert list(releases_folder().iterdir()) == []
    assert pulled_releases() == ()


@pytest.mark.parametrize("name", ["../../evil", f"{TOP}/../../evil", "/tmp/evil"])
def test_an_archive_that_leads_out_leaves_nothing_behind(tmp_path, data, name):
    with pytest.raises(ArchiveRefused):
        pull("v5.0", str(saved(tmp_path, tar_bytes([member(name, "evil")]))))
    assert list(releases_folder().iterdir()) == []
    assert everything_in(tmp_path) == ["archive"]


def test_a_tree_that_cannot_be_read_is_refused_with_its_findings(tmp_path, data):
    files = {**FILES, ROOT_FILE: "Vehicle:\n  type: branch\n#include Missing.vspec\n"}
    with pytest.raises(InputRefused) as refused:
        pull("v5.0", str(saved(tmp_path, tar_bytes(files=files))))
    assert [(finding.rule, finding.file) for finding in refused.value.findings] == [("R008", ROOT_FILE)]
    assert list(releases_folder().iterdir()) == []


def of_version(major: int, minor: int, patch: int) -> bytes:
    """An archive whose tree says which release it is."""
    version = "".join(
        f"Vehicle.VersionVSS.{name}: {{type: attribute, datatype: uint32, default: {number}, description: {name}.}}\n"
        for name, number in (("Major", major), ("Minor", minor), ("Patch", patch))
    )
    branch = "Vehicle.VersionVSS: {type: branch, description: Version.}\n"
    return tar_bytes(files={**FILES, ROOT_FILE: f"{FILES[ROOT_FILE]}\n{branch}{version}"})


@pytest.mark.parametrize("name", ["v5.0", "v6.0.1", "v60.0", "v6.1-rc1"])
def test_a_release_that_says_it_is_another_one_is_refused(tmp_path, data, name):
    with pytest.raises(InputRefused, match=rf"is release v6\.0\.0 .* not {name}"):
        pull(name, str(saved(tmp_path, of_version(6, 0, 0))))
    assert list(releases_folder().iterdir()) == []


@pytest.mark.parametrize("name", ["6.0", "v6.0.0", "v6.0-rc1", "acme-2024"])
def test_a_release_is_what_it_says_and_other_names_are_free(tmp_path, data, name):
    assert pull(name, str(saved(tmp_path, of_version(6, 0, 0)))).name == release_name(name)


def test_a_release_that_cannot_be_used_replaces_none(tmp_path, data):
    pull("v5.0", str(saved(tmp_path, of_version(5, 0, 0))))
    with pytest.raises(InputRefused):
        pull("v5.0", str(saved(tmp_path, of_version(6, 0, 0))), replaces=True)
    assert "default: 5" in find_release("v5.0").spec.read_text()


@pytest.mark.parametrize("origin", ["file:///etc/passwd", "ftp://host/x", "missing.tar.gz", "."])
def test_an_origin_is_a_web_address_or_a_file(data, origin):
    with pytest.raises(UsageError):
        pull("v5.0", origin)


@pytest.mark.parametrize("name", ["../v5.0", "v5.0/x", "", ".hidden", "a" * 100, "v5\n"])
def test_names_that_could_be_paths_are_refused(data, name):
    with pytest.raises(UsageError):
        pull(name, "x")


def test_without_an_origin_a_name_has_to_be_a_version(data):
    with pytest.raises(UsageError, match="is not a version"):
        pull("master")


@pytest.mark.parametrize(
    ("text", "name"),
    [("5.0", "v5.0"), ("V5.0", "v5.0"), ("v3.1.1", "v3.1.1"), ("6.0-rc1", "v6.0-rc1"), ("acme-2024", "acme-2024")],
)
def test_versions_are_tags(text, name):
    assert release_name(text) == name


@pytest.mark.parametrize("digest", ["abc", "g" * 64, "md5:" + "0" * 32])
def test_a_digest_that_is_none_is_refused(data, digest):
    with pytest.raises(UsageError, match="SHA-256"):
        pull("v5.0", "x", digest)


def test_what_is_not_here_is_told_with_how_to_pull_it(server, data):
    pull("v5.0", f"{server}/good", f"SHA256:{DIGEST.upper()}")
    with pytest.raises(NotFound, match=r"Pulled are v5\.0\. Run `sigcat pull v5\.1`"):
        find_release("5.1")


def test_releases_are_listed_by_version_and_broken_records_are_not(server, data):
    for name in ("v10.0", "v3.1.1", "v3.1"):
        pull(name, f"{server}/good")
    (data / "releases" / "v9").mkdir()
    (data / "releases" / "v9" / "release.json").write_text("{")
    assert [release.name for release in pulled_releases()] == ["v3.1", "v3.1.1", "v10.0"]


def test_two_pulls_at_once_leave_one_release(server, data):
    found = []
    threads = [threading.Thread(target=lambda: found.append(pull("v5.0", f"{server}/good"))) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 8
    assert len({release.folder for release in found}) == 1
    assert [path.name for path in releases_folder().iterdir()] == ["v5.0"]


_PULL = """
import os, signal, sys
from sigcat.catalogue.hosting.releases import pull
address, last = sys.argv[1:]

def step(event, arguments):
    path = str(arguments[0]) if arguments else ""
    if os.environ["SIGCAT_DATA"] in path and f"{event} {os.path.basename(path)}".startswith(last):
        os.kill(os.getpid(), signal.SIGKILL)

if last:
    sys.addaudithook(step)
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell in the background has it ignored
pull("v5.0", address, allows_private=True)
"""


def pulling(address: str, killed_at: str = "") -> "subprocess.Popen[bytes]":
    """A pull in a separate process, which kills itself before the first step in the data folder that is this one."""
    return subprocess.Popen([sys.executable, "-c", _PULL, address, killed_at], stderr=subprocess.DEVNULL)


@pytest.mark.skipif(os.name != "posix", reason="POSIX, where a dead process is distinguished from a living one")
@pytest.mark.parametrize(
    "step",
    ["open release.json", "os.mkdir releases", "open archive", "os.mkdir content", "open Cabin.vspec", "open LICENSE",
     "os.rename content", "shutil.rmtree"],
)  # fmt: skip
def test_a_pull_that_is_killed_leaves_no_release_and_the_next_one_cleans_up(server, data, step):
    assert pulling(f"{server}/good", killed_at=step).wait() == -signal.SIGKILL
    for release in pulled_releases():
        assert everything_in(release.folder) == sorted(
            [*(n for n in FILES if not n.startswith("docs")), "release.json"]
        )
    pull("v5.0", f"{server}/good")
    pull("v6.0", f"{server}/good")
    assert sorted(path.name for path in releases_folder().iterdir()) == ["v5.0", "v6.0"]


@pytest.mark.skipif(os.name != "posix", reason="the signals of POSIX")
def test_a_pull_that_is_interrupted_cleans_up_by_itself(server, data):
    process = pulling(f"{server}/slow")
    wait_until(lambda: list(releases_folder().glob(".pull-*/archive")), "the download begins")
    process.send_signal(signal.SIGINT)
    assert process.wait() != 0
    assert list(releases_folder().iterdir()) == []


@official_releases
@pytest.mark.parametrize(("name", "nodes"), [("v5.0", 1411), ("v6.0", 1607)])
def test_official_releases_are_pulled_whole(tmp_path, data, name, nodes):
    archive = tmp_path / "release.tar.gz"
    subprocess.run(["tar", "-C", OFFICIAL, "-czf", archive, "--", name], check=True)
    release = pull(name, str(archive))
    assert release.nodes == nodes
    official = {str(path.relative_to(OFFICIAL / name)) for path in (OFFICIAL / name).rglob("*") if path.is_file()}
    assert everything_in(release.folder) == sorted({*official, "release.json"})
