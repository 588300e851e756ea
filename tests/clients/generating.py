"""Generate clients from the running service, check their types, and run the same round trip with each."""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory

from sigcat.digest import digest_of

ROOT = Path(__file__).parents[2]
CASES = Path(__file__).parent / "cases"
NODE_FOLDER = ROOT / ".venv" / "node"
DECLARATION = ROOT / "examples" / "core_acc" / "function.yaml"
_ENVIRONMENT = {
    **os.environ,
    "PYTHONPATH": str(ROOT / "app"),
    "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}",
}


class NoNode(Exception):
    """Node or its packages are not to be had here."""


@contextmanager
def running_service() -> Iterator[str]:
    """Address of a service with the shipped catalogues and an empty registry, in a separate process."""
    with TemporaryDirectory() as folder:
        project = Path(folder) / "sigcat.toml"
        project.write_text('[registry]\ndatabase = "registry.db"\n')
        yield from _served(project)


def _served(project: Path) -> Iterator[str]:
    command = [sys.executable, "-m", "sigcat.cli", "serve", "--port", "0", "--config", str(project)]
    with subprocess.Popen(command, cwd=ROOT, env=_ENVIRONMENT, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            match = re.search(r"http://\S+", process.stdout.readline())
            assert match, "the service did not start"
            yield match.group()
        finally:
            process.terminate()


def check_python_client(address: str, folder: Path) -> None:
    """Generate the Python client, check it with mypy --strict, run the round trip. Raises AssertionError."""
    tool = str(Path(sys.executable).with_name("openapi-python-client"))
    config = f"--config={CASES / 'python.yaml'}"
    output = f"--output-path={folder / 'sigcat_client'}"
    url = f"--url={address}/openapi.json"
    _run([tool, "generate", url, "--meta=none", "--fail-on-warning", config, output], folder)
    shutil.copy(CASES / "round_trip.py", folder)
    (folder / "mypy.ini").write_text("[mypy]\nstrict = true\n")
    _run([sys.executable, "-m", "mypy", "--config-file=mypy.ini", "sigcat_client", "round_trip.py"], folder)
    _run([sys.executable, "round_trip.py", address, str(DECLARATION)], folder)


def check_typescript_client(address: str, folder: Path) -> None:
    """Generate the TypeScript client, check it with tsc, run the round trip. Raises NoNode, or AssertionError."""
    tools = node_tools()
    for name in ("round_trip.ts", "tsconfig.json", "package.json", "openapi-ts.config.mjs"):
        shutil.copy(CASES / name, folder)
    (folder / "node_modules").symlink_to(tools / "node_modules")
    _run([str(tools / "node_modules/.bin/openapi-ts")], folder, OPENAPI=f"{address}/openapi.json")
    _run([str(tools / "node_modules/.bin/tsc"), "-p", "."], folder)
    _run(["node", "built/round_trip.js", address, str(DECLARATION)], folder)


def lint_with_redocly(document: Path) -> None:
    """Lint an OpenAPI document with Redocly's recommended rules, warnings as errors. Raises NoNode, or AssertionError."""
    tool = node_tools() / "node_modules/.bin/redocly"
    _run([str(tool), "lint", str(document), f"--config={CASES / 'redocly.yaml'}", "--format=stylish"], CASES)


def lint_with_spectral(document: Path) -> None:
    """Lint an OpenAPI document with all rules that Spectral has for OpenAPI. Raises NoNode, or AssertionError."""
    tool = node_tools() / "node_modules/.bin/spectral"
    rules = f"--ruleset={CASES / 'spectral.yaml'}"
    _run([str(tool), "lint", str(document), rules, "--fail-severity=hint"], CASES)


def node_tools() -> Path:
    """A folder with the packages of package-lock.json, installed once. Raises NoNode."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        raise NoNode("Node: install it with npm")
    folder = NODE_FOLDER / digest_of((CASES / "package-lock.json").read_bytes())[:12]
    if not folder.is_dir():
        NODE_FOLDER.mkdir(parents=True, exist_ok=True)
        with TemporaryDirectory(dir=NODE_FOLDER) as temporary:
            _install(npm, Path(temporary))
            with suppress(OSError):  # another test was faster
                Path(temporary, "tools").rename(folder)
    return folder


def _install(npm: str, folder: Path) -> None:
    tools = folder / "tools"
    tools.mkdir()
    for name in ("package.json", "package-lock.json"):
        shutil.copy(CASES / name, tools)
    quiet = ["--no-audit", "--no-fund", "--ignore-scripts"]
    result = subprocess.run([npm, "ci", *quiet], cwd=tools, capture_output=True, check=False, timeout=180)
    if result.returncode:
        raise NoNode("the packages of tests/clients/cases/package-lock.json: npm could not install them")


def _run(command: list[str], folder: Path, **extra: str) -> None:
    environment = {**_ENVIRONMENT, **extra, "REDOCLY_TELEMETRY": "off", "REDOCLY_SUPPRESS_UPDATE_NOTICE": "true"}
    environment["MYPYPATH"] = environment["PYTHONPATH"] = str(folder)
    result = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False, timeout=120
    )
    assert result.returncode == 0, f"{' '.join(command)}\n{result.stdout}\n{result.stderr}"
