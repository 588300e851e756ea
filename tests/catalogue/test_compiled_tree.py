"""The shipped tree is parsed once and is the same afterwards; a file that changed in any way is parsed."""

import os
import shutil
from pathlib import Path

import pytest

from sigcat.catalogue.reading import compiled_tree, layers
from sigcat.catalogue.reading.layers import read_layer
from sigcat.catalogue.reading.vspec_file import parse_vspec
from sigcat.data import VSPEC
from sigcat.limits import DEFAULT_LIMITS

ANY_LIMITS = DEFAULT_LIMITS._replace(nodes=DEFAULT_LIMITS.nodes - 1)
"""With given limits, everything is parsed."""


@pytest.fixture
def root(tmp_path, monkeypatch):
    """A copy of the shipped tree that is taken for the shipped one, and nothing kept of it."""
    monkeypatch.setattr("sys.dont_write_bytecode", False)
    monkeypatch.setattr("sys.pycache_prefix", None)
    monkeypatch.setattr(compiled_tree, "FOLDER", tmp_path / "kept")
    (tmp_path / "kept").mkdir()
    shutil.copytree(VSPEC, tmp_path / "vspec")
    root = tmp_path / "vspec" / "VehicleSignalSpecification.vspec"
    monkeypatch.setattr(compiled_tree, "ROOT_FILE", root)
    return root


@pytest.fixture
def parsed(monkeypatch):
    """Names of the files that are parsed."""
    names = []

    def recorded(data, source, limits):
        names.append(Path(source.name).name)
        return parse_vspec(data, source, limits)

    monkeypatch.setattr(layers, "parse_vspec", recorded)
    return names


def everything(layer):
    """All that a layer knows, positions of items included."""
    return layer.files, layer.findings, [
        (s.path, s.file, s.values, list(s.values), s.origin(), [s.origin_of_key(name) for name in s.values],
         [s.origin_within(name, [0]) for name, value in s.values.items() if isinstance(value, list | dict)])
        for s in layer.statements
    ]  # fmt: skip


def kept(root):
    (file,) = (root.parents[1] / "kept" / "__pycache__").iterdir()
    return file


def test_what_is_kept_is_what_the_files_say(root, parsed):
    first = everything(read_layer(root))
    assert len(parsed) == len(first[0])
    assert everything(read_layer(root)) == first == everything(read_layer(root, limits=ANY_LIMITS))
    assert len(parsed) == 2 * len(first[0]), "the second reading parses nothing, the third everything"


def test_a_changed_file_is_parsed_even_if_it_looks_the_same(root, parsed):
    read_layer(root)
    file = next(root.parent.rglob("Body.vspec"))
    before = file.stat()
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("type: sensor", "type: seNsor", 1), encoding="utf-8")
    os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert (file.stat().st_size, file.stat().st_mtime_ns) == (before.st_size, before.st_mtime_ns)
    parsed.clear()
    assert "seNsor" in [s.values.get("type") for s in read_layer(root).statements]
    assert parsed == ["Body.vspec"]
    parsed.clear()
    assert everything(read_layer(root)) == everything(read_layer(root, limits=ANY_LIMITS))


def test_the_same_bytes_elsewhere_are_told_of_where_they_are(root):
    read_layer(root)
    body, chassis = (next(root.parent.rglob(name)) for name in ("Body.vspec", "Chassis.vspec"))
    chassis.write_bytes(body.read_bytes())
    assert everything(read_layer(root)) == everything(read_layer(root, limits=ANY_LIMITS))


def test_findings_are_found_each_time(root):
    file = next(root.parent.rglob("Body.vspec"))
    file.write_text(f"{file.read_text(encoding='utf-8')}\nNumber: 1\n", encoding="utf-8")
    found = read_layer(root).findings
    assert found
    assert read_layer(root).findings == found


def test_another_tree_is_not_kept(root, tmp_path, parsed):
    other = Path(shutil.copytree(root.parent, tmp_path / "other")) / root.name
    read_layer(other)
    parsed.clear()
    assert len(read_layer(other).files) == len(parsed)
    assert not (tmp_path / "kept" / "__pycache__").exists()


def test_changed_code_parses_again(root, parsed, monkeypatch, tmp_path):
    read_layer(root)
    edited = tmp_path / "edited.py"
    edited.write_bytes(b"# edited\n")
    monkeypatch.setattr(compiled_tree, "CODE", (*compiled_tree.CODE, edited))
    parsed.clear()
    assert len(read_layer(root).files) == len(parsed)


@pytest.mark.parametrize("data", [b"", b"x", b"(\x02\x00\x00\x00", b"i\x01\x00\x00\x00", b"\x00" * 100, b"N"])
def test_what_is_damaged_is_not_used(root, data):
    first = everything(read_layer(root))
    kept(root).write_bytes(data)
    assert everything(read_layer(root)) == first


def test_a_folder_that_cannot_be_written_is_left_alone(root, monkeypatch):
    monkeypatch.setattr("sys.dont_write_bytecode", True)
    read_layer(root)
    assert not (root.parents[1] / "kept" / "__pycache__").exists()
