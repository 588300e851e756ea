"""Logs that python-can writes, and what the gateway makes of them."""

import csv

import can
import pytest

from sigcat.cli import main
from tests.gateway.logs import DBC, MAPPINGS, PATHS


@pytest.fixture(scope="session")
def mappings(tmp_path_factory):
    """The overlay with the mappings. All tests name the same file, so its catalogue is composed once."""
    path = tmp_path_factory.mktemp("mappings") / "can.vspec"
    path.write_text(MAPPINGS)
    return path


@pytest.fixture
def run(tmp_path, mappings, capsys):
    """The rows of the trace of a log, and the reported lines; by times and cells."""
    (tmp_path / "bus.dbc").write_text(DBC)
    (tmp_path / "can.vspec").write_text(MAPPINGS)

    def running(log, *options, status=0):
        out = tmp_path / "trace.csv"
        given = ("gateway", log, "--dbc", tmp_path / "bus.dbc", "-s", "vss", "-l", mappings, "-o", out)
        assert main([*map(str, given), *map(str, options)]) == status
        assert out.exists() or status in {1, 2}, "a log that yields nothing is an error"
        rows = list(csv.DictReader(out.read_text().splitlines())) if out.exists() else []
        more = [name for name in (rows[0] if rows else ()) if name not in {"time", *PATHS}]
        return [
            ",".join(row[name] for name in ("time", *PATHS, *more)) for row in rows
        ], capsys.readouterr().err.replace(f"{tmp_path}/", "").replace(f"{mappings.parent}/", "")

    return running


@pytest.fixture
def log(tmp_path):
    """A log as python-can writes it."""

    def writing(messages, name="drive.log"):
        path = tmp_path / name
        with can.Logger(str(path)) as logger:
            for each in messages:
                logger.on_message_received(each)
        return path

    return writing
