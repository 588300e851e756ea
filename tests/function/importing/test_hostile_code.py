"""Errors in a folder of C code are findings, whatever the folder contains, within a bounded time."""

import os
from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.errors import InputRefused, UsageError
from sigcat.function.c_project import files, parsing
from sigcat.function.c_project.project import CodeProject
from sigcat.function.c_project.read_project import read_project

SOUND = "#pragma once\nextern float speed; /* '<Root>/speed' */\nvoid wash_init(void);\nvoid wash_step(void);\n"
SOURCE = '#include "wash.h"\nfloat speed;\nvoid wash_init(void) {}\nvoid wash_step(void) { (void)speed; }\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "wash.h").write_text(SOUND)
    (tmp_path / "wash.c").write_text(SOURCE)
    return tmp_path


def imported(folder: Path) -> CodeProject:
    return read_project(folder, "Washing")


def rules(project: CodeProject) -> set[str]:
    return {finding.rule for finding in project.findings}


def test_the_code_that_they_change_is_sound(folder):
    project = imported(folder)
    assert [value.expression for value in project.interface.inputs] == ["speed"]
    assert project.findings == ()


@pytest.mark.parametrize(
    "data",
    [b"\0\1\2" * 1000, b"\x7fELF\0\0", "void speed_step(void);".encode("utf-16")],
    ids=["zeros", "program", "utf-16"],
)
def test_a_binary_file_is_left_out(folder, data):
    (folder / "binary.h").write_bytes(data)
    (finding,) = imported(folder).findings
    assert (finding.rule, finding.file) == ("S001", "binary.h")


@pytest.mark.parametrize("comment", ["été".encode("latin-1"), "总线".encode("gbk"), "总线".encode(), b"\xff\xfe"])
def test_comments_are_in_any_encoding(folder, comment):
    level = b"extern float level; /* '<Root>/level' " + comment + b" [0,5] */\n"
    (folder / "wash.h").write_bytes(SOUND.encode() + level)
    (folder / "wash.c").write_text(SOURCE.replace("(void)speed", "level = speed"))
    (found,) = imported(folder).interface.outputs
    assert (found.remark.min, found.remark.max) == (0, 5)


def test_a_file_that_is_too_large_is_left_out(folder, monkeypatch):
    monkeypatch.setattr(files, "CODE_FILE_BYTES", 1_000)
    (folder / "huge.h").write_text("int x;\n" * 1_000)
    assert rules(imported(folder)) == {"S001"}


def test_a_folder_that_is_too_large_is_read_in_part(folder, monkeypatch):
    monkeypatch.setattr(files, "CODE_BYTES", len(SOUND) + len(SOURCE) + 10)
    (folder / "x.h").write_text("int x;\n" * 100)
    assert [finding.file for finding in imported(folder).findings] == ["x.h"]


def test_a_folder_of_too_many_files_is_read_in_part(folder, monkeypatch):
    monkeypatch.setattr(files, "CODE_FILES", 2)
    (folder / "x.h").write_text("int x;\n")
    assert rules(imported(folder)) == {"S001"}


def test_links_lead_nowhere_else(folder, tmp_path_factory):
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    (elsewhere / "secret.h").write_text("extern float secret;\n")
    (folder / "secret.h").symlink_to(elsewhere / "secret.h")
    (folder / "more").symlink_to(elsewhere)
    (folder / "circle").symlink_to(folder)
    (folder / "lost.h").symlink_to(folder / "nothing.h")
    (folder / "again.h").symlink_to(folder / "wash.h")
    found = {finding.file: finding.rule for finding in imported(folder).findings}
    assert found == {"secret.h": "S001", "lost.h": "S001"}


def test_pipes_are_not_waited_for(folder):
    os.mkfifo(folder / "pipe.h")
    assert {finding.file for finding in imported(folder).findings} == {"pipe.h"}


@pytest.mark.parametrize(
    "include",
    ['"/etc/passwd"', "</etc/passwd>", '"../../../../../../etc/passwd"', '"C:/secret.h"', '"\\\\server\\secret.h"'],
)
def test_an_include_leads_nowhere_else(folder, include):
    (folder / "wash.h").write_text(f"{SOUND}#include {include}\n")
    project = imported(folder)
    assert rules(project) <= {"S006"}
    assert "root:" not in str(project)


def test_a_hidden_include_leads_nowhere_else(folder, tmp_path_factory):
    secret = tmp_path_factory.mktemp("elsewhere") / "secret.txt"
    secret.write_text("extern float secret; /* '<Root>/secret' */\n")
    (folder / "wash.h").write_text(f'{SOUND}#define NAME "{secret}"\n#inc\\\nlude NAME\n')
    (folder / "wash.c").write_text(SOURCE.replace("(void)speed", "secret = speed"))
    assert imported(folder).interface.outputs == ()


@pytest.mark.parametrize(
    "text",
    ['#include "wash.h"\n' * 500, '#include "a.h"\n', "#include __FILE__\n", "#include\n", '#include "wash.h'],
    ids=["often", "itself", "itself by name", "nothing", "open"],
)
def test_includes_in_circles_end(folder, text):
    (folder / "a.h").write_text(text)
    assert imported(folder).interface.inputs


@pytest.mark.parametrize(
    "text",
    [
        "}" * 1_000,
        "{" * 100_000,
        "(" * 100_000,
        "struct a { " * 5_000,
        "extern float x" + "[2]" * 5_000 + ";",
        "extern float " + "*" * 5_000 + "x;",
        "typedef struct s { struct s inner; float x; } s; extern s endless;",
        "typedef struct t t; struct t { t *next; float x; }; extern t chain;",
        '"' * 1_001,
        "/*" * 1_000,
        "#if 1\n" * 10_000,
        "#error no\n" * 500,
        "template <int n> struct T { T<n + 1> x; };",
        "\\\n" * 10_000,
        "??/\n??=??(" * 100,
        "extern float " + "x" * 100_000 + ";",
        '#line 2000000000 "/etc/passwd"\nextern float y;',
        "enum e { A = 99999999999999999999999 };",
        "extern float big[2000000000];",
        "extern float none[0], minus[-1];",
        "int f(int a) { return f(" * 300,
    ],
    ids=lambda text: text[:12].strip(),
)
def test_unbalanced_and_endless_code_is_survived(folder, text):
    (folder / "odd.h").write_text(text)
    (folder / "odd.c").write_text(text)
    assert rules_of_refusal(folder) in ([], ["S003"])


def rules_of_refusal(folder: Path) -> list[str]:
    try:
        return [] if imported(folder).interface.inputs else ["nothing"]
    except InputRefused as error:
        return [finding.rule for finding in error.findings]


def test_macros_that_multiply_are_stopped(folder, monkeypatch):
    monkeypatch.setattr(parsing, "CODE_SECONDS", 3.0)
    doubled = "\n".join(f"#define a{n} a{n - 1} a{n - 1}" for n in range(1, 60))
    (folder / "bomb.h").write_text(f"#define a0 int x;\n{doubled}\na59\n")
    assert rules_of_refusal(folder) == ["S003"]


def test_values_of_an_endless_array_are_bounded(folder):
    (folder / "wash.h").write_text(
        f"{SOUND}typedef struct {{ float x; }} Item;\ntypedef struct {{ Item items[1000000]; }} WashInputs;\n"
        "extern WashInputs wash_inputs;\n"
    )
    project = imported(folder)
    assert len(project.interface.inputs) == 2_000
    assert "S011" in rules(project)


def test_what_code_says_is_never_read_as_yaml(folder):
    said = "x: y\\n- path: Vehicle.Other # ' \" {[ \x1b[31m \u2028 \u202e */ /* '<Root>/speed'"
    (folder / "wash.h").write_text(SOUND.replace("'<Root>/speed'", said))
    assert main(["function", "new", "Washing", "--from-c", str(folder)]) == 0
    text = (folder / "function.yaml").read_text()
    assert not {"\x1b", "\u2028", "\u202e"} & set(text)
    assert "Vehicle.Other" not in "".join(line for line in text.splitlines() if not line.lstrip().startswith("#"))


def test_a_folder_that_is_none_is_told(tmp_path):
    with pytest.raises(UsageError, match="no such folder"):
        imported(tmp_path / "nothing")
    (tmp_path / "file.h").write_text(SOUND)
    with pytest.raises(UsageError, match="not a file: use --from-c"):
        imported(tmp_path / "file.h")


def test_without_libclang_the_command_says_what_it_needs(folder, monkeypatch, capsys):
    monkeypatch.setattr(parsing, "find_spec", lambda _name: None)
    assert main(["function", "new", "Washing", "--from-c", str(folder)]) == 2
    assert "pip install 'sigcat[c]'" in capsys.readouterr().err
    assert not (folder / "function.yaml").exists()


def test_code_that_wants_definitions_says_so_and_takes_them(folder):
    (folder / "config.h").write_text("#ifndef VARIANT\n#error Name a variant.\n#endif\n")
    (finding,) = imported(folder).findings
    assert (finding.rule, finding.file, finding.line) == ("S007", "config.h", 2)
    assert read_project(folder, "Washing", definitions=["VARIANT=3"]).findings == ()


@pytest.mark.parametrize("definition", ["", "1", "A B", "A\n", "-o/etc/passwd", "A(x)=x"])
def test_a_definition_is_a_name_with_a_value(folder, definition):
    with pytest.raises(UsageError, match="NAME=VALUE"):
        read_project(folder, "Washing", definitions=[definition])


def test_nothing_is_written_over_and_the_file_stands_above_the_code(folder, tmp_path_factory, capsys):
    arguments = ["function", "new", "Washing", "--from-c", str(folder)]
    assert main([*arguments, "-o", str(tmp_path_factory.mktemp("elsewhere"))]) == 2
    assert "must be in" in capsys.readouterr().err
    assert main([*arguments, "-o", str(folder.parent)]) == 0
    assert main([*arguments, "-o", str(folder.parent)]) == 2
    assert "is there already" in capsys.readouterr().err
