"""`sigcat pull` and `sigcat releases`, as a user meets them."""

import argparse
import hashlib
import json
import os
import pty
import subprocess
import sys

import pytest

from sigcat.cli import pull, releases
from sigcat.cli.catalogue_options import add_catalogue_options, hosted_sources
from sigcat.cli.pull import bar_text
from sigcat.errors import SigcatError
from sigcat.project.project import Project
from tests.catalogue.hosting.archives import saved, zip_bytes
from tests.catalogue.hosting.server import GOOD


def run(*argv: str) -> int:
    """Parse and run, as the command line does."""
    parser = argparse.ArgumentParser()
    commands = parser.add_subparsers(required=True)
    pull.add_parser(commands)
    releases.add_parser(commands)
    arguments = parser.parse_args(argv)
    status: int = arguments.run(arguments)
    return status


def test_a_pulled_release_is_served_beside_the_shipped_trees(server, data, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    parser = argparse.ArgumentParser()
    add_catalogue_options(parser)
    assert run("pull", "5.0", "--from", f"{server}/good", "--allow-private") == 0
    sources = hosted_sources(parser.parse_args([]), Project())
    assert [source.id for source in sources] == ["interfaces", "vss", "v5.0"]


def test_pulling_says_what_came_and_listing_shows_it(server, data, capsys):
    assert run("pull", "5.0", "--from", f"{server}/good", "--allow-private") == 0
    output = capsys.readouterr()
    digest = hashlib.sha256(GOOD).hexdigest()
    assert output.out == f"v5.0: 2 nodes in {data}/releases/v5.0\n      SHA-256 {digest}, from {server}/good\n"
    assert output.err == ""
    assert run("releases") == 0
    line = capsys.readouterr().out
    assert line.startswith("v5.0  2")
    assert line.endswith(f"2 nodes  sha256:{digest}\n")
    assert run("releases", "--format", "json") == 0
    (release,) = json.loads(capsys.readouterr().out)
    assert (release["name"], release["nodes"], release["digest"]) == ("v5.0", 2, digest)


def test_a_release_that_is_here_is_named_and_force_replaces_it(server, data, tmp_path, capsys):
    assert run("pull", "5.0", "--from", f"{server}/good", "--allow-private") == 0
    other = str(saved(tmp_path, zip_bytes()))
    capsys.readouterr()
    assert run("pull", "5.0", "--from", other) == 0
    output = capsys.readouterr()
    assert output.err == f"sigcat: v5.0 is here already, and {other} is not used; --force replaces it\n"
    assert f"from {server}/good" in output.out
    assert run("pull", "5.0", "--from", other, "--force") == 0
    output = capsys.readouterr()
    assert output.err == ""
    assert f"from {other}" in output.out
    assert [path.name for path in (data / "releases").iterdir()] == ["v5.0"]


def test_with_nothing_pulled_the_list_says_what_to_do(data, capsys):
    assert run("releases") == 0
    output = capsys.readouterr()
    assert output.out == ""
    assert f"No releases in {data}/releases. `sigcat pull" in output.err


def test_a_refusal_is_an_error_for_users(server, data):
    with pytest.raises(SigcatError, match=r"127\.0\.0\.1 is not a public address; --allow-private"):
        run("pull", "5.0", "--from", f"{server}/good")
    with pytest.raises(SigcatError, match="answers 404"):
        run("pull", "5.0", "--from", f"{server}/none", "--allow-private")


def test_the_bar_shows_what_has_come_of_the_whole():
    assert bar_text("v5.0", 0, 2_000_000) == f"v5.0  [{'.' * 30}] 0.0 MB of 2.0 MB"
    assert bar_text("v5.0", 1_000_000, 2_000_000) == f"v5.0  [{'#' * 15}{'.' * 15}] 1.0 MB of 2.0 MB"
    assert bar_text("v5.0", 1_500_000, None) == "v5.0  1.5 MB"


@pytest.mark.skipif(os.name != "posix", reason="the pseudo terminals of POSIX")
def test_a_terminal_gets_a_bar_and_keeps_a_clean_line(server, data):
    terminal, side = pty.openpty()
    code = (
        "import sys; from sigcat.cli import main;"
        f"sys.exit(main(['pull', 'v5.0', '--from', '{server}/good', '--allow-private']))"
    )
    subprocess.run([sys.executable, "-c", code], stderr=side, stdout=subprocess.DEVNULL, check=True)
    os.close(side)
    drawn = os.read(terminal, 10_000).decode()
    os.close(terminal)
    assert "#" * 30 in drawn
    assert drawn.endswith("\r\x1b[K")
