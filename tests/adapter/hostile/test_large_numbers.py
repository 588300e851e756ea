"""Numbers that no double holds: each document with one is refused with a finding, whichever field has it and whatever reads it."""

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import pytest
import yaml

from sigcat.adapter.host.shapes import Array, Number
from sigcat.cli import main
from sigcat.errors import InputRefused
from sigcat.findings import has_errors
from sigcat.function.document.document import Pointer, pointer_text
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.deployment_file import read_deployment
from sigcat.platforms.platform import Options
from sigcat.platforms.table import PLATFORMS
from sigcat.runs.recording.cells import Unfit, value_of
from tests.adapter.hostile.deployment import DEPLOYMENT
from tests.adapter.hostile.everything import DOCUMENTS, FUNCTION, FUNCTION_JSON, catalogue, changed, document

LARGE = (10**400, -(10**400))


def numbers(value: Any, at: Pointer = ()) -> Iterator[Pointer]:
    """Every number of a document."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        yield at
    elif isinstance(value, Mapping):
        for key, item in value.items():
            yield from numbers(item, (*at, key))
    elif isinstance(value, Sequence) and not isinstance(value, str):
        for index, item in enumerate(value):
            yield from numbers(item, (*at, index))


def places(whole: Any) -> list[Pointer]:
    """One number of each field: indexes do not make another one."""
    found: dict[Pointer, Pointer] = {}
    for at in numbers(whole):
        found.setdefault(tuple("*" if isinstance(part, int) else part for part in at), at)
    return list(found.values())


@pytest.mark.parametrize("large", LARGE, ids=("positive", "negative"))
@pytest.mark.parametrize("kind", DOCUMENTS)
def test_json_with_one_is_refused_by_every_generator(kind, large):
    found = places(json.loads(document(kind)))
    assert found
    generators = PLATFORMS[kind].generators if kind != FUNCTION_JSON else PLATFORMS["autosar-adaptive"].generators
    for at in found:
        data = changed(kind, at, large)
        for generator in generators:
            with pytest.raises(InputRefused):
                generator.generate(data, "a.json", DEFAULT_LIMITS, Options(bench=generator.has_bench))


@pytest.mark.parametrize("large", LARGE, ids=("positive", "negative"))
def test_a_declaration_with_one_is_refused(large):
    whole = yaml.safe_load(FUNCTION.read_text())
    for at in places(whole):
        data = yaml.safe_dump(_with(whole, at, large), sort_keys=False).encode()
        with pytest.raises(InputRefused) as refused:
            read_functions([(data, "function.yaml")], catalogue())
        assert has_errors(refused.value.findings), pointer_text(at)


@pytest.mark.parametrize("large", LARGE, ids=("positive", "negative"))
def test_a_deployment_with_one_is_refused(large):
    for at in places(DEPLOYMENT):
        data = yaml.safe_dump(_with(DEPLOYMENT, at, large), sort_keys=False).encode()
        with pytest.raises(InputRefused):
            read_deployment(data, "deployment.yaml")


def _with(whole: Any, at: Pointer, value: Any) -> Any:
    copy = json.loads(json.dumps(whole))
    part = copy
    for key in at[:-1]:
        part = part[key]
    part[at[-1]] = value
    return copy


TREE = {
    "Vehicle": {"type": "branch", "description": "A vehicle."},
    "Vehicle.X": {"type": "sensor", "datatype": "float", "description": "X."},
}
ATTRIBUTES: dict[str, Any] = {
    "min": None,
    "max": None,
    "default": None,
    "allowed": [],
    "instances": [],
    "arraysize": None,
    "own": {"a": []},
}


@pytest.mark.parametrize("large", LARGE, ids=("positive", "negative"))
@pytest.mark.parametrize("name", ATTRIBUTES)
@pytest.mark.parametrize("datatype", ["float", "uint8", "string", "double[]"])
def test_a_tree_with_one_is_refused_by_every_reader(tmp_path, capsys, name, datatype, large):
    value = {"a": [large]} if name == "own" else [large] if name in ("allowed", "instances") else large
    tree = {**TREE, "Vehicle.X": {**TREE["Vehicle.X"], "datatype": datatype, name: value}}
    (tmp_path / "tree.vspec").write_text(yaml.safe_dump(tree, sort_keys=False))
    child = {"type": "sensor", "datatype": datatype, "description": "X.", name: value}
    (tmp_path / "tree.json").write_text(
        json.dumps({"Vehicle": {"type": "branch", "description": "A.", "children": {"X": child}}})
    )
    assert main(["lint", str(tmp_path / "tree.vspec"), "--isolated"]) == 1
    assert "R014" in capsys.readouterr().out
    assert main(["show", "Vehicle.X", "-s", str(tmp_path / "tree.json"), "--isolated"]) == 1
    assert main(["diff", str(tmp_path / "tree.json"), "vss", "--isolated"]) == 1
    capsys.readouterr()


@pytest.mark.parametrize("cell", ["1" + "0" * 400, "[" + "1" + "0" * 400 + ",0]", "-1" + "0" * 400])
@pytest.mark.parametrize(
    "shape", [Number("float"), Number("uint8"), Number("uint64"), Array(Number("double"), 2), Array(Number("uint8"), 2)]
)
def test_a_cell_of_a_trace_with_one_is_unfit_or_infinite(cell, shape):
    try:
        value = value_of(cell, shape)
    except Unfit:
        return
    assert isinstance(value, float)
    assert math.isinf(value)
