"""The configuration of the service, for its operator: all errors in it are reported at once."""

import hashlib
from pathlib import Path

import pytest

from sigcat.cli import main

FAULTS = """\
wach = true
[[catalogue]]
id = "own"
spec = "missing.vspec"
[service]
port = "abc"
resluts = 7
[lint]
nope = 1
select = "V"
"""


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("command", ["config", "serve"])
def test_everything_wrong_is_told_at_once_with_its_line(command, capsys, monkeypatch):
    monkeypatch.setenv("SIGCAT_RESULTS", "0")
    Path("sigcat.toml").write_text(FAULTS, encoding="utf-8")
    assert main([command]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert [int(line.split(":")[1]) for line in lines if line.startswith("sigcat.toml:")] == [1, 4, 6, 7, 9, 10]
    assert any("SIGCAT_RESULTS" in line for line in lines)


@pytest.mark.parametrize("command", ["config", "serve"])
@pytest.mark.parametrize("text", ["[service", "[lint]\nnope = 1\n", "service = 1\n", "lint = 1\n"])
def test_a_configuration_that_cannot_be_used_stops_the_command(command, text):
    Path("sigcat.toml").write_text(text, encoding="utf-8")
    assert main([command]) == 2


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            ("--new-token", "a:b"),
            "the name of a token must be letters, digits, '.', '_' and '-', at most 64, not 'a:b'",
        ),
        (("--new-token", ""), "the name of a token must be"),
        (("--new-token", "ci", "--scope", "READ"), "a scope must be read or reload, not 'READ'"),
    ],
)
def test_a_token_that_cannot_be_made_says_what_is_wrong(options, message, capsys):
    assert main(["config", *options]) == 2
    assert message in capsys.readouterr().err


def test_what_no_findings_were_made_of_could_not_run(capsys):
    """A damaged archive; a document with errors has findings, and ends with 1."""
    Path("release.tgz").write_bytes(hashlib.sha256(b"noise").digest())
    assert main(["pull", "v5.0", "--from", "release.tgz"]) == 2
    Path("integration.json").write_text("{}", encoding="utf-8")
    assert main(["generate", "arxml", "integration.json", "-o", "arxml"]) == 1


def test_what_is_no_json_is_told_so(capsys):
    Path("function.yaml").write_text("function:\n  name: One\n", encoding="utf-8")
    assert main(["generate", "arxml", "function.yaml", "-o", "arxml"]) == 1
    assert "The document must be JSON." in capsys.readouterr().err
