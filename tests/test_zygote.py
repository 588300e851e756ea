"""The process that forks: its messages are complete, or nothing."""

import os
import signal
from pathlib import Path

import pytest

from sigcat.zygote import LENGTH, Zygote

KEEPING = """\
from pathlib import Path

def keep(data):
    Path(__file__).with_suffix(".kept").write_bytes(data)
"""


@pytest.fixture
def zygote(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Zygote:
    (tmp_path / "keeping.py").write_text(KEEPING)
    monkeypatch.syspath_prepend(str(tmp_path))
    return Zygote("keeping")


def ended(zygote: Zygote) -> int:
    zygote.close()
    return zygote.wait()


def test_a_message_is_kept(zygote: Zygote, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    zygote.tell(b"tree")
    assert (ended(zygote), capfd.readouterr().err) == (0, "")
    assert (tmp_path / "keeping.kept").read_bytes() == b"tree"


@pytest.mark.parametrize("sent", [b"", LENGTH.pack(4)[:3], LENGTH.pack(4), LENGTH.pack(4) + b"tre"])
def test_a_message_that_breaks_off_is_dropped_without_an_error(
    sent: bytes, zygote: Zygote, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """A service is stopped while it sends."""
    with zygote._asked("", is_told=True) as connection:
        connection.sendall(sent)
    assert (ended(zygote), capfd.readouterr().err) == (0, "")
    assert not (tmp_path / "keeping.kept").exists()


def test_a_child_that_ends_meanwhile_does_not_cut_a_message(zygote: Zygote, tmp_path: Path) -> None:
    """The system sends SIGCHLD, which ends a call that waits for more, however much is there."""
    data = bytes(range(256)) * 20
    with zygote._asked("", is_told=True) as connection:
        for byte in LENGTH.pack(len(data)) + data:
            connection.sendall(bytes((byte,)))
            os.kill(zygote._process.pid, signal.SIGCHLD)
    ended(zygote)
    assert (tmp_path / "keeping.kept").read_bytes() == data
