"""Every string field with a type refuses every payload where the product takes documents: `function validate` and each generator."""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import pytest

from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.document.document import Pointer, pointer_text
from sigcat.function.document.field_types import FREE
from sigcat.function.document.unfit_texts import string_fields, typed_strings
from sigcat.function.function_file import check_function_json
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.deployment_file import DEPLOYMENT_FILE, read_deployment
from sigcat.platforms.platform import Generator, Options
from sigcat.platforms.table import PLATFORMS
from tests.adapter.hostile.dangerous import MODELS, at_pointer
from tests.adapter.hostile.deployment import DEPLOYMENT
from tests.adapter.hostile.everything import FUNCTION_JSON, catalogue, document
from tests.adapter.hostile.payloads import PAYLOADS
from tests.function.test_field_types import models

Door = Callable[[bytes], Sequence[Finding]]


def refused_by(read: Callable[[bytes], Any]) -> Door:
    def findings(data: bytes) -> Sequence[Finding]:
        try:
            read(data)
        except InputRefused as refused:
            return refused.findings
        return ()

    return findings


def _generate(generator: Generator, data: bytes) -> object:
    return generator.generate(data, "a.json", DEFAULT_LIMITS, Options(bench=generator.has_bench))


def _doors() -> Iterator[tuple[str, str, Door]]:
    yield FUNCTION_JSON, "function validate", lambda data: check_function_json(data, "a.json").findings
    yield FUNCTION_JSON, "core", refused_by(lambda data: read_functions([(data, "a.json")], catalogue()))
    for name, platform in PLATFORMS.items():
        for each in platform.generators:
            yield name, each.name, refused_by(partial(_generate, each))
    yield "deployment", "integrate", refused_by(lambda data: read_deployment(data, "a.json"))


DOORS = {(kind, name): door for kind, name, door in _doors()}


def whole_of(kind: str) -> Any:
    return DEPLOYMENT if kind == "deployment" else json.loads(document(kind))


def typed(kind: str, whole: Any) -> tuple[list[Pointer], list[Pointer]]:
    """Places of strings with a type: values, and the first key of each mapping."""
    model = DEPLOYMENT_FILE if kind == "deployment" else MODELS[kind]
    values: list[Pointer] = []
    keys: dict[Pointer, Pointer] = {}
    for each in typed_strings(model.model_validate(whole, by_name=kind == "deployment" or False)):
        if each.grammar is not FREE and at_pointer(whole, each.pointer) == each.text:
            values.append(each.pointer)
        elif each.grammar is not FREE:
            keys.setdefault(each.pointer[:-1], each.pointer)
    return values, list(keys.values())


def with_payload(whole: Any, places: Sequence[Pointer], payload: str, *, is_key: bool) -> bytes:
    copied = json.loads(json.dumps(whole))
    for *above, last in places:
        part = at_pointer(copied, tuple(above))
        if is_key:
            part[payload] = part.pop(last)
        else:
            part[last] = payload
    return json.dumps(copied).encode()


@pytest.mark.parametrize("payload", PAYLOADS, ids=ascii)
@pytest.mark.parametrize("kind", [*MODELS, "deployment"])
def test_every_field_refuses_it_at_every_door(kind, payload):
    whole = whole_of(kind)
    values, keys = typed(kind, whole)
    for (of, name), door in DOORS.items():
        left = set(values) if of == kind else set()
        while left:  # what the structure refuses is reported before what types refuse
            found = {each.pointer for each in door(with_payload(whole, sorted(left, key=str), payload, is_key=False))}
            refused = {at for at in left if pointer_text(at) in found}
            assert refused, (name, sorted(map(pointer_text, left)))
            left -= refused
        for key in keys if of == kind else ():
            assert door(with_payload(whole, [key], payload, is_key=True)), (name, pointer_text(key))


def test_the_deployment_has_every_string_field():
    """Also those that are added: the models are walked."""
    names = {
        (model.__name__, field.alias)
        for model in models(DEPLOYMENT_FILE, {})
        for field in string_fields(model)
        if field.values or field.keys
    }
    assert {alias for _, alias in names} <= set(_aliases(DEPLOYMENT))


def _aliases(value: Any) -> Iterator[str]:
    if isinstance(value, Mapping):
        for key, inner in value.items():
            yield key
            yield from _aliases(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _aliases(inner)
