"""The log of the service: signals, failures with one traceback, a fork server that was killed."""

import json
import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from tests import plain_http
from tests.api.conftest import TREE
from tests.api.serving import Service, served
from tests.api.test_running import OVERLAY
from tests.processes import PROC, family
from tests.waiting import wait_until

VEHICLE = "Vehicle: {type: branch, description: A vehicle.}\n"
FAILING = f"""\
from pathlib import Path
from sigcat.api.server import run
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library, Source
from sigcat.web.site import create_site

site = create_site(Library([Source("small", "Small", Path({str(TREE / "tree.vspec")!r}))]))

@site.get("/api/v1/failing")
async def failing() -> None:
    raise RuntimeError("on purpose")

@site.get("/failing")
async def failing_page() -> None:
    raise RuntimeError("on purpose")

run(site, Settings(port=0))
"""


def messages(service: Service, level: str) -> list[str]:
    return [str(line["message"]) for line in service.logged(level=level) if "message" in line]


def test_sighup_reads_files_again_and_is_logged(tmp_path: Path) -> None:
    tree = tmp_path / "tree.vspec"
    tree.write_text(VEHICLE)
    with served(tree) as service:
        address = f"{service.address}/api/v1/catalogues/local"
        assert plain_http.get(address).json()["node_count"] == 1
        tree.write_text(VEHICLE + OVERLAY.decode())
        service.process.send_signal(signal.SIGHUP)
        wait_until(lambda: plain_http.get(address).json()["node_count"] == 2, "the files are read again")
        wait_until(lambda: any(each.startswith("functions: ") for each in messages(service, "info")), "all are read")
        assert [each for each in messages(service, "info") if each.startswith("SIGHUP")]
        assert service.process.poll() is None


@pytest.mark.parametrize("path", ["/api/v1/failing", "/failing"])
def test_a_failure_has_one_traceback_and_the_id_of_its_request(path: str) -> None:
    with (
        tempfile.TemporaryFile("w+") as log,
        subprocess.Popen([sys.executable, "-c", FAILING], stdout=subprocess.PIPE, stderr=log, text=True) as process,
    ):
        assert process.stdout is not None
        try:
            answer = plain_http.get(process.stdout.readline().split()[3] + path)
        finally:
            process.terminate()
            process.wait()
        log.seek(0)
        lines = [json.loads(line) for line in log]
    traces = [line for line in lines if "trace" in line]
    assert (answer.status_code, len(traces)) == (500, 1)
    assert answer.headers["x-request-id"] in traces[0]["message"]
    assert "on purpose" in traces[0]["trace"]


@pytest.mark.skipif(not PROC.exists(), reason="Linux, where processes are found in /proc")
def test_a_fork_server_that_is_killed_is_logged_and_replaced() -> None:
    with served(TREE / "tree.vspec") as service:
        assert plain_http.post(f"{service.address}/api/v1/lint", content=OVERLAY).status_code == 200
        os.kill(fork_server(service), signal.SIGKILL)
        wait_until(lambda: messages(service, "error"), "it is logged")
        assert "killed by signal 9" in messages(service, "error")[0]
        assert plain_http.post(f"{service.address}/api/v1/lint", content=OVERLAY).status_code == 200
        assert len(messages(service, "error")) == 1


def fork_server(service: Service) -> int:
    """The child of the service that forks workers."""
    for process in family(service.process.pid):
        if b"sigcat.api.work.worker" in (PROC / str(process) / "cmdline").read_bytes():
            return process
    raise AssertionError("the service has a fork server")
