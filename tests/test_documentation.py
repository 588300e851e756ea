"""The commands that README and docs show run as they are shown: by a shell, against a service that is really there."""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from tests.catalogue.hosting.archives import saved, tar_bytes

ROOT = Path(__file__).parents[1]
SIGCAT = (sys.executable, "-m", "sigcat.cli")
SHOWN_AT = "http://127.0.0.1:8000"
DOCUMENTS = ("README.md", "docs/reference/api.md", "docs/reference/exports.md")
BEYOND = ("make ", "sigcat pull", "openapi-python-client ", "npx ")
"""Commands that have tests of their own, for they need more than a shell and a service."""
PRELUDE = f"""\
set -eu
curl() {{ command curl --fail-with-body --silent --show-error "$@"; }}
sigcat() {{ {" ".join(SIGCAT)} "$@" || test $? -eq 1; }}
"""
FILES = {
    "tree.vspec": "Vehicle:\n  type: branch\n  description: A vehicle.\nVehicle.Speed:\n  type: sensor\n"
    "  datatype: float\n  unit: km/h\n  description: How fast it is.\n",
    "overlay.vspec": "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  max: 250\n  ASILlevel: B\n",
    "types.vspec": "Types:\n  type: branch\n  description: Types.\nTypes.Place:\n  type: struct\n  description: A place.\n"
    "Types.Place.X:\n  type: property\n  datatype: float\n  description: Along the vehicle.\n",
}


def shell_blocks() -> Iterator[tuple[str, str]]:
    for document in DOCUMENTS:
        text = (ROOT / document).read_text(encoding="utf-8")
        for block in re.findall(r"^```sh\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
            lines = [line for line in block.splitlines() if line and not line.startswith(BEYOND)]
            if lines:
                yield document, "\n".join(lines)


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, str]:
    """An environment in which the release that the documents name was pulled."""
    data = tmp_path_factory.mktemp("data")
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "app"), "SIGCAT_DATA": str(data)}
    archive = saved(tmp_path_factory.mktemp("archive"), tar_bytes())
    subprocess.run([*SIGCAT, "pull", "v5.0", "--from", str(archive)], env=environment, check=True, capture_output=True)
    return environment


@pytest.fixture(scope="module")
def service(environment: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    """Address of a service, and a token that it takes."""
    new = [*SIGCAT, "config", "--new-token", "ci", "--scope", "reload"]
    told = subprocess.run(new, env=environment, capture_output=True, text=True, check=True).stdout
    token, line = re.findall(r"^sigcat_\S+", told, re.MULTILINE)[0], re.findall(r"ci:reload:[0-9a-f]{64}", told)[0]
    with_token = {**environment, "SIGCAT_TOKENS": line}
    command = [*SIGCAT, "serve", "--port", "0"]
    with subprocess.Popen(command, env=with_token, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as run:
        assert run.stdout is not None
        match = re.search(r"http://\S+", run.stdout.readline())
        assert match, "the service did not start"
        yield match.group(), token
        run.terminate()


@pytest.mark.parametrize(("document", "block"), list(shell_blocks()), ids=lambda text: text.splitlines()[0])
def test_the_commands_run(document, block, environment, service, tmp_path):
    if not shutil.which("curl"):
        pytest.skip("curl: install it")
    for name in ("vspec", "overlays", "examples"):
        (tmp_path / name).symlink_to(ROOT / name)
    for name, text in {**FILES, "my_overlay.vspec": FILES["overlay.vspec"]}.items():
        (tmp_path / name).write_text(text)
    for name in ("units.yaml", "quantities.yaml"):
        shutil.copy(ROOT / "vspec" / name, tmp_path)
    address, token = service
    script = PRELUDE + block.replace(SHOWN_AT, address)
    (tmp_path / "CoreAcc.json").write_bytes((ROOT / "examples/ecocontrol/expected/core_acc.json").read_bytes())
    done = subprocess.run(
        ["bash", "-c", script],
        check=False,
        cwd=tmp_path,
        env={**environment, "TOKEN": token},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, f"{document}: {done.stdout[-500:]}{done.stderr}"
    assert "internal error" not in done.stderr
