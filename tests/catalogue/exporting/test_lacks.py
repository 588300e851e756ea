"""An exporter that wraps what stopped it: that memory or room is lacking is seen through whatever was raised of it."""

import errno

import pytest

from sigcat.catalogue.exporting.vss_tools import worker


def raising(error, cause):
    def _export(*_):
        try:
            raise cause
        except type(cause):
            raise error  # noqa: B904 - as exporters do it

    return _export


@pytest.mark.parametrize("error", [ValueError("It cannot be written."), SystemExit(1)], ids=["raised", "exited"])
@pytest.mark.parametrize(
    ("cause", "status"),
    [
        (MemoryError(), worker.NO_MEMORY),
        (SystemError("<function> returned NULL without setting an exception"), worker.NO_MEMORY),
        (OSError(errno.ENOMEM, "Cannot allocate memory"), worker.NO_MEMORY),
        (OSError(errno.ENOSPC, "No space left on device"), worker.NO_SPACE),
        (KeyError("unit"), worker.REFUSED),
    ],
    ids=["memory", "memory even for the error", "memory of the system", "room", "neither"],
)
def test_what_is_lacking_decides(error, cause, status, monkeypatch, tmp_path):
    monkeypatch.setattr(worker, "_export", raising(error, cause))
    assert worker.export({"log": str(tmp_path / "log")}) == status


def test_memory_alone_decides_too(monkeypatch, tmp_path):
    monkeypatch.setattr(worker, "_export", raising(MemoryError(), KeyError("unit")))
    assert worker.export({"log": str(tmp_path / "log")}) == worker.NO_MEMORY
