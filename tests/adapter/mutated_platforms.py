"""Documents whose platforms are compiled: functions that use most keys of a declaration, over code that a header declares in a few lines."""

import json
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

from sigcat.adapter.files import GeneratedFile
from sigcat.errors import InputRefused
from sigcat.findings import has_errors
from sigcat.function.function_file import check_function_json
from sigcat.function.function_json.model import FunctionJson, to_json
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.integrate import integrate
from sigcat.platforms.platform import Generator, Options
from sigcat.platforms.table import PLATFORMS
from tests.adapter.autosar_adaptive.application.generated import FULL
from tests.adapter.compiled_platforms import compiled
from tests.adapter.core.fixed import FIXED
from tests.adapter.hostile.everything import FUNCTION as EVERYTHING
from tests.function.shipped import interfaces

_FIXED = ("time_outs", "rejections", "errors", "schedules")
NAMES = ("everything", "full", *_FIXED)
"""The documents, as messages name them."""
_OWN_FILES = ("Sources", "IncludeFolders", "Definitions", "Objects", "Accessors")
"""Members in the code of a function that no generated header declares."""


def read(document: Any) -> tuple[ResolvedFunction, ...]:
    """The function of a document, checked without a catalogue. Raises InputRefused with its errors."""
    checked = check_function_json(json.dumps(document, indent=1).encode(), "f.json")
    if checked.resolved is None or has_errors(checked.findings):
        raise InputRefused("f.json has errors.", checked.findings)
    return (checked.resolved,)


@cache
def documents() -> dict[str, Any]:
    """The Function JSON of functions, by their names in messages."""
    files = {"everything": EVERYTHING, "full": FULL / "function.yaml"}
    found = {name: json.loads(to_json(_function(path).function)) for name, path in files.items()}
    for document in found.values():
        _flatten(document)
    found |= {name: json.loads(to_json(FIXED[name]())) for name in _FIXED}
    found["schedules"] = _with_ticks(found["schedules"])
    return found


def _with_ticks(document: Any) -> Any:
    """A document whose offsets AUTOSAR Classic takes, too."""
    return json.loads(json.dumps(document).replace('"12.5"', '"12"'))


def _function(path: Path) -> ResolvedFunction:
    return read_functions([(path.read_bytes(), path.name)], interfaces()).functions[0]


def _flatten(document: Any) -> None:
    """Each variable is declared by itself, in the header of the function."""
    for key in _OWN_FILES:
        document["Code"].pop(key, None)
    for holder in _mappings(document):
        for key in ("DefinedBy", "CType", "Members"):
            holder.pop(key, None)
        for key, value in holder.items():
            if key.endswith("Variable") and isinstance(value, str):
                holder[key] = value.replace(".", "_")


def _mappings(value: Any) -> Iterator[dict[str, Any]]:
    items = list(value.values()) if isinstance(value, dict) else value if isinstance(value, list) else []
    if isinstance(value, dict):
        yield value
    for item in items:
        yield from _mappings(item)


def code_generator(platform: str) -> Generator:
    """The generator of code, and not of ARXML alone."""
    return next(each for each in PLATFORMS[platform].generators if each.name == platform)


def files_of(generator: Generator, integration: bytes, *, is_bench: bool) -> tuple[GeneratedFile, ...]:
    """Return the generated files; none if they are refused with findings."""
    return _or_nothing(lambda: generator.generate(integration, "i.json", DEFAULT_LIMITS, Options(bench=is_bench)))


def _or_nothing(make: Callable[[], tuple[GeneratedFile, ...]]) -> tuple[GeneratedFile, ...]:
    try:
        return make()
    except InputRefused as refused:
        if not refused.findings:
            raise
        return ()


def compile_function(platform: str, document: Any) -> bool:
    """Whether a function is generated for a platform, and compiled; False if it is refused with findings."""

    def make() -> tuple[GeneratedFile, ...]:
        integration = integrate(PLATFORMS[platform], read(document)).document
        return code_generator(platform).generate(integration, "i.json", DEFAULT_LIMITS, _options(platform))

    return _compiled(platform, _or_nothing(make), [document])


def compile_integration(platform: str, document: Any) -> bool:
    """Whether code is generated from an Integration JSON, and compiled; False if it is refused with findings."""
    generator = code_generator(platform)
    files = files_of(generator, json.dumps(document, indent=1).encode(), is_bench=generator.has_bench)
    return _compiled(platform, files, document.get("SourceFunctionList") or () if files else ())


def _options(platform: str) -> Options:
    return Options(bench=code_generator(platform).has_bench)


def _compiled(platform: str, files: tuple[GeneratedFile, ...], functions: Any) -> bool:
    if files:
        compiled(platform, files, [FunctionJson.model_validate(each, by_name=False) for each in functions])
    return bool(files)


@cache
def integration_of(platform: str, name: str) -> Any:
    """The Integration JSON of a function."""
    return json.loads(integrate(PLATFORMS[platform], read(documents()[name])).document)
