"""Every string of a function.yaml is a payload once: it is refused, or no parser finds it as code in what is generated."""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Annotated, Any, get_args, get_origin

import pytest
import yaml

from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.declaration.declaration import Declaration
from sigcat.function.document.document import Pointer, pointer_text
from sigcat.function.document.unfit_texts import annotation_of
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from sigcat.platforms.integrate import integrate
from sigcat.platforms.platform import Options
from sigcat.platforms.table import PLATFORMS
from tests.adapter.hostile.dangerous import at_pointer
from tests.adapter.hostile.everything import FUNCTION, catalogue, strings
from tests.adapter.hostile.payloads import EVIL, PAYLOADS
from tests.adapter.test_hostile_text import LANGUAGES
from tests.function.test_field_types import models


@cache
def declared() -> Any:
    return yaml.safe_load(FUNCTION.read_text())


def fields() -> dict[tuple[str, ...], Pointer]:
    """A pointer for each field that has a string: indexes do not make another one."""
    found: dict[tuple[str, ...], Pointer] = {}
    for at, _ in strings(declared()):
        found.setdefault(tuple("*" if isinstance(part, int) else part for part in at), at)
    return found


def written(places: Iterable[Pointer], payload: str) -> bytes:
    """The function with a payload in some places, each value on its own line."""
    whole = yaml.safe_load(FUNCTION.read_text())
    for at in places:
        at_pointer(whole, at[:-1])[at[-1]] = payload
    return yaml.safe_dump(whole, sort_keys=False, default_flow_style=False, width=10**9).encode()


def lines(data: bytes) -> dict[int, Pointer]:
    """Pointers of the values by their lines."""
    root = yaml.compose(data)
    assert root is not None
    return {node.start_mark.line + 1: at for at, node in _scalars(root, ())}


def _scalars(node: yaml.Node, at: Pointer) -> Iterator[tuple[Pointer, yaml.Node]]:
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            yield from _scalars(value, (*at, key.value))
    elif isinstance(node, yaml.SequenceNode):
        for index, value in enumerate(node.value):
            yield from _scalars(value, (*at, index))
    else:
        yield at, node


def accepted(payload: str) -> set[Pointer]:
    """Fields that take a payload, all at once."""
    left = set(fields().values())
    while blamed := left & blamed_in(left, payload):
        left -= blamed
    return fitting(set(), sorted(left, key=pointer_text), payload)


def blamed_in(places: Collection[Pointer], payload: str) -> set[Pointer]:
    """Values at whose lines an error is."""
    data = written(places, payload)
    at = lines(data)
    return {at[each.line] for each in refusals(data) if each.line in at}


def refusals(data: bytes) -> Sequence[Finding]:
    try:
        read_functions([(data, "a.function.yaml")], catalogue())
    except InputRefused as refused:
        return [each for each in refused.findings if each.severity == "error"]
    return ()


def fitting(kept: set[Pointer], places: Sequence[Pointer], payload: str) -> set[Pointer]:
    """Those of the places that take a payload beside those that do, half by half: an error may be at another line."""
    if not refusals(written({*kept, *places}, payload)):
        return {*kept, *places}
    if len(places) == 1:
        return kept
    middle = len(places) // 2
    return fitting(fitting(kept, places[:middle], payload), places[middle:], payload)


@pytest.mark.parametrize("payload", PAYLOADS, ids=ascii)
def test_it_is_refused_or_no_code(payload):
    places = accepted(payload)
    functions = read_functions([(written(places, payload), "a.function.yaml")], catalogue()).functions
    assert 10 < len(places) < len(fields()) / 2, sorted(map(pointer_text, places))
    for platform in PLATFORMS.values():
        document = integrate(platform, functions, DEFAULT_DEPLOYMENT).document
        for generator in platform.generators:
            options = Options(bench=generator.has_bench)
            for file in generator.generate(document, "a.json", DEFAULT_LIMITS, options):
                if EVIL.encode() in file.data:
                    words = LANGUAGES[Path(file.name).suffix](file)
                    assert [word for word in words if EVIL in word] == [], file.name


OTHER_SIGNATURES: Mapping[str, Callable[[Any, str], object]] = {
    "class": lambda whole, text: whole["code"].update({"signature": "class", "class": text}),
    "arguments": lambda whole, text: (
        whole["code"].update(signature="pointers"),
        whole["components"][0]["runnables"][1].update(arguments=[text]),
    ),
    "member": lambda whole, text: (
        whole["code"].update(signature="pointers"),
        whole["code"]["objects"].append({"name": "Demo_U", "type": "U_Demo_T", "member": text}),
    ),
}
"""Fields of code that is called otherwise."""


@pytest.mark.parametrize("field", OTHER_SIGNATURES)
def test_fields_of_other_signatures_refuse_it(field):
    def changed(text: str) -> bytes:
        whole = yaml.safe_load(FUNCTION.read_text())
        OTHER_SIGNATURES[field](whole, text)
        return yaml.safe_dump(whole).encode()

    harmless = {each.message for each in refusals(changed("Demo_B"))}
    for payload in PAYLOADS:
        assert {each.message for each in refusals(changed(payload))} - harmless, payload


def test_the_function_has_every_string_field():
    """Also those that are added: the models are walked."""
    names = {
        info.alias or name
        for model in models(Declaration, {})
        for name, info in model.model_fields.items()
        if _is_text(annotation_of(info))
    }
    given = {part for at, _ in strings(declared()) for part in at if isinstance(part, str)}
    assert names - given == OTHER_SIGNATURES.keys()


def _is_text(annotation: Any) -> bool:
    parts = get_args(annotation)
    if get_origin(annotation) is dict:
        return _is_text(parts[1])
    if get_origin(annotation) is Annotated:
        return _is_text(parts[0])
    return annotation is str or any(_is_text(part) for part in parts)
