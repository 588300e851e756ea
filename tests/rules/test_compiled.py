"""Rules are read from YAML once and are the same afterwards; what is kept never outlives the files or the code that reads them."""

import shutil
from pathlib import Path

import pytest

from sigcat.data import INTERFACE_RULES
from sigcat.errors import InputRefused
from sigcat.rules import compiled
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.record import load_rules


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setattr("sys.dont_write_bytecode", False)
    monkeypatch.setattr("sys.pycache_prefix", None)
    shutil.copytree(INTERFACE_RULES, tmp_path / "rules", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path / "rules"


def kept(folder):
    (file,) = (folder / "__pycache__").iterdir()
    return file


def test_kept_rules_are_those_of_the_files(folder):
    rules = load_rules(folder)
    assert compiled_rules(folder) == rules
    assert kept(folder).stat().st_size
    assert compiled_rules(folder) == rules


def test_a_changed_file_is_read_again(folder):
    compiled_rules(folder)
    file = folder / "vss.yaml"
    file.write_text(file.read_text(encoding="utf-8").replace("severity: error", "severity: warning"), encoding="utf-8")
    assert compiled_rules(folder) == load_rules(folder)


@pytest.mark.parametrize("module", ["record", "yaml_document", "compiled"])
def test_rules_are_read_again_by_changed_code(folder, module, monkeypatch, tmp_path):
    compiled_rules(folder)
    before = kept(folder).read_bytes()
    code = {Path(file).stem: Path(file) for file in compiled.CODE}
    edited = tmp_path / "edited.py"
    edited.write_bytes(code[module].read_bytes() + b"# edited\n")
    monkeypatch.setattr(compiled, "CODE", tuple(edited if file == code[module] else file for file in code.values()))
    assert compiled_rules(folder) == load_rules(folder)
    assert kept(folder).read_bytes() != before


@pytest.mark.parametrize("data", [b"", b"x", b"(\x02\x00\x00\x00", b"i\x01\x00\x00\x00", b"\x00" * 100, b"N"])
def test_what_is_damaged_is_not_used(folder, data):
    compiled_rules(folder)
    kept(folder).write_bytes(data)
    assert compiled_rules(folder) == load_rules(folder)


def test_rules_are_read_where_nothing_can_be_kept(folder):
    (folder / "__pycache__").write_text("in the way")
    assert compiled_rules(folder) == load_rules(folder)


def test_a_defect_is_reported_and_nothing_is_kept(folder):
    (folder / "own.yaml").write_text("X001: {}\n")
    with pytest.raises(InputRefused):
        compiled_rules(folder)
    assert not (folder / "__pycache__").exists()
