"""Several workers behind one address: `/metrics` shows their total, whichever of them answers."""

import os
import re
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import httpx
import pytest

from sigcat.api.middleware.process_metrics import workers_in
from tests import plain_http
from tests.waiting import wait_until

WORKERS = 2
REQUESTS = 40


@contextmanager
def workers(folder: Path) -> Iterator[str]:
    """The address of a service with several workers."""
    (folder / "metrics").mkdir()
    (folder / "sigcat.toml").write_text("shipped = true\n")
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    command = [sys.executable, "-m", "uvicorn", "--factory", "sigcat.cli.serve:application", "--port", str(port)]
    command += ["--http", "sigcat.api.connections.http:HttpConnection", "--workers", str(WORKERS)]
    shared = {"SIGCAT_CONFIG": str(folder / "sigcat.toml"), "PROMETHEUS_MULTIPROC_DIR": str(folder / "metrics")}
    with subprocess.Popen(command, env={**os.environ, **shared}, stderr=subprocess.DEVNULL) as process:
        try:
            yield f"http://127.0.0.1:{port}"
        finally:
            process.terminate()


def answers(address: str) -> bool:
    with suppress(httpx.TransportError):
        return plain_http.get(f"{address}/health").status_code == 200
    return False


def value(text: str, name: str) -> float:
    match = re.search(rf"^{re.escape(name)} (\S+)$", text, re.MULTILINE)
    assert match, f"{name} is not in\n{text}"
    return float(match[1])


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="Linux, where figures of processes are in /proc")
def test_metrics_are_the_total_of_all_workers(tmp_path: Path) -> None:
    with workers(tmp_path) as address:
        wait_until(lambda: answers(address), "a worker answers")
        wait_until(lambda: len(list(workers_in(tmp_path / "metrics"))) == WORKERS, "all workers have begun")
        for _ in range(REQUESTS):
            plain_http.get(f"{address}/api/v1/rules/V101")
        texts = [plain_http.get(f"{address}/metrics").text for _ in range(4)]
        serving = list(workers_in(tmp_path / "metrics"))
        held = sum(int(Path(f"/proc/{each}/statm").read_text().split()[1]) for each in serving)
    counted = 'sigcat_requests_total{method="GET",route="/api/v1/rules/{rule_id}",status="200"}'
    assert {value(text, counted) for text in texts} == {REQUESTS}
    assert all(value(text, "process_resident_memory_bytes") > held * os.sysconf("SC_PAGESIZE") / 2 for text in texts)
    assert all(value(text, "sigcat_memory_pss_bytes") > 0 for text in texts)
    assert all("sigcat_build_info{" in text for text in texts)
    assert all(re.search(r"^sigcat_heavy_pending 0\.0$", text, re.MULTILINE) for text in texts)


def test_a_worker_that_has_ended_counts_no_more(tmp_path: Path) -> None:
    ended = subprocess.Popen([sys.executable, "-c", ""])
    ended.wait()
    for process in (ended.pid, os.getpid()):
        (tmp_path / f"gauge_livesum_{process}.db").touch()
    assert list(workers_in(tmp_path)) == [os.getpid()]
    assert [file.name for file in tmp_path.iterdir()] == [f"gauge_livesum_{os.getpid()}.db"]
