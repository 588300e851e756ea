"""Functions of one set have versions of their own; each platform generates what it integrated."""

from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.platforms.table import PLATFORMS

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("platform", PLATFORMS)
def test_functions_of_different_versions_are_one_set(platform: str, tmp_path: Path) -> None:
    files = []
    for name, version in (("core_acc", "1.2.0"), ("eco_control_mpc", "0.3.1")):
        text = (EXAMPLES / name / "function.yaml").read_text()
        assert "\nversion: 1.0.0\n" in text
        files.append(tmp_path / f"{name}.yaml")
        files[-1].write_text(text.replace("\nversion: 1.0.0\n", f"\nversion: {version}\n"))
    document = tmp_path / "set.json"
    deployment = ["--deployment", str(EXAMPLES / "ecocontrol/deployment.yaml")]
    assert main(["integrate", platform, *map(str, files), *deployment, "-o", str(document), "--isolated"]) == 0
    assert main(["generate", platform, str(document), "-o", str(tmp_path / "out")]) == 0
