"""Property tests: `make test` and `make real` try the same examples in every run, `make fuzz` and `make slow` search at random.

The search writes each new failure into `found_examples.json`; every later run tries it, too. Values in this file are Python literals.
"""

import json
import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from inspect import signature
from pathlib import Path
from types import FunctionType
from typing import Any

import pytest
from hypothesis import HealthCheck, example, is_hypothesis_test, settings
from hypothesis.internal.conjecture import providers

from tests.needs import IS_SLOW_RUN

FILE = Path(__file__).with_name("found_examples.json")
FUZZ = int(os.environ.get("SIGCAT_FUZZ", "0"))
"""Extent of the search of `make fuzz`: the examples of a test are a fifth as many times the usual number."""
IS_SEARCH = IS_SLOW_RUN or bool(FUZZ)
"""Whether examples are random."""
TIMES = FUZZ // 5 or (10 if IS_SLOW_RUN else 1)
PROPERTY = "found"
"""Name of the report property with the failed example."""
_CONSTANTS = {"nan": math.nan, "inf": math.inf}

Arguments = Mapping[str, Any]


def load_profile() -> None:
    """Make examples independent of the clock, of earlier runs, and of the modules that happen to be imported."""
    providers.is_local_module_file = lambda path: False  # type: ignore[attr-defined,assignment] # else their constants are examples
    fixed = settings(
        max_examples=100 * TIMES,
        derandomize=not IS_SEARCH,
        database=None,
        deadline=None,
        print_blob=False,
        report_multiple_bugs=not IS_SEARCH,
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
    )
    settings.register_profile("sigcat", fixed)
    settings.load_profile("sigcat")


def examples(usual: int) -> settings:
    """The number of examples of a test; a search tries many times as many."""
    return settings(max_examples=usual * TIMES)


def found(test: str) -> Sequence[Arguments]:
    """Examples that failed once, by the name of the test: `tests/FILE.py::NAME`."""
    return [eval(text, {"__builtins__": {}}, dict(_CONSTANTS)) for text in _texts().get(test, ())]


def names() -> Iterable[str]:
    """Names of the tests of which the file has examples."""
    return _texts()


def seeds(test: str, usual: int, number: int = 1) -> Sequence[object]:
    """Seeds for `parametrize`: the usual ones, or in a search random ones; then those that failed once."""
    first = int.from_bytes(os.urandom(4)) if IS_SEARCH else usual
    drawn = [pytest.param(first + each, id=f"drawn {each}") for each in range(number)]  # workers draw their own
    return [*drawn, *(each["seed"] for each in found(test))]


def prepare(items: Iterable[pytest.Item]) -> None:
    """Mark property tests, add the examples of the file to them, and have them remember what they fail with."""
    for item in items:
        function = _function(item)
        if function is None:
            continue
        item.add_marker("property")
        if not hasattr(function.hypothesis.inner_test, "failed"):
            for arguments in found(_name(item)):
                example(**arguments)(function)
            function.hypothesis.inner_test = _remembering(function.hypothesis.inner_test)


def note(item: pytest.Item) -> None:
    """Let the report of a failed search have the example: workers send reports."""
    text = repr(_arguments(item)) if IS_SEARCH else "{}"
    if text != "{}" and is_literal(text):
        item.user_properties.append((PROPERTY, (_name(item), text)))


def write(report: pytest.TestReport) -> str:
    """Write the failed example of a report to the file; a line that says so, or nothing."""
    values: list[Any] = [value for name, value in report.user_properties if name == PROPERTY]
    if not values or not report.failed:
        return ""
    test, text = map(str, values[-1])
    texts = _texts()
    if text in texts.get(test, ()):
        return ""
    texts.setdefault(test, []).append(text)
    FILE.write_text(json.dumps(dict(sorted(texts.items())), indent=2) + "\n", encoding="utf-8")
    return f"a failed example of {test} was added to tests/{FILE.name}"


def _texts() -> dict[str, list[str]]:
    texts: dict[str, list[str]] = json.loads(FILE.read_text("utf-8"))
    return texts


def _name(item: pytest.Item) -> str:
    return item.nodeid.partition("[")[0]


def _arguments(item: pytest.Item) -> Arguments:
    """Arguments that a test failed with, without its fixtures."""
    function = _function(item)
    if function is None:
        given = getattr(item, "callspec", None)
        return {"seed": given.params["seed"]} if given and "seed" in given.params else {}
    failed: Arguments = function.hypothesis.inner_test.failed
    return {name: value for name, value in failed.items() if name not in signature(function).parameters}


def _function(item: pytest.Item) -> Any:
    """A property test of this project; None for others, such as those that schemathesis makes."""
    function = getattr(item, "obj", None)
    return function if isinstance(function, FunctionType) and is_hypothesis_test(function) else None


def _remembering(test: Callable[..., None]) -> Callable[..., None]:
    """The test, which remembers its last failed arguments: Hypothesis ends with the smallest ones."""

    @wraps(test)
    def remembering(*args: Any, **kwargs: Any) -> None:
        try:
            test(*args, **kwargs)
        except Exception:
            remembering.failed = kwargs  # type: ignore[attr-defined]
            raise

    remembering.failed = {}  # type: ignore[attr-defined]
    return remembering


def is_literal(text: str) -> bool:
    """Whether the file can have a value that is written so."""
    try:
        eval(text, {"__builtins__": {}}, dict(_CONSTANTS))
    except (NameError, SyntaxError):
        return False
    return True
