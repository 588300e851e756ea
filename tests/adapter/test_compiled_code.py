"""Declared settings of the code are used in every compilation: folders of headers, macros."""

from pathlib import Path

import pytest

from scripts.cases import ROOT, RUNS
from sigcat.cli import main

CASE = ROOT / RUNS.folder / "one_function_feeds_another"


@pytest.mark.parametrize("platform", ["autosar-adaptive", "autosar-classic", "ros2"])
def test_folders_and_macros_of_a_declaration_are_those_of_cmake(platform: str, tmp_path: Path):
    functions = [str(CASE / name) for name in ("filter.yaml", "counter.yaml")]
    document = tmp_path / "integration.json"
    assert main(["integrate", platform, *functions, "-o", str(document)]) == 0
    bench = [] if platform == "ros2" else ["--bench"]
    assert main(["generate", platform, str(document), *bench, "-o", str(tmp_path / "generated")]) == 0
    told = "".join(path.read_text() for path in (tmp_path / "generated").rglob("CMakeLists.txt"))
    assert "${COUNTER_CODE}/code" in told.replace("${COUNTER_CODE}/code/counter.c", "")
    assert '"COUNTER_STEP=2"' in told
