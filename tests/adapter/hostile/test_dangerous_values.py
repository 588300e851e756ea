"""Fields with a type have the most dangerous values that their types accept: parsers of generated files find none as code."""

import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path

import pytest

from sigcat.adapter.core.core_files import core_files
from sigcat.adapter.core.planned_core import derive
from sigcat.adapter.files import GeneratedFile
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.platform import Options
from sigcat.platforms.table import PLATFORMS
from tests.adapter.hostile.dangerous import dangerous
from tests.adapter.hostile.everything import DOCUMENTS, FUNCTION_JSON, catalogue
from tests.adapter.ros2.test_interfaces import parsed
from tests.adapter.test_hostile_text import LANGUAGES
from tests.needs import ros2

ALONE = re.compile(r"(?<!\w)EVIL_?(?!\w)")
"""The word that values have between signs."""


@cache
def generated(kind: str, data: bytes) -> Sequence[GeneratedFile]:
    """Files of a document by every generator that takes it, with and without a bench."""
    if kind == FUNCTION_JSON:
        (function,) = read_functions([(data, "a.json")], catalogue()).functions
        return core_files(derive(function).plan).files
    return [
        file
        for generator in PLATFORMS[kind].generators
        for bench in {False, generator.has_bench}
        for file in generator.generate(data, "a.json", DEFAULT_LIMITS, Options(bench=bench))
    ]


@pytest.mark.parametrize("kind", DOCUMENTS)
def test_no_value_of_a_type_becomes_code(kind):
    document = dangerous(kind)
    assert len(document.changes) > 100
    files = generated(kind, document.data)
    assert sum(b"EVIL" in file.data for file in files) > 1
    for file in files:
        words = LANGUAGES.get(Path(file.name).suffix, lambda file: [file.data.decode("utf-8", "replace")])(file)
        assert [word for word in words if ALONE.search(word)] == [], file.name


@ros2
def test_rosidl_reads_messages_with_such_values(tmp_path):
    found = parsed({file.name: file.data.decode() for file in generated("ros2", dangerous("ros2").data)}, tmp_path)
    named = [name for each in found.values() for _, name, *_ in (*each.get("fields", ()), *each.get("constants", ()))]
    assert len(named) > 20
    assert [name for name in named if not re.fullmatch(r"\w+", name)] == []
