"""A struct that contains itself, directly, in an array or through another struct, is a finding wherever it is used."""

import pytest

from sigcat.cli import main

FUNCTION = """\
function: Track
description: Follows a track.
responsible: Navigation team
code: {{signature: globals, sources: [track.c], headers: [track.h]}}
define:
  types:
    Types.Point: {{description: A point., fields: {{Next: {{datatype: {next}, description: The next point.}}}}}}
    Types.Other: {{description: Another one., fields: {{Point: {{datatype: Types.Point, description: A point.}}}}}}
  data:
    Vehicle.Cabin.Track: {{datatype: Types.Point, description: The track.}}
  scheduling:
    Step: {{cycleTime: 10, asil: QM, description: Follows.}}
components:
  - name: Track
    runnables:
      - interface: Step
        data: [{{path: Vehicle.Cabin.Track, role: consumed, provider: Map, variable: track, asil: QM}}]
"""


COMMANDS = [["lint"], ["function", "build"], ["generate", "core"], ["integrate", "fmi"]]
CASES = [
    *((command, following) for command in COMMANDS for following in ("Types.Point", "Types.Other")),
    *((command, "'Types.Point[]'") for command in COMMANDS[2:]),
]


@pytest.mark.parametrize(("command", "following"), CASES)
def test_it_is_reported_and_nothing_is_generated(command, following, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "track.h").write_text("struct point { int next; };\nextern struct point track;\n")
    (tmp_path / "track.c").write_text('#include "track.h"\n')
    (tmp_path / "function.yaml").write_text(FUNCTION.format(next=following))
    output = [] if command == ["lint"] else ["-o", "out"]
    assert main([*command, "function.yaml", "--isolated", *output]) == 1
    shown = "".join(capsys.readouterr())
    assert "F084 A datatype must not contain itself; 'DT_" in shown
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("command", COMMANDS[:2])
def test_a_list_of_itself_is_no_end_of_a_lint(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "function.yaml").write_text(FUNCTION.format(next="'Types.Point[]'").replace("code:", "#"))
    main([*command, "function.yaml", "--isolated"])
    shown = "".join(capsys.readouterr())
    assert "F084" not in shown
    assert "internal error" not in shown
