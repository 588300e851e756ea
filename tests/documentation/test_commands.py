"""The commands that pages show run as they are shown: by a shell, against a service that is really there.

Commands whose output is shown run in tests/test_generated.py, which compares it.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from tests.catalogue.hosting.archives import saved, tar_bytes
from tests.documentation.pages import PAGES, ROOT, blocks

SIGCAT = (sys.executable, "-m", "sigcat.cli")
SHOWN_AT = "http://127.0.0.1:8000"
BEYOND = (
    *("make ", ".venv/", "sigcat pull", "openapi-python-client ", "npx ", "docker ", "uvicorn "),
    *("sigcat registry verify", "sigcat registry export", "sigcat registry token revoke"),
    *("python3 -m venv", "venv/bin/", "export PATH=", "mkdir speed_warning", "git push", "git switch"),
)
"""Commands that have separate tests or set up a machine: they need more than a shell and a service."""
PRELUDE = f"""\
set -eu
curl() {{ command curl --fail-with-body --silent --show-error "$@"; }}
sigcat() {{
  {shlex.join(SIGCAT)} "$@" || {{ status=$?; [[ $status == 1 && $1 =~ ^(lint|diff)$ ]] || return $status; }}
}}
"""
FILES = {
    "tree.vspec": "Vehicle:\n  type: branch\n  description: A vehicle.\nVehicle.Speed:\n  type: sensor\n"
    "  datatype: float\n  unit: km/h\n  description: How fast it is.\n",
    "overlay.vspec": "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  max: 250\n  ASILlevel: B\n",
    "my_overlay.vspec": "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  max: 250\n  ASILlevel: B\n",
    "types.vspec": "Types:\n  type: branch\n  description: Types.\nTypes.Place:\n  type: struct\n  description: A place.\n"
    "Types.Place.X:\n  type: property\n  datatype: float\n  description: Along the vehicle.\n",
    "overlays/seats.vspec": "Vehicle.Speed:\n  comment: Of the vehicle.\n",
    "function.yaml": "function: Watch\ndescription: Watches the speed.\nresponsible: A team\ndefine:\n  scheduling:\n"
    "    Init: {description: Starts., asil: QM}\n    Step: {description: Watches., cycleTime: 10, asil: QM}\n"
    "    Terminate: {description: Ends., asil: QM}\ncomponents:\n  - name: Watch\n    runnables:\n      - Init\n"
    "      - interface: Step\n        data: [{path: Vehicle.Speed, role: consumed, variable: v, asil: QM}]\n"
    "      - Terminate\n",
}


def shell_blocks() -> Iterator[tuple[str, str]]:
    for page in PAGES:
        for block in blocks(page, "sh"):
            lines = [line.strip() for line in block.text.splitlines() if line.strip()]
            if commands := [line for line in lines if not line.startswith(BEYOND)]:
                yield page, "\n".join(commands)


SHELL_BLOCKS = list(shell_blocks())


def test_pages_show_commands():
    assert len({page for page, _ in SHELL_BLOCKS}) > 5


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, str]:
    """An environment in which the releases that pages name were pulled."""
    data = tmp_path_factory.mktemp("data")
    environment = {
        **os.environ,
        "PYTHONPATH": str(ROOT / "app"),
        "SIGCAT_DATA": str(data),
        "GIT_CONFIG_GLOBAL": os.devnull,
    }
    archive = saved(tmp_path_factory.mktemp("archive"), tar_bytes())
    for release in ("v5.0", "v6.0"):
        pull = [*SIGCAT, "pull", release, "--from", str(archive)]
        subprocess.run(pull, env=environment, check=True, capture_output=True)
    return environment


@pytest.fixture(scope="module")
def registry(environment: Mapping[str, str], tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """The project of the page about the registry, with its functions published, and a token."""
    folder = tmp_path_factory.mktemp("registry")
    write_titled("docs/how-to/registry.md", folder)
    project = folder / "sigcat.toml"
    project.write_text(project.read_text().replace("[registry]", '[registry]\nkey = "registry.key"'))
    for arguments in (
        ("registry", "new-key", "registry.key"),
        ("publish", *(f"functions/{name}.function.yaml" for name in ("Advisor", "Display", "Meter"))),
        ("registry", "record-deployment", "SUV-2025", "Display@1.0.0"),
    ):
        subprocess.run([*SIGCAT, *arguments], cwd=folder, env=environment, check=True, capture_output=True)
    (folder / "served.toml").write_text('[registry]\ndatabase = "registry.db"\nkey = "registry.key"\n')
    new = [*SIGCAT, "registry", "token", "create", "ci", "--scope", "administer"]
    token = subprocess.run(new, cwd=folder, env=environment, capture_output=True, text=True, check=True).stdout.strip()
    return folder / "served.toml", token


@pytest.fixture(scope="module")
def service(environment: Mapping[str, str], registry: tuple[Path, str]) -> Iterator[tuple[str, str]]:
    """Address of a service, and a token that it takes."""
    new = [*SIGCAT, "config", "--new-token", "ci", "--scope", "reload"]
    printed = subprocess.run(new, env=environment, capture_output=True, text=True, check=True).stdout
    token = re.findall(r"^sigcat_\S+", printed, re.MULTILINE)[0]
    with_token = {**environment, "SIGCAT_TOKENS": re.findall(r"ci:reload:[0-9a-f]{64}", printed)[0]}
    command = [*SIGCAT, "serve", "--port", "0", "--config", str(registry[0])]
    with subprocess.Popen(command, env=with_token, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as run:
        assert run.stdout is not None
        match = re.search(r"http://\S+", run.stdout.readline())
        assert match, "the service did not start"
        yield match.group(), token
        run.terminate()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A repository with a tree, an overlay and the examples."""
    shutil.copytree(ROOT / "vspec", tmp_path / "vspec")
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    for name in ("units.yaml", "quantities.yaml"):
        shutil.copy(ROOT / "vspec" / name, tmp_path)
    shutil.copy(ROOT / "examples/ecocontrol/expected/core_acc.json", tmp_path / "CoreAcc.json")
    who = ("-c", "user.name=A", "-c", "user.email=a@example.org")
    for arguments in (("init", "-q"), ("add", "."), (*who, "commit", "-q", "-m", "All")):
        subprocess.run(
            ["git", *arguments], cwd=tmp_path, check=True, env={**os.environ, "GIT_CONFIG_GLOBAL": os.devnull}
        )
    (tmp_path / "baseline.json").write_text('{"version": 1, "findings": []}')
    return tmp_path


TITLED = re.compile(r'```\w+ title="([^"]+)"\n(.*?)```', re.DOTALL)
"""Files that a page shows whole, by their names."""


def write_titled(page: str, folder: Path, address: str = SHOWN_AT) -> None:
    """Write the files that a page shows, for a service at an address."""
    for name, text in TITLED.findall((ROOT / page).read_text("utf-8")):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text.replace(SHOWN_AT, address), encoding="utf-8")


@pytest.mark.parametrize(("page", "block"), SHELL_BLOCKS, ids=lambda text: text.splitlines()[0])
def test_the_commands_run(page, block, environment, service, registry, folder):
    if not shutil.which("curl"):
        pytest.skip("curl: install it")
    address, token = service
    write_titled(page, folder, address)
    done = subprocess.run(
        ["bash", "-c", PRELUDE + block.replace(SHOWN_AT, address)],
        check=False,
        cwd=folder,
        env={**environment, "TOKEN": token, "SIGCAT_TOKEN": registry[1]},
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert done.returncode == 0, f"{page}: {done.stdout[-500:]}{done.stderr}"
    assert "internal error" not in done.stderr
