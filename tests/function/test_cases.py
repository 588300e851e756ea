"""Functions that say how their code is called: the Function JSON that they give, and what is found wrong with others."""

import errno
import io
import json
import os
import re
import shutil
from pathlib import Path

import jsonschema_rs
import pytest

from scripts.cases import BAD_FUNCTIONS, FUNCTIONS, ROOT
from sigcat import codes
from sigcat.adapter.core.cores import plans
from sigcat.cli import main
from sigcat.data import EXAMPLES
from sigcat.errors import InputRefused
from sigcat.function.function_file import check_function, checked_file
from sigcat.function.function_json.model import function_schema, to_json
from sigcat.integration.report import NOT_CARRIED
from sigcat.platforms.integrate import integrate
from sigcat.platforms.table import PLATFORMS
from tests.function.shipped import interfaces, resolved
from tests.published.schemas import schema

OF_THE_AUTHORS = {"autosar-adaptive", "ros2"}
"""Platforms of whose Integration JSON the authors of the method published a schema."""
PUBLISHED = ROOT / "tests" / "published"


def source(name: str) -> bytes:
    return (ROOT / FUNCTIONS.folder / name / "function.yaml").read_bytes()


@pytest.mark.parametrize("name", FUNCTIONS.names)
def test_a_function_gives_its_function_json(name):
    assert FUNCTIONS.made(name) == FUNCTIONS.text(name), "If that is meant, run `make generate`."


@pytest.mark.parametrize("name", FUNCTIONS.names)
def test_it_is_valid_under_the_published_schema_and_ours(name):
    document = json.loads(FUNCTIONS.text(name))
    jsonschema_rs.validate(schema("function_json"), document)
    jsonschema_rs.validate(function_schema(), document)


@pytest.mark.parametrize("name", FUNCTIONS.names)
def test_nothing_is_found_wrong_with_it_as_a_declaration_or_as_function_json(name):
    checked = checked_file(source(name), "function.yaml", interfaces())
    assert checked.findings == ()
    assert checked.function is not None
    assert check_function(to_json(checked.function), "function.json", interfaces()) == ()


def test_what_the_authors_published_is_held_against_it():
    assert PLATFORMS.keys() >= OF_THE_AUTHORS
    assert {file.stem.replace("_", "-") for file in PUBLISHED.glob("*.yaml")} - {"function-json"} == OF_THE_AUTHORS


def has_obstacles(function):
    """Whether the function has no core, as no header declares a variable."""
    try:
        plans([function])
    except InputRefused as refused:
        return {finding.rule for finding in refused.findings} == {codes.HEADER_MISSING.id}
    return False


@pytest.mark.parametrize("platform", PLATFORMS)
@pytest.mark.parametrize("name", FUNCTIONS.names)
def test_each_field_goes_into_an_integration_of_the_published_form_or_the_report_says_why_not(name, platform):
    checked = checked_file(source(name), "function.yaml", interfaces())
    assert checked.function is not None
    function = resolved(checked.function)
    if platform == "fmi" and has_obstacles(function):  # an FMU is made of a core
        return
    made = integrate(PLATFORMS[platform], [function])
    if platform in OF_THE_AUTHORS:
        jsonschema_rs.validate(schema(platform.replace("-", "_")), json.loads(made.document))
    report = made.report
    assert [entry for entry in report if entry.target == NOT_CARRIED and not entry.note] == []
    assert "no field of Function JSON that sigcat knows" not in {entry.note for entry in report}


@pytest.mark.parametrize("name", BAD_FUNCTIONS.names)
def test_each_mistake_is_found_where_it_was_made(name):
    assert BAD_FUNCTIONS.made(name) == BAD_FUNCTIONS.text(name), "If that is meant, run `make generate`."


@pytest.mark.parametrize("command", [["function", "build"], ["function", "validate"], ["lint"]])
def test_files_of_the_code_are_looked_for_beside_the_function_file(command, tmp_path, capsys):
    file = tmp_path / "core_acc" / "function.yaml"
    shutil.copytree(EXAMPLES / "core_acc", file.parent)
    assert main([*command, str(file)]) == 0
    assert "F201" not in "".join(capsys.readouterr())
    (file.parent / "CoreAcc.c").unlink()
    main([*command, str(file)])
    assert f"{file}:14:13: warning F201 There is no file 'CoreAcc.c'." in "".join(capsys.readouterr())


def test_of_a_posted_function_nobody_looks_for_files(monkeypatch, capsys):
    posted = (EXAMPLES / "core_acc/function.yaml").read_bytes()
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(posted)))
    assert main(["lint", "-"]) == 0
    assert "F201" not in capsys.readouterr().out


@pytest.fixture
def core_acc(tmp_path):
    shutil.copytree(EXAMPLES / "core_acc", tmp_path / "core_acc")
    return tmp_path / "core_acc"


def _as_folder(file):
    file.unlink()
    file.mkdir()


def _as_pipe(file):
    file.unlink()
    os.mkfifo(file)


def _as_link_to_nothing(file):
    file.unlink()
    file.symlink_to("nothing")


@pytest.mark.parametrize("name", ["CoreAcc.c", "CoreAcc.h"])
@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (_as_folder, "must be a file, not a folder."),
        (_as_pipe, "must be a regular file."),
        (lambda file: file.write_bytes(b"\x7fELF\0\1"), "is not a text in UTF-8 or a similar encoding."),
        (lambda file: file.write_text(file.read_text(), encoding="utf-16"), "is not a text in UTF-8"),
        (_as_link_to_nothing, "There is no "),
    ],
)
@pytest.mark.parametrize("command", [["lint"], ["simulate", "--duration", "1"]])
def test_a_file_of_the_code_that_is_no_text_is_reported(command, spoil, fault, name, core_acc, capsys):
    spoil(core_acc / name)
    assert main([*command, str(core_acc / "function.yaml")]) == 1
    said = "".join(capsys.readouterr())
    assert re.search(rf"function.yaml:1[3-9]:\d+: (warning|error) F201 .*{re.escape(fault)}", said)
    assert "T01" not in said


def test_a_file_of_the_code_that_cannot_be_read_says_why(core_acc, capsys, monkeypatch):
    opened = Path.open

    def refuse(path, *arguments, **options):
        if path.name == "CoreAcc.c":
            raise PermissionError(errno.EACCES, "Permission denied")
        return opened(path, *arguments, **options)

    monkeypatch.setattr(Path, "open", refuse)
    assert main(["lint", str(core_acc / "function.yaml")]) == 1
    assert "F201 'CoreAcc.c' cannot be read: Permission denied." in capsys.readouterr().out


def test_an_include_folder_is_one(core_acc, capsys):
    file = core_acc / "function.yaml"
    file.write_text(file.read_text().replace("  headers:", "  includeFolders: [CoreAcc.c]\n  headers:"))
    assert main(["lint", str(file)]) == 1
    assert "F201 'CoreAcc.c' must be a folder, not a file." in capsys.readouterr().out


@pytest.mark.parametrize("path", ["a" * 5000, "a/" * 3000 + "b"])
def test_a_path_that_no_file_can_have_is_missing(path, core_acc, capsys):
    file = core_acc / "function.yaml"
    file.write_text(file.read_text().replace("CoreAcc.c", path))
    assert main(["lint", str(file)]) == 1
    assert "F201 There is no file" in capsys.readouterr().out
