"""Unpacking of an archive, and archives that are refused before anything is written."""

import gzip
import io
import stat
import struct
import tarfile
import tracemalloc
import zipfile
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.catalogue.hosting.archive import ArchiveRefused, unpack
from sigcat.limits import ArchiveLimits
from tests.catalogue.hosting.archives import FILES, ROOT_FILE, TOP, everything_in, member, saved, tar_bytes, zip_bytes
from tests.properties import examples

KEPT = sorted(name for name in FILES if not name.startswith("docs/"))


def refusal(tmp_path: Path, data: bytes, limits: ArchiveLimits | None = None) -> str:
    """Why the archive is refused; nothing of it may be written."""
    folder = tmp_path / "unpacked"
    folder.mkdir()
    with pytest.raises(ArchiveRefused) as refused:
        unpack(saved(tmp_path, data), folder, limits or ArchiveLimits())
    assert everything_in(folder) == []
    return str(refused.value)


@pytest.mark.parametrize("data", [tar_bytes(), tar_bytes(mode="w"), zip_bytes()], ids=["tar.gz", "tar", "zip"])
def test_tree_overlays_and_licence_are_kept_and_nothing_else(tmp_path, data):
    folder = tmp_path / "unpacked"
    folder.mkdir()
    written = unpack(saved(tmp_path, data), folder)
    assert sorted(map(str, written)) == everything_in(folder) == KEPT
    assert (folder / ROOT_FILE).read_text() == FILES[ROOT_FILE]


@pytest.mark.parametrize("prefix", ["", "./", "./repository/", "a/b/c/"])
def test_the_tree_is_found_wherever_it_stands(tmp_path, prefix):
    buffer = io.BytesIO()
    with tarfile.open(fileobj=buffer, mode="w:gz") as tar:
        for info, data in [member(f"{prefix}{name}", text) for name, text in FILES.items()]:
            tar.addfile(info, io.BytesIO(data))
    folder = tmp_path / "unpacked"
    folder.mkdir()
    unpack(saved(tmp_path, buffer.getvalue()), folder)
    assert everything_in(folder) == KEPT


@pytest.mark.parametrize(
    "name",
    [
        "../evil", f"{TOP}/../../evil", f"{TOP}/spec/../../../evil", "/etc/evil", "..", f"{TOP}/spec/..",
        "C:/evil", "C:evil", f"{TOP}\\..\\..\\evil", "\\\\host\\share\\evil",
    ],
)  # fmt: skip
@pytest.mark.parametrize("pack", ["tar", "zip"])
def test_a_path_that_leads_out_is_refused(tmp_path, name, pack):
    data = tar_bytes([member(name, "evil")]) if pack == "tar" else zip_bytes({name: b"evil"})
    assert "leads out of the folder" in refusal(tmp_path, data)


@pytest.mark.parametrize("name", [f"{TOP}/spec/a\nb", f"{TOP}/spec/\x1b[31m", f"{TOP}//spec/a", f"{TOP}/./a"])
def test_a_path_that_is_none_is_refused(tmp_path, name):
    assert "not a usable path" in refusal(tmp_path, tar_bytes([member(name, "evil")]))


@pytest.mark.parametrize("name", [f"{TOP}/spec/{'a' * 300}", f"{TOP}{'/a' * 50}"])
def test_a_path_that_is_too_long_is_refused(tmp_path, name):
    assert "too long a path" in refusal(tmp_path, tar_bytes([member(name, "evil")]))


@pytest.mark.parametrize(
    ("name", "kind", "target"),
    [
        ("spec/link.vspec", tarfile.SYMTYPE, "/etc/passwd"),
        ("spec/link.vspec", tarfile.SYMTYPE, "../../../etc/passwd"),
        ("spec/link.vspec", tarfile.SYMTYPE, "Cabin/Cabin.vspec"),
        ("spec/link.vspec", tarfile.LNKTYPE, "/etc/passwd"),
        ("docs/link", tarfile.SYMTYPE, "/etc/passwd"),
        ("docs/link", tarfile.SYMTYPE, "../../outside"),
        ("docs/link", tarfile.LNKTYPE, "../../outside"),
        ("spec/Cabin", tarfile.SYMTYPE, "/tmp"),
    ],
)
def test_a_link_is_refused(tmp_path, name, kind, target):
    data = tar_bytes([member(f"{TOP}/{name}", type=kind, linkname=target)])
    assert "is a link" in refusal(tmp_path, data)


def test_a_link_among_what_is_not_kept_and_that_stays_inside_does_no_harm(tmp_path):
    data = tar_bytes([member(f"{TOP}/docs/latest", type=tarfile.SYMTYPE, linkname="../docs/index.md")])
    folder = tmp_path / "unpacked"
    folder.mkdir()
    unpack(saved(tmp_path, data), folder)
    assert everything_in(folder) == KEPT


def test_a_link_in_a_zip_is_refused(tmp_path):
    link = zipfile.ZipInfo(f"{TOP}/spec/link.vspec")
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    assert "is a link, to '/etc/passwd'" in refusal(tmp_path, zip_bytes({link: b"/etc/passwd"}))


@pytest.mark.parametrize("kind", [tarfile.CHRTYPE, tarfile.BLKTYPE, tarfile.FIFOTYPE])
def test_a_device_is_refused(tmp_path, kind):
    assert "neither a file nor a folder" in refusal(tmp_path, tar_bytes([member(f"{TOP}/spec/device", type=kind)]))


def test_the_same_path_twice_is_refused(tmp_path):
    assert "twice" in refusal(tmp_path, tar_bytes([member(f"{TOP}/{ROOT_FILE}", "Other:\n  type: branch\n")]))


def test_a_file_where_a_folder_stands_is_refused(tmp_path):
    folder = tmp_path / "unpacked"
    folder.mkdir()
    data = tar_bytes([member(f"{TOP}/spec/Cabin/Cabin.vspec/inside", "x")])
    with pytest.raises(ArchiveRefused):
        unpack(saved(tmp_path, data), folder)


def test_ten_gigabytes_are_refused_by_what_the_header_says(tmp_path):
    info, _ = member(f"{TOP}/docs/zeros")
    info.size = 10_000_000_000
    tar = gzip.decompress(tar_bytes())
    end = tar.rindex(b"# Not kept") // 512 * 512 + 512
    data = gzip.compress(tar[:end] + info.tobuf(tarfile.PAX_FORMAT) + b"\0" * 100_000)
    assert "unpacks to more than 536,870,912 bytes" in refusal(tmp_path, data)


@pytest.mark.parametrize("pack", ["tar", "zip"])
def test_what_grows_without_measure_is_refused(tmp_path, pack):
    zeros = b"\0" * 3_000_000
    data = tar_bytes([member(f"{TOP}/docs/zeros", zeros)]) if pack == "tar" else zip_bytes({f"{TOP}/docs/0": zeros})
    assert "20 times its size" in refusal(tmp_path, data, ArchiveLimits(ratio=20, free_bytes=100_000))


def counted(monkeypatch: pytest.MonkeyPatch, kind: Any) -> list[int]:
    """Number of bytes that each read of such a packed file returns, from now on."""
    read, sizes = kind.read, []

    def counting(self, *size):
        data = read(self, *size)
        sizes.append(len(data))
        return data

    monkeypatch.setattr(kind, "read", counting)
    return sizes


@pytest.mark.parametrize("pack", ["tar", "zip"])
def test_a_bomb_is_refused_before_half_of_it_is_unpacked_and_in_little_memory(tmp_path, pack, monkeypatch):
    zeros = b"\0" * 200_000_000
    data = tar_bytes([member(f"{TOP}/docs/0", zeros)]) if pack == "tar" else zip_bytes({f"{TOP}/docs/0": zeros})
    del zeros
    file = saved(tmp_path, data)
    tracemalloc.start()
    unpacked = counted(monkeypatch, gzip.GzipFile) if pack == "tar" else counted(monkeypatch, zipfile.ZipExtFile)
    with pytest.raises(ArchiveRefused, match="200 times its size"):
        unpack(file, tmp_path / "nowhere")
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert bool(unpacked) is (pack == "tar"), "a zip archive is refused by what its directory says"
    assert sum(unpacked) < 100_000_000
    assert peak < 5_000_000
    assert not (tmp_path / "nowhere").exists()


@pytest.mark.parametrize("pack", ["tar", "zip"])
def test_limits_on_bytes_and_files_are_kept(tmp_path, pack):
    data = tar_bytes() if pack == "tar" else zip_bytes()
    (tmp_path / "a").mkdir()
    assert "more than 300 bytes" in refusal(tmp_path / "a", data, ArchiveLimits(unpacked_bytes=300))
    (tmp_path / "b").mkdir()
    assert "more than 3 files" in refusal(tmp_path / "b", data, ArchiveLimits(entries=3))
    (tmp_path / "c").mkdir()
    assert "the limit is 50" in refusal(tmp_path / "c", data, ArchiveLimits(file_bytes=50))


def test_a_zip_whose_directory_alone_would_hurt_is_refused(tmp_path):
    data = bytearray(zip_bytes())
    struct.pack_into("<I", data, data.rindex(b"PK\x05\x06") + 12, 500_000_000)
    assert "too many files" in refusal(tmp_path, bytes(data))


@pytest.mark.parametrize(
    "data", [b"", b"<html>", b"\x1f\x8b", b"PK\x03\x04", b"PK\x05\x06", gzip.compress(b"x" * 9_999, mtime=0)]
)
def test_what_is_no_archive_is_refused(tmp_path, data):
    assert refusal(tmp_path, data)


def test_an_archive_without_a_tree_is_refused(tmp_path):
    message = refusal(tmp_path, tar_bytes(files={"README.md": "Nothing.\n"}))
    assert "not a release of VSS" in message


@pytest.mark.parametrize("data", [tar_bytes(), zip_bytes()], ids=["tar.gz", "zip"])
@pytest.mark.parametrize("part", [0.1, 0.5, 0.9, 0.98])
def test_a_truncated_archive_is_refused(tmp_path, data, part):
    assert refusal(tmp_path, data[: int(len(data) * part)])


def test_a_zip_that_points_to_before_its_beginning_is_refused(tmp_path):
    data = bytearray(zip_bytes())
    end = data.rindex(b"PK\x05\x06")
    start = struct.unpack_from("<I", data, end + 16)[0]
    struct.pack_into("<I", data, end + 16, start + 400)
    assert refusal(tmp_path, bytes(data))


@examples(150)
@given(position=st.integers(0, 10_000), byte=st.integers(0, 255), is_zip=st.booleans())
def test_a_damaged_archive_is_unpacked_or_refused_and_never_leads_out(tmp_path_factory, position, byte, is_zip):
    folder = tmp_path_factory.mktemp("damaged")
    data = bytearray(zip_bytes() if is_zip else tar_bytes(mode="w"))
    data[position % len(data)] = byte
    target = folder / "inner" / "target"
    target.mkdir(parents=True)
    with suppress(ArchiveRefused):
        unpack(saved(folder, bytes(data)), target)
    assert {path.name for path in folder.iterdir()} == {"archive", "inner"}
    assert {path.name for path in (folder / "inner").iterdir()} == {"target"}
