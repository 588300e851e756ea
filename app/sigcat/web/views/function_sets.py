"""A set of functions, hosted or posted, checked and connected: what the page of the wiring shows."""

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.findings import Finding, in_order
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.hosted_files import HostedFile, HostedFiles
from sigcat.function.hosting import file_of
from sigcat.function.sets.check_set import check_set, read_set
from sigcat.function.sets.wiring import Wiring, connect
from sigcat.limits import DEFAULT_LIMITS, PAGE_FUNCTIONS, Limits
from sigcat.web.forms import PostedFile
from sigcat.web.views.source_view import shown_text

_ECO_CONTROL = ("core_acc", "eco_control_mpc")
_SEPARATOR = re.compile(r"^---[ \t]*(?:#[ \t]*(.*?))?[ \t]*$", re.MULTILINE)
"""Between two documents: the three dashes of YAML, with the name of the file as their comment."""


class FunctionSet(NamedTuple):
    """Functions that were read together: what one defines, the others may use."""

    catalogue: Catalogue
    """With everything that the functions define."""
    files: tuple[PostedFile, ...]
    functions: tuple[FunctionJson, ...]
    """Every function that can be drawn, each name once."""
    whole: tuple[ResolvedFunction, ...]
    """Functions without an error: files are made of them."""
    findings: tuple[Finding, ...]
    wiring: Wiring


def function_set(files: Sequence[PostedFile], catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS) -> FunctionSet:
    """The functions of files. What cannot be read is among the findings."""
    members, over = read_set([(file.data, file.name) for file in files], catalogue, limits)
    together = check_set(members, over, is_whole=len(members) > 1)
    findings = in_order([*(finding for member in members for finding in member.findings), *together])
    built = {m.function.info.function_name: m for m in reversed(members) if m.function is not None}
    drawn = tuple(function for m in members if (function := m.function) and built[function.info.function_name] is m)
    whole = tuple(sound for f in drawn if (sound := built[f.info.function_name].sound))
    return FunctionSet(over, tuple(files), drawn, whole, findings, connect(drawn))


def known_sets(files: HostedFiles) -> Mapping[str, tuple[str, ...]]:
    """The sets that pages offer: ids of functions by title, the operator's own first."""
    own = [file.id for file in files if not file.is_shipped]
    title = "Your functions" if len(own) <= PAGE_FUNCTIONS else f"Your first {PAGE_FUNCTIONS} functions"
    sets = {title: tuple(own[:PAGE_FUNCTIONS])} if len(own) > 1 else {}
    return {**sets, "EcoControl": _ECO_CONTROL} if {file.id for file in files}.issuperset(_ECO_CONTROL) else sets


@lru_cache(maxsize=16)
def hosted_set(files: HostedFiles, function_ids: tuple[str, ...], catalogue: Catalogue) -> FunctionSet:
    """A set of functions that the service hosts. Raises NotFound with the nearest ids."""
    return function_set(chosen_files(files, function_ids), catalogue)


def chosen_files(files: HostedFiles, function_ids: Iterable[str]) -> tuple[PostedFile, ...]:
    """The files of functions that the service hosts. Raises NotFound with the nearest ids."""
    return tuple(PostedFile(_name_in_set(file), file.data) for file in (file_of(files, each) for each in function_ids))


def _name_in_set(file: HostedFile) -> str:
    """Shipped files all have one name; side by side, their folders distinguish them."""
    return f"{file.id}/{file.name}" if file.is_shipped else file.name


def documents_in(text: str) -> tuple[PostedFile, ...]:
    """The documents of a text, where `---` begins a new one: `--- # brake.yaml` also names it."""
    names, texts = [""], []
    start = 0
    for line in _SEPARATOR.finditer(text):
        texts.append(text[start : line.start()])
        names.append(line.group(1) or "")
        start = line.end() + 1
    texts.append(text[start:])
    given = [(name, each) for name, each in zip(names, texts, strict=True) if each.strip()]
    return tuple(
        PostedFile(name or f"document {index}", each.encode("utf-8", "replace"))
        for index, (name, each) in enumerate(given, 1)
    )


def as_text(files: Iterable[PostedFile]) -> str:
    """One text of several files, such as `documents_in` takes apart."""
    return "\n".join(f"--- # {' '.join(file.name.split())}\n{shown_text(file.data)}" for file in files)


def distinct(files: Iterable[PostedFile]) -> tuple[PostedFile, ...]:
    """Files with unique names, so that each finding has one file: a second `a.yaml` becomes `a.yaml (2)`."""
    known: Counter[str] = Counter()
    named = []
    for file in files:
        known[file.name] += 1
        number = known[file.name]
        named.append(file if number == 1 else file._replace(name=f"{file.name} ({number})"))
    return tuple(named)
