"""Exports of vss-tools in a service: forked from a process that has imported it, and gone with all files when given up."""

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from pathlib import Path

import httpx
import pytest

from sigcat.catalogue.exporting.export import export
from sigcat.catalogue.exporting.vss_tools import processes
from sigcat.catalogue.hosting.source import Source, load
from tests.api.serving import Service, served
from tests.processes import PROC, family
from tests.waiting import DEADLINE, wait_until

pytestmark = pytest.mark.skipif(not (PROC / "self/stat").exists(), reason="Linux, where processes are found in /proc")
TREE = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Row: {type: branch, instances: 'Row[1,2000]', description: A row.}
Vehicle.Row.IsFull: {type: sensor, datatype: boolean, description: Whether nobody else can sit down in this row.}
"""
_FEW_BLOCKS = ("sh", "-c", 'ulimit -f 128 && exec "$@"', "sh")
"""Files of the command behind it are at most this long: as good as a full folder, for whatever writes them."""


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("rows") / "tree.vspec"
    file.write_text(TREE)
    return file


@pytest.fixture(scope="module")
def temporary(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("temporary")


@pytest.fixture(scope="module")
def service(tree: Path, temporary: Path) -> Iterator[Service]:
    with served(tree, TMPDIR=str(temporary)) as service:
        yield service


def exported(service: Service, name: str, catalogue: str = "local") -> httpx.Response:
    return httpx.get(f"{service.address}/api/v1/catalogues/{catalogue}/export/{name}", timeout=DEADLINE)


def of_vss_tools(service: Service) -> list[int]:
    """The process that has imported vss-tools, and its children."""
    return [each for each in family(service.process.pid) if "vss_tools" in command_of(each)]


def command_of(process: int) -> str:
    with suppress(OSError):
        return (PROC / str(process) / "cmdline").read_text()
    return ""


@pytest.mark.parametrize("name", ["csv", "yaml"])
def test_an_export_has_the_bytes_of_a_process_of_its_own(service: Service, tree: Path, name: str) -> None:
    assert exported(service, name).content == export(load(Source("local", "Local", tree)), name)[0].data


def test_vss_tools_is_imported_once_where_there_is_one_thread(service: Service) -> None:
    exported(service, "csv")
    (before,) = wait_until(lambda: only_one(of_vss_tools(service)), "the export is gone")
    assert len(list((PROC / str(before) / "task").iterdir())) == 1
    exported(service, "tree")
    (after,) = wait_until(lambda: only_one(of_vss_tools(service)), "the export is gone")
    assert after == before


def only_one(processes: list[int]) -> list[int]:
    return processes if len(processes) == 1 else []


def test_an_export_that_is_given_up_leaves_nothing(tree: Path, tmp_path: Path) -> None:
    with served(tree, TMPDIR=str(tmp_path), SIGCAT_HEAVY_SECONDS="5") as service:
        refused = exported(service, "id")
        assert (refused.status_code, "longer than 5 seconds" in refused.text) == (503, True)
        wait_until(lambda: not list(tmp_path.iterdir()), "its files are removed")
        wait_until(lambda: len(of_vss_tools(service)) <= 1, "its process ends")


def test_equal_exports_under_way_are_one(service: Service, temporary: Path) -> None:
    with ThreadPoolExecutor(3) as clients:
        answers = [clients.submit(partial(exported, service, "samm")) for _ in range(3)]
        wait_until(lambda: list(temporary.iterdir()), "an export begins")
        most = 0
        while not all(answer.done() for answer in answers):
            most = max(most, len(list(temporary.iterdir())))
    assert most == 1
    assert len({answer.result().content for answer in answers}) == 1


@pytest.mark.parametrize(
    ("catalogue", "what"), [("interfaces", "the tree cannot be written"), ("local", "the export cannot")]
)
def test_a_full_folder_for_temporary_files_is_said(tree: Path, tmp_path: Path, catalogue: str, what: str) -> None:
    with served(tree, before=_FEW_BLOCKS, TMPDIR=str(tmp_path)) as service:
        refused = exported(service, "csv", catalogue)
        assert (refused.status_code, refused.json()["type"]) == (507, "/problems/no-temporary-space"), what
        assert "more room for temporary files" in refused.json()["detail"]
        assert "more room for temporary files" in service.log.read_text()
        assert exported(service, "json").status_code == 200
        wait_until(lambda: not list(tmp_path.iterdir()), "what was written is removed")


def test_no_other_folder_is_taken_for_one_that_is_gone(tree: Path, tmp_path: Path) -> None:
    place = tmp_path / "temporary"
    place.mkdir()
    with served(tree, TMPDIR=str(place)) as service:
        place.rmdir()
        refused = exported(service, "csv")
        assert (refused.status_code, "No such file or directory" in refused.json()["detail"]) == (507, True)
        place.mkdir()
        assert exported(service, "csv").status_code == 200


def test_a_service_says_at_once_that_there_is_no_folder_for_temporary_files(tree: Path, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "sigcat.cli", "serve", "--port", "0", "-s", str(tree)]
    environment = {**os.environ, "TMPDIR": str(tmp_path / "none")}
    ended = subprocess.run(command, check=False, env=environment, capture_output=True, text=True, timeout=DEADLINE)
    assert (ended.returncode, ended.stdout) == (2, "")
    assert "sigcat: Temporary files cannot be written: No such file or directory." in ended.stderr


def test_an_exporter_that_somebody_kills_is_no_fault_of_the_tree(tree: Path) -> None:
    with served(tree) as service, ThreadPoolExecutor(1) as client:
        answer = client.submit(exported, service, "id")
        (_, export) = wait_until(lambda: of_vss_tools(service)[1:] and of_vss_tools(service), "the export begins")
        os.kill(export, signal.SIGKILL)
        failed = answer.result()
        assert (failed.status_code, failed.json()["type"]) == (500, "/problems/internal-error")
        assert "crashed while it exported id" in failed.json()["detail"]
        assert exported(service, "csv").status_code == 200


def test_so_is_one_that_ended_before_it_was_asked(tmp_path: Path) -> None:
    ours, theirs = socket.socketpair()
    asked = processes._Forked(ours, tmp_path)
    theirs.close()
    with pytest.raises(processes.ExportEnded):
        asked.status({"seconds": DEADLINE})
    asked.close()


def test_exporters_that_need_too_much_memory_are_ended(tree: Path) -> None:
    with served(tree, SIGCAT_HEAVY_BYTES=str(8 * 1024 * 1024)) as service:
        refused = exported(service, "yaml", "interfaces")
        assert (refused.status_code, "more than 8 MiB" in refused.text) == (503, True)
