"""A template is compiled once for all processes, and again when it or its options change."""

import os
from pathlib import Path

import pytest
from jinja2 import Environment, FileSystemLoader

from sigcat.compiled_templates import CompiledTemplates


class Folder:
    """Templates in a folder, beside the module that sets their options."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.options = path / "environment.py"
        self.options.write_text("options = 1\n")
        self.compiled: list[str] = []

    def write(self, text: str) -> None:
        (self.path / "a.txt.j2").write_text(text)

    def text(self) -> str:
        """The text that a process renders which has loaded nothing yet."""
        environment = Environment(
            loader=FileSystemLoader(self.path), autoescape=True, bytecode_cache=CompiledTemplates(self.options)
        )
        once = environment.compile

        def compiled(source: str, name: str, filename: str) -> object:
            self.compiled.append(name)
            return once(source, name, filename)

        environment.__dict__["compile"] = compiled
        return environment.get_template("a.txt.j2").render(name="Speed")

    def kept(self) -> list[Path]:
        return sorted((self.path / "__pycache__").glob("*"))


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setattr("sys.dont_write_bytecode", False)
    monkeypatch.setattr("sys.pycache_prefix", None)
    made = Folder(tmp_path)
    made.write("{{ name }}")
    return made


def test_the_second_process_compiles_nothing(folder):
    assert [folder.text(), folder.text()] == ["Speed", "Speed"]
    assert folder.compiled == ["a.txt.j2"]


def test_another_text_is_compiled_though_size_and_time_are_the_same(folder):
    file = folder.path / "a.txt.j2"
    before = file.stat()
    folder.text()
    folder.write("{{'Mean'}}")
    os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert file.stat().st_size == before.st_size
    assert folder.text() == "Mean"


def test_other_options_compile_again(folder):
    folder.text()
    folder.options.write_text("options = 22\n")
    folder.text()
    assert folder.compiled == ["a.txt.j2"] * 2


@pytest.mark.parametrize("damage", [b"", b"\0", b"not marshal"])
def test_a_damaged_file_is_written_again(folder, damage):
    folder.text()
    (kept,) = folder.kept()
    kept.write_bytes(damage)
    assert [folder.text(), folder.text()] == ["Speed", "Speed"]
    assert folder.compiled == ["a.txt.j2"] * 2


def test_nothing_is_kept_where_python_keeps_nothing(folder, monkeypatch):
    monkeypatch.setattr("sys.dont_write_bytecode", True)
    assert folder.text() == "Speed"
    assert folder.kept() == []
