"""The life of a node: every transition from every state, wrong ones too; Init and Terminate follow each other once each."""

from pathlib import Path

import pytest

from tests.adapter.ros2.built import USUAL, preloaded, running, workspace
from tests.adapter.ros2.other_end import (
    ACTIVATE,
    ACTIVE_SHUTDOWN,
    CLEANUP,
    CONFIGURE,
    DEACTIVATE,
    INACTIVE_SHUTDOWN,
    UNCONFIGURED_SHUTDOWN,
    Peer,
)
from tests.needs import ros2

pytestmark = [ros2, pytest.mark.parametrize("language", USUAL)]

NODE = "eco_control_mpc"
MADE = {
    ("unconfigured", CONFIGURE): "inactive",
    ("inactive", CLEANUP): "unconfigured",
    ("inactive", ACTIVATE): "active",
    ("active", DEACTIVATE): "inactive",
    ("unconfigured", UNCONFIGURED_SHUTDOWN): "finalized",
    ("inactive", INACTIVE_SHUTDOWN): "finalized",
    ("active", ACTIVE_SHUTDOWN): "finalized",
}
"""Transitions that a lifecycle node makes when it is asked to; all others leave it where it is."""
REACHED = {"unconfigured": (), "inactive": (CONFIGURE,), "active": (CONFIGURE, ACTIVATE)}
ASKED = (*range(9), 10, 30, 41, 60, 99, 255)
"""Numbers of requests: public ones, those of callbacks' results, and some unknown ones."""


def cycles(folder: Path) -> int:
    """Number of writes of the stored file: the ignition cycle grows with each successful Init, and is written after Terminate."""
    (file,) = folder.glob("eco_control/*.txt")
    (line,) = (line for line in file.read_text().splitlines() if line.startswith("ignition_cycle: "))
    return int(line.partition(": ")[2])


@pytest.mark.parametrize("state", REACHED)
def test_only_the_right_transitions_are_made(language, state, tmp_path):
    """A wrong one is refused, and the node lives on."""
    with running(language, tmp_path, NODE) as peer:
        peer.bring(NODE, *REACHED[state])
        for transition in ASKED:
            if (state, transition) not in MADE:
                peer.change(NODE, transition)
                assert peer.state(NODE) == state, transition
        shutdown = next(number for (before, number), after in MADE.items() if (before, after) == (state, "finalized"))
        peer.bring(NODE, shutdown)
        for transition in ASKED:
            peer.change(NODE, transition)
            assert peer.state(NODE) == "finalized", transition


def test_each_good_init_is_followed_by_one_terminate(language, tmp_path):
    with running(language, tmp_path, NODE) as peer:
        for number in (1, 2, 3):
            peer.bring(NODE, CONFIGURE, ACTIVATE, DEACTIVATE, ACTIVATE, DEACTIVATE, CLEANUP)
            assert cycles(tmp_path) == number
        peer.bring(NODE, CONFIGURE, ACTIVATE, ACTIVE_SHUTDOWN)
        assert cycles(tmp_path) == 4
    assert cycles(tmp_path) == 4


def test_what_is_kept_is_written_when_a_process_is_told_to_end(language, tmp_path):
    for number in (1, 2):
        with running(language, tmp_path, NODE) as peer:
            peer.bring(NODE, CONFIGURE, ACTIVATE)
        assert cycles(tmp_path) == number


def stored_file(peer: Peer, folder: Path) -> Path:
    """The file of the node, whose name has the domain."""
    file = folder / f"eco_control/{NODE}-{peer.variables['ROS_DOMAIN_ID']}.txt"
    file.parent.mkdir()
    return file


@pytest.mark.parametrize("text", ["", "sigcat 1\nignition_cycle: 70", "sigcat 1\nignition_cycle: 1e2\n"])
def test_a_file_that_is_not_whole_is_left_aside(language, text, tmp_path):
    """One that ends within its last number too: the rest of it may be missing."""
    with running(language, tmp_path, NODE) as peer:
        file = stored_file(peer, tmp_path)
        file.write_text(text)
        peer.bring(NODE, CONFIGURE, CLEANUP)
    assert file.with_name(f"{file.name}.broken").read_text() == text
    assert cycles(tmp_path) == 1


def test_what_another_version_has_stored_stays(language, tmp_path):
    """A function that is updated and set back keeps its learned values; bytes that are not text do no harm."""
    with running(language, tmp_path, NODE) as peer:
        file = stored_file(peer, tmp_path)
        file.write_bytes(b"sigcat 1\nOfAnotherVersion: 5\nignition_cycle: 7\n\xff: \xfe\n")
        peer.bring(NODE, CONFIGURE, CLEANUP, CONFIGURE, CLEANUP)
    lines = file.read_bytes().split(b"\n")
    assert {b"OfAnotherVersion: 5", b"ignition_cycle: 9", b"\xff: \xfe"} <= {*lines}


FULL_DISK = """
#include <cerrno>

extern "C" int fsync(int)
{
  errno = ENOSPC;
  return -1;
}
"""


def test_a_disk_that_is_full_leaves_what_was_stored_and_is_told(language, tmp_path, monkeypatch):
    workspace()
    monkeypatch.setenv("LD_PRELOAD", str(preloaded(FULL_DISK, tmp_path)))
    with running(language, tmp_path, NODE) as peer:
        file = stored_file(peer, tmp_path)
        file.write_text("sigcat 1\nignition_cycle: 7\n")
        peer.bring(NODE, CONFIGURE, CLEANUP)
    assert file.read_text() == "sigcat 1\nignition_cycle: 7\n"
    assert [each.name for each in file.parent.iterdir()] == [file.name]
    assert "No space left on device" in (tmp_path / "nodes.txt").read_text()
