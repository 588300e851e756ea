"""The extension for VS Code packs with npm, and its archive has the client and the grammar."""

import shutil
import subprocess
from pathlib import Path
from zipfile import ZipFile

import pytest

from tests.documentation.pages import ROOT

pytestmark = pytest.mark.real


def test_npm_packs_the_extension(tmp_path: Path) -> None:
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        pytest.skip("Node: install it with npm")
    folder = tmp_path / "vscode"
    shutil.copytree(ROOT / "editors" / "vscode", folder)
    installed = subprocess.run(
        [npm, "install", "--no-audit", "--no-fund"], cwd=folder, check=False, capture_output=True
    )
    if installed.returncode:
        pytest.skip("@vscode/vsce: npm could not install it")
    packed = subprocess.run([npm, "run", "package"], cwd=folder, check=False, capture_output=True, text=True)
    assert packed.returncode == 0, packed.stdout + packed.stderr
    (archive,) = folder.glob("*.vsix")
    with ZipFile(archive) as files:
        assert {f"extension/{name}" for name in ("package.json", "dist/extension.js", "vspec.tmLanguage.json")} <= set(
            files.namelist()
        )
