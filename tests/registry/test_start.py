"""The packages of the registry are loaded by its commands only, and a missing one is reported."""

import subprocess
import sys
from pathlib import Path

import pytest

from sigcat.cli.registry_options import hosted_registry
from sigcat.project.project import Project, RegistrySettings

_WITHOUT = "import sys; sys.modules.update(dict.fromkeys({packages})); from sigcat.cli import main; sys.exit(main())"
_LOADED = (
    "import sys; from sigcat.cli import main; main();"
    " print([name for name in ('sqlalchemy', 'cryptography') if name in sys.modules])"
)


def run(code: str, folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code, *arguments], cwd=folder, capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize(
    ("missing", "arguments"),
    [
        ("sqlalchemy", ("registry", "list")),
        ("sqlalchemy", ("users", "Vehicle.Speed")),
        ("cryptography", ("registry", "list")),
        ("cryptography", ("registry", "new-key", "other.key")),
    ],
)
def test_a_command_without_its_packages_says_what_to_install(
    tmp_path: Path, missing: str, arguments: tuple[str, ...]
) -> None:
    (tmp_path / "sigcat.toml").write_text('[registry]\ndatabase = "registry.db"\nkey = "key"\n', encoding="utf-8")
    ended = run(_WITHOUT.format(packages=(missing, f"{missing}.exceptions")), tmp_path, *arguments)
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr.endswith("run `pip install 'sigcat[registry]'`\n")
    assert [each.name for each in tmp_path.iterdir()] == ["sigcat.toml"]


def test_a_command_without_the_driver_of_its_database_says_what_to_install(tmp_path: Path) -> None:
    (tmp_path / "sigcat.toml").write_text('[registry]\ndatabase = "postgresql://host/name"\n', encoding="utf-8")
    ended = run(_WITHOUT.format(packages=("psycopg",)), tmp_path, "registry", "list")
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr.endswith("run `pip install 'sigcat[registry-postgresql]'`\n")


def test_a_service_whose_key_is_missing_serves_the_rest(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    settings = RegistrySettings(tmp_path / "registry.db", tmp_path / "missing.key")
    assert hosted_registry(Project(registry=settings)) is None
    assert "the registry is not served" in capsys.readouterr().err


def test_a_lint_in_a_project_with_a_registry_loads_neither(tmp_path: Path) -> None:
    (tmp_path / "sigcat.toml").write_text('[registry]\ndatabase = "registry.db"\n', encoding="utf-8")
    (tmp_path / "own.vspec").write_text(
        "Vehicle.Own: {type: sensor, datatype: float, description: Own signal.}\n", encoding="utf-8"
    )
    assert run(_LOADED, tmp_path, "lint").stdout.splitlines()[-1] == "[]"
