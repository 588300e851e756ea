"""Entries of the log as CloudEvents, which the SDK of the CNCF reads."""

import json
import os
import select
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from cloudevents.core.bindings.http import HTTPMessage, from_structured
from cloudevents.core.formats.json import JSONFormat
from cloudevents.core.v1.event import CloudEvent

from sigcat.registry.decisions.acknowledgements import acknowledge
from sigcat.registry.decisions.approvals import approve, reject
from sigcat.registry.events import TYPES, event_text, events_after
from sigcat.registry.lines import record, set_rule, set_state
from sigcat.registry.publish import publish
from sigcat.registry.reference import Reference
from sigcat.registry.storing.database import reading
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.transfer import exported, import_lines
from tests.registry.parts import candidate, catalogue, declaration, plain_candidate

CATALOGUE = catalogue()
ROOT = Path(__file__).parents[2]


@pytest.fixture
def registry(tmp_path: Path) -> Registry:
    """A registry with an event of each type."""
    registry = Registry(tmp_path / "registry.db")
    old, new = Reference("Alpha", "1.0.0"), Reference("Alpha", "1.1.0")
    publish(registry, [candidate(declaration("Alpha", ("S0",)), CATALOGUE)], is_draft=True)
    publish(registry, [candidate(declaration("Alpha", ("S0",)), CATALOGUE)])
    publish(registry, [candidate(declaration("Beta", (), ("S0",)), CATALOGUE)])
    set_rule(registry, "function", "Alpha", "approval")
    publish(registry, [candidate(declaration("Alpha", (), (), "1.1.0"), CATALOGUE)])
    reject(registry, "function", new, "Team Beta", "S0 is needed.")
    approve(registry, "function", new, "Team Beta")
    record(registry, "deployment", "SUV-2025", old)
    record(registry, "release", "VAN-2026", old)
    record(registry, "support ended", "SUV-2025", old)
    record(registry, "support ended", "VAN-2026", old)
    set_state(registry, "function", old, "deprecated")
    acknowledge(registry, "function", old, "Team Beta")
    set_state(registry, "function", old, "retired")
    return registry


def test_each_entry_is_a_valid_event_and_each_type_is_listed(registry: Registry) -> None:
    with reading(registry.database) as connection:
        found = events_after(connection, 0)
    for event in found:
        message = HTTPMessage({"content-type": "application/cloudevents+json"}, event_text(event).encode())
        read = from_structured(message, JSONFormat(), CloudEvent)
        assert (read.get_id(), read.get_type(), read.get_source()) == (event["id"], event["type"], event["source"])
        assert read.get_subject() == event["subject"]
        assert read.get_data() == event["data"]
        assert read.get_time() is not None
    assert {event["type"] for event in found} == set(TYPES)
    assert len({event["id"] for event in found}) == len(found)


def test_events_are_the_same_after_an_import(registry: Registry, tmp_path: Path) -> None:
    with reading(registry.database) as connection:
        found, lines = events_after(connection, 0), list(exported(connection))
    import_lines(tmp_path / "second.db", [line.encode() for line in lines], "export")
    with reading(tmp_path / "second.db") as connection:
        assert events_after(connection, 0) == found


def command(folder: Path, *arguments: str) -> list[str]:
    (folder / "sigcat.toml").write_text('[registry]\ndatabase = "registry.db"\n', encoding="utf-8")
    return [sys.executable, "-m", "sigcat.cli", "registry", "events", *arguments]


def run(folder: Path, *arguments: str) -> tuple[int, list[str], str]:
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "app")}
    done = subprocess.run(
        command(folder, *arguments), cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout.splitlines(), done.stderr


def test_the_command_prints_events_after_one(registry: Registry, tmp_path: Path) -> None:
    _, lines, _ = run(tmp_path)
    assert len(lines) == 14
    assert run(tmp_path, "--after", json.loads(lines[9])["id"])[1] == lines[10:]
    status, lines, text = run(tmp_path, "--after", "0" * 64)
    assert (status, lines, "error E005" in text) == (1, [], True)


def test_more_events_than_an_answer_has_are_all_printed(tmp_path: Path, monkeypatch, capsys) -> None:
    from sigcat.cli import main

    publish(Registry(tmp_path / "registry.db"), [plain_candidate("o", f"1.{n}.0") for n in range(10)])
    command(tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sigcat.registry.events.REGISTRY_ROWS", 3)
    assert main(["registry", "events"]) == 0
    subjects = [json.loads(line)["subject"] for line in capsys.readouterr().out.splitlines()]
    assert subjects == [f"o@1.{n}.0" for n in range(10)]


def test_follow_prints_an_event_when_it_is_written(tmp_path: Path) -> None:
    registry = Registry(tmp_path / "registry.db")
    publish(registry, [plain_candidate("o", "1.0.0")])
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "app")}
    process = subprocess.Popen(command(tmp_path, "--follow"), cwd=tmp_path, env=environment, stdout=subprocess.PIPE)
    assert process.stdout is not None
    try:
        assert json.loads(process.stdout.readline())["subject"] == "o@1.0.0"
        publish(registry, [plain_candidate("o", "1.1.0")])
        assert select.select([process.stdout], [], [], 30)[0]
        assert json.loads(process.stdout.readline())["subject"] == "o@1.1.0"
    finally:
        process.send_signal(signal.SIGINT)
        assert process.wait(30) == 0
        process.stdout.close()
