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


@pytest.mark.parametrize("command", [["lint"], ["function", "build"], ["generate", "core"], ["integrate", "fmi"]])
@pytest.mark.parametrize("following", ["Types.Point", "'Types.Point[]'", "Types.Other"])
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
