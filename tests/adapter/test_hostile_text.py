"""Documents whose free text is an attack: whatever is generated of them, parsers of its languages find no code in it."""

import ast
import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any
from xml.parsers import expat

import pytest
import yaml
from clang.cindex import Index, TokenKind
from pydantic import BaseModel

from sigcat.adapter.files import GeneratedFile
from sigcat.function.document.text import Text, json_of
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_adaptive import document as adaptive
from sigcat.integration.autosar_classic import document as classic
from sigcat.integration.ros2 import document as ros2
from sigcat.integration.ros2.model import MessageConstant
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from sigcat.platforms.integrate import integrate
from sigcat.platforms.platform import Options
from sigcat.platforms.table import PLATFORMS
from tests.adapter.autosar_classic.generated import functions

ROOT = Path(__file__).parents[2]
FULL = ROOT / "tests/adapter/autosar_adaptive/application/full/function.yaml"
READERS: Mapping[str, tuple[Any, Any]] = {
    "autosar-adaptive": (adaptive.read_integration, written),
    "autosar-classic": (classic.read_integration, written),
    "ros2": (ros2.read_integration, written),
}
WORD = "int_EVIL_code"
"""Text that no token, tag or key may have."""
ATTACKS = (
    f"*/ {WORD} /* // {WORD} \\", f'"; {WORD}; "\\" ??/', f"a\n{WORD};\n#include <{WORD}>\r\n{WORD}\u2028{WORD}\x0c{WORD}",
    f"]]> <{WORD}/> <!-- {WORD} & ]]> <script>{WORD}</script>", f"${{{WORD}}} $({WORD}) `{WORD}` @{WORD}@ #) {WORD} #]] {WORD}; {WORD}",
    f"\"\"\"\n{WORD}\n'''\n{WORD}\n\\\"\"\"\n{WORD}", f"\\*/{WORD} *\\/{WORD} ??/{WORD}", f"\0{WORD}\0\n{WORD} \u202e{WORD}",
    f"%s {{0}} {{}} {{{WORD}}} : {WORD}\n- {WORD}: {WORD}\n---\n{WORD}", f"x {WORD} " * 600, f"{'e' * 60}({WORD};" * 20,
    f"{'e' * 60}, {WORD}; || {WORD} = {WORD}(" * 20,
)  # fmt: skip
JSON = {"default_elements", "default_text", "init_elements"}
"""Texts that are JSON, where they are of an array or a struct."""
ONE_LINE = {"maintainer", "license", "value"}
"""Texts that ROS has on one line of printable characters; others are refused."""


@cache
def document(platform: str) -> bytes:
    return integrate(PLATFORMS[platform], functions((FULL,)), DEFAULT_DEPLOYMENT).document


def attacked(value: Any, attack: str, name: str = "") -> Any:
    """A model with an attack in the place of each free text."""
    if isinstance(value, MessageConstant) and value.datatype != "string":
        return value
    if isinstance(value, BaseModel):
        fields = type(value).model_fields
        return value.model_copy(update={each: attacked(getattr(value, each), attack, each) for each in fields})
    if isinstance(value, tuple):
        return tuple(attacked(each, attack, name) for each in value)
    if isinstance(value, list):
        return [attacked(each, attack, name) for each in value]
    if isinstance(value, Text) and (name not in JSON or json_of(value) is None):
        return Text(re.sub(r"[^ -~]+|#", " ", attack) if name in ONE_LINE else attack)
    return value


def generated(platform: str, attack: str) -> list[GeneratedFile]:
    read, written = READERS[platform]
    model = attacked(read(document(platform), "a.json", DEFAULT_LIMITS), attack)
    data = written(model)
    assert data.count(b"EVIL") > 20
    return [
        file
        for generator in PLATFORMS[platform].generators
        for file in generator.generate(data, "a.json", DEFAULT_LIMITS, Options(bench=generator.has_bench))
    ]


def words_of_c(file: GeneratedFile) -> list[str]:
    name = "a.c" if file.name.endswith(".c") else "a.cpp"
    options = ["-trigraphs", "-std=c99" if name == "a.c" else "-std=c++14", "-fsyntax-only"]
    unit = Index.create().parse(name, options, unsaved_files=[(name, file.data.decode())])
    plain = (TokenKind.COMMENT, TokenKind.LITERAL)
    return [token.spelling for token in unit.get_tokens(extent=unit.cursor.extent) if token.kind not in plain]


def words_of_python(file: GeneratedFile) -> list[str]:
    return [str(value) for node in ast.walk(ast.parse(file.data)) if not isinstance(node, ast.Constant)
            for value in vars(node).values() if isinstance(value, str)]  # fmt: skip


def words_of_xml(file: GeneratedFile) -> list[str]:
    found: list[str] = []
    parser = expat.ParserCreate()
    parser.StartElementHandler = lambda name, attributes: found.extend((name, *attributes))
    parser.Parse(file.data, True)
    return found


def words_of_yaml(file: GeneratedFile) -> list[str]:
    def keys(value: Any) -> list[str]:
        return (
            [word for key, inner in value.items() for word in (str(key), *keys(inner))]
            if isinstance(value, dict)
            else []
        )

    return keys(yaml.safe_load(file.data))


def words_of_cmake(file: GeneratedFile) -> list[str]:
    return re.sub(r'"(?:[^"\\]|\\.)*"|#[^\n]*', "", file.data.decode()).split()


def words_of_message(file: GeneratedFile) -> list[str]:
    return [word for row in file.data.decode().splitlines() if not row.startswith("#") for word in row.split()]


def words_of_markdown(file: GeneratedFile) -> list[str]:
    return re.findall(r"<[^>]*>", re.sub(r"`[^`]*`", "", file.data.decode()))


LANGUAGES: Mapping[str, Any] = {
    ".c": words_of_c, ".h": words_of_c, ".cpp": words_of_c, ".hpp": words_of_c, ".py": words_of_python, ".arxml": words_of_xml,
    ".xml": words_of_xml, ".ssd": words_of_xml, ".html": words_of_xml, ".yaml": words_of_yaml, ".txt": words_of_cmake, ".msg": words_of_message, ".srv": words_of_message,
    ".md": words_of_markdown, ".json": words_of_yaml, ".rst": words_of_cmake,
}  # fmt: skip


@pytest.mark.parametrize("platform", READERS)
@pytest.mark.parametrize("attack", ATTACKS, ids=range(len(ATTACKS)))
def test_free_text_never_becomes_code(platform, attack):
    made = generated(platform, attack)
    reached = [file for file in made if b"EVIL" in file.data]
    assert reached
    for file in reached:
        assert b"\0" not in file.data
        assert "\u202e" not in file.data.decode()
        words = LANGUAGES[Path(file.name).suffix](file)
        assert not [word for word in words if "EVIL" in word], file.name
