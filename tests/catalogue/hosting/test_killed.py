"""Killed at any point of a pull or of a reload, the service starts again with the last good catalogue.

Real processes are killed after random times, drawn from a fixed seed. `make fuzz` sets SIGCAT_FUZZ: then it is 50 times each, and in `make slow` two.
"""

import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from random import Random

import pytest

from sigcat.api.tokens import new_token
from sigcat.catalogue.hosting.library import Source, load
from sigcat.catalogue.hosting.releases import pull, pulled_releases, releases_folder
from tests.catalogue.hosting.archives import FILES, everything_in
from tests.needs import IS_SLOW_RUN

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the SIGKILL of POSIX")
TIMES = 50 if "SIGCAT_FUZZ" in os.environ else 2 if IS_SLOW_RUN else 1
SECRET, TOKEN = new_token("ci", ["reload"])
WHOLE = sorted([*(name for name in FILES if not name.startswith("docs")), "release.json"])
SIGCAT = (sys.executable, "-m", "sigcat.cli")


@contextmanager
def served(*arguments: str) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """A service in a separate process, and its address."""
    command = [*SIGCAT, "serve", "--port", "0", *arguments]
    with (
        tempfile.TemporaryFile("w+") as log,
        subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log, text=True) as process,
    ):
        try:
            assert process.stdout is not None
            told = process.stdout.readline()
            assert told.startswith("sigcat is at "), os.pread(log.fileno(), 10_000, 0)
            yield told.split()[3], process
        finally:
            process.kill()


def hosted_in(address: str) -> Mapping[str, str]:
    """Content hashes of the hosted catalogues of a service, by id."""
    with urllib.request.urlopen(f"{address}/health/ready", timeout=10) as answer:
        hosted: Mapping[str, str] = json.load(answer)["digests"]
    return hosted


def test_a_service_starts_with_every_whole_release_wherever_a_pull_was_killed(server: str, data: Path) -> None:
    random = Random(1)
    good = pull("v5.0", f"{server}/good", allows_private=True)
    digest = load(Source("v5.0", "v5.0", good.spec)).digest
    start = time.monotonic()
    subprocess.run(
        [*SIGCAT, "pull", "v6.0", "--from", f"{server}/good", "--allow-private"], check=True, capture_output=True
    )
    whole_pull = time.monotonic() - start
    for number in range(TIMES):
        process = subprocess.Popen(
            [*SIGCAT, "pull", f"v{number + 7}.0", "--from", f"{server}/good", "--allow-private"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        time.sleep(random.uniform(0.2, 1.1) * whole_pull)
        process.kill()
        process.wait()
        releases = pulled_releases()
        assert {"v5.0", "v6.0"} <= {release.name for release in releases}
        assert all(everything_in(release.folder) == WHOLE for release in releases)
        with served() as (address, _):
            assert {release.name: digest for release in releases}.items() <= hosted_in(address).items()
    pull("v1000.0", f"{server}/good", allows_private=True)
    assert not list(releases_folder().glob(".*")), "what killed processes left is removed by the next pull"


STATES = [
    f"Vehicle: {{type: branch, description: State {number}.}}\n"
    + "".join(f"Vehicle.S{i}: {{type: sensor, datatype: float, description: Signal {i}.}}\n" for i in range(3000))
    for number in range(2)
]


def write(file: Path, text: str) -> None:
    """Put a new state in the place of the old one at once, as whoever deploys files has to."""
    beside = file.with_suffix(".new")
    beside.write_text(text)
    beside.rename(file)


def reload_again_and_again(address: str, tree: Path) -> None:
    """Change the files and have them read, until the service is gone."""
    request = urllib.request.Request(
        f"{address}/api/v1/catalogues/own/reload", method="POST", headers={"Authorization": f"Bearer {SECRET}"}
    )
    try:
        for number in range(1, 1000):
            write(tree, STATES[number % 2])
            urllib.request.urlopen(request, timeout=10).close()
    except OSError:
        return


def test_a_service_starts_with_the_last_good_state_wherever_a_reload_was_killed(tmp_path: Path, data: Path) -> None:
    random = Random(2)
    tree = tmp_path / "tree.vspec"
    config = tmp_path / "sigcat.toml"
    config.write_text(
        f'shipped = false\n[[catalogue]]\nid = "own"\nspec = "tree.vspec"\n[service]\ntokens = ["{TOKEN}"]\n'
    )
    digests = set()
    for state in reversed(STATES):
        write(tree, state)
        digests.add(load(Source("own", "own", tree)).digest)
    for _ in range(TIMES):
        with served("--config", str(config)) as (address, process):
            assert set(hosted_in(address).values()) == {load(Source("own", "own", tree)).digest} <= digests
            writing = threading.Thread(target=reload_again_and_again, args=(address, tree))
            writing.start()
            time.sleep(random.uniform(0.0, 1.0))
            process.send_signal(signal.SIGKILL)
            writing.join()
    with served("--config", str(config)) as (address, _):
        assert set(hosted_in(address).values()) <= digests
