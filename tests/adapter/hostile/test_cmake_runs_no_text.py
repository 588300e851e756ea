"""CMake itself runs the files of attacked documents: it calls what it calls for the same documents without attacks.

A file that an attack does not change is run once, as it is without the attack.
"""

import json
import re
import subprocess
from functools import cache
from pathlib import Path

import pytest

from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.platform import Options
from sigcat.platforms.table import PLATFORMS
from tests.adapter.hostile.dangerous import dangerous
from tests.adapter.hostile.everything import document
from tests.adapter.test_hostile_text import ATTACKS, READERS, generated

HARMLESS = "EVIL"
"""A text without any sign."""
CALL = re.compile(r"^\s*([A-Za-z_]\w*)\s*\(", re.MULTILINE)
FLOW = {"if", "elseif", "else", "endif", "foreach", "endforeach", "function", "endfunction", "macro", "endmacro", "set"}


@cache
def files_of_cmake(platform: str, attack: str) -> dict[str, str]:
    return {
        file.name: file.data.decode() for file in generated(platform, attack) if file.name.endswith("CMakeLists.txt")
    }


def calls(text: str, names: set[str], folder: Path) -> list[str]:
    """Names of the commands that CMake calls, each of `names` doing nothing."""
    folder.mkdir()
    (folder / "listed.cmake").write_text(text, encoding="utf-8")
    stubs = "".join(f"function({name})\nendfunction()\n" for name in sorted(names - FLOW))
    (folder / "run.cmake").write_text(f"{stubs}include(${{CMAKE_CURRENT_LIST_DIR}}/listed.cmake)\n", encoding="utf-8")
    command = ["cmake", "--trace-expand", "--trace-format=json-v1", "--trace-redirect=trace.json", "-P", "run.cmake"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    rows = [json.loads(row) for row in (folder / "trace.json").read_text(encoding="utf-8").splitlines()]
    return [row["cmd"].lower() for row in rows if row.get("file", "").endswith("listed.cmake")]


@pytest.mark.parametrize("platform", READERS)
def test_text_calls_no_command(platform, tmp_path):
    for name, plain in files_of_cmake(platform, HARMLESS).items():
        names = {each.lower() for each in CALL.findall(plain)} - {"include"}
        expected = calls(plain, names, tmp_path / f"{name.replace('/', '_')}.plain")
        assert expected
        for index, attack in enumerate(ATTACKS):
            text = files_of_cmake(platform, attack)[name]
            if text == plain:
                continue
            assert calls(text, names, tmp_path / f"{name.replace('/', '_')}.{index}") == expected, (name, attack)


@pytest.mark.parametrize("platform", READERS)
def test_values_of_types_call_no_command(platform, tmp_path):
    names, expected, found = set[str](), [], []
    for index, text in enumerate(listed(platform, document(platform))):
        names |= {each.lower() for each in CALL.findall(text)} - {"include"}
        expected.append(sorted(calls(text, names, tmp_path / f"plain{index}")))
    for index, text in enumerate(listed(platform, dangerous(platform).data)):
        found.append(sorted(calls(text, names, tmp_path / str(index))))
    assert any(expected)
    assert sorted(found) == sorted(expected)


def listed(platform: str, data: bytes) -> list[str]:
    """Files of CMake of a document."""
    return [
        file.data.decode()
        for generator in PLATFORMS[platform].generators
        for file in generator.generate(data, "a.json", DEFAULT_LIMITS, Options(bench=generator.has_bench))
        if file.name.endswith("CMakeLists.txt")
    ]


def test_a_command_in_a_text_is_noticed(tmp_path):
    with pytest.raises(AssertionError, match="EVIL"):
        calls("set(a b)\nEVIL()\n", set(), tmp_path / "a")
    assert calls("set(a b)\nmessage(c)\n", set(), tmp_path / "b") == ["set", "message"]
