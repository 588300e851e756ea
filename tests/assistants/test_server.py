"""`sigcat mcp` answers the client of the package `mcp` over standard input and output: look-ups, bounded, read-only."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from mcp import Client, StdioServerParameters, stdio_client

from sigcat.limits import ASSISTANT_CHARACTERS, ASSISTANT_ITEMS, ASSISTANT_TEXT
from tests.own_loop import run

OVERLAY = "Vehicle.CabinNoise:\n  type: sensor\n  datatype: float\n  unit: dB\n  description: {}\n"
FUNCTION = """\
function: Noise
description: Watches the noise.
responsible: A team
components:
  - name: Noise
    runnables:
      - {interface: Step, data: [{path: Vehicle.CabinNoise, role: consumed, init: 0, asil: QM}]}
define:
  scheduling:
    Step: {description: Watches., cycleTime: 100, asil: QM}
"""


@pytest.fixture
def project(tmp_path):
    folder = tmp_path / "project"
    (folder / "functions").mkdir(parents=True)
    (folder / "functions/noise.yaml").write_text(FUNCTION)
    (folder / "acme.vspec").write_text(OVERLAY.format("Sound level in the cabin."))
    (folder / "sigcat.toml").write_text(
        'functions = ["functions"]\n[[catalogue]]\nid = "acme"\nrelease = "shipped"\noverlays = ["acme.vspec"]\n'
        '[[catalogue]]\nid = "plain"\nrelease = "shipped"\n'
    )
    return folder


def session(project: Path, *calls, between=lambda _: None, errors=None, options=()):
    """Answers of a server to calls of tools; `between` is called before each with its number."""

    async def talk(log):
        command = ["-m", "sigcat.cli", "mcp", str(project), *options]
        parameters = StdioServerParameters(command=sys.executable, args=command, env=dict(os.environ))
        async with Client(stdio_client(parameters, errlog=log)) as client:
            answers = []
            for number, (tool, arguments) in enumerate(calls):
                between(number)
                answers.append(await client.call_tool(tool, arguments))
            return (await client.list_tools()).tools, answers

    with Path(errors or os.devnull).open("w") as log:
        return run(talk(log))


def test_look_ups_over_standard_input_and_output(project, tmp_path):
    log = tmp_path / "log"
    draft = "Vehicle.CabinNoise:\n  type: sensor\n  datatype: float\n  unit: bD\n"
    tools, answers = session(
        project,
        ("search", {"words": "cabin noise"}),
        ("show", {"path": "Vehicle.CabinNoise"}),
        ("lint", {"text": draft, "name": "draft.vspec"}),
        ("try_overlay", {"text": draft.replace("bD", "dB") + "  max: 120\n"}),
        ("diff", {"old": "plain", "new": "acme"}),
        ("who_uses", {"path": "Vehicle.CabinNoise"}),
        errors=log,
    )
    assert {tool.name for tool in tools} == {"search", "show", "lint", "try_overlay", "diff", "who_uses"}
    assert all(tool.annotations.read_only_hint and tool.description for tool in tools)
    assert not any(answer.is_error for answer in answers)
    search, show, lint, tried, diff, uses = (answer.structured_content for answer in answers)
    assert search["nodes"][0]["path"] == "Vehicle.CabinNoise"
    assert show["attributes"]["unit"] == {"value": "dB", "written_in": f"{project / 'acme.vspec'}:4"}
    assert {"draft.vspec"} == {each["file"] for each in lint["findings"]}
    assert lint["findings"][0]["severity"] == "error"
    assert tried["summary"]["total"] == 1
    assert [change["path"] for change in diff["changes"]] == ["Vehicle.CabinNoise"]
    assert [(use["function"], use["verb"]) for use in uses["uses"]] == [("Noise", "consumes")]
    assert "files_with_errors" not in uses
    assert log.read_text() == ""


def test_files_that_changed_are_read_again_and_their_errors_are_the_answer(project):
    def change(number):
        if number == 1:
            (project / "acme.vspec").write_text(OVERLAY.format("Noise, changed."))
            (project / "functions/noise.yaml").write_text(FUNCTION.replace("consumed", "eaten"))
        if number == 3:
            (project / "acme.vspec").write_text(OVERLAY.format("Broken.").replace("float", "flaot"))

    show = ("show", {"path": "Vehicle.CabinNoise"})
    uses = ("who_uses", {"path": "Vehicle.CabinNoise"})
    _, (before, after, broken_function, broken) = session(project, show, show, uses, show, between=change)
    assert before.structured_content["attributes"]["description"]["value"] == "Sound level in the cabin."
    assert after.structured_content["attributes"]["description"]["value"] == "Noise, changed."
    assert broken_function.structured_content["files_with_errors"]
    assert broken.is_error
    assert "flaot" in broken.content[0].text


def test_what_cannot_be_answered_says_why_and_reveals_no_file_outside(project, tmp_path):
    (tmp_path / "secret.vspec").write_text("root:x:0\n")
    (project / "link.vspec").symlink_to(tmp_path / "secret.vspec")
    _, answers = session(
        project,
        ("show", {"path": "Vehicle.CabinNoize"}),
        ("show", {"path": "Vehicle.Speed", "catalogue": "acmee"}),
        ("search", {"words": "speed", "type": "sensr"}),
        ("diff", {"old": "acme", "new": str(tmp_path / "secret.vspec")}),
        ("diff", {"old": "../secret.vspec", "new": "acme"}),
        ("diff", {"old": "link.vspec", "new": "acme"}),
        ("diff", {"old": f"plain+{tmp_path / 'secret.vspec'}", "new": "acme"}),
        ("diff", {"old": "git:-x", "new": "acme"}),
        ("lint", {"text": "", "name": "../../secret.vspec"}),
    )
    texts = [answer.content[0].text for answer in answers]
    assert [answer.is_error for answer in answers] == [True] * 8 + [False]
    assert "Vehicle.CabinNoise" in texts[0]
    assert "'acmee'" in texts[1]
    assert "'sensor'" in texts[2]
    assert all("can be compared" in text for text in texts[3:7])
    assert not any("root:x" in text or "Traceback" in text for text in texts)


def test_answers_are_bounded(project):
    signals = "".join(
        f"Vehicle.Many.S{n}:\n  type: sensor\n  datatype: uint8\n  description: {'A' * 5000}\n" for n in range(3000)
    )
    many = f"Vehicle.Many:\n  type: branch\n  description: Many.\n{signals}"
    (project / "acme.vspec").write_text(many)
    bad = "".join(f"Vehicle.X{n}:\n  type: sensr\n" for n in range(500))
    _, answers = session(
        project,
        ("search", {"words": "many"}),
        ("show", {"path": "Vehicle.Many"}),
        ("lint", {"text": bad}),
        ("try_overlay", {"text": bad}),
        ("diff", {"old": "plain", "new": "acme"}),
    )
    for answer in answers:
        assert not answer.is_error
        assert len(json.dumps(answer.structured_content)) < 2 * ASSISTANT_CHARACTERS + 10_000
    search, show, lint, *_ = (answer.structured_content for answer in answers)
    assert search["omitted"] + len(search["nodes"]) > 3000
    assert len(show["children"]) <= ASSISTANT_ITEMS
    assert len(show["children"][0]["description"]) == ASSISTANT_TEXT + 1
    assert lint["omitted"] > 0


def test_a_folder_that_is_not_there_is_an_error(tmp_path):
    command = [sys.executable, "-m", "sigcat.cli", "mcp", "no/such"]
    ended = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
    assert (ended.returncode, ended.stderr) == (2, "sigcat: no/such: there is no such folder\n")


def test_another_project_file_is_named_and_none_is_used(project, tmp_path):
    (project / "other.toml").write_text('[[catalogue]]\nid = "other"\nrelease = "shipped"\n')
    show = ("show", {"path": "Vehicle.CabinNoise"})
    _, (named,) = session(project, show, options=("--config", str(project / "other.toml")))
    _, (isolated,) = session(project, show, options=("--isolated",))
    _, (found,) = session(project, show)
    assert (named.is_error, isolated.is_error, found.is_error) == (True, True, False)
