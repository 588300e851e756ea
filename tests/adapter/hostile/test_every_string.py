"""Every string of every document is free text, or of a type that refuses what a language interprets.

What becomes of free text is tested with the parsers of the languages, in tests/adapter/test_hostile_text.py.
"""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from pydantic import BaseModel

from sigcat.function.document.document import Pointer
from sigcat.function.document.field_types import FREE
from sigcat.function.document.text import Text
from sigcat.function.document.unfit_texts import string_fields, typed_strings
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from sigcat.integration.autosar_classic.model import ClassicIntegration
from sigcat.integration.fmi.model import FmiIntegration
from sigcat.integration.ros2.model import Ros2Integration
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.platform import Options
from sigcat.platforms.table import PLATFORMS
from tests.adapter.hostile.deployment import DEPLOYMENT
from tests.adapter.hostile.everything import DOCUMENTS, FUNCTION_JSON, document, one_of_each, strings
from tests.adapter.hostile.payloads import EVIL, PAYLOADS
from tests.adapter.hostile.test_function_yaml import fields as fields_of_declaration
from tests.adapter.test_hostile_text import words_of_xml

MODELS: dict[str, type[BaseModel]] = {
    FUNCTION_JSON: FunctionJson,
    "autosar-adaptive": IntegrationModel,
    "autosar-classic": ClassicIntegration,
    "ros2": Ros2Integration,
    "fmi": FmiIntegration,
}


def read(kind: str) -> BaseModel:
    return MODELS[kind].model_validate(json.loads(document(kind)), by_name=False)


def other_strings(value: Any, at: Pointer = ()) -> Iterator[tuple[Pointer, str]]:
    """Pointers of free text, and of words that a model lists one by one."""
    if isinstance(value, Text):
        yield at, "free"
    elif isinstance(value, str):
        yield at, "listed"
    elif isinstance(value, tuple | list):
        for index, item in enumerate(value):
            yield from other_strings(item, (*at, index))
    elif isinstance(value, dict):
        for key, item in value.items():
            yield from other_strings(item, (*at, key))
    elif isinstance(value, BaseModel):
        typed = {field.name for field in string_fields(type(value)) if field.values is not None}
        for name, info in type(value).model_fields.items():
            inner = getattr(value, name)
            if name not in typed or not isinstance(inner, str | tuple | list | dict):
                yield from other_strings(inner, (*at, info.alias or name))


@pytest.mark.parametrize("kind", DOCUMENTS)
def test_each_string_is_free_text_or_has_a_type(kind):
    model = read(kind)
    known = {each.pointer for each in typed_strings(model)} | {pointer for pointer, _ in other_strings(model)}
    assert {pointer for pointer, _ in strings(json.loads(document(kind)))} <= known


@pytest.mark.parametrize("kind", DOCUMENTS)
def test_no_field_with_a_type_takes_a_payload(kind):
    grammars = {each.grammar for each in typed_strings(read(kind)) if each.grammar is not FREE}
    assert len(grammars) > 10
    accepted = [(each.expected, payload) for each in grammars for payload in PAYLOADS if each.accepts(payload)]
    assert accepted == []


@pytest.mark.parametrize("kind", PLATFORMS)
def test_what_a_document_only_keeps_is_text_in_arxml_at_most(kind):
    whole = json.loads(document(kind))
    if "Provenance" in whole:
        whole["Provenance"] = [{"Generator": PAYLOADS[0], "Kept": PAYLOADS[1], "Deep": {"Keys": PAYLOADS[6]}}]
    for function in whole["SourceFunctionList"]:
        for definition in function["Provenance"]["Definitions"]:
            definition["Attributes"] = {"description": PAYLOADS[0], "Kept": PAYLOADS[1]}
    for generator in PLATFORMS[kind].generators:
        options = Options(bench=generator.has_bench)
        for file in generator.generate(json.dumps(whole).encode(), "a.json", DEFAULT_LIMITS, options):
            if EVIL.encode() in file.data:
                assert file.name.endswith(".arxml")
                assert not [word for word in words_of_xml(file) if EVIL in word]


def test_the_page_counts_what_is_tested():
    generators = {kind: len(PLATFORMS[kind].generators) for kind in PLATFORMS}
    numbers = [  # fields, and generators of each
        *((len(one_of_each(kind)), generators.get(kind, 1)) for kind in DOCUMENTS),
        (len(fields_of_declaration()), sum(generators.values())),
        (len(list(strings(DEPLOYMENT))), 1),
    ]
    page = (Path(__file__).parents[3] / "docs/explanation/trust.md").read_text()
    assert f"{sum(fields for fields, _ in numbers):,} fields" in page
    assert f"{len(PAYLOADS)} payloads" in page
    assert f"{sum(fields * times for fields, times in numbers) * len(PAYLOADS):,} combinations" in page
