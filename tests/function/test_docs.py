"""docs/reference/functions.md shows commands that run, and keys that exist."""

import re
from pathlib import Path

from sigcat.cli import main
from sigcat.function.declaration.declaration import declaration_schema

TEXT = (Path(__file__).parents[2] / "docs" / "reference" / "functions.md").read_text(encoding="utf-8")


def test_the_shown_commands_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for line in TEXT.split("```sh\n")[1].split("```")[0].splitlines():
        assert main(line.split()[1:]) == 0, line


def test_every_key_of_a_data_item_is_documented():
    table = TEXT.split("adds what only")[1].split("## ")[0]
    told = set(re.findall(r"`(\w+)`", table))
    assert set(declaration_schema()["$defs"]["DataItem"]["properties"]) <= told | {"path", "role"}
