"""Applications, generated from functions."""

from functools import cache
from pathlib import Path

from sigcat.adapter.autosar_adaptive.application.adaptive_application import generate
from sigcat.data import EXAMPLES
from sigcat.function.function_file import build_function
from sigcat.function.function_json.wire import written
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from tests.function.shipped import interfaces
from tests.integration.autosar_adaptive.sets import deployed, derive

ECOCONTROL = EXAMPLES / "ecocontrol/expected/autosar-adaptive.json"
FULL = Path(__file__).parent / "full"
"""A function that uses everything that a declaration can say."""
PACED = Path(__file__).parent / "paced"
"""A function with calls of three priorities, one of which waits for steps of another one."""
SMALL = Path(__file__).parent / "small"
"""Functions that leave out almost everything, or have names that are easily taken."""
STORING = Path(__file__).parent / "storing.function.yaml"
"""A function with parameters in several storages."""


def integration(*functions):
    """The Integration JSON of functions."""
    return written(derive(functions).model)


@cache
def ecocontrol():
    """The files of EcoControl with the bench, by name."""
    return files(ECOCONTROL.read_bytes(), bench=True)


@cache
def full_integration():
    """The Integration JSON of the function that uses everything."""
    return integration(built(FULL / "function.yaml"))


@cache
def full():
    """The files of the function that uses everything, with the bench, by name."""
    return files(full_integration(), bench=True)


@cache
def paced_integration():
    """The integration of the function with calls of three priorities, whose error is protected, and of one that follows it."""
    return derive(
        [each.function for each in paced_functions()],
        deployed(autosarAdaptive={"e2e": {"profile": 4, "maxDeltaCounter": 3}}),
    ).model


def paced_functions():
    """The function with calls of three priorities, and the one that follows it."""
    sources = [(path.read_bytes(), path.name) for path in sorted(PACED.glob("*.yaml"))]
    functions, _ = read_functions(sources, interfaces())
    return functions


@cache
def paced():
    """The files of the function with calls of three priorities, with the bench, by name."""
    return files(written(paced_integration()), bench=True)


@cache
def small():
    """The files of all small functions, with the bench, by name."""
    return files(integration(*map(built, sorted(SMALL.glob("*.yaml")))), bench=True)


def built(path):
    """A function of a file."""
    function, _ = build_function(path.read_bytes(), path.name, interfaces())
    return function


@cache
def storing():
    """The files of a function with parameters in several storages, by name."""
    return files(integration(built(STORING)))


def files(document, *, bench=False):
    """The files that are generated from an Integration JSON, by name."""
    made = generate(document, "integration.json", DEFAULT_LIMITS, None, bench=bench)
    return {file.name: file.data.decode() for file in made}


def write(made, folder):
    """Write files below a folder."""
    for name, text in made.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
